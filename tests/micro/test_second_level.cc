// The second level of the solver: what it saves, and that it changes nothing.
#include "micro/laws/counter_random.h"
#include "micro/solve/motion_matrix.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;

namespace {
using Places = std::array<std::vector<double>, 3>;

/// Between -1/2 and 1/2.
Places anywhere(const std::size_t n, const unsigned int seed) {
  Places result;
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t i = 0; i < n; ++i) result[d].push_back(random_uniform(seed, 3 * i + d) - 0.5);
  return result;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(second_level)

/// A long row of stiff bodies of eight nodes each, held to their neighbours by three weak rows and a link:
/// the second level takes the way of their rigid motions out of the iterations, and changes nothing of the
/// solution.
BOOST_AUTO_TEST_CASE(a_second_level_saves_iterations_and_keeps_the_solution) {
  constexpr std::uint32_t groups = 40, own = 8;
  Places x = anywhere(groups * own, 3), f = anywhere(groups * own, 4);
  std::vector<std::uint32_t> first;
  for (std::uint32_t group = 0; group <= groups; ++group) first.push_back(group * own);
  for (std::uint32_t i = 0; i < groups * own; ++i) x[0][i] += i / own;
  const auto place = [&](const std::uint32_t i) { return Vector<3>(x[0][i], x[1][i], x[2][i]); };
  const auto line = [&](const std::uint32_t i, const std::uint32_t j) {
    return Vector<3>((place(j) - place(i)).normalized());
  };
  Places v[2];
  unsigned int iterations[2];
  for (const bool with : {false, true}) {
    MotionMatrix matrix({.tolerance = 1e-6, .max_iterations = 20000});
    matrix.clear(groups * own);
    for (double &one : matrix.medium) one = 1e-2;
    for (std::uint32_t group = 0; group < groups; ++group)
      for (std::uint32_t i = group * own; i < (group + 1) * own; ++i)
        for (std::uint32_t j = group * own; j < i; ++j) matrix.link<3>(i, j, line(i, j), 100., 0.);
    for (std::uint32_t group = 0; group + 1 < groups; ++group)
      for (std::uint32_t k = 0; k < 6; ++k) {
        const std::array<std::uint32_t, 2> two{group * own + k, (group + 1) * own + k};
        const Vector<3> e = line(two[0], two[1]);
        if (k == 0)
          matrix.link<3>(two[0], two[1], e, 1., 0.5);
        else
          matrix.row<3>(two, std::array<Vector<3>, 2>{e, -e}, 1.);
      }
    if (with) matrix.second_level(first, x);
    v[with] = Places{std::vector<double>(groups * own), std::vector<double>(groups * own),
                     std::vector<double>(groups * own)};
    matrix.solve<3>(f, v[with], 2);
    iterations[with] = matrix.iterations();
  }
  double most = 0., apart = 0.;
  for (int d = 0; d < 3; ++d)
    for (std::size_t i = 0; i < groups * own; ++i) {
      most = std::max(most, std::abs(v[0][d][i]));
      apart = std::max(apart, std::abs(v[0][d][i] - v[1][d][i]));
    }
  BOOST_TEST(apart < 1e-3 * most);
  BOOST_TEST(3 * iterations[1] < iterations[0]);
}

BOOST_AUTO_TEST_SUITE_END()
