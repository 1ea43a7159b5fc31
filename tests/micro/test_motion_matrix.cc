// The matrix of motion: links, rows, whole cells and bodies of given velocity against dense solutions in 2D
// and 3D, what it conserves, what costs nothing, clusters in a weak medium.
#include "micro/laws/counter_random.h"
#include "micro/solve/motion_matrix.h"

#include <boost/test/unit_test.hpp>

#include <Eigen/Dense>

#include <numeric>

using namespace turgor;

namespace {
double number(const std::uint64_t k, const unsigned int seed) { return random_uniform(seed, k) - 0.5; }

template <int dim>
Vector<dim> arrow(const std::uint64_t k, const unsigned int seed) {
  Vector<dim> a;
  for (int d = 0; d < dim; ++d) a[d] = number(dim * k + std::uint64_t(d), seed);
  return a;
}

template <int dim>
using Components = std::array<std::vector<double>, dim>;

template <int dim>
Components<dim> components(const std::size_t n, const unsigned int seed, const double size) {
  Components<dim> result;
  for (int d = 0; d < dim; ++d)
    for (std::size_t i = 0; i < n; ++i) result[d].push_back(size * number(dim * i + std::size_t(d), seed));
  return result;
}

/// The same matrix twice: dense, with rows and columns of bodies of given velocity behind the others, and as
/// it is solved.
template <int dim>
struct Both {
  std::uint32_t n;
  MotionMatrix matrix{{.tolerance = 1e-11}};
  Eigen::MatrixXd A;
  Eigen::VectorXd given;                   ///< m/s
  std::vector<std::uint32_t> place_given;  ///< index in the matrix of motion

  Both(const std::uint32_t n_, const std::vector<Vector<dim>> &given_, const double medium)
      : n(n_),
        A(Eigen::MatrixXd::Zero(dim * Eigen::Index(n_ + given_.size()),
                                dim * Eigen::Index(n_ + given_.size()))),
        given(dim * Eigen::Index(given_.size())) {
    matrix.clear(n);
    for (std::uint32_t i = 0; i < n; ++i) {
      matrix.medium[i] = medium * (1. + random_uniform(1, i));
      for (int d = 0; d < dim; ++d) A(dim * i + d, dim * i + d) = matrix.medium[i];
    }
    for (std::size_t k = 0; k < given_.size(); ++k) {
      place_given.push_back(matrix.given<dim>(given_[k]));
      given.segment<dim>(dim * Eigen::Index(k)) = given_[k];
    }
  }
  std::uint32_t place(const std::uint32_t i) const { return i < n ? i : place_given[i - n]; }

  void link(const std::uint32_t i, const std::uint32_t j, const Vector<dim> &e, const double normal,
            const double tangential) {
    matrix.link<dim>(i, place(j), e, normal, tangential);
    const Tensor2<dim> ee = e * e.transpose(),
                       block = normal * ee + tangential * (Tensor2<dim>::Identity() - ee);
    for (const auto &[a, b, sign] :
         {std::tuple(i, i, 1.), std::tuple(j, j, 1.), std::tuple(i, j, -1.), std::tuple(j, i, -1.)})
      A.template block<dim, dim>(dim * a, dim * b) += sign * block;
  }
  void row(const std::vector<std::uint32_t> &bodies, const std::vector<Vector<dim>> &g, const double c) {
    std::vector<std::uint32_t> places;
    for (const std::uint32_t i : bodies) places.push_back(place(i));
    matrix.row<dim>(places, g, c);
    dense_row(bodies, g, c);
  }
  void whole(const std::uint32_t first, const std::vector<Vector<dim>> &g, const double c) {
    matrix.whole<dim>(first, g, c);
    std::vector<std::uint32_t> bodies(g.size());
    std::iota(bodies.begin(), bodies.end(), first);
    dense_row(bodies, g, c);
  }
  Eigen::VectorXd exact(const Components<dim> &f) const {
    const Eigen::Index moving = dim * n;
    Eigen::VectorXd F(moving);
    for (std::uint32_t i = 0; i < n; ++i)
      for (int d = 0; d < dim; ++d) F[dim * i + d] = f[d][i];
    return A.topLeftCorner(moving, moving).ldlt().solve(F - A.topRightCorner(moving, given.size()) * given);
  }

 private:
  void dense_row(const std::vector<std::uint32_t> &bodies, const std::vector<Vector<dim>> &g,
                 const double c) {
    for (std::size_t a = 0; a < bodies.size(); ++a)
      for (std::size_t b = 0; b < bodies.size(); ++b)
        A.template block<dim, dim>(dim * bodies[a], dim * bodies[b]) += c * g[a] * g[b].transpose();
  }
};

/// Vectors whose sum is zero: a common velocity costs nothing.
template <int dim>
std::vector<Vector<dim>> balanced(const std::size_t count, const std::uint64_t k, const unsigned int seed) {
  std::vector<Vector<dim>> g(count);
  Vector<dim> sum = Vector<dim>::Zero();
  for (std::size_t a = 0; a + 1 < count; ++a) sum += g[a] = arrow<dim>(3000 * k + a, seed);
  g.back() = -sum;
  return g;
}

/// Links, rows of two to seven bodies (among them ones that cost a common velocity something), two whole
/// cells that share a row.
template <int dim>
void fill(Both<dim> &both, const bool with_given) {
  const std::uint32_t n = both.n;
  const auto any = [&](const std::uint64_t k) {
    return std::min(std::uint32_t(random_uniform(2, k) * n), n - 1);
  };
  for (std::uint32_t k = 0; k < 3 * n; ++k)
    if (const std::uint32_t i = any(2 * k), j = any(2 * k + 1); i != j)
      both.link(i, j, arrow<dim>(k, 3).normalized(), random_uniform(4, 2 * k), random_uniform(4, 2 * k + 1));
  for (std::uint32_t k = 0; k < 2 * n; ++k) {
    const std::size_t count = 2 + k % 6;
    std::vector<std::uint32_t> bodies;
    for (std::uint64_t a = 0; bodies.size() < count; ++a)
      if (const std::uint32_t i = any(100000 + 100 * k + a);
          std::find(bodies.begin(), bodies.end(), i) == bodies.end())
        bodies.push_back(i);
    if (with_given && k % 7 == 0) bodies.back() = n + k % 2;
    std::vector<Vector<dim>> g = balanced<dim>(count, k, 5);
    if (k % 5 == 0) g[0] += arrow<dim>(k, 6);
    both.row(bodies, g, 2. * random_uniform(7, k));
  }
  both.whole(0, balanced<dim>(n / 3, 1000, 8), 3.);
  both.whole(n / 3, balanced<dim>(n / 3, 2000, 8), 20.);
  if (with_given)
    for (std::uint32_t k = 0; k < 10; ++k)
      both.link(any(k), n + k % 2, arrow<dim>(k, 9).normalized(), 1., 0.3);
}

template <int dim>
double difference(const Components<dim> &v, const Eigen::VectorXd &exact) {
  double sum = 0.;
  for (std::size_t i = 0; i < v[0].size(); ++i)
    for (int d = 0; d < dim; ++d) sum += std::pow(v[d][i] - exact[dim * Eigen::Index(i) + d], 2);
  return std::sqrt(sum) / exact.norm();
}

template <int dim>
void agrees_with_a_dense_solution() {
  for (const bool with_given : {false, true}) {
    const std::uint32_t n = 93;  // no multiple of eight
    Both<dim> both(n,
                   with_given ? std::vector<Vector<dim>>{arrow<dim>(1, 20), arrow<dim>(2, 20)}
                              : std::vector<Vector<dim>>(),
                   0.1);
    fill(both, with_given);
    const Components<dim> f = components<dim>(n, 10, 1.);
    Components<dim> v = components<dim>(n, 11, 0.1);
    both.matrix.template solve<dim>(f, v, 1);
    BOOST_TEST(both.matrix.iterations() > 0u);
    BOOST_CHECK_SMALL(difference<dim>(v, both.exact(f)),
                      1e-8);  // residual 1e-11 times the condition, some hundreds
    const Components<dim> other = components<dim>(n, 12, 3.);
    both.matrix.template again<dim>(other, v, 2);
    BOOST_CHECK_SMALL(difference<dim>(v, both.exact(other)), 1e-8);
  }
}

/// What velocities cost, before anything is solved and afterwards.
template <int dim>
void power_is_that_of_the_dense_matrix() {
  for (const bool with_given : {false, true}) {
    const std::uint32_t n = 93;
    Both<dim> both(n,
                   with_given ? std::vector<Vector<dim>>{arrow<dim>(1, 20), arrow<dim>(2, 20)}
                              : std::vector<Vector<dim>>(),
                   0.1);
    fill(both, with_given);
    const Components<dim> velocity = components<dim>(n, 14, 1.);
    Eigen::VectorXd v = Eigen::VectorXd::Zero(both.A.rows()), pushed = v;
    for (std::uint32_t i = 0; i < n; ++i)
      for (int d = 0; d < dim; ++d) v[dim * i + d] = velocity[d][i];
    v.tail(both.given.size()) = pushed.tail(both.given.size()) = both.given;
    const Eigen::VectorXd product = both.A * v;
    for (const unsigned int threads : {1u, 2u}) {
      const Power power = both.matrix.template power<dim>(velocity, threads);
      BOOST_TEST(power.lost == v.dot(product), boost::test_tools::tolerance(1e-11));
      BOOST_CHECK_SMALL(power.given - both.given.dot(product.tail(both.given.size())), 1e-11 * power.lost);
      BOOST_CHECK_SMALL(power.pushed + (both.A * pushed).head(dim * n).dot(v.head(dim * n)),
                        1e-11 * power.lost);
      Components<dim> solution = velocity;
      both.matrix.template solve<dim>(components<dim>(n, 10, 1.), solution, threads);
      BOOST_CHECK_SMALL(difference<dim>(solution, both.exact(components<dim>(n, 10, 1.))), 1e-8);
    }
  }
}

template <int dim>
void inverse_is_symmetric_and_positive() {
  const std::uint32_t n = 12;
  Both<dim> both(n, {}, 0.1);
  fill(both, false);
  Components<dim> zero, v;
  for (int d = 0; d < dim; ++d) zero[d].assign(n, 0.);
  v = zero;
  Eigen::MatrixXd inverse(dim * n, dim * n);
  both.matrix.template solve<dim>(components<dim>(n, 13, 1.), v, 1);
  for (std::uint32_t i = 0; i < n; ++i)
    for (int d = 0; d < dim; ++d) {
      Components<dim> f = zero;
      f[d][i] = 1.;
      v = zero;
      both.matrix.template again<dim>(f, v, 1);
      for (std::uint32_t j = 0; j < n; ++j)
        for (int e = 0; e < dim; ++e) inverse(dim * j + e, dim * i + d) = v[e][j];
    }
  BOOST_CHECK_SMALL((inverse - inverse.transpose()).norm() / inverse.norm(), 1e-8);
  BOOST_TEST(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(inverse).eigenvalues()[0] > 0.);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(motion_matrix)

BOOST_AUTO_TEST_CASE(agrees_with_a_dense_solution_in_2d) { agrees_with_a_dense_solution<2>(); }
BOOST_AUTO_TEST_CASE(agrees_with_a_dense_solution_in_3d) { agrees_with_a_dense_solution<3>(); }
BOOST_AUTO_TEST_CASE(power_in_2d) { power_is_that_of_the_dense_matrix<2>(); }
BOOST_AUTO_TEST_CASE(power_in_3d) { power_is_that_of_the_dense_matrix<3>(); }
BOOST_AUTO_TEST_CASE(is_symmetric_and_positive_in_2d) { inverse_is_symmetric_and_positive<2>(); }
BOOST_AUTO_TEST_CASE(is_symmetric_and_positive_in_3d) { inverse_is_symmetric_and_positive<3>(); }

// A body in a medium that a wall drags along, by hand: (medium + normal) v = F + normal V along the link,
// tangential across.
BOOST_AUTO_TEST_CASE(a_body_of_given_velocity_drags) {
  MotionMatrix matrix({.tolerance = 1e-12});
  matrix.clear(1);
  matrix.medium[0] = 2.;
  const std::uint32_t wall = matrix.given<3>(Vector<3>(1., 4., 0.));
  matrix.link<3>(0, wall, Vector<3>::UnitX(), 3., 0.5);
  Components<3> f, v;
  for (int d = 0; d < 3; ++d) {
    f[d] = {0.};
    v[d] = {7.};
  }
  matrix.solve<3>(f, v, 1);
  BOOST_TEST(v[0][0] == 3. / 5., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(v[1][0] == 2. / 2.5, boost::test_tools::tolerance(1e-12));
  BOOST_CHECK_SMALL(v[2][0], 1e-12);
}

// What bodies exchange they do not lose: sum medium v = sum F, with links and rows up to 1e6 times the
// medium.
BOOST_AUTO_TEST_CASE(momentum_is_exchanged) {
  const std::uint32_t n = 300;
  MotionMatrix matrix({.tolerance = 1e-9, .max_iterations = 20000});
  matrix.clear(n);
  matrix.medium.assign(n, 1e-4);
  const Components<3> x = components<3>(n, 30, 1.), f = components<3>(n, 31, 1.);
  matrix.correct_clusters<3>(x);
  for (std::uint32_t i = 0; i + 4 < n; ++i) {
    matrix.link<3>(i, i + 1, arrow<3>(i, 32).normalized(), 100. * random_uniform(33, i), 1.);
    matrix.row<3>(std::vector<std::uint32_t>{i, i + 4, i + 2, i + 3}, balanced<3>(4, i, 34), 10.);
  }
  matrix.whole<3>(0, balanced<3>(n, 1000, 35), 1.);
  Components<3> v = components<3>(n, 36, 0.);
  matrix.solve<3>(f, v, 1);
  for (int d = 0; d < 3; ++d) {
    double drag = 0., forces = 0., size = 0.;
    for (std::uint32_t i = 0; i < n; ++i) {
      drag += matrix.medium[i] * v[d][i];
      forces += f[d][i];
      size += std::abs(f[d][i]);
    }
    BOOST_CHECK_SMALL(drag - forces, 1e-10 * size);
  }
}

// Rows of a hinge-like four-body angle, of a triangle's area and of a body that slides on a facet with the
// facet's spin (v_q - sum b_k v_k - w x d) cost a rigid motion nothing, however stiff.
BOOST_AUTO_TEST_CASE(a_rigid_motion_costs_nothing) {
  const std::uint32_t n = 40;
  MotionMatrix matrix({.tolerance = 1e-9, .max_iterations = 20000});
  matrix.clear(n);
  matrix.medium.assign(n, 1.);
  const Components<3> x = components<3>(n, 40, 1.);
  const auto at = [&](const std::uint32_t i) { return Vector<3>(x[0][i], x[1][i], x[2][i]); };
  double moved_by_rows = 0.;
  for (std::uint32_t q = 0; q + 3 < n; ++q) {
    const std::array<std::uint32_t, 4> body{q, q + 1, q + 2, q + 3};
    const Vector<3> x1 = at(q + 1), x2 = at(q + 2), x3 = at(q + 3), normal = (x2 - x1).cross(x3 - x1),
                    nf = normal.normalized();
    const double twice = normal.norm();
    if (twice < 0.1)  // a sliver: gradients without bounds
      continue;
    const std::array<Vector<3>, 3> grad{nf.cross(x3 - x2) / twice, nf.cross(x1 - x3) / twice,
                                        nf.cross(x2 - x1) / twice};
    // a point of the facet with a body above it, as close as it may be
    const std::array<double, 3> b{0.2, 0.3, 0.5};
    const Vector<3> d = at(q) - (b[0] * x1 + b[1] * x2 + b[2] * x3);
    for (int axis = 0; axis < 3; ++axis) {
      const Vector<3> f = Vector<3>::Unit(axis), u = nf.dot(d) * f - f.dot(nf) * d;
      const double t = 0.5 * f.dot(nf.cross(d));
      std::array<Vector<3>, 4> g{f};
      for (std::size_t k = 0; k < 3; ++k)
        g[k + 1] = -(b[k] * f - grad[k].dot(u) * nf + t * nf.cross(grad[k]));
      matrix.row<3>(body, g, 1e4);
      moved_by_rows += g[1].norm();
    }
    const std::array<Vector<3>, 3> area{0.5 * nf.cross(x3 - x2), 0.5 * nf.cross(x1 - x3),
                                        0.5 * nf.cross(x2 - x1)};
    matrix.row<3>(std::span(body).subspan(1), area, 1e4);
  }
  BOOST_TEST(moved_by_rows > 1.);
  const Vector<3> speed(1., -2., 0.5), spin(0.3, 0.7, -1.1);
  Components<3> f, v;
  for (int d = 0; d < 3; ++d)
    for (std::uint32_t i = 0; i < n; ++i) {
      f[d].push_back((speed + spin.cross(at(i)))[d]);
      v[d].push_back(0.);
    }
  matrix.solve<3>(f, v, 1);  // the medium alone has to be overcome
  for (int d = 0; d < 3; ++d)
    for (std::uint32_t i = 0; i < n; ++i) BOOST_CHECK_SMALL(v[d][i] - f[d][i], 1e-8);
}

// Several chunks of bodies and of rows.
BOOST_AUTO_TEST_CASE(same_bits_on_any_number_of_threads) {
  const std::uint32_t n = 2900;
  std::array<Components<3>, 3> ends;
  for (const unsigned int threads : {1u, 2u, 3u}) {
    MotionMatrix matrix({});
    matrix.clear(n);
    matrix.medium.assign(n, 0.1);
    const std::uint32_t wall = matrix.given<3>(Vector<3>(1., 0., 0.));
    const Components<3> x = components<3>(n, 50, 1.);
    matrix.correct_clusters<3>(x);
    for (std::uint32_t i = 0; i + 7 < n; ++i) {
      matrix.link<3>(i, i % 90 == 0 ? wall : i + 7, arrow<3>(i, 51).normalized(), 1., 0.2);
      matrix.row<3>(std::vector<std::uint32_t>{i, i + 5, i + 3}, balanced<3>(3, i, 52), 1.);
    }
    matrix.whole<3>(100, balanced<3>(700, 1, 53), 1.);
    Components<3> v = components<3>(n, 54, 0.1);
    matrix.solve<3>(components<3>(n, 55, 1.), v, threads);
    BOOST_TEST(matrix.iterations() > 0u);
    ends[threads - 1] = v;
  }
  BOOST_CHECK(ends[0] == ends[1]);
  BOOST_CHECK(ends[0] == ends[2]);
}

namespace {
/// Two chains of bodies that central links and rows hold together, and one body alone, in a medium 1e8 times
/// weaker: every cluster moves and turns as its net force and torque say.
template <int dim>
void clusters_move_as_their_net_force_says() {
  const std::uint32_t n = 81, half = 40;
  constexpr double gamma = 1e-8;
  MotionMatrix matrix({.tolerance = 1e-5});
  matrix.clear(n);
  matrix.medium.assign(n, gamma);
  const Components<dim> x = components<dim>(n, 60, 1.), f = components<dim>(n, 61, 1.);
  const auto at = [&](const Components<dim> &a, const std::uint32_t i) {
    Vector<dim> result;
    for (int d = 0; d < dim; ++d) result[d] = a[d][i];
    return result;
  };
  matrix.template correct_clusters<dim>(x);
  for (const std::uint32_t first : {0u, half})
    for (std::uint32_t i = first; i + 1 < first + half; ++i)
      for (std::uint32_t j = i + 1; j < std::min(first + half, i + 5); ++j) {
        const Vector<dim> e = (at(x, i) - at(x, j)).normalized();
        if (j % 2 == 0)
          matrix.template link<dim>(i, j, e, 1., 0.);
        else
          matrix.template row<dim>(std::vector<std::uint32_t>{i, j}, std::vector<Vector<dim>>{e, -e}, 1.);
      }
  Components<dim> v = components<dim>(n, 62, 1.);
  matrix.template solve<dim>(f, v, 1);
  const auto net = [&](const std::uint32_t begin, const std::uint32_t end, const Components<dim> &a,
                       const double scale) {
    Vector<dim> force = Vector<dim>::Zero();
    Vector<3> torque = Vector<3>::Zero();  // about the origin
    for (std::uint32_t i = begin; i < end; ++i) {
      Vector<3> arm = Vector<3>::Zero(), push = Vector<3>::Zero();
      arm.head<dim>() = at(x, i);
      push.head<dim>() = scale * at(a, i);
      force += scale * at(a, i);
      torque += arm.cross(push);
    }
    return std::pair(force, torque);
  };
  for (const auto &[begin, end] : {std::pair(0u, half), std::pair(half, 2 * half), std::pair(2 * half, n)}) {
    const auto [force, torque] = net(begin, end, f, 1.);
    const auto [drag, turn] = net(begin, end, v, gamma);
    BOOST_CHECK_SMALL((drag - force).norm() / force.norm(), 1e-6);
    BOOST_CHECK_SMALL((turn - torque).norm() / std::max(torque.norm(), 1e-3), 1e-6);
  }
}

/// Links of a list that multiplies by itself.
class OwnLinks final : public OwnProduct {
 public:
  struct Pair {
    std::uint32_t i, j;
    double drag;
  };
  std::vector<Pair> pairs;

  void add(const FloatRow *p, std::size_t begin, std::size_t end, FloatRow *product) const override {
    for_ends(begin, end, [&](const std::uint32_t i, const std::uint32_t j, const double drag) {
      product[i - begin] += float(drag) * (p[i] - p[j]);
    });
  }
  void add(const BodyVector *v, std::size_t begin, std::size_t end, BodyVector *product) const override {
    for_ends(begin, end, [&](const std::uint32_t i, const std::uint32_t j, const double drag) {
      product[i - begin].v += drag * (v[i].v - v[j].v);
    });
  }
  void add_blocks(std::size_t begin, std::size_t end, Block *blocks) const override {
    for_ends(begin, end, [&](const std::uint32_t i, std::uint32_t, const double drag) {
      blocks[i - begin].xx += drag;
      blocks[i - begin].yy += drag;
      blocks[i - begin].zz += drag;
    });
  }
  void connect(const std::function<void(std::uint32_t, std::uint32_t)> &join) const override {
    for (const Pair &pair : pairs) join(pair.i, pair.j);
  }

 private:
  template <class Body>
  void for_ends(const std::size_t begin, const std::size_t end, const Body &body) const {
    for (const Pair &pair : pairs) {
      if (pair.i >= begin && pair.i < end) body(pair.i, pair.j, pair.drag);
      if (pair.j >= begin && pair.j < end) body(pair.j, pair.i, pair.drag);
    }
  }
};
}  // namespace

BOOST_AUTO_TEST_CASE(clusters_in_a_weak_medium_in_2d) { clusters_move_as_their_net_force_says<2>(); }
BOOST_AUTO_TEST_CASE(clusters_in_a_weak_medium_in_3d) { clusters_move_as_their_net_force_says<3>(); }

BOOST_AUTO_TEST_CASE(a_term_that_multiplies_by_itself_is_as_links_that_are_pushed) {
  const std::uint32_t n = 600;
  const Components<3> f = components<3>(n, 70, 1.);
  Components<3> v[2];
  for (const bool own : {false, true}) {
    MotionMatrix matrix({.tolerance = 1e-10});
    matrix.clear(n);
    matrix.medium.assign(n, 0.1);
    OwnLinks links;
    for (std::uint32_t i = 0; i + 9 < n; ++i)
      for (const std::uint32_t j : {i + 1, i + 9})
        if (const double drag = random_uniform(71, 2 * i + (j == i + 1)); own)
          links.pairs.push_back({i, j, drag});
        else
          matrix.link<3>(i, j, Vector<3>::UnitX(), drag, drag);
    if (own) matrix.add(links);
    v[own] = components<3>(n, 72, 0.);
    matrix.solve<3>(f, v[own], 2);
    BOOST_TEST(matrix.iterations() > 0u);
  }
  double worst = 0., size = 0.;
  for (int d = 0; d < 3; ++d)
    for (std::uint32_t i = 0; i < n; ++i) {
      worst = std::max(worst, std::abs(v[0][d][i] - v[1][d][i]));
      size = std::max(size, std::abs(v[0][d][i]));
    }
  BOOST_CHECK_SMALL(worst, 1e-7 * size);
}

BOOST_AUTO_TEST_SUITE_END()
