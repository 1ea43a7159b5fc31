#include "coupling/point_shares.h"

#include <boost/test/unit_test.hpp>

using turgor::PointShares;

BOOST_AUTO_TEST_SUITE(point_shares)

BOOST_AUTO_TEST_CASE(without_mpi_all_points_are_mine) {
  PointShares shares;
  shares.set_points(5);
  BOOST_TEST(shares.ranks() == 1u);
  BOOST_TEST(shares.mine().size() == 5u);
  std::vector<double> records{1., 2., 3., 4., 5.};
  shares.gather(1, records);
  BOOST_TEST(records == (std::vector<double>{1., 2., 3., 4., 5.}), boost::test_tools::per_element());
  BOOST_TEST(shares.any(true));
  BOOST_TEST(!shares.any(false));
  BOOST_TEST(shares.sum(2.5) == 2.5);
}

BOOST_AUTO_TEST_CASE(imbalance_by_hand) {
  PointShares shares;
  shares.set_points(3);
  BOOST_TEST(shares.imbalance({1., 2., 3.}, {0, 0, 0}) == 1.);  // one rank is always balanced
  BOOST_TEST(shares.imbalance({0., 0., 0.}, {0, 0, 0}) == 1.);
}

BOOST_AUTO_TEST_SUITE_END()
