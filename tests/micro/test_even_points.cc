// Points spread evenly in polygons: by hand, equal shares, evenness, bad input.
#include "micro/cells/even_points.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>

using namespace turgor;

namespace {
std::vector<Vector<2>> hexagon(const unsigned int bonds_a_side) {
  std::vector<Vector<2>> ring;
  for (int side = 0; side < 6; ++side) {
    const double a = (side + 0.5) * std::numbers::pi / 3., b = a + std::numbers::pi / 3.;
    const Vector<2> from(std::cos(a), std::sin(a)), to(std::cos(b), std::sin(b));
    for (unsigned int k = 0; k < bonds_a_side; ++k)
      ring.push_back(Vector<2>(from + (to - from) * (double(k) / bonds_a_side)));
  }
  return ring;
}

double nearest(const std::vector<EvenPoint> &points) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, (points[i].at - points[j].at).norm());
  return least;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(even_points_in_polygons)

BOOST_AUTO_TEST_CASE(a_square_by_hand) {
  const std::vector<Vector<2>> square{Vector<2>(1., 1.), Vector<2>(3., 1.), Vector<2>(3., 3.),
                                      Vector<2>(1., 3.)};
  const std::vector<EvenPoint> points = even_points(square, 4);
  BOOST_REQUIRE(points.size() == 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    BOOST_TEST((points[k].at - Vector<2>(1.5 + double(k % 2), 1.5 + double(k / 2))).norm() < 1e-12);
    BOOST_TEST((points[k].size - Vector<2>(1., 1.)).norm() < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(equal_shares_and_even_in_any_shape) {
  // a wedge is the worst of shapes: its tips are thinner than any piece
  const std::vector<Vector<2>> wedge{Vector<2>(0., 0.), Vector<2>(4., 0.), Vector<2>(0., 1.)};
  const double third = 1. / 3.;
  for (const std::size_t count : {1u, 36u, 64u, 196u, 484u})
    for (const bool six : {true, false}) {
      const std::vector<EvenPoint> points = even_points(six ? hexagon(8) : wedge, count);
      BOOST_REQUIRE(points.size() == count);
      // pieces of one area: the mean of their centres is the centre of the whole
      Vector<2> mean = Vector<2>::Zero();
      for (const EvenPoint &point : points) mean += point.at / double(count);
      BOOST_TEST((mean - (six ? Vector<2>(0., 0.) : Vector<2>(4. * third, third))).norm() < 1e-9);
      const double piece = (six ? 1.5 * std::numbers::sqrt3 : 2.) / double(count);
      if (count > 1) BOOST_TEST(nearest(points) > 0.6 * std::sqrt(piece));
      for (const EvenPoint &point : points)
        if (six)
          for (int side = 0; side < 6; ++side)  // inside
            BOOST_TEST(point.at.dot(Vector<2>(std::cos(side * std::numbers::pi / 3.),
                                              std::sin(side * std::numbers::pi / 3.))) < std::sqrt(0.75));
    }
}

BOOST_AUTO_TEST_CASE(a_ring_that_encloses_nothing_is_refused) {
  const std::vector<Vector<2>> clockwise{Vector<2>(0., 0.), Vector<2>(0., 1.), Vector<2>(1., 1.),
                                         Vector<2>(1., 0.)};
  BOOST_CHECK_EXCEPTION(even_points(clockwise, 4), std::runtime_error, [](const auto &error) {
    return std::string(error.what()).find("encloses no area") != std::string::npos;
  });
}

BOOST_AUTO_TEST_SUITE_END()
