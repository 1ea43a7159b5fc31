#include "tests/macro/tissue_fixture.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(f_bar)

namespace {
struct Setting {
  unsigned int degree;
  std::string locking;
};
const std::vector<Setting> settings = {{1, "f_bar"}, {1, "full"}, {2, "f_bar"}, {2, "full"}};

template <int dim>
struct Piece {
  explicit Piece(const Setting &s, double eta = 0.)
      : law(mu, 5e6, eta, rho), mesh(parameters(s)), op(mesh, parameters(s), law) {}
  static TissueParameters<dim> parameters(const Setting &s) {
    TissueParameters<dim> p;
    p.size.fill(width);
    p.size[1] = 0.7 * width;
    p.elements.fill(2);
    p.degree = s.degree;
    p.locking = choice_of<Locking>(s.locking);
    return p;
  }
  double energy(const std::vector<double> &u) {
    BOOST_REQUIRE(op.evaluate(0., 0., u, std::vector<double>(u.size(), 0.)));
    double sum = 0.;
    for (std::size_t q = 0; q < mesh.gauss_weight.size(); ++q)
      sum += mesh.gauss_weight[q] * op.answer().energy[q];
    return sum;
  }
  std::vector<double> forces(const std::vector<double> &u, const std::vector<double> &v) {
    BOOST_REQUIRE(op.evaluate(0., 0., u, v));
    std::vector<double> f;
    op.internal_forces(f);
    return f;
  }

  NeoHookeanLaw<dim> law;
  TissueMesh<dim> mesh;
  TissueOperator<dim> op;
};

double dot(const std::vector<double> &a, const std::vector<double> &b) {
  double sum = 0.;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

template <int dim>
void check_force_is_gradient(const Setting &setting) {
  Piece<dim> piece(setting);
  const std::vector<double> u = wavy(piece.mesh, 0.1 * width, 0.4);
  const std::vector<double> force = piece.forces(u, std::vector<double>(u.size(), 0.));
  const double step = 1e-6 * width, size = std::sqrt(dot(force, force) / static_cast<double>(force.size()));
  for (std::size_t i = 0; i < u.size(); ++i) {
    std::vector<double> plus = u, minus = u;
    plus[i] += step;
    minus[i] -= step;
    const double slope = (piece.energy(plus) - piece.energy(minus)) / (2. * step);
    BOOST_TEST(std::abs(slope - force[i]) < 1e-6 * size, "degree " << setting.degree << ' ' << setting.locking
                                                                   << " entry " << i << ": " << slope
                                                                   << " against " << force[i]);
  }
}
}  // namespace

BOOST_AUTO_TEST_CASE(internal_force_is_the_derivative_of_the_energy) {
  for (const Setting &setting : settings) check_force_is_gradient<2>(setting);
  check_force_is_gradient<3>({1, "f_bar"});
}

BOOST_AUTO_TEST_CASE(rate_is_the_time_derivative_and_power_balances) {
  for (const Setting &setting : settings) {
    Piece<2> piece(setting, 3.);
    const std::vector<double> u = wavy(piece.mesh, 0.1 * width, 0.4), v = wavy(piece.mesh, 1., 2.);
    const double step = 1e-5 * width;
    std::vector<double> plus = u, minus = u;
    for (std::size_t i = 0; i < u.size(); ++i) {
      plus[i] += step * v[i];
      minus[i] -= step * v[i];
    }
    piece.forces(plus, v);
    const auto F_plus = piece.op.F_bar();
    piece.forces(minus, v);
    const auto F_minus = piece.op.F_bar();
    const std::vector<double> force = piece.forces(u, v);
    double power = 0.;
    for (std::size_t q = 0; q < F_plus.size(); ++q)
      power += piece.mesh.gauss_weight[q] *
               dealii::scalar_product(piece.op.answer().P[q], (F_plus[q] - F_minus[q]) / (2. * step));
    BOOST_TEST(dot(force, v) == power, boost::test_tools::tolerance(1e-7));

    // the rate the law saw: viscous stress alone, from its dissipation being twice eta D : D J
    Piece<2> elastic(setting, 0.);
    double dissipation = 0.;
    const std::vector<double> without = elastic.forces(u, v);
    for (std::size_t q = 0; q < F_plus.size(); ++q) {
      const auto &F = piece.op.F_bar()[q];
      const auto L = (F_plus[q] - F_minus[q]) / (2. * step) * dealii::invert(F);
      const auto D = 0.5 * (L + dealii::transpose(L));
      dissipation += piece.mesh.gauss_weight[q] * 2. * 3. * dealii::determinant(F) * D.norm_square();
    }
    BOOST_TEST(dot(force, v) - dot(without, v) == dissipation, boost::test_tools::tolerance(1e-5));
  }
}

BOOST_AUTO_TEST_CASE(stiffness_is_the_derivative_of_the_force) {
  for (const Setting &setting : settings) {
    Piece<2> piece(setting);
    const std::vector<double> u = wavy(piece.mesh, 0.1 * width, 0.4), rest(u.size(), 0.);
    BOOST_REQUIRE(piece.op.evaluate(0., 0., u, rest, true));
    std::vector<double> matrices;
    piece.op.element_stiffness(matrices);
    const std::size_t n = piece.mesh.nodes_per_cell * 2, size = u.size();
    std::vector<double> full(size * size, 0.);
    for (unsigned int cell = 0; cell < piece.mesh.cells; ++cell)
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
          const auto entry = [&](std::size_t k) {
            return piece.mesh.cell_node[cell * piece.mesh.nodes_per_cell + k / 2] * 2 + k % 2;
          };
          full[entry(i) * size + entry(j)] += matrices[(cell * n + i) * n + j];
        }
    double largest = 0.;
    for (const double value : full) largest = std::max(largest, std::abs(value));
    const double step = 1e-6 * width;
    for (std::size_t j = 0; j < size; ++j) {
      std::vector<double> plus = u, minus = u;
      plus[j] += step;
      minus[j] -= step;
      const auto up = piece.forces(plus, rest), down = piece.forces(minus, rest);
      for (std::size_t i = 0; i < size; ++i)
        BOOST_TEST(std::abs((up[i] - down[i]) / (2. * step) - full[i * size + j]) < 1e-6 * largest);
    }
  }
}

BOOST_AUTO_TEST_CASE(patch_test_affine_displacement) {
  for (const Setting &setting : settings) {
    Piece<2> piece(setting);
    dealii::Tensor<2, 2> G;
    G[0][0] = 0.1;
    G[0][1] = 0.25;
    G[1][0] = -0.05;
    G[1][1] = -0.08;
    std::vector<double> u;
    for (const auto &x : piece.mesh.node_position)
      for (unsigned int c = 0; c < 2; ++c) u.push_back(G[c] * dealii::Tensor<1, 2>(x));
    const std::vector<double> force = piece.forces(u, std::vector<double>(u.size(), 0.));
    for (const auto &F : piece.op.F_bar())
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j) BOOST_TEST(std::abs(F[i][j] - G[i][j] - (i == j)) < 1e-13);
    double largest = 0.;
    for (const double f : force) largest = std::max(largest, std::abs(f));
    unsigned int inside = 0;
    for (std::size_t i = 0; i < force.size(); ++i) {
      const auto &x = piece.mesh.node_position[i / 2];
      if (x[0] < 1e-9 || x[0] > width - 1e-9 || x[1] < 1e-9 || x[1] > 0.7 * width - 1e-9) continue;
      ++inside;
      BOOST_TEST(std::abs(force[i]) < 1e-12 * largest);
    }
    BOOST_TEST(inside > 0u);
  }
}

BOOST_AUTO_TEST_CASE(rotated_state_gives_rotated_forces_and_no_net_force_or_torque) {
  for (const Setting &setting : settings) {
    Piece<2> piece(setting, 2.);
    const std::vector<double> u = wavy(piece.mesh, 0.1 * width, 0.4), v = wavy(piece.mesh, 1., 2.);
    const double c = std::cos(0.7), s = std::sin(0.7);
    std::vector<double> turned_u(u.size()), turned_v(u.size());
    const auto &X = piece.mesh.node_position;
    for (std::size_t a = 0; a < X.size(); ++a) {
      const double x = X[a][0] + u[2 * a], y = X[a][1] + u[2 * a + 1];
      turned_u[2 * a] = c * x - s * y - X[a][0];
      turned_u[2 * a + 1] = s * x + c * y - X[a][1];
      turned_v[2 * a] = c * v[2 * a] - s * v[2 * a + 1];
      turned_v[2 * a + 1] = s * v[2 * a] + c * v[2 * a + 1];
    }
    const auto force = piece.forces(u, v), turned = piece.forces(turned_u, turned_v);
    const double size = std::sqrt(dot(force, force));
    double sum_x = 0., sum_y = 0., torque = 0.;
    for (std::size_t a = 0; a < X.size(); ++a) {
      BOOST_TEST(std::abs(turned[2 * a] - (c * force[2 * a] - s * force[2 * a + 1])) < 1e-11 * size);
      BOOST_TEST(std::abs(turned[2 * a + 1] - (s * force[2 * a] + c * force[2 * a + 1])) < 1e-11 * size);
      sum_x += force[2 * a];
      sum_y += force[2 * a + 1];
      torque += (X[a][0] + u[2 * a]) * force[2 * a + 1] - (X[a][1] + u[2 * a + 1]) * force[2 * a];
    }
    BOOST_TEST(std::abs(sum_x) < 1e-12 * size);
    BOOST_TEST(std::abs(sum_y) < 1e-12 * size);
    BOOST_TEST(std::abs(torque) < 1e-12 * size * width);
  }
}

BOOST_AUTO_TEST_CASE(bilinear_volume_change_is_that_of_the_centre) {
  Piece<2> piece({1, "f_bar"});
  piece.forces(wavy(piece.mesh, 0.1 * width, 0.4), std::vector<double>(piece.op.size(), 0.));
  for (unsigned int cell = 0; cell < piece.mesh.cells; ++cell)
    for (unsigned int q = 1; q < 4; ++q)
      BOOST_TEST(dealii::determinant(piece.op.F_bar()[cell * 4 + q]) ==
                     dealii::determinant(piece.op.F_bar()[cell * 4]),
                 boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(inverted_element_is_a_recoverable_failure_with_its_place) {
  Piece<2> piece({1, "f_bar"});
  std::vector<double> u(piece.op.size());
  for (std::size_t i = 0; i < u.size(); i += 2) u[i] = -2. * piece.mesh.node_position[i / 2][0];
  BOOST_TEST(!piece.op.evaluate(0., 0., u, u));
  BOOST_TEST(piece.op.failure().describe().find("turned inside out") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
