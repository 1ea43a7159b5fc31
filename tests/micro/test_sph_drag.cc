// The drag of the bulk fluid: friction that is symmetric, takes energy, knows no rigid motion and keeps both
// momenta; pressure as the adjoint of the divergence.
#include "micro/laws/counter_random.h"
#include "micro/terms/sph_drag.h"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>

using namespace turgor;

BOOST_TEST_DONT_PRINT_LOG_VALUE(turgor::DragForm)

namespace {
const auto forms =
    boost::unit_test::data::make({DragForm::least_squares, DragForm::morris, DragForm::monaghan});

/// A drop of jittered particles, spacing 1, no walls.
template <int dim>
struct Drop {
  std::vector<Vector<dim>> x;
  SphDrag<dim> drag;

  explicit Drop(const DragForm form) {
    const int across = dim == 2 ? 9 : 5;
    Vector<dim> at;
    for (int k = 0; k < std::pow(across, dim); ++k) {
      int rest = k;
      for (int d = 0; d < dim; ++d, rest /= across)
        at[d] = rest % across + 0.4 * random_uniform(1, std::uint64_t(dim * k + d));
      x.push_back(at);
    }
    drag.clear(form, 2.);
    for (std::size_t i = 0; i < x.size(); ++i) {
      drag.body();
      for (std::size_t j = 0; j < x.size(); ++j) {
        const Vector<dim> r = x[j] - x[i];
        if (i != j && r.norm() < 2.6) drag.pair(std::uint32_t(j), r, std::pow(1. - r.norm() / 2.6, 3));
      }
    }
    drag.finish(1);
  }

  std::vector<BodyVector> velocities(const std::function<Vector<dim>(std::size_t)> &of) const {
    std::vector<BodyVector> v(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      for (int d = 0; d < dim; ++d) v[i].v[d] = of(i)[d];
    return v;
  }
  std::vector<BodyVector> noise(const unsigned int seed) const {
    return velocities([&](const std::size_t i) {
      Vector<dim> v;
      for (int d = 0; d < dim; ++d) v[d] = 2. * random_uniform(seed, dim * i + std::uint64_t(d)) - 1.;
      return v;
    });
  }
  std::vector<BodyVector> times(const std::vector<BodyVector> &v) {
    std::vector<BodyVector> product(x.size());
    drag.begin(v.data(), 1);
    drag.add(v.data(), 0, x.size(), product.data());
    return product;
  }
  static double dot(const std::vector<BodyVector> &a, const std::vector<BodyVector> &b) {
    double sum = 0.;
    for (std::size_t i = 0; i < a.size(); ++i)
      for (int d = 0; d < dim; ++d) sum += a[i].v[d] * b[i].v[d];
    return sum;
  }
  double torque_over_force(const std::vector<BodyVector> &f) const {
    Tensor2<dim> moment = Tensor2<dim>::Zero();
    double size = 0.;
    for (std::size_t i = 0; i < x.size(); ++i) {
      Vector<dim> one;
      for (int d = 0; d < dim; ++d) one[d] = f[i].v[d];
      moment += one * x[i].transpose();
      size += one.norm();
    }
    return (moment - moment.transpose()).norm() / size;
  }
};

template <int dim>
void check_friction(const DragForm form) {
  Drop<dim> drop(form);
  const auto u = drop.noise(2), v = drop.noise(3), Au = drop.times(u), Av = drop.times(v);
  const double power = Drop<dim>::dot(v, Av);
  BOOST_TEST(power > 0.);
  BOOST_TEST(std::abs(Drop<dim>::dot(u, Av) - Drop<dim>::dot(v, Au)) < 1e-12 * power);
  DoubleRow sum{};
  double size = 0.;
  for (const BodyVector &one : Av) {
    sum += one.v;
    for (int d = 0; d < dim; ++d) size += std::abs(one.v[d]);
  }
  for (int d = 0; d < dim; ++d) BOOST_TEST(std::abs(sum[d]) < 1e-14 * size);
  // Morris's pairs turn a drop, the others keep its angular momentum
  const double torque = drop.torque_over_force(Av);
  Tensor2<dim> spin = Tensor2<dim>::Zero();
  spin(0, 1) = 1.;
  spin(1, 0) = -1.;
  const auto turning = drop.velocities([&](const std::size_t i) { return Vector<dim>(spin * drop.x[i]); });
  const double of_spin = Drop<dim>::dot(turning, drop.times(turning));
  if (form == DragForm::morris) {
    BOOST_TEST(torque > 1e-3);
    BOOST_TEST(of_spin > 1e-2 * power);
  } else {
    BOOST_TEST(torque < 1e-14);
    BOOST_TEST(std::abs(of_spin) < 1e-13 * power);
  }
  // the product in single precision is the same to its digits
  std::vector<FloatRow> p(drop.x.size()), Ap(drop.x.size());
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = __builtin_convertvector(v[i].v, FloatRow);
  drop.drag.begin(p.data(), 1);
  drop.drag.add(p.data(), 0, p.size(), Ap.data());
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int d = 0; d < dim; ++d)
      BOOST_TEST(std::abs(Ap[i][d] - Av[i].v[d]) < 3e-5 * size / double(p.size()));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(sph_drag)

BOOST_DATA_TEST_CASE(friction_is_symmetric_and_keeps_momenta, forms, form) {
  check_friction<2>(form);
  check_friction<3>(form);
}

/// Beside a row of nodes, balanced: symmetric, takes energy, keeps the momenta of particles and nodes
/// together.
BOOST_AUTO_TEST_CASE(a_balanced_wall_keeps_what_friction_has_to_keep) {
  const Drop<2> drop(DragForm::least_squares);
  const std::size_t n = drop.x.size(), nodes = 12, behind = (n + 7) / 8 * 8;
  std::vector<Vector<2>> x = drop.x;
  x.resize(behind, Vector<2>::Zero());
  for (std::size_t k = 0; k < nodes; ++k) x.push_back(Vector<2>(double(k) - 1., -0.3));
  SphDrag<2> drag;
  drag.clear(DragForm::least_squares, 2.);
  for (std::size_t i = 0; i < n; ++i) {
    drag.body();
    const auto weight = [](const Vector<2> &r) { return std::pow(std::max(0., 1. - r.norm() / 2.6), 3); };
    for (std::size_t j = 0; j < n; ++j)
      if (const Vector<2> r = x[j] - x[i]; i != j && weight(r) > 0.)
        drag.pair(std::uint32_t(j), r, weight(r));
    for (std::uint32_t k = 0; k + 1 < nodes; ++k)
      if (const Vector<2> r = 0.5 * (x[behind + k] + x[behind + k + 1]) - x[i]; weight(r) > 0.)
        drag.ray(r, weight(r), k, k + 1, 0.5);
  }
  drag.finish(1, true);
  drag.walls(std::uint32_t(behind), std::uint32_t(nodes));
  const auto noise = [&](const unsigned int seed, const bool of_nodes) {
    std::vector<BodyVector> v(x.size());
    for (std::size_t k = 0; k < v.size(); ++k)
      if (k < n || (of_nodes && k >= behind))
        for (int d = 0; d < 2; ++d) v[k].v[d] = 2. * random_uniform(seed, 2 * k + std::size_t(d)) - 1.;
    return v;
  };
  const auto times = [&](const std::vector<BodyVector> &v) {
    std::vector<BodyVector> product(x.size());
    drag.begin(v.data(), 1);
    drag.add(v.data(), 0, n, product.data());
    return product;
  };
  for (unsigned int seed = 2; seed < 12; seed += 2) {
    const auto u = noise(seed, false), v = noise(seed + 1, false);
    const double power = Drop<2>::dot(v, times(v)), left = Drop<2>::dot(u, times(v));
    BOOST_TEST(power > 0.);
    BOOST_TEST(std::abs(left - Drop<2>::dot(v, times(u))) < 1e-12 * power);
  }
  const auto all = noise(20, true);
  auto force = times(all);
  const std::vector<Vector<2>> on_nodes = drag.on_walls(all.data(), nodes);
  Vector<2> sum = Vector<2>::Zero();
  double torque = 0., size = 0.;
  for (std::size_t k = 0; k < x.size(); ++k) {
    Vector<2> f = Vector<2>::Zero();
    if (k < n) f = -Vector<2>(force[k].v[0], force[k].v[1]);
    if (k >= behind) f = on_nodes[k - behind];
    sum += f;
    torque += x[k][0] * f[1] - x[k][1] * f[0];
    size += f.norm();
  }
  BOOST_TEST(sum.norm() < 1e-13 * size);
  BOOST_TEST(std::abs(torque) < 1e-12 * size);
}

/// Power of the pressures in any flow = V sum p div; affine flow has its exact divergence.
BOOST_AUTO_TEST_CASE(pressure_is_the_adjoint_of_the_divergence) {
  Drop<2> drop(DragForm::least_squares);
  const std::size_t n = drop.x.size();
  std::vector<double> p(n);
  for (std::size_t i = 0; i < n; ++i) p[i] = random_uniform(5, i) - 0.3;
  const auto v = drop.noise(4);
  const std::vector<double> divergence = drop.drag.divergence(v.data());
  std::array<std::vector<double>, 2> f{std::vector<double>(n, 0.), std::vector<double>(n, 0.)};
  std::vector<Vector<2>> nodes;
  drop.drag.push(p, 0.7, f, nodes);
  double power = 0., expected = 0., size = 0.;
  for (std::size_t i = 0; i < n; ++i) {
    power += f[0][i] * v[i].v[0] + f[1][i] * v[i].v[1];
    expected += 0.7 * p[i] * divergence[i];
    size += std::abs(p[i] * divergence[i]);
  }
  BOOST_TEST(std::abs(power - expected) < 1e-12 * size);
  Tensor2<2> L;
  L << 0.3, 0.7, -0.2, 0.5;
  const auto affine = drop.velocities([&](const std::size_t i) { return Vector<2>(L * drop.x[i]); });
  for (const double one : drop.drag.divergence(affine.data())) BOOST_TEST(std::abs(one - 0.8) < 1e-12);
  // an implicit step: A v with stiffness less friction alone is h times the forces that the divergence brings
  std::vector<SphDrag<2>::Stiffness> stiffness(n);
  for (auto &one : stiffness) one.kappa = 3.;
  const auto plain = drop.times(v);
  drop.drag.set_stiffness(stiffness, true);
  const auto stiff = drop.times(v);
  std::vector<double> minus(n);
  for (std::size_t i = 0; i < n; ++i) minus[i] = -3. * divergence[i];
  for (auto &component : f) component.assign(n, 0.);
  drop.drag.push(minus, 2., f, nodes);  // mu V = 2 in the drop
  for (std::size_t i = 0; i < n; ++i)
    for (int d = 0; d < 2; ++d) BOOST_TEST(std::abs(stiff[i].v[d] - plain[i].v[d] + f[d][i]) < 1e-11 * size);
}

BOOST_AUTO_TEST_SUITE_END()
