// Pairs of spheres by bins against all pairs looked at one by one, whatever the number of threads, and the
// list that is made of them: its order and each sphere's own pairs.
#include "micro/engine/pair_list.h"
#include "micro/laws/counter_random.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <utility>

using namespace turgor;

namespace {
template <int dim>
Particles<dim> spheres(const std::size_t n, const double side) {
  Particles<dim> p;
  p.resize(n);
  p.declare("radius");
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t d = 0; d < dim; ++d) p.x[d][i] = side * random_uniform(5, 4 * i + d);
    p.field("radius")[i] = 0.5 + 0.5 * random_uniform(5, 4 * i + 3);
  }
  if (n > 10) p.x[0][7] += 1e3 * side;  // far away from all others, and beyond the last bin
  return p;
}

typedef std::vector<std::pair<std::uint32_t, std::uint32_t>> Pairs;

template <int dim>
void check(const std::size_t n, const double side) {
  constexpr double skin = 0.3;
  const Particles<dim> p = spheres<dim>(n, side);
  const std::vector<double> &radius = p.field("radius");
  Pairs expected;
  std::vector<std::vector<std::uint32_t>> neighbours(n);
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j)
      if (i != j && (p.position(i) - p.position(j)).norm() < radius[i] + radius[j] + skin) {
        neighbours[i].push_back(j);
        if (i < j) expected.push_back({i, j});
      }
  for (const unsigned int threads : {1u, 2u}) {
    PairList<dim> list(skin);
    std::vector<unsigned char> touching;
    list.build(p, radius, touching, threads);
    Pairs pairs;
    for (const Pair &pair : list.pairs()) pairs.push_back({pair.i, pair.j});
    BOOST_TEST((pairs == expected));
    for (std::uint32_t i = 0; i < n; ++i) {
      const auto other = list.other().begin();
      BOOST_REQUIRE(std::equal(other + list.first()[i], other + list.first()[i + 1], neighbours[i].begin(),
                               neighbours[i].end()));
      for (std::uint32_t k = list.first()[i]; k < list.first()[i + 1]; ++k)
        BOOST_REQUIRE((pairs[list.own()[k]] == std::minmax({i, list.other()[k]})));
    }
  }
}
}  // namespace

BOOST_AUTO_TEST_SUITE(pair_search)

BOOST_AUTO_TEST_CASE(every_pair_is_found_once_and_in_order) {
  for (const std::size_t n : {0, 1, 2, 3, 9, 40}) {
    check<2>(n, 3.);
    check<3>(n, 2.);
  }
  check<2>(700, 30.);
  check<3>(1500, 15.);
  check<3>(300, 2.);  // all in a few bins, with many more than a block of neighbours
}

BOOST_AUTO_TEST_SUITE_END()
