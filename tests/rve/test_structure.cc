// RVEs of tissue that is not square: stress free at F = I, the same however many cells and however turned,
// and the numbers of the trial of general cells (12 nodes a side, lamella ratio 1) to 1 %.
#include "micro/cells/tissue_structure.h"
#include "rve/hydrostatic_rve.h"
#include "rve/mixed_control.h"
#include "rve/make_rve.h"
#include "rve/plane_moduli.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace turgor;

namespace {
ParenchymaParameters cell() {
  ParenchymaParameters p;
  p.period = 100e-6;
  p.nodes_per_side = 12;
  p.lamella_ratio = 1.;
  return p;
}

HydrostaticRve rve_of(const std::string &kind, const unsigned int n, const double rotation = 0.,
                      const double tolerance = EquilibriumSettings().tolerance) {
  TissueStructure structure;
  structure.kind = choice_of<StructureKind>(kind);
  structure.rotation = rotation;
  HydrostaticRveSettings settings;
  settings.equilibrium.tolerance = tolerance;
  return HydrostaticRve(turgid_tissue(structure, cell(), n, n), settings);
}

RveAnswer<2> answer_at(const HydrostaticRve &rve, const Tensor2<2> &F) {
  const auto workspace = rve.make_workspace();
  RveRequest request;
  request.tangent = true;
  return rve.evaluate(rve.initial_state(), F, Tensor2<2>::Zero(), request, *workspace);
}

/// kPa, pressed along `axis` in steps of 1 %, sides free: nominal stress at 5, 10 and 20 %.
std::vector<double> pressed(const HydrostaticRve &rve, const int axis) {
  LoadingEntries entries;
  entries.path = axis == 0 ? "0 : 1, 0; 0, 1 | 1 : 0.8, 0; 0, 1" : "0 : 1, 0; 0, 1 | 1 : 1, 0; 0, 0.8";
  entries.found = axis == 0 ? "yy" : "xx";
  entries.F_dot_by_hand = "0, 0; 0, 0";
  entries.points = 21;
  const LoadingPath path(entries);
  MixedControl control(rve, path, {});
  const auto workspace = rve.make_workspace();
  RveState<2> state = rve.initial_state();
  double time = 0.;
  std::vector<double> stress;
  for (int percent = 1; percent <= 20; ++percent) {
    LoadingPath::Load load;
    const RveAnswer<2> answer = control.advance(state, time, path.times()[percent], load, *workspace);
    BOOST_REQUIRE_MESSAGE(answer.diagnostics.converged, answer.diagnostics.message);
    BOOST_TEST(std::abs(answer.P(1 - axis, 1 - axis)) < 1.);
    state = answer.trial;
    if (percent == 5 || percent == 10 || percent == 20) stress.push_back(-1e-3 * answer.P(axis, axis));
  }
  return stress;
}

void compare(const std::vector<double> &found, const std::vector<double> &trial) {
  for (std::size_t i = 0; i < trial.size(); ++i)
    BOOST_TEST(found[i] == trial[i], boost::test_tools::tolerance(0.01));
}
}  // namespace

BOOST_AUTO_TEST_SUITE(structure)

BOOST_AUTO_TEST_CASE(moduli_are_those_of_the_trial) {
  struct Row {
    std::string kind;
    double x, y, at_45, axes, shear_45, held;  // kPa, MPa
  };
  for (const Row &row : {Row{"hexagon", 1180., 1180., 1180., 297., 297., 41.3},
                         Row{"brick", 1779., 1782., 942., 450., 237., 41.7}}) {
    const HydrostaticRve rve = rve_of(row.kind, 1);
    const RveAnswer<2> at_rest = answer_at(rve, Tensor2<2>::Identity());
    BOOST_TEST(at_rest.sigma.cwiseAbs().maxCoeff() < 1e-6 * cell().turgor);
    const PlaneModuli found(at_rest.tangent);
    constexpr double quarter = std::numbers::pi / 4.;
    const auto within = boost::test_tools::tolerance(0.01);
    BOOST_TEST(1e-3 * found.free(0.) == row.x, within);
    BOOST_TEST(1e-3 * found.free(2. * quarter) == row.y, within);
    BOOST_TEST(1e-3 * found.free(quarter) == row.at_45, within);
    BOOST_TEST(1e-3 * found.shear_axes == row.axes, within);
    BOOST_TEST(1e-3 * found.shear_45 == row.shear_45, within);
    BOOST_TEST(1e-6 * found.held_y == row.held, within);
  }
}

BOOST_AUTO_TEST_CASE(hexagons_are_isotropic_in_the_plane) {
  const PlaneModuli found(answer_at(rve_of("hexagon", 1), Tensor2<2>::Identity()).tangent);
  for (const double angle : {0.2, 0.5, 0.9, 1.3})
    BOOST_TEST(found.free(angle) == found.free(0.), boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(pressed_with_free_sides_they_answer_as_in_the_trial) {
  const HydrostaticRve brick = rve_of("brick", 1), hexagon = rve_of("hexagon", 1);
  compare(pressed(brick, 1), {121., 376., 1429.});
  compare(pressed(brick, 0), {96., 248., 907.});
  compare(pressed(hexagon, 1), {73., 212., 958.});
  compare(pressed(hexagon, 0), {66., 174., 677.});
}

BOOST_AUTO_TEST_CASE(more_cells_answer_the_same_while_walls_are_in_tension) {
  Tensor2<2> F;
  F << 1.03, 0.1, 0.02, 0.99;
  for (const std::string kind : {"hexagon", "brick"}) {
    const RveAnswer<2> one = answer_at(rve_of(kind, 1, 0., 1e-12), F),
                       nine = answer_at(rve_of(kind, 3, 0., 1e-12), F);
    const double off = (one.sigma - nine.sigma).cwiseAbs().maxCoeff() / cell().turgor;
    BOOST_TEST_MESSAGE(kind << ", 3 x 3 against 1: " << off << " of turgor, residuals "
                            << one.diagnostics.residual << ", " << nine.diagnostics.residual);
    BOOST_TEST(off < 1e-9);
    BOOST_TEST((one.tangent - nine.tangent).cwiseAbs().maxCoeff() < 1e-7 * one.tangent.cwiseAbs().maxCoeff());
  }
}

BOOST_AUTO_TEST_CASE(a_turned_tissue_turns_the_answer) {
  const double degrees = 25., angle = degrees * std::numbers::pi / 180.;
  Tensor2<2> F, turn;
  F << 1.02, 0.08, 0., 0.97;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  for (const std::string kind : {"square", "hexagon", "brick", "voronoi"}) {
    const RveAnswer<2> as_is = answer_at(rve_of(kind, 2), F),
                       turned = answer_at(rve_of(kind, 2, degrees), turn * F * turn.transpose());
    const Tensor2<2> expected = turn * as_is.sigma * turn.transpose();
    BOOST_TEST((turned.sigma - expected).cwiseAbs().maxCoeff() < 1e-9 * expected.cwiseAbs().maxCoeff());
  }
}

// Fluid of particles turns with its walls. Laid anew in turned walls it answered 0.2 % otherwise in shear.
BOOST_AUTO_TEST_CASE(particles_of_a_turned_tissue_turn_with_it) {
  const double degrees = 30., angle = degrees * std::numbers::pi / 180.;
  Tensor2<2> F, turn;
  F << 1., 0.1, 0., 1.;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  for (const StructureKind kind : {StructureKind::square, StructureKind::brick}) {
    RveParameters p;
    p.structure.kind = kind;
    p.cell = cell();
    p.fluid = RveFluid::sph;
    p.sph.particles_per_side = 8;
    p.sph.anneal_steps = 3000;
    const auto answer_of = [&](const double rotation, const Tensor2<2> &deformed) {
      p.structure.rotation = rotation;
      const auto rve = make_rve(p);
      const auto workspace = rve->make_workspace();
      return rve->evaluate(rve->initial_state(), deformed, Tensor2<2>::Zero(), {}, *workspace);
    };
    const RveAnswer<2> upright = answer_of(0., F), turned = answer_of(degrees, turn * F * turn.transpose());
    BOOST_TEST(upright.diagnostics.converged, upright.diagnostics.message);
    const Tensor2<2> expected = turn * upright.sigma * turn.transpose();
    BOOST_TEST((turned.sigma - expected).norm() < 1e-5 * expected.norm());
  }
}

// What is folded together answers alike: P(Q F Q^T) = Q P(F) Q^T for every symmetry that is named.
BOOST_AUTO_TEST_CASE(symmetries_are_those_of_the_cells) {
  Tensor2<2> F;
  F << 1.03, 0.09, -0.02, 0.98;
  struct Row {
    StructureKind kind;
    unsigned int columns, rows;
    std::size_t images;
  };
  for (const Row &row : {Row{StructureKind::square, 1, 1, 3}, Row{StructureKind::square, 2, 1, 1},
                         Row{StructureKind::brick, 1, 1, 1}, Row{StructureKind::brick, 1, 2, 1},
                         Row{StructureKind::brick, 2, 1, 0}, Row{StructureKind::hexagon, 1, 1, 5},
                         Row{StructureKind::hexagon, 2, 2, 5}, Row{StructureKind::hexagon, 2, 1, 0},
                         Row{StructureKind::voronoi, 2, 2, 0}}) {
    RveParameters p;
    p.structure.kind = row.kind;
    p.structure.rotation = 20.;
    p.cell = cell();
    p.columns = row.columns;
    p.rows = row.rows;
    const auto rve = make_rve(p);
    BOOST_TEST(rve->symmetries().size() == row.images);
    const auto &network = dynamic_cast<const HydrostaticRve &>(*rve);
    const Tensor2<2> P = answer_at(network, F).P;
    for (const Tensor2<2> &Q : rve->symmetries())
      BOOST_TEST((answer_at(network, Q * F * Q.transpose()).P - Q * P * Q.transpose()).norm() <
                 1e-7 * P.norm());
  }
}

BOOST_AUTO_TEST_SUITE_END()
