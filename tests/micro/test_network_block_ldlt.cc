// Block L D L^T against dense algebra.
#include "micro/solve/block_ldlt.h"

#include <Eigen/Dense>

#include <boost/test/unit_test.hpp>

#include <random>

using namespace turgor;

BOOST_AUTO_TEST_SUITE(block_ldlt)

BOOST_AUTO_TEST_CASE(solves_and_counts_negative_eigenvalues) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1., 1.);
  for (const std::uint32_t n : {1u, 2u, 7u, 40u}) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
      pairs.emplace_back(i, i + 1);
      pairs.emplace_back((7 * i + 3) % n, i);
      pairs.emplace_back(n - 1, i);  // one full row
    }
    BlockLdlt solver;
    solver.analyse(n, pairs);
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    const auto set = [&](const std::uint32_t i, const std::uint32_t j) {
      const BlockLdlt::Place at = solver.place(i, j);
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) {
          double v = number(random);
          if (i == j && a == b) v += i % 5 == 4 ? -8. : 8.;  // indefinite
          if (i == j && a < b) v = A(2 * i + b, 2 * j + a);
          A(2 * i + a, 2 * j + b) = A(2 * j + b, 2 * i + a) = v;
        }
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b)
          solver.values()[at.index][a + 2 * b] =
              at.transposed ? A(2 * i + b, 2 * j + a) : A(2 * i + a, 2 * j + b);
    };
    for (std::uint32_t i = 0; i < n; ++i) set(i, i);
    for (const auto &[i, j] : pairs)
      if (i != j) set(i, j);
    // both triangles of the diagonal blocks
    for (std::uint32_t i = 0; i < n; ++i)
      A(2 * i, 2 * i + 1) = A(2 * i + 1, 2 * i) = solver.values()[solver.place(i, i).index][1] =
          solver.values()[solver.place(i, i).index][2];
    BOOST_TEST((Eigen::MatrixXd(solver.matrix()) - A).norm() == 0.);
    BOOST_TEST(solver.factorise());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> exact(A);
    BOOST_TEST(int(solver.negative_pivots()) == (exact.eigenvalues().array() < 0.).count());
    Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(2 * n, -1., 2.), b = A * x;
    solver.solve(b.data());
    BOOST_TEST((b - x).norm() < 1e-10 * x.norm());
  }
}

BOOST_AUTO_TEST_CASE(singular_is_said) {
  BlockLdlt solver;
  solver.analyse(1, {});
  solver.values()[0] = {1., 1., 1., 1.};
  BOOST_TEST(!solver.factorise());
}

BOOST_AUTO_TEST_SUITE_END()
