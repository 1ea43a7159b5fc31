// Walls laid along tilings, and their turgid reference with its lattice.
#include "micro/cells/hydrostatic_network.h"
#include "micro/cells/parenchyma.h"
#include "micro/cells/tiled_layout.h"
#include "micro/cells/tissue_structure.h"
#include "micro/cells/turgid_layout.h"
#include "micro/geometry/regular_tilings.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

using namespace turgor;

namespace {
constexpr double L = 100e-6;

ParenchymaParameters cell_of(const unsigned int nodes_per_side) {
  ParenchymaParameters p;
  p.period = L;
  p.nodes_per_side = nodes_per_side;
  p.lamella_ratio = 1.;
  return p;
}

using Tie = std::array<std::int64_t, 4>;
/// Either way round is the same tie.
std::map<Tie, double> ties_of(const CellLayout &layout) {
  std::map<Tie, double> ties;
  for (const LamellaTie &t : layout.ties) {
    const Tie tie =
        t.a < t.b ? Tie{t.a, t.b, t.shift[0], t.shift[1]} : Tie{t.b, t.a, -t.shift[0], -t.shift[1]};
    BOOST_TEST(ties.emplace(tie, t.stiffness).second);
  }
  return ties;
}

void require_facing_nodes_together(const CellLayout &layout) {
  for (const LamellaTie &t : layout.ties)
    BOOST_TEST(LamellaSpring::gap(layout.nodes[t.a], layout.nodes[t.b], t.shift, layout.lattice).norm() <
               1e-9 * L);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(tiled_layout)

BOOST_AUTO_TEST_CASE(square_cells_are_those_of_parenchyma) {
  for (const auto &[columns, rows] : {std::pair{1u, 1u}, {3u, 2u}}) {
    const ParenchymaParameters p = cell_of(7);
    const CellLayout wanted = make_parenchyma(p, columns, rows, true, true),
                     laid = lay_cells(replicated(square_tiling(L), columns, rows), p, 0.,
                                      turgid_wall_stretch(p));
    const auto near = boost::test_tools::tolerance(1e-12);
    BOOST_TEST((laid.lattice - wanted.lattice).norm() < 1e-15 * L);
    BOOST_REQUIRE(laid.nodes.size() == wanted.nodes.size());
    BOOST_REQUIRE(laid.cells() == wanted.cells());
    for (std::size_t i = 0; i < laid.nodes.size(); ++i) {
      BOOST_TEST((laid.nodes[i] - wanted.nodes[i]).norm() < 1e-14 * L);
      BOOST_TEST(laid.rest_length[i] == wanted.rest_length[i], near);
      BOOST_TEST(std::abs(laid.rest_angle[i] - wanted.rest_angle[i]) < 1e-12);
      BOOST_TEST(laid.hinge[i] == wanted.hinge[i], near);
      BOOST_TEST(laid.node_mass[i] == wanted.node_mass[i], near);
    }
    for (std::size_t c = 0; c < laid.cells(); ++c) {
      BOOST_TEST(
          (laid.rings[c].first == wanted.rings[c].first && laid.rings[c].count == wanted.rings[c].count));
      BOOST_TEST(laid.fluid_mass[c] == wanted.fluid_mass[c], near);
    }
    BOOST_TEST(laid.spring_stiffness == wanted.spring_stiffness, near);
    const auto laid_ties = ties_of(laid), wanted_ties = ties_of(wanted);
    BOOST_REQUIRE(laid_ties.size() == wanted_ties.size());
    for (const auto &[tie, stiffness] : wanted_ties) {
      BOOST_REQUIRE(laid_ties.count(tie) == 1u);
      BOOST_TEST(laid_ties.at(tie) == stiffness, near);
    }
  }
}

BOOST_AUTO_TEST_CASE(bricks_have_the_nodes_and_ties_one_counts_by_hand) {
  const CellLayout dense = lay_cells(brick_tiling(L), cell_of(12));
  BOOST_TEST(dense.nodes.size() == 48u);  // 6 + 6 + 12 + 6 + 6 + 12
  BOOST_TEST(dense.ties.size() == 27u);   // three walls: 7 + 7 + 13
  require_facing_nodes_together(dense);
  // a gap of 20 um: nodes at its ends, none tied inside. Half sides 50 um: 2 + 1 + 2 bonds, long ones 2 + 7 +
  // 2
  const CellLayout sparse = lay_cells(brick_tiling(L), cell_of(12), 20e-6);
  BOOST_TEST(sparse.nodes.size() == 4u * 5u + 2u * 11u);
  BOOST_TEST(sparse.ties.size() == 2u * 2u + 8u);
  require_facing_nodes_together(sparse);
  double nearest = L;
  for (const LamellaTie &t : sparse.ties)
    for (const Vector<2> &junction : {Vector<2>(0., 0.), Vector<2>(0.5 * L, 0.), Vector<2>(L, 0.),
                                      Vector<2>(0., L), Vector<2>(0.5 * L, L), Vector<2>(L, L)})
      nearest = std::min(nearest, (sparse.nodes[t.a] - junction).norm());
  BOOST_TEST(nearest == 20e-6, boost::test_tools::tolerance(1e-9));
  BOOST_CHECK_THROW(lay_cells(brick_tiling(L), cell_of(12), -1e-6), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(walls_of_half_a_bond_more_are_cut_alike_everywhere) {
  // half sides of 12.5 spacings: 13 bonds, wherever the cell is and however it is turned
  for (const double gap : {0., 20e-6})
    for (const Tiling &t :
         {replicated(brick_tiling(L), 3, 3), rotated(replicated(brick_tiling(L), 5, 2), 0.3)}) {
      const CellLayout layout = lay_cells(t, cell_of(25), gap);
      for (const WallRing &ring : layout.rings)
        BOOST_TEST(ring.count == (gap > 0. ? 4u * (5u + 3u + 5u) + 2u * 25u : 4u * 13u + 2u * 25u));
      require_facing_nodes_together(layout);
    }
}

BOOST_AUTO_TEST_CASE(voronoi_walls_face_each_other_node_by_node) {
  TissueStructure voronoi;
  voronoi.kind = StructureKind::voronoi;
  for (const unsigned int n : {1u, 2u, 4u})
    for (voronoi.seed = 1; voronoi.seed < 4; ++voronoi.seed) {
      const CellLayout layout = lay_cells(voronoi.tiling(L, n, n, L / 12.), cell_of(12));
      require_facing_nodes_together(layout);
      for (const WallRing &ring : layout.rings) {
        double turn = 0.;
        for (std::size_t i = ring.first; i < ring.end(); ++i) {
          turn += layout.rest_angle[i];
          BOOST_TEST(layout.rest_length[i] >
                     L / 25.);  // two bonds at least on a side that is not shorter than a spacing
        }
        BOOST_TEST(turn == 2. * M_PI, boost::test_tools::tolerance(1e-12));
      }
    }
}

BOOST_AUTO_TEST_CASE(a_turgid_tissue_carries_no_stress) {
  const ParenchymaParameters p = cell_of(12);
  TissueStructure structure;
  for (const std::string kind : {"hexagon", "brick", "voronoi"})
    for (const unsigned int n : {1u, 3u}) {
      structure.kind = choice_of<StructureKind>(kind);
      structure.rotation = n == 3 ? 30. : 0.;
      structure.jitter = kind == "brick" && n == 3 ? 0.06 : 0.;
      const CellLayout layout = turgid_tissue(structure, p, n, n);
      const HydrostaticNetwork network(layout);
      NetworkEvaluation e;
      network.evaluate(layout.positions(), layout.lattice, NetworkOrder::gradient, e);
      const double volume = layout.lattice.determinant() * p.depth;
      BOOST_TEST((e.virial.total() / volume).cwiseAbs().maxCoeff() < 1e-6 * p.turgor);
      double area = 0.;
      for (std::size_t c = 0; c < layout.cells(); ++c) {
        BOOST_TEST(e.pressure[c] == p.turgor, boost::test_tools::tolerance(1e-9));
        area += e.volume[c] / p.depth;
      }
      BOOST_TEST(area == layout.lattice.determinant(),
                 boost::test_tools::tolerance(0.02));  // the lamella gives a little
      double left = 0.;
      for (const double f : e.gradient) left = std::max(left, std::abs(f));
      BOOST_TEST(left < 1e-8 * network.force_scale());
    }
}

BOOST_AUTO_TEST_CASE(periods_at_turgor_are_those_of_inextensible_walls_stretched) {
  // by the trial of general cells: bricks 96.5 x 121.4 um, hexagons 110.6 x 95.8 um, squares 102.8 um
  const ParenchymaParameters p = cell_of(12);
  const auto periods = [&](const Tiling &t) { return turgid_with_lattice(lay_cells(t, p)).lattice; };
  const Tensor2<2> brick = periods(brick_tiling(L)), hexagon = periods(hexagon_tiling(L)),
                   square = periods(square_tiling(L));
  BOOST_TEST(std::abs(brick(0, 0) - 96.46e-6) < 0.05e-6);
  BOOST_TEST(std::abs(brick(1, 1) - 121.36e-6) < 0.05e-6);
  BOOST_TEST(std::abs(hexagon(0, 0) - 110.63e-6) < 0.05e-6);
  BOOST_TEST(std::abs(hexagon(1, 1) - 95.81e-6) < 0.05e-6);
  BOOST_TEST(std::abs(square(0, 0) - 102.84e-6) < 0.05e-6);
  for (const Tensor2<2> &H : {brick, hexagon})
    BOOST_TEST(H(0, 1) == 0.5 * H(0, 0), boost::test_tools::tolerance(1e-9));
}

// Walls up to the stiffest that are allowed do not stretch: the periods are those of the stress-free walls.
BOOST_AUTO_TEST_CASE(walls_much_stiffer_than_turgor_have_a_reference) {
  for (const Tiling &one : {brick_tiling(L), hexagon_tiling(L)})
    for (const double stiffness : {1e5, 1e7, 1e8, 1e9}) {
      ParenchymaParameters p = cell_of(25);
      p.wall_stiffness = stiffness;
      TurgidSearch how;
      const CellLayout layout = turgid_with_lattice(lay_cells(one, p), &how);
      BOOST_TEST(how.stress <= 1e-11 * stiffness / p.period);
      BOOST_TEST(layout.lattice.determinant() > 0.9 * L * L);
    }
}

BOOST_AUTO_TEST_CASE(more_cells_and_turned_cells_have_the_same_periods) {
  const ParenchymaParameters p = cell_of(8);
  for (const Tiling &one : {brick_tiling(L), hexagon_tiling(L)}) {
    const CellLayout single = turgid_with_lattice(lay_cells(one, p));
    const CellLayout four = turgid_with_lattice(lay_cells(replicated(one, 2, 2), p));
    Tensor2<2> twice = 2. * single.lattice;
    twice.col(1) -= std::ceil(twice(0, 1) / twice(0, 0) - 0.5 - 1e-6) * twice.col(0);
    BOOST_TEST((four.lattice - twice).cwiseAbs().maxCoeff() < 1e-9 * L);
    const double angle = 0.4;
    const CellLayout turned = turgid_with_lattice(lay_cells(rotated(one, angle), p));
    Tensor2<2> turn;
    turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    BOOST_TEST((turned.lattice - turn * single.lattice).cwiseAbs().maxCoeff() < 1e-9 * L);
  }
}

BOOST_AUTO_TEST_SUITE_END()
