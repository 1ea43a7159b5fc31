// The static block of cells: balance of forces, frozen surfaces, the slab's closed form, water.
#include "micro/cells/parenchyma.h"
#include "run/input_entries.h"
#include "micro/scenes/tissue/static_lattice.h"
#include "tests/memory_context.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

using namespace turgor;

namespace {
ParenchymaParameters coarse_cell() {
  ParenchymaParameters cell;
  cell.nodes_per_side = 5;
  return cell;
}

const EquilibriumSettings settings{1e-9, 300};

double largest_shift(const LatticeBlock &block) {
  const std::vector<double> flat = block.reference;
  double largest = 0.;
  for (std::size_t i = 0; i < flat.size(); ++i)
    largest = std::max(largest, std::abs(block.relaxed[i] - flat[i]));
  return largest;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(static_lattice)

BOOST_AUTO_TEST_CASE(frozen_surfaces_keep_the_reference) {
  for (const Surfaces surfaces : {Surfaces::frozen, Surfaces::slab}) {
    LatticeBlock block(coarse_cell(), 3, 2, surfaces);
    const LatticeEffort effort = block.relax(settings);
    BOOST_TEST(effort.residual <= 1e-9);
    BOOST_TEST(largest_shift(block) < 1e-9 * block.width);
    // stress-free as a whole: the missing neighbours pull as much as they push
    const double scale = 200e3 * block.width * 50e-6;
    BOOST_TEST(block.dead_force().norm() < 1e-6 * scale);
  }
}

BOOST_AUTO_TEST_CASE(the_clamp_carries_the_weight) {
  for (const Surfaces surfaces : {Surfaces::frozen, Surfaces::free, Surfaces::osmosis, Surfaces::slab}) {
    LatticeBlock block(coarse_cell(), 3, 2, surfaces);
    block.relax(settings);
    block.load({.size = 5e3}, settings);
    const Vector<2> sum = block.clamp_reaction() + block.weight() + block.dead_force();
    BOOST_TEST(sum.norm() < 1e-5 * block.weight().norm());
    BOOST_TEST(block.probe_displacement()[1] < 0.);
  }
}

// Shear of a slab tilts the horizontal walls, whose tension is turgor L z0 a period: shear modulus = turgor,
// so u(W)/W = rho b W/(2 turgor) for small loads. A string under even load takes the exact shape at its
// supports, so this holds for few cells too. Ties and bending walls, which are not in it, are made stiff and
// soft.
BOOST_AUTO_TEST_CASE(slab_bends_as_strings_under_turgor) {
  ParenchymaParameters cell = coarse_cell();
  cell.wall_bending = false;
  cell.lamella_ratio = 1e3;
  LatticeBlock block(cell, 5, 1, Surfaces::slab);
  block.relax(settings);
  const double load = 200.;  // Pa
  block.load({.size = load}, settings);
  const double expected = load / (2. * cell.turgor);
  BOOST_TEST(-block.probe_displacement()[1] / block.width == expected, boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(free_cells_bulge_and_osmosis_restores_turgor) {
  LatticeBlock fixed(coarse_cell(), 3, 3, Surfaces::free), osmotic(coarse_cell(), 3, 3, Surfaces::osmosis);
  fixed.relax(settings);
  osmotic.relax(settings);
  BOOST_TEST(largest_shift(fixed) > 0.01 * 100e-6);
  double taken_up = 0.;
  for (std::size_t c = 0; c < 9; ++c) {
    BOOST_TEST(fixed.network->fluid_mass(c) == fixed.network->fluid_mass(0));
    BOOST_TEST(fixed.pressure()[c] < fixed.reference_pressure);
    BOOST_TEST(osmotic.pressure()[c] == osmotic.reference_pressure, boost::test_tools::tolerance(1e-6));
    taken_up += osmotic.network->fluid_mass(c) - fixed.network->fluid_mass(c);
  }
  BOOST_TEST(taken_up > 0.);  // as a whole: swelling neighbours may squeeze water out of a cell at the clamp
}

// The tip does not know in how many increments the load came.
BOOST_AUTO_TEST_CASE(the_way_of_loading_does_not_matter) {
  LatticeBlock once(coarse_cell(), 3, 3, Surfaces::frozen), twice(coarse_cell(), 3, 3, Surfaces::frozen);
  once.load({.size = 20e3}, settings);
  twice.load({.size = 10e3}, settings);
  twice.load({.size = 20e3}, settings);
  BOOST_TEST((once.probe_displacement() - twice.probe_displacement()).norm() < 1e-7 * once.width);
}

BOOST_AUTO_TEST_CASE(water_held_at_a_pressure_has_its_forces_from_the_energy) {
  HydrostaticNetwork network(make_parenchyma(coarse_cell(), 2, 1, false, false));
  network.hold_pressure(150e3);
  std::vector<double> x = network.layout().positions();
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] += 0.02 * network.layout().spacing * std::sin(3. * double(i));
  const Tensor2<2> H = network.layout().lattice;
  NetworkEvaluation at, side;
  network.evaluate(x, H, NetworkOrder::gradient, at);
  const double h = 1e-4 * network.layout().spacing;
  for (std::size_t i = 0; i < x.size(); i += 7) {
    double difference = 0.;
    for (const double sign : {1., -1.}) {
      std::vector<double> y = x;
      y[i] += sign * h;
      network.evaluate(y, H, NetworkOrder::energy, side);
      difference += sign * side.energy / (2. * h);
    }
    BOOST_TEST(std::abs(difference - at.gradient[i]) < 1e-4 * network.force_scale());
  }
  network.release_water(at.volume);
  NetworkEvaluation released;
  network.evaluate(x, H, NetworkOrder::gradient, released);
  for (const double p : released.pressure) BOOST_TEST(p == 150e3, boost::test_tools::tolerance(1e-8));
  BOOST_CHECK_THROW(network.release_water(at.volume), std::logic_error);
  BOOST_CHECK_THROW(network.set_fluid_masses({1.}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_block_too_large_is_refused) {
  StaticLattice scene;
  InputEntries prm;
  scene.declare_parameters(prm);
  prm.read("set Columns = 200\nset Rows = 200\n");
  BOOST_CHECK_EXCEPTION(scene.check(), InputError, [](const InputError &e) {
    return std::string(e.what()).find("choose a smaller block") != std::string::npos;
  });
  InputEntries other;
  StaticLattice fine;
  fine.declare_parameters(other);
  other.read("set Columns = 4\nset Rows = 4\n");
  fine.check();
}

// Walls of a millionth of N/m under 0.2 MPa: defined, and not what anybody means.
BOOST_AUTO_TEST_CASE(walls_blown_up_by_turgor_are_told_of) {
  for (const auto &[stiffness, told] : {std::pair{"1e-6", true}, {"100", false}}) {
    test::Disk disk;
    test::MemoryContext context(disk, false);
    StaticLattice scene;
    InputEntries prm;
    scene.declare_parameters(prm);
    for (const auto &[name, value] : {std::pair{"Columns", "1"}, {"Rows", "1"}, {"Load", "1"}})
      prm.set(name, std::string(value));
    prm.set("Fields", std::string("false"));
    prm.enter_subsection("Cell");
    prm.set("Nodes per side", std::string("5"));
    prm.set("Wall stiffness", std::string(stiffness));
    prm.leave_subsection();
    scene.check();
    scene.run(context);
    BOOST_TEST(context.notes.contains("wall_stretch") == told);
  }
}

BOOST_AUTO_TEST_SUITE_END()
