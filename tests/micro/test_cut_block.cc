// Blocks cut out of periodic tissue: their sides, and that frozen surfaces keep what the missing neighbours
// pull, whatever the cells.
#include "micro/cells/cut_block.h"
#include "micro/cells/parenchyma.h"
#include "micro/cells/tissue_block.h"
#include "micro/cells/turgid_layout.h"
#include "micro/scenes/tissue/lattice_block.h"
#include "tests/micro/small_patch.h"
#include "tests/micro/unlike_cells.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

using namespace turgor;

BOOST_AUTO_TEST_SUITE(cut_block)

// By hand: the left sides of the first column, corners included; the two corners that meet in the middle of
// the right side.
BOOST_AUTO_TEST_CASE(sides_of_squares) {
  ParenchymaParameters cell;
  cell.nodes_per_side = 4;
  const CellLayout whole = make_parenchyma(cell, 3, 2, true, true);
  const CutBlock block = cut_out(whole, whole, Surfaces::frozen);
  BOOST_TEST(block.clamped == (std::vector<std::uint32_t>{0, 12, 13, 14, 15, 48, 60, 61, 62, 63}),
             boost::test_tools::per_element());
  BOOST_TEST(block.probe == (std::vector<std::uint32_t>{2 * 16 + 8, 5 * 16 + 4}),
             boost::test_tools::per_element());
  BOOST_TEST(block.width == 3. * cell.period);
  BOOST_TEST(block.cut.size() == 5u * (2 + 3));
  const CellLayout bounded = make_parenchyma(cell, 3, 2, false, false),
                   slab = make_parenchyma(cell, 3, 2, false, true);
  BOOST_TEST(block.layout.ties.size() == bounded.ties.size());
  BOOST_TEST(cut_out(whole, whole, Surfaces::slab).layout.ties.size() == slab.ties.size());
  BOOST_TEST(block.density * whole.lattice.determinant() * cell.depth ==
                 whole.total_fluid_mass() + whole.total_wall_mass(),
             boost::test_tools::tolerance(1e-14));
  BOOST_CHECK_THROW(cut_out(bounded, bounded, Surfaces::frozen), std::invalid_argument);
}

// Cells of five shapes filled with particles: every force is that of the periodic tissue, those of free
// surfaces are not.
BOOST_AUTO_TEST_CASE(frozen_surfaces_pull_as_the_neighbours_did) {
  CellLayout layout = test::unlike_cells(10e-6);
  for (std::size_t i = 0; i < layout.nodes.size(); ++i)  // apart, so that ties pull
    for (int d = 0; d < 2; ++d)
      layout.nodes[i][d] += 0.05 * layout.spacing * (random_uniform(3, 2 * i + d) - 0.5);
  SphParameters sph;
  sph.particles_per_side = 9;
  const std::vector<CellContents> contents = unannealed_cells(layout, sph);
  const auto periodic = make_sph_patch(layout, sph, contents);
  periodic->system.compute_forces();
  const auto difference = [&](const Surfaces surfaces) {
    const TissueBlock block = make_tissue_block(layout, sph, contents, surfaces);
    block.cells->system.compute_forces();
    return test::largest_difference(periodic->system.particles, block.cells->system.particles);
  };
  const double scale = test::largest_force(periodic->system.particles);
  BOOST_TEST(difference(Surfaces::frozen) < 1e-10 * scale);
  BOOST_TEST(difference(Surfaces::slab) < 1e-10 * scale);
  BOOST_TEST(difference(Surfaces::free) > 1e-3 * scale);
}

// A network of those cells at turgor: at rest as it is cut out; under load the clamp and the missing
// neighbours carry the weight.
BOOST_AUTO_TEST_CASE(a_block_of_unlike_cells_keeps_its_reference) {
  const CellLayout laid = test::unlike_cells(), reference = turgid(laid);
  LatticeBlock block(laid, reference, Surfaces::frozen);
  const EquilibriumSettings settings{1e-9, 300};
  block.relax(settings);
  double shift = 0.;
  for (std::size_t i = 0; i < block.x.size(); ++i)
    shift = std::max(shift, std::abs(block.relaxed[i] - block.reference[i]));
  BOOST_TEST(shift < 1e-7 * block.width);
  block.load({.size = 5e3}, settings);
  BOOST_TEST((block.clamp_reaction() + block.weight() + block.dead_force()).norm() <
             1e-5 * block.weight().norm());
  BOOST_TEST(block.probe_displacement()[1] < 0.);
}

// The right side carries all of a traction, every node by its share of the height, and the clamp holds it.
BOOST_AUTO_TEST_CASE(a_traction_on_the_right_side) {
  const CellLayout laid = test::unlike_cells(), reference = turgid(laid);
  const CutBlock cut = cut_out(laid, reference, Surfaces::frozen);
  double height = 0.;
  for (const CutBlock::SideNode &one : cut.right) {
    BOOST_TEST(one.height >= 0.);
    height += one.height;
  }
  BOOST_TEST(height == reference.lattice(1, 1), boost::test_tools::tolerance(1e-12));
  LatticeBlock block(laid, reference, Surfaces::frozen);
  const EquilibriumSettings settings{1e-9, 300};
  block.relax(settings);
  const Vector<2> before = block.clamp_reaction(), traction(3e3, -2e3);
  block.load({.size = 0., .traction = traction}, settings);
  const Vector<2> force = height * reference.parameters.depth * traction;
  BOOST_TEST((block.clamp_reaction() - before + force).norm() < 1e-5 * force.norm());
  BOOST_TEST(block.probe_displacement()[0] > 0.);
  BOOST_TEST(block.probe_displacement()[1] < 0.);
}

// A block of particles feels nothing before its load is put on, and then exactly that.
BOOST_AUTO_TEST_CASE(particles_carry_the_load_from_its_beginning_on) {
  const CellLayout layout = test::unlike_cells(10e-6);
  SphParameters sph;
  sph.particles_per_side = 9;
  const std::vector<CellContents> contents = unannealed_cells(layout, sph);
  const BlockLoad load{.size = 1e3, .direction = {3., 4.}, .traction = {500., -200.}};
  TissueBlock block = make_tissue_block(layout, sph, contents, Surfaces::frozen, load);
  Particles<2> &p = block.cells->system.particles;
  const auto total = [&] {
    block.cells->system.compute_forces();
    Vector<2> sum = Vector<2>::Zero();
    for (std::size_t i = 0; i < p.size(); ++i)
      for (int d = 0; d < 2; ++d) sum[d] += p.f[d][i];
    return sum;
  };
  const Vector<2> before = total();
  block.put_on_load();
  Vector<2> wanted = layout.lattice(1, 1) * layout.parameters.depth * load.traction;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p.inverse_mass[i] > 0.) wanted += block.acceleration / p.inverse_mass[i];
  BOOST_TEST((total() - before - wanted).norm() < 1e-9 * wanted.norm());
  BOOST_TEST(block.acceleration.norm() * block.density * block.width == 1e3,
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
