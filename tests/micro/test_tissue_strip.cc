// Strips of particles that are periodic along x, and blocks: the tissue of an RVE without its ties across the
// periods that end.
#include "micro/cells/brick_tissue.h"
#include "micro/cells/hydrostatic_network.h"
#include "micro/cells/tissue_strip.h"
#include "micro/processes/tissue_inflation.h"
#include "micro/scenes/tissue/strip_width.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <set>
#include <string>

using namespace turgor;

namespace {
struct Strip {
  ParenchymaParameters cell;
  SphParameters sph;
  BrickParameters brick;

  Strip() {
    cell.nodes_per_side = 8;
    cell.lamella_ratio = 1.;
    sph.particles_per_side = 6;
    brick.columns = 1;
    brick.rows = 3;
    brick.jitter = 0.;
    brick.sides = TissueSides::periodic;
  }
  BrickLayout lay() const { return lay_strip(brick.structure, cell, brick.columns, brick.rows); }
};

std::string refusal(const BrickParameters &brick, const ParenchymaParameters &cell) {
  try {
    brick.check(cell, SphParameters());
  } catch (const std::invalid_argument &why) {
    return why.what();
  }
  return "";
}
}  // namespace

BOOST_AUTO_TEST_SUITE(tissue_strip)

// By hand: of 3 rows of one brick each, 2 pairs of rows face each other. A brick faces two cells of the next
// row along half a side each, 8/2 + 1 ties twice, and itself across the period along a side, 8 + 1 ties.
BOOST_AUTO_TEST_CASE(ties_of_a_strip) {
  const Strip strip;
  const CellLayout whole = turgid_tissue(strip.brick.structure, strip.cell, 1, 3);
  const BrickLayout layout = strip.lay();
  BOOST_TEST(layout.ties.size() == 3u * 9 + 2u * 2 * 5);
  BOOST_TEST(layout.tie_from_end.size() == layout.ties.size());
  BOOST_TEST((layout.periodic == std::array<bool, 2>{true, false}));
  BOOST_TEST(layout.rest_length == whole.rest_length, boost::test_tools::per_element());
  BOOST_TEST(layout.lattice(0, 0) == whole.lattice(0, 0));
  BOOST_TEST(layout.junctions[1].size() == 6u);  // amid others: all its corners
  BOOST_TEST(layout.junctions[0].size() == 3u);  // of the lowest row: those above it
}

// By hand: half sides have 2 + 1 + 2 bonds, the inner one tied, whole ones 2 + 5 + 2. Of the three rows of
// air spaces, two a brick each, the one across the period that ends is open.
BOOST_AUTO_TEST_CASE(ties_and_air_of_a_sparse_strip) {
  Strip strip;
  strip.brick.structure.gap = 20e-6;
  const BrickLayout layout = strip.lay();
  for (const WallRing &ring : layout.rings) BOOST_TEST(ring.count == 4u * 5 + 2u * 9);
  BOOST_TEST(layout.ties.size() == 3u * 6 + 2u * 2 * 2);
  BOOST_TEST(layout.air.size() == 4u);
  BOOST_TEST(layout.junctions[1].size() == 6u);
  BOOST_TEST(layout.junctions[0].size() == 3u);
  for (const LamellaTie &tie : layout.ties)
    for (const std::size_t c : {0u, 1u, 2u})
      for (const std::uint32_t corner : layout.junctions[c])
        BOOST_TEST((tie.a != layout.rings[c].first + corner && tie.b != layout.rings[c].first + corner));
  // two bonds of 10 um from the end of a half side, and of a whole one
  for (const std::uint32_t bonds : layout.tie_from_end) BOOST_TEST(bonds >= 2u);
}

// Corners that are moved give rings of unlike lengths: still the very tissue of the RVE, with a mark for
// every bond.
BOOST_AUTO_TEST_CASE(cells_of_unlike_rings) {
  Strip strip;
  strip.brick.structure.jitter = 0.15;
  strip.brick.columns = 2;
  strip.brick.critical_stretch = 1.3;
  strip.brick.yielding = Yielding::plastic;
  for (const double gap : {0., 20e-6}) {
    strip.brick.structure.gap = gap;
    const auto tissue = make_brick_tissue(strip.cell, strip.sph, strip.brick);
    const BrickLayout &layout = tissue->layout;
    const CellLayout whole =
        turgid_tissue(strip.brick.structure, strip.brick.yielding_cell(strip.cell), 2, 3);
    BOOST_TEST(layout.rest_length == whole.rest_length, boost::test_tools::per_element());
    std::set<std::uint32_t> counts;
    for (std::size_t c = 0; c < layout.cells(); ++c) {
      counts.insert(layout.rings[c].count);
      BOOST_TEST(tissue->system.particles.groups[c].wall_count() == layout.rings[c].count);
      BOOST_TEST(tissue->damage->cells[c].bond_broken.size() == layout.rings[c].count);
      BOOST_TEST(tissue->damage->cells[c].face_gone.size() == layout.rings[c].count);
      BOOST_TEST(tissue->flow->permanent[c].size() == layout.rings[c].count);
    }
    BOOST_TEST(counts.size() > 1u);
    const auto at_rest = rest_of_the_walls(strip.cell, strip.sph, strip.brick, {});
    BOOST_TEST(at_rest->contact->crossed_bonds() == 0u);
  }
}

BOOST_AUTO_TEST_CASE(a_block_is_cut_on_all_sides) {
  Strip strip;
  strip.brick.sides = TissueSides::cut;
  strip.brick.columns = strip.brick.rows = 2;
  for (const double gap : {0., 20e-6}) {
    strip.brick.structure.gap = gap;
    const BrickLayout layout = strip.brick.lay(strip.cell);
    BOOST_TEST((layout.periodic == std::array<bool, 2>{false, false}));
    // one wall in each row, three half walls between the rows
    BOOST_TEST(layout.ties.size() == (gap > 0. ? 2u * 6 + 3u * 2 : 2u * 9 + 3u * 5));
    // where the half walls meet a wall of a row
    BOOST_TEST(layout.air.size() == (gap > 0. ? 2u : 0u));
  }
  const auto tissue = rest_of_the_walls(strip.cell, strip.sph, strip.brick, {});
  BOOST_TEST(tissue->contact->crossed_bonds() == 0u);
}

// Away from its ends a strip of particles is the tissue that FE2 has: turgid walls alone are in balance but
// for the outer rows, and the same strip one period aside is the same strip.
BOOST_AUTO_TEST_CASE(inner_rows_begin_at_rest) {
  for (const double gap : {0., 20e-6}) {
    Strip strip;
    strip.brick.structure.gap = gap;
    const auto tissue = make_brick_tissue(strip.cell, strip.sph, strip.brick, BrickFilling::pressure);
    tissue->system.compute_forces();
    const Particles<2> &p = tissue->system.particles;
    const double scale = strip.cell.turgor * tissue->spacing * strip.cell.depth;
    double inside = 0., outside = 0.;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::uint32_t i = p.groups[c].begin; i < p.groups[c].fluid; ++i)
        (c == 1 ? inside : outside) = std::max(c == 1 ? inside : outside, std::hypot(p.f[0][i], p.f[1][i]));
    BOOST_TEST(inside < 1e-6 * scale);
    BOOST_TEST(outside > 0.1 * scale);
    const CellLayout whole = turgid_tissue(strip.brick.structure, strip.cell, 1, 3);
    const HydrostaticNetwork network(whole);
    const double air = network.air_share(whole.positions(), whole.lattice);
    BOOST_TEST((gap > 0.) == (air > 0.05));
    BOOST_TEST(std::abs(tissue->void_fraction() - air) < 3e-3);
  }
}

// The width follows until no stress is left along x.
BOOST_AUTO_TEST_CASE(width_gives_way) {
  const Strip strip;
  const auto tissue = rest_of_the_walls(strip.cell, strip.sph, strip.brick, {});
  ParticleSystem<2> &system = tissue->system;
  system.compute_forces();
  const double height = 3.5e-4, depth = strip.cell.depth;
  StripWidth width{.bulk = 7. * strip.cell.fluid_modulus};
  const double before = StripWidth::stress(system, height, depth), W = system.box.H(0, 0);
  const double energy = system.potential_energy();
  width.follow(system, height, depth, 0.);
  BOOST_TEST(std::abs(before) > 100.);
  BOOST_TEST(width.worst == std::abs(before));
  BOOST_TEST((system.box.H(0, 0) - W) * before < 0.);  // pressed: wider
  BOOST_TEST(width.work == system.potential_energy() - energy, boost::test_tools::tolerance(1e-12));
  // A change so large that the stress of before, times the change, is off by a fifth.
  const double then = system.potential_energy(), first_order = 1e-3 * system.virial()(0, 0);
  StripWidth fast{.bulk = 7. * strip.cell.fluid_modulus};
  fast.follow(system, height, depth, 1e-3);
  BOOST_TEST(fast.work == system.potential_energy() - then, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(fast.work - first_order) > 0.1 * std::abs(fast.work));
}

BOOST_AUTO_TEST_CASE(refusals) {
  Strip strip;
  strip.brick.gap = 20e-6;
  BOOST_TEST(refusal(strip.brick, strip.cell).find("use Gap = 0 and Structure/Gap") != std::string::npos);
  strip.brick.gap = 0.;
  strip.brick.structure.gap = 25e-6;
  BOOST_TEST(refusal(strip.brick, strip.cell).find("less than a quarter of Cell/Period") !=
             std::string::npos);
  strip.brick.structure.gap = 0.;
  strip.brick.sides = TissueSides::cut;
  BOOST_TEST(refusal(strip.brick, strip.cell).find("has an even number of them: use 4.") !=
             std::string::npos);
  strip.brick.sides = TissueSides::periodic;
  strip.brick.structure.kind = StructureKind::voronoi;
  BOOST_TEST(refusal(strip.brick, strip.cell).find("use square, hexagon or brick") != std::string::npos);
  strip.brick.structure.kind = StructureKind::brick;
  strip.brick.structure.rotation = 90.;
  BOOST_TEST(refusal(strip.brick, strip.cell).find("Structure/Rotation") != std::string::npos);
  strip.brick.structure.rotation = 0.;
  strip.brick.sides = TissueSides::free;
  strip.brick.structure.kind = StructureKind::hexagon;
  BOOST_TEST(refusal(strip.brick, strip.cell).find("use Sides = cut, periodic or widening") !=
             std::string::npos);
  strip.brick.structure.kind = StructureKind::brick;
  strip.brick.structure.gap = 20e-6;
  BOOST_TEST(refusal(strip.brick, strip.cell).find("use Sides = cut, periodic or widening") !=
             std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
