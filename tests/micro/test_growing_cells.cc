// Deformable cells that grow and divide: the reference state, halves of cells, the books, and the same bits
// after a stop and on threads.
#include "micro/geometry/cell_halves.h"
#include "micro/geometry/surface_crossing.h"
#include "micro/laws/population_doubling.h"
#include "micro/laws/random_turn.h"
#include "micro/scenes/deformable/growing_cells.h"
#include "micro/scenes/deformable/spheroid_deformable.h"
#include "run_of_scene.h"

#include <numbers>

using namespace turgor;
using namespace turgor::test;

namespace {
constexpr double third = 4. / 3. * std::numbers::pi;

TouchingMaterial coarse_material() {
  TouchingMaterial m;
  m.nu = 3;
  m.bulk_modulus = 2500.;
  m.adhesion = 1e-5;
  m.viscosity = 600.;
  m.tolerance = 0.05;
  m.longest_step = 60.;
  m.range = 0.75e-6;
  m.rest = 0.3e-6;
  return m;
}

GrowingCellsParameters coarse() {
  GrowingCellsParameters all;
  all.material = coarse_material();
  all.life.birth_volume = third * 1e-15;
  all.life.cycle_time = 5000.;
  all.life.growth = {.exponential = true, .inhibition = Inhibition::none};
  all.life.cycle.mitosis = 0.;
  all.life.variability.spread = 0.;
  all.interval = 50.;
  return all;
}

struct Grown {
  explicit Grown(const GrowingCellsParameters &parameters, const std::vector<Vector<3>> &centres,
                 const double until)
      : tissue(parameters, centres, std::vector<double>(centres.size(), 0.), 1) {
    tissue.begin();
    while (tissue.cells.time() < until * (1. - 1e-12)) tissue.step(until - tissue.cells.time());
  }
  GrowingCells tissue;
};

const std::string two =
    "set First cells = 2\nset End time = 6000\nset Frames = 2\nset Longest step = 100\nset Fields = "
    "false\nset "
    "Samples = 30\nsubsection Cell\n set Frequency = 2\n set Cycle time = 5000\nend\nsubsection Contact\n "
    "set "
    "Gap at rest = 0.45e-6\nend\nsubsection Growth\n set Mitosis time = 300\nend\n";
}  // namespace

BOOST_AUTO_TEST_SUITE(growing_cells)

// A cell that grows with its reference state and lies as large as that stays free of stress (B.17).
BOOST_AUTO_TEST_CASE(growth_keeps_a_cell_free_of_stress) {
  DeformableCells cells(coarse_material(), {sphere_shape(3, 10e-6)}, 1);
  Particles<3> &p = cells.system.particles;
  const double before = cells.surfaces->cells.column("rest_volume")[0], s = std::cbrt(2.);
  cells.system.compute_forces();
  cells.surfaces->grow(0, 1.3 * before);  // the slope of the energy, by central differences
  const double slope = cells.slope_of_growth(0), by = 1e-4;
  double energy[2];
  for (const int k : {0, 1}) {
    cells.surfaces->grow(0, 1.3 * before * std::exp(k == 0 ? 3. * by : -3. * by));
    cells.system.compute_forces();
    energy[k] = cells.energy();
  }
  BOOST_TEST((energy[0] - energy[1]) / (2. * by) == slope, boost::test_tools::tolerance(1e-6));
  cells.surfaces->grow(0, 2. * before);
  cells.system.compute_forces();
  BOOST_TEST(cells.energy() > 1e-16);
  for (int d = 0; d < 3; ++d)
    for (double &x : p.x[d]) x *= s;
  cells.system.compute_forces();
  BOOST_TEST(cells.energy() < 1e-28);
  BOOST_TEST(cells.largest_force() < 1e-20);
  BOOST_TEST(cells.surfaces->volume(p, 0) == 2. * before, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(halves_of_a_ball_by_hand) {
  const DeformableShape ball = sphere_shape(8, 1.);
  CellHalves::Faces faces;
  for (const auto &[a, b, c] : ball.mesh.faces) faces.push_back({a, b, c});
  std::vector<Vector<3>> nodes;
  for (const Vector<3> &x : ball.nodes) nodes.push_back(x + Vector<3>(3., -2., 1.));
  const Vector<3> along = Vector<3>(1., 2., -2.).normalized();
  const CellHalves halves(nodes, faces, along);
  for (const int side : {0, 1}) {
    BOOST_TEST(halves.volume(side) == 0.5 * third, boost::test_tools::tolerance(1e-9));
    const Vector<3> away = halves.centre(side) - Vector<3>(3., -2., 1.);  // at 3/8 of the radius
    BOOST_TEST((away - (side == 0 ? 0.375 : -0.375) * along).norm() < 5e-3);
    for (const unsigned int sweeps : {0u, 10u}) {
      const DeformableShape net = sphere_shape(4, 1.);
      std::vector<Vector<3>> directions;
      for (const Vector<3> &x : net.nodes) directions.push_back((random_turn(1, 7) * x).normalized());
      const double gap = 0.025;
      const std::vector<Vector<3>> daughter = halves.daughter(side, net.mesh, directions, gap, sweeps);
      BOOST_TEST(!find_crossing(net.mesh, daughter));
      double volume = 0.;
      for (const auto &[a, b, c] : net.mesh.faces)
        volume += (daughter[a] - halves.centre(side))
                      .dot((daughter[b] - halves.centre(side)).cross(daughter[c] - halves.centre(side))) /
                  6.;
      BOOST_TEST(volume > 0.88 * 0.5 * third);
      for (const Vector<3> &x : daughter) {
        BOOST_TEST((x - Vector<3>(3., -2., 1.)).norm() < 1.02);
        BOOST_TEST((side == 0 ? 1. : -1.) * along.dot(x - Vector<3>(3., -2., 1.)) > 0.5 * gap - 1e-9);
      }
    }
  }
}

// Growth that nothing inhibits has a closed form whatever cells do to each other: V_0 in all doubles in each
// cycle, cells of one age divide together.
BOOST_AUTO_TEST_CASE(volume_at_rest_and_number_by_their_closed_form) {
  const GrowingCellsParameters law = coarse();
  const Grown grown(law, {Vector<3>::Zero()}, 12500.);
  const auto &rest = grown.tissue.cells.surfaces->cells.column("rest_volume");
  double sum = 0.;
  for (const double V : rest) sum += V;
  BOOST_TEST(grown.tissue.size() == 4u);
  BOOST_TEST(sum == law.life.birth_volume * std::exp2(2.5), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(grown.tissue.life.grown == sum - law.life.birth_volume, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(grown.tissue.life.born() == 7u);
  BOOST_TEST(grown.tissue.divided.rejected == 0u);
  BOOST_TEST(grown.tissue.divided.least_volume > 0.95);
  BOOST_TEST(grown.tissue.divided.lowest_gap > 0.);
  // one newborn cell: two after its cycle; with spread half of the fifth generation has divided at five
  // cycles
  BOOST_TEST(expected_cells(12500., 5000., 0.) == 4.);
  BOOST_TEST(expected_cells(5., 1., 0.1) == 24., boost::test_tools::tolerance(1e-3));
  BOOST_TEST(
      expected_cells(20.5, 1., 0.1) / expected_cells(19.5, 1., 0.1) == std::exp2(1. / doubling_time(1., 0.1)),
      boost::test_tools::tolerance(0.02));
}

// What steps of finite length lose falls with their length; nothing else is missing in the books of growth
// and division.
BOOST_AUTO_TEST_CASE(growth_and_division_balance_their_energy) {
  double lost[2];
  for (int k = 0; k < 2; ++k) {
    GrowingCellsParameters law = coarse();
    law.interval = law.material.longest_step = k == 0 ? 50. : 5.;
    law.material.residual = 1e-8;
    const Grown grown(law, {Vector<3>::Zero()}, 5200.);
    BOOST_TEST(grown.tissue.size() == 2u);
    BOOST_TEST(grown.tissue.growth_work > 0.);
    lost[k] = grown.tissue.cells.energy_lost();
  }
  BOOST_TEST_MESSAGE("lost " << lost[0] << ", " << lost[1]);
  BOOST_TEST(std::abs(lost[1]) < 0.5 * std::abs(lost[0]));
}

// The first of two cells moves, the other one is held: it stays, to femtometres, and pushes as one that moves
// does.
BOOST_AUTO_TEST_CASE(held_cells_stay_and_touch) {
  const TouchingMaterial m = coarse_material();
  DeformableCells both(
      m, {sphere_shape(3, 10e-6), placed(sphere_shape(3, 10e-6), random_turn(1, 1), {20.1e-6, 0., 0.})}, 1);
  both.begin(0.1);
  DeformableCells part(both, {0, 1}, 1);
  part.begin(0.1);
  const Particles<3> &p = both.system.particles, &q = part.system.particles;
  for (int d = 0; d < 3; ++d)
    for (std::uint32_t i = 0; i < p.groups[0].end; ++i) BOOST_TEST(p.f[d][i] == q.f[d][i]);
  for (int k = 0; k < 5; ++k) part.step(1.);
  double moved = 0.;
  for (int d = 0; d < 3; ++d)
    for (std::uint32_t i = p.groups[1].begin; i < p.groups[1].end; ++i)
      moved = std::max(moved, std::abs(p.x[d][i] - q.x[d][i]));
  BOOST_TEST(moved < 1e-15);
  BOOST_TEST(std::abs(p.x[0][0] - q.x[0][0]) > 1e-12);
  BOOST_TEST(part.heat() > 0.);
}

// Two cells pressed together: the least pressed direction of each is across the line of their centres.
BOOST_AUTO_TEST_CASE(contacts_tell_where_a_cell_is_pressed) {
  TouchingMaterial m = coarse_material();
  m.adhesion = 0.;
  DeformableCells cells(
      m, {sphere_shape(3, 10e-6), placed(sphere_shape(3, 10e-6), random_turn(1, 1), {19.9e-6, 0., 0.})}, 1);
  cells.begin(1.);
  const Tensor2<3> virial = cells.touching->virial(0, Vector<3>::Zero());
  BOOST_TEST(virial(0, 0) < 0.);
  BOOST_TEST(std::abs(virial(1, 1)) < 0.2 * std::abs(virial(0, 0)));
  CellDivision law;
  law.direction = DivisionDirection::least_stress;
  BOOST_TEST(std::abs(law.choose(0, virial)[0]) < 0.2);
}

BOOST_AUTO_TEST_CASE(stopped_runs_go_on_with_the_same_bits_and_threads_do_not_matter) {
  const Outcome once = run<SpheroidDeformable>(two, 1, 0, "history");
  BOOST_TEST(once.results.at("divisions") >= 2.);
  for (const unsigned long stop : {20ul, 50ul, 56ul})
    BOOST_TEST((run<SpheroidDeformable>(two, 1, stop, "history").rows == once.rows));
  for (const unsigned int threads : {2u, 3u})
    BOOST_TEST((run<SpheroidDeformable>(two, threads, 0, "history").rows == once.rows));
}

BOOST_AUTO_TEST_SUITE_END()
