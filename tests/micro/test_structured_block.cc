// Blocks with upright sides of hexagons, bricks and Laguerre cells: laid in rows, repeated to the state that
// the whole block finds by itself, at rest behind frozen surfaces, and refused where there is no such block.
#include "micro/cells/structured_block.h"
#include "micro/geometry/regular_tilings.h"
#include "micro/processes/annealed_cells.h"
#include "micro/scenes/tissue/lattice_block.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

using namespace turgor;

namespace {
ParenchymaParameters coarse_cell() {
  ParenchymaParameters cell;
  cell.nodes_per_side = 8;
  return cell;
}

TissueStructure of_kind(const StructureKind kind) {
  TissueStructure structure;
  structure.kind = kind;
  return structure;
}

std::string refusal(const TissueStructure &structure, const unsigned int rows,
                    const ParenchymaParameters &cell = coarse_cell()) {
  try {
    check_block(structure, cell, rows);
  } catch (const std::invalid_argument &why) {
    return why.what();
  }
  return "";
}
}  // namespace

BOOST_AUTO_TEST_SUITE(structured_block)

// By hand: bricks of side 1 in two rows, the upper one half a cell to the right.
BOOST_AUTO_TEST_CASE(rows_of_bricks_at_right_angles) {
  const Tiling t = replicated_upright(brick_tiling(1.), 3, 4);
  t.check();
  BOOST_TEST(std::abs(t.lattice(0, 0) - 3.) + std::abs(t.lattice(0, 1)) + std::abs(t.lattice(1, 0)) +
                 std::abs(t.lattice(1, 1) - 4.) <
             1e-12);
  for (unsigned int row = 0; row < 4; ++row)
    for (unsigned int column = 0; column < 3; ++column) {
      const Vector<2> middle = polygon_centroid(t.outline(row * 3 + column));
      BOOST_TEST((middle - Vector<2>(column + 0.5 + 0.5 * (row % 2), row + 0.5)).norm() < 1e-12);
    }
  BOOST_CHECK_THROW(replicated_upright(brick_tiling(1.), 3, 3), std::invalid_argument);
  BOOST_TEST(replicated_upright(square_tiling(1.), 3, 3).cells.size() == 9u);
}

BOOST_AUTO_TEST_CASE(repeated_is_what_the_whole_block_finds) {
  for (const StructureKind kind : {StructureKind::hexagon, StructureKind::brick}) {
    const TissueStructure structure = of_kind(kind);
    const CellLayout repeated = turgid_block(structure, coarse_cell(), 3, 4),
                     whole = turgid_tissue(structure, coarse_cell(), 3, 4, Periods::upright);
    repeated.check();
    BOOST_REQUIRE(repeated.nodes.size() == whole.nodes.size());
    BOOST_REQUIRE(repeated.ties.size() == whole.ties.size());
    BOOST_TEST((repeated.lattice - whole.lattice).norm() < 1e-7 * whole.lattice.norm());
    for (std::size_t i = 0; i < whole.nodes.size(); ++i)
      BOOST_TEST((repeated.nodes[i] - whole.nodes[i]).norm() < 1e-6 * whole.spacing);
    BOOST_TEST(all_alike(repeated));
    BOOST_TEST(all_alike(whole));
  }
  BOOST_TEST(!all_alike(turgid_block(of_kind(StructureKind::voronoi), coarse_cell(), 3, 3)));
}

BOOST_AUTO_TEST_CASE(frozen_surfaces_keep_the_reference) {
  for (const StructureKind kind : {StructureKind::hexagon, StructureKind::brick, StructureKind::voronoi}) {
    const CellLayout turgid = turgid_block(of_kind(kind), coarse_cell(), 4, 4);
    LatticeBlock block(turgid, turgid, Surfaces::frozen);
    const EquilibriumSettings settings{1e-9, 300};
    block.relax(settings);
    double shift = 0.;
    for (std::size_t i = 0; i < block.x.size(); ++i)
      shift = std::max(shift, std::abs(block.relaxed[i] - block.reference[i]));
    BOOST_TEST(shift < 1e-6 * block.width);
    block.load({.size = 5e3}, settings);
    BOOST_TEST((block.clamp_reaction() + block.weight() + block.dead_force()).norm() <
               1e-5 * block.weight().norm());
    BOOST_TEST(block.probe_displacement()[1] < 0.);
  }
}

BOOST_AUTO_TEST_CASE(where_cells_stand) {
  const TissueStructure bricks = of_kind(StructureKind::brick), any = of_kind(StructureKind::voronoi);
  const CellLayout block = turgid_block(bricks, coarse_cell(), 3, 2);
  BOOST_TEST((place_in_block(bricks, block, 3, 4) - Vector<2>(1., 1.)).norm() == 0.);
  const CellLayout unlike = turgid_block(any, coarse_cell(), 3, 3);
  Vector<2> mean = Vector<2>::Zero();
  for (std::size_t c = 0; c < 9; ++c) mean += place_in_block(any, unlike, 3, c) / 9.;
  // Rings are never wrapped: cells at the border may lie on either side of it.
  BOOST_TEST((mean - Vector<2>(1.5, 1.5)).norm() < 1.);
}

BOOST_AUTO_TEST_CASE(blocks_that_cannot_be) {
  TissueStructure bricks = of_kind(StructureKind::brick);
  BOOST_TEST(refusal(bricks, 4).empty());
  BOOST_TEST(
      refusal(bricks, 3) ==
      "Rows is 3, but rows of Structure/Structure = brick are moved by half a cell, so that a block has "
      "an even number of them: use 4.");
  BOOST_TEST(refusal(of_kind(StructureKind::voronoi), 3).empty());
  ParenchymaParameters bursting = coarse_cell();
  bursting.turgor = 1e8;
  BOOST_TEST(refusal(bricks, 4, bursting).find("walls stretch without end. Use less turgor") !=
             std::string::npos);
  bricks.rotation = 30.;
  BOOST_TEST(refusal(bricks, 4) ==
             "Structure/Rotation is 30 degrees, but the sides of a clamped block are upright, and so is its "
             "tissue: use 0.");
}

BOOST_AUTO_TEST_SUITE_END()
