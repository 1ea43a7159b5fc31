// A layout of cells that are not alike: rings, ties across the periods, masses; what is impossible is named.
#include "tests/micro/unlike_cells.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>

using namespace turgor;

BOOST_AUTO_TEST_SUITE(cell_layout)

BOOST_AUTO_TEST_CASE(rings_of_their_own_sizes_fill_the_lattice_and_are_tied_across_it)
{
  const CellLayout layout = test::unlike_cells();
  layout.check();
  std::set<std::uint32_t> sizes;
  double area = 0.;
  for (const WallRing &ring : layout.rings)
    {
      sizes.insert(ring.count);
      for (std::size_t i = ring.first; i < ring.end(); ++i)
        {
          const Vector<2> a = layout.nodes[i], b = layout.nodes[ring.after(i)];
          area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
          BOOST_TEST(ring.before(ring.after(i)) == i);
        }
    }
  BOOST_TEST(sizes.size() > 2u); // unlike
  BOOST_TEST(area == layout.lattice.determinant(), boost::test_tools::tolerance(1e-12));
  // every side has a facing one: a tie for every two nodes, and one more for every side
  const std::size_t sides = 30;
  BOOST_TEST(layout.ties.size() == (layout.nodes.size() + sides) / 2);
  std::vector<int> tied(layout.nodes.size(), 0);
  for (const LamellaTie &tie : layout.ties)
    {
      BOOST_TEST(LamellaSpring::gap(layout.nodes[tie.a], layout.nodes[tie.b], tie.shift, layout.lattice).norm() < 1e-12 * layout.spacing);
      ++tied[tie.a];
      ++tied[tie.b];
    }
  BOOST_TEST(std::count(tied.begin(), tied.end(), 2) == int(sides)); // corners
  BOOST_TEST(std::count(tied.begin(), tied.end(), 1) == int(layout.nodes.size() - sides));
}

BOOST_AUTO_TEST_CASE(masses_add_up)
{
  const CellLayout layout = test::unlike_cells();
  double walls = 0.;
  for (std::size_t c = 0; c < layout.cells(); ++c)
    walls += layout.wall_mass(c);
  BOOST_TEST(layout.total_wall_mass() == walls, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(layout.total_fluid_mass() == std::accumulate(layout.fluid_mass.begin(), layout.fluid_mass.end(), 0.), boost::test_tools::tolerance(1e-14));
  CellLayout alike = layout;
  alike.node_mass.assign(layout.nodes.size(), 0.1);
  BOOST_TEST(alike.total_wall_mass() == 0.1 * double(layout.nodes.size())); // to the last bit, whatever the number
}

BOOST_AUTO_TEST_CASE(impossible_layouts_are_named)
{
  const auto wrong = [](const auto &change) {
    CellLayout layout = test::unlike_cells();
    change(layout);
    BOOST_CHECK_THROW(layout.check(), std::invalid_argument);
  };
  wrong([](CellLayout &l) { l.periodic = {true, false}; });
  wrong([](CellLayout &l) { l.rest_length[3] = 0.; });
  wrong([](CellLayout &l) { l.rings[1].count += 1; });
  wrong([](CellLayout &l) { l.fluid_mass.pop_back(); });
  wrong([](CellLayout &l) { l.ties[5].stiffness = 0.; });
  wrong([](CellLayout &l) { l.rings.clear(); });
}

BOOST_AUTO_TEST_SUITE_END()
