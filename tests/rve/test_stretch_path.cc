// The way between two deformation gradients: ends, determinant, length by hand, turns with its end.
#include "rve/stretch_path.h"
#include "tests/rve/matrix.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace turgor;
using turgor::test::matrix;

namespace {
const Tensor2<2> from = matrix(1.1, 0.2, -0.1, 0.9), to = matrix(0.5, 1.2, -0.8, 0.4),
                 Q = matrix(0.8, -0.6, 0.6, 0.8);
}  // namespace

BOOST_AUTO_TEST_SUITE(stretch_path)

BOOST_AUTO_TEST_CASE(ends_at_F_and_its_determinant_goes_geometrically) {
  const StretchPath path(from, to);
  BOOST_TEST((path.at(1.) - to).norm() < 1e-14);
  const double ratio = to.determinant() / from.determinant();
  for (const double s : {0.1, 0.5, 0.9})
    BOOST_TEST(path.at(s).determinant() == from.determinant() * std::pow(ratio, s),
               boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(steps_are_equal_stretches) {
  const StretchPath path(from, to);
  for (int k = 1; k < 5; ++k)
    BOOST_TEST(StretchPath(path.at(0.2 * k), path.at(0.2 * (k + 1))).length() == 0.2 * path.length(),
               boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(turns_with_its_end_and_with_both_ends) {
  for (const double s : {0.25, 0.75}) {
    const Tensor2<2> F = StretchPath(from, to).at(s);
    BOOST_TEST((StretchPath(from, Q * to).at(s) - Q * F).norm() < 1e-14);
    BOOST_TEST((StretchPath(Q * from, Q * to).at(s) - Q * F).norm() < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(length_by_hand) {
  const Tensor2<2> I = Tensor2<2>::Identity();
  BOOST_TEST(StretchPath(I, Q).length() < 1e-15);  // a rotation is no way at all
  BOOST_TEST(StretchPath(I, matrix(0.5, 0., 0., 2.)).length() == std::log(2.),
             boost::test_tools::tolerance(1e-14));
  // simple shear g stretches by g/2 + sqrt(1 + g^2/4)
  BOOST_TEST(StretchPath(I, matrix(1., 0.3, 0., 1.)).length() == std::asinh(0.15),
             boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_SUITE_END()
