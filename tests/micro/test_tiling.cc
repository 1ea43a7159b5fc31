// Tilings of the plane: regular ones by hand, Laguerre's by what every tiling has to have.
#include "micro/geometry/joined_polygons.h"
#include "micro/geometry/laguerre_tiling.h"
#include "micro/geometry/regular_tilings.h"
#include "micro/laws/counter_random.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

using namespace turgor;

namespace {
constexpr double L = 100e-6;

/// Of a periodic tiling without air: sides that face each other end at the same places, V - E + F = 0, areas
/// sum to det H (check).
void require_good(const Tiling &t) {
  t.check();
  const auto facing = t.facing();
  std::size_t sides = 0;
  for (std::size_t c = 0; c < t.cells.size(); ++c)
    for (std::size_t k = 0; k < t.cells[c].size(); ++k, ++sides) {
      const FacingSide &other = facing[c][k];
      BOOST_REQUIRE(other.exists());
      const auto &far = t.cells[other.cell];
      const Vector<2> moved = t.lattice * Vector<2>(other.shift[0], other.shift[1]);
      BOOST_TEST((t.place(t.cells[c][k]) - t.place(far[(other.side + 1) % far.size()]) - moved).norm() <
                 1e-9 * L);
      BOOST_TEST(
          (t.place(t.cells[c][(k + 1) % t.cells[c].size()]) - t.place(far[other.side]) - moved).norm() <
          1e-9 * L);
      const FacingSide &back = facing[other.cell][other.side];
      BOOST_TEST((back.cell == c && back.side == k && back.shift[0] == -other.shift[0] &&
                  back.shift[1] == -other.shift[1]));
    }
  BOOST_TEST(t.vertices.size() + t.cells.size() == sides / 2);  // Euler, on a torus
}

std::vector<Vector<2>> random_seeds(const std::size_t count, const Vector<2> &periods,
                                    const std::uint64_t seed) {
  std::vector<Vector<2>> seeds;
  for (std::size_t i = 0; i < count; ++i)
    seeds.push_back({periods[0] * random_uniform(seed, 2 * i), periods[1] * random_uniform(seed, 2 * i + 1)});
  return seeds;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(tiling)

BOOST_AUTO_TEST_CASE(regular_tilings_have_the_neighbours_one_counts_by_hand) {
  struct Case {
    Tiling cell;
    std::size_t corners;
    double longest, shortest;
  };
  const double edge = L * std::sqrt(2. / (3. * std::sqrt(3.)));
  for (const Case &c : {Case{square_tiling(L), 4, L, L}, Case{brick_tiling(L), 6, L, 0.5 * L},
                        Case{hexagon_tiling(L), 6, edge, edge}})
    for (const auto &[columns, rows] : {std::pair{1u, 1u}, {2u, 2u}, {3u, 2u}, {1u, 5u}, {10u, 10u}}) {
      const Tiling t = replicated(c.cell, columns, rows);
      BOOST_TEST(t.cells.size() == columns * rows);
      require_good(t);
      for (std::size_t cell = 0; cell < t.cells.size(); ++cell) {
        BOOST_TEST(t.cells[cell].size() == c.corners);
        BOOST_TEST(t.area(cell) == L * L, boost::test_tools::tolerance(1e-12));
        double longest = 0., shortest = 1.;
        for (std::size_t k = 0; k < c.corners; ++k) {
          longest = std::max(longest, t.side_length(cell, k));
          shortest = std::min(shortest, t.side_length(cell, k));
        }
        BOOST_TEST(longest == c.longest, boost::test_tools::tolerance(1e-12));
        BOOST_TEST(shortest == c.shortest, boost::test_tools::tolerance(1e-12));
      }
      BOOST_TEST(std::abs(t.lattice(0, 1)) <= 0.5000001 * t.lattice(0, 0));  // as upright as it can be
    }
  // the brick's lower right half side, by hand: on the other side is the cell of the row below, to the right
  const Tiling brick = brick_tiling(L);
  const FacingSide below = brick.facing()[0][1];
  BOOST_TEST((below.cell == 0 && below.side == 4 && below.shift[0] == 1 && below.shift[1] == -1));
}

BOOST_AUTO_TEST_CASE(a_turned_tiling_is_the_same_tiling) {
  const Tiling t = replicated(brick_tiling(L), 2, 3), turned = rotated(t, 0.7);
  require_good(turned);
  BOOST_TEST(turned.lattice.determinant() == t.lattice.determinant(), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::atan2(turned.lattice(1, 0), turned.lattice(0, 0)) == 0.7,
             boost::test_tools::tolerance(1e-12));
  for (std::size_t c = 0; c < t.cells.size(); ++c)
    BOOST_TEST(turned.side_length(c, 2) == t.side_length(c, 2), boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(polygons_one_by_one_are_the_same_tiling) {
  // the corners of bricks alone: that two more lie on their long sides is found
  for (const Tiling &t :
       {replicated(brick_tiling(L), 3, 2), replicated(square_tiling(L), 1, 2), brick_tiling(L)}) {
    std::vector<std::vector<Vector<2>>> polygons;
    for (std::size_t c = 0; c < t.cells.size(); ++c) {
      std::vector<Vector<2>> corners = t.outline(c);
      if (corners.size() == 6) corners = {corners[0], corners[5], corners[3], corners[2]};  // clockwise
      polygons.push_back(corners);
    }
    const Tiling joined = join_polygons(polygons, &t.lattice, 1e-9 * L);
    require_good(joined);
    BOOST_TEST(joined.vertices.size() == t.vertices.size());
    const Tiling piece = join_polygons(polygons, nullptr, 1e-9 * L);
    BOOST_TEST(piece.total_area() == t.total_area(), boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(laguerre_cells_have_the_areas_asked_for) {
  for (const std::size_t count : {1u, 2u, 3u, 4u, 7u, 16u, 36u, 100u})
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      const Vector<2> periods(L * std::ceil(std::sqrt(double(count))),
                              L * double(count) / std::ceil(std::sqrt(double(count))));
      std::vector<double> areas;
      for (std::size_t i = 0; i < count; ++i) areas.push_back(0.6 + 0.8 * random_uniform(seed + 100, i));
      const std::vector<Vector<2>> seeds = random_seeds(count, periods, seed);
      const Tiling t = laguerre_tiling(periods, seeds, areas, 10);
      require_good(t);
      BOOST_TEST(t.cells.size() == count);
      const double sum = std::accumulate(areas.begin(), areas.end(), 0.);
      for (std::size_t c = 0; c < count; ++c)
        BOOST_TEST(t.area(c) == areas[c] / sum * periods.prod(),
                   boost::test_tools::tolerance(1e-5 * sum / areas[c]));
      const Tiling again = laguerre_tiling(periods, seeds, areas, 10);
      BOOST_TEST((again.vertices == t.vertices && again.cells == t.cells));
      const double shortest = 0.1 * L;
      const Tiling merged = without_short_sides(t, shortest);
      require_good(merged);
      BOOST_TEST(merged.vertices.size() <= t.vertices.size());
    }
}

BOOST_AUTO_TEST_CASE(short_sides_become_one_vertex) {
  Tiling hexagons = replicated(hexagon_tiling(L), 2, 2);
  // the upright side between vertices 1 and 0 of neighbouring cells shrinks to a tenth
  const auto facing = hexagons.facing();
  const TilingCorner low = hexagons.cells[0][2], high = hexagons.cells[0][3];
  const Vector<2> middle = 0.5 * (hexagons.place(low) + hexagons.place(high)),
                  half = 0.05 * (hexagons.place(high) - hexagons.place(low));
  hexagons.vertices[low.vertex] += middle - half - hexagons.place(low);
  hexagons.vertices[high.vertex] += middle + half - hexagons.place(high);
  require_good(hexagons);
  const Tiling merged = without_short_sides(hexagons, 0.1 * L);
  require_good(merged);
  BOOST_TEST(merged.vertices.size() == hexagons.vertices.size() - 1);
  BOOST_TEST(merged.cells[0].size() == 5u);
  BOOST_TEST((merged.place(merged.cells[0][2]) - middle).norm() < 1e-9 * L);
}

BOOST_AUTO_TEST_CASE(what_is_no_tiling_gets_a_sentence) {
  const auto complaint = [](const Tiling &t) {
    try {
      t.check();
    } catch (const std::invalid_argument &wrong) {
      return std::string(wrong.what());
    }
    return std::string();
  };
  const auto says = [&](const Tiling &t, const std::string &words) {
    return complaint(t).find(words) != std::string::npos;
  };
  Tiling t = replicated(square_tiling(L), 2, 1);
  BOOST_TEST(complaint(t) == "");
  Tiling wrong = t;
  std::reverse(wrong.cells[1].begin(), wrong.cells[1].end());
  BOOST_TEST(says(wrong, "cell 2 does not run counter-clockwise"));
  wrong = t;
  wrong.cells[0].resize(2);
  BOOST_TEST(says(wrong, "cell 1 has 2 corners"));
  wrong = t;
  wrong.cells[1] = wrong.cells[0];
  BOOST_TEST(says(wrong, "lie on the same side of a wall"));
  wrong = t;
  wrong.cells[0][1] = wrong.cells[0][0];
  BOOST_TEST(says(wrong, "the same corner twice"));
  wrong = t;
  wrong.cells[0][1].vertex = 99;
  BOOST_TEST(says(wrong, "is nowhere"));
  wrong = t;
  wrong.lattice(0, 0) *= -1.;
  BOOST_TEST(says(wrong, "positive area"));
  BOOST_TEST(says(Tiling{}, "there are none"));
  BOOST_CHECK_THROW(without_short_sides(t, 2. * L), std::invalid_argument);
  BOOST_CHECK_THROW(laguerre_tiling({L, L}, {{0., 0.}}, {1., 1.}, 1), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
