// Which bound of the law a step of finite elements needs: over all G, not over plane waves (stable_step.h).
#include "tests/macro/tissue_fixture.h"

#include <deal.II/lac/lapack_full_matrix.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(stable_step)

namespace {
struct Largest {
  double form = 0., laplacian = 0.;  // 1/s^2, largest eigenvalue of M^-1 K; of M^-1 L, per Pa
};

using Matrix = dealii::LAPACKFullMatrix<double>;

double largest(Matrix matrix, const std::vector<double> &mass) {
  for (unsigned int i = 0; i < matrix.m(); ++i)
    for (unsigned int j = 0; j < matrix.n(); ++j) matrix(i, j) /= std::sqrt(mass[i] * mass[j]);
  matrix.compute_eigenvalues();
  double found = 0.;
  for (unsigned int i = 0; i < matrix.m(); ++i) found = std::max(found, matrix.eigenvalue(i).real());
  return found;
}

/// All nodes free, F = I. modulus (G + G^T + tr(G) I): the form of a viscous flow as that of an elastic
/// solid, whose largest value over all G is (2 + dim) modulus and over plane waves 3 modulus.
template <int dim>
Largest of_free_block(unsigned int elements, unsigned int degree, const char *locking, double modulus) {
  TissueParameters<dim> p;
  p.size.fill(width);
  p.elements.fill(elements);
  p.degree = degree;
  p.locking = choice_of<Locking>(locking);
  NeoHookeanLaw<dim> law(modulus, modulus, 0., rho);
  const TissueMesh<dim> mesh(p);
  TissueOperator<dim> op(mesh, p, law);
  const std::vector<double> rest(op.size(), 0.);
  BOOST_REQUIRE(op.evaluate(0., 0., rest, rest, true));
  std::vector<double> matrices;
  op.element_stiffness(matrices);
  const unsigned int n = mesh.nodes_per_cell;
  Matrix K(op.size()), L(op.size());
  K = 0.;
  L = 0.;
  for (unsigned int cell = 0; cell < mesh.cells; ++cell)
    for (unsigned int i = 0; i < n * dim; ++i)
      for (unsigned int j = 0; j < n * dim; ++j) {
        const unsigned int a = i / dim, b = j / dim;
        const std::size_t row = std::size_t(mesh.cell_node[cell * n + a]) * dim + i % dim,
                          column = std::size_t(mesh.cell_node[cell * n + b]) * dim + j % dim;
        K(row, column) += matrices[(std::size_t(cell) * n * dim + i) * n * dim + j];
        if (i % dim != j % dim) continue;
        for (unsigned int q = 0; q < mesh.gauss_points; ++q) {
          const dealii::Tensor<1, dim> *gradient = &mesh.gradient[(std::size_t(cell) * mesh.points + q) * n];
          L(row, column) += mesh.gauss_weight[cell * mesh.gauss_points + q] * (gradient[a] * gradient[b]);
        }
      }
  return {largest(K, op.mass()), largest(L, op.mass())};
}
}  // namespace

BOOST_AUTO_TEST_CASE(one_free_element_that_breathes_has_all_that_the_law_resists) {
  for (const char *locking : {"f_bar", "full"}) {
    const Largest flat = of_free_block<2>(1, 1, locking, 3e5), solid = of_free_block<3>(1, 1, locking, 3e5);
    BOOST_TEST(flat.form == 4. * 3e5 * flat.laplacian, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(solid.form == 5. * 3e5 * solid.laplacian, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(no_block_exceeds_the_bound_over_all_changes_of_F) {
  for (const unsigned int elements : {1u, 2u, 4u})
    for (const unsigned int degree : {1u, 2u})
      for (const char *locking : {"f_bar", "full"}) {
        const Largest block = of_free_block<2>(elements, degree, locking, 3e5);
        BOOST_TEST_MESSAGE(elements << " x " << elements << ", degree " << degree << ", " << locking << ": "
                                    << block.form / (3e5 * block.laplacian) << " of 4");
        BOOST_TEST(block.form <= 4. * 3e5 * block.laplacian * (1. + 1e-12));
      }
}

BOOST_AUTO_TEST_SUITE_END()
