// A layout of cells that are not alike: rings, ties across the periods, masses; what is impossible is named.
#include "micro/cells/round_layout.h"
#include "tests/micro/unlike_cells.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <stdexcept>

using namespace turgor;

BOOST_AUTO_TEST_SUITE(cell_layout)

BOOST_AUTO_TEST_CASE(rings_of_their_own_sizes_fill_the_lattice_and_are_tied_across_it) {
  const CellLayout layout = test::unlike_cells();
  layout.check();
  std::set<std::uint32_t> sizes;
  double area = 0.;
  for (const WallRing &ring : layout.rings) {
    sizes.insert(ring.count);
    for (std::size_t i = ring.first; i < ring.end(); ++i) {
      const Vector<2> a = layout.nodes[i], b = layout.nodes[ring.after(i)];
      area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
      BOOST_TEST(ring.before(ring.after(i)) == i);
    }
  }
  BOOST_TEST(sizes.size() > 2u);  // unlike
  BOOST_TEST(area == layout.lattice.determinant(), boost::test_tools::tolerance(1e-12));
  // every side has a facing one: a tie for every two nodes, and one more for every side
  const std::size_t sides = 30;
  BOOST_TEST(layout.ties.size() == (layout.nodes.size() + sides) / 2);
  std::vector<int> tied(layout.nodes.size(), 0);
  for (const LamellaTie &tie : layout.ties) {
    BOOST_TEST(
        LamellaSpring::gap(layout.nodes[tie.a], layout.nodes[tie.b], tie.shift, layout.lattice).norm() <
        1e-12 * layout.spacing);
    ++tied[tie.a];
    ++tied[tie.b];
  }
  BOOST_TEST(std::count(tied.begin(), tied.end(), 2) == int(sides));  // corners
  BOOST_TEST(std::count(tied.begin(), tied.end(), 1) == int(layout.nodes.size() - sides));
}

BOOST_AUTO_TEST_CASE(masses_add_up) {
  const CellLayout layout = test::unlike_cells();
  double walls = 0.;
  for (std::size_t c = 0; c < layout.cells(); ++c) walls += layout.wall_mass(c);
  BOOST_TEST(layout.total_wall_mass() == walls, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(
      layout.total_fluid_mass() == std::accumulate(layout.fluid_mass.begin(), layout.fluid_mass.end(), 0.),
      boost::test_tools::tolerance(1e-14));
  CellLayout alike = layout;
  alike.node_mass.assign(layout.nodes.size(), 0.1);
  BOOST_TEST(alike.total_wall_mass() ==
             0.1 * double(layout.nodes.size()));  // to the last bit, whatever the number
}

BOOST_AUTO_TEST_CASE(impossible_layouts_are_named) {
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

// A regular polygon and a geodesic sphere: areas, volumes and masses by hand; what does not belong together
// is refused.
BOOST_AUTO_TEST_CASE(round_cells_are_layouts) {
  RoundCellParameters p;
  p.ring_nodes = 12;
  p.frequency = 6;
  const double r2 = p.radius / p.turgid_stretch(2), r3 = p.radius / p.turgid_stretch(3),
               pi = std::numbers::pi;
  const auto near = boost::test_tools::tolerance(1e-12);
  const CellLayout ring = round_layout<2>(p);
  BOOST_TEST(ring.cells() == 1u);
  BOOST_TEST(ring.total_fluid_mass() == p.fluid_density * p.depth * 6. * std::sin(pi / 6.) * r2 * r2, near);
  BOOST_TEST(
      ring.total_wall_mass() == p.wall_density * p.wall_thickness * p.depth * 24. * r2 * std::sin(pi / 12.),
      near);
  BOOST_TEST(std::accumulate(ring.rest_angle.begin(), ring.rest_angle.end(), 0.) == 2. * pi, near);
  const SurfaceLayout sphere = round_layout<3>(p);
  BOOST_TEST(sphere.nodes.size() == 362u);
  BOOST_TEST(sphere.fluid_mass == p.fluid_density * sphere.volume(), near);
  BOOST_TEST(sphere.volume() == 4. / 3. * pi * std::pow(r3, 3),
             boost::test_tools::tolerance(0.03));  // of the polyhedron inside
  BOOST_TEST(sphere.volume() < 4. / 3. * pi * std::pow(r3, 3));
  BOOST_TEST(std::accumulate(sphere.node_mass.begin(), sphere.node_mass.end(), 0.) ==
                 p.wall_density * p.wall_thickness * 4. * pi * r3 * r3,
             boost::test_tools::tolerance(0.03));
  BOOST_CHECK_THROW(SurfaceLayout(sphere.mesh, {sphere.nodes[0]}, p, p), std::invalid_argument);
  std::vector<Vector<3>> mirrored = sphere.nodes;
  for (Vector<3> &node : mirrored) node[0] *= -1.;
  BOOST_CHECK_THROW(SurfaceLayout(sphere.mesh, mirrored, p, p), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
