// Which points are near: eight at a time against one after another.
#include "micro/geometry/near_points.h"
#include "micro/laws/counter_random.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <vector>

using namespace turgor;

BOOST_AUTO_TEST_SUITE(near_points)

BOOST_AUTO_TEST_CASE(bits_are_those_of_one_point_after_another) {
  std::vector<double> x[3], limit;
  for (unsigned int k = 0; k < 40 + near_block; ++k) {
    for (unsigned int d = 0; d < 3; ++d) x[d].push_back(2. * random_uniform(1, 4 * k + d) - 1.);
    limit.push_back(random_uniform(1, 4 * k + 3));
  }
  const double at[3] = {0.1, -0.2, 0.05};
  for (std::uint32_t k = 0; k < 40; ++k) {
    unsigned int one = 0, each = 0;
    for (unsigned int l = 0; l < near_block; ++l) {
      double r2 = 0.;
      for (int d = 0; d < 3; ++d) r2 += (x[d][k + l] - at[d]) * (x[d][k + l] - at[d]);
      one |= unsigned(r2 < 0.6) << l;
      each |= unsigned(r2 < limit[k + l]) << l;
    }
    const std::array<const double *, 3> all = {x[0].data(), x[1].data(), x[2].data()};
    BOOST_TEST(near_bits<3>(all, k, at, [](std::uint32_t) {
                 return FourNumbers{0.6, 0.6, 0.6, 0.6};
               }) == one);
    BOOST_TEST(near_bits<3>(all, k, at, [&](const std::uint32_t j) { return four_numbers(&limit[j]); }) ==
               each);
  }
}

BOOST_AUTO_TEST_CASE(numbers_whose_bit_is_set_are_kept_in_order) {
  const std::uint16_t from[8] = {7, 65535, 256, 255, 1, 40000, 3, 0};
  const std::uint32_t wide[8] = {7, 2147483647, 65536, 255, 1, 40000, 3, 0};
  for (unsigned int bits = 0; bits < 256; ++bits) {
    std::vector<std::uint16_t> expected;
    for (unsigned int l = 0; l < 8; ++l)
      if (bits >> l & 1) expected.push_back(from[l]);
    std::uint16_t to[8];
    const unsigned int kept = keep_numbers(from, bits, to);
    BOOST_TEST(std::vector<std::uint16_t>(to, to + kept) == expected, boost::test_tools::per_element());
    std::uint32_t wide_to[8];
    BOOST_REQUIRE(keep_numbers(wide, bits, wide_to) == kept);
    for (unsigned int l = 0, k = 0; l < 8; ++l)
      if (bits >> l & 1) BOOST_TEST(wide_to[k++] == wide[l]);
  }
}

BOOST_AUTO_TEST_CASE(few_numbers_are_sorted) {
  for (unsigned int count = 0; count < 25; ++count)
    for (unsigned int trial = 0; trial < 20; ++trial) {
      std::vector<std::uint32_t> numbers;
      while (numbers.size() < count) {
        const auto one =
            std::uint32_t(2147483647. * random_uniform(trial, 100 * count + unsigned(numbers.size())));
        numbers.push_back(numbers.empty() ? 0 : one);  // nought is one of them
      }
      std::vector<std::uint32_t> expected = numbers;
      std::sort(expected.begin(), expected.end());
      sort_few(numbers.data(), numbers.size());
      BOOST_TEST(numbers == expected, boost::test_tools::per_element());
    }
}

BOOST_AUTO_TEST_SUITE_END()
