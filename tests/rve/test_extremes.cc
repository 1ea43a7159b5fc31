// Row of extremes: isochoric 0.5 ... 2, shear up to 1, J 0.98 ... 1.02, rates up to 1e5 1/s and random
// combinations. Nothing may be infinite or NaN; each converges or says why not; a rotated F gives the
// rotated stress. The cheap part runs always; all of it, with tables (doc/validation.md):
//
//   ninja -C build test_rve
//   build/tests/test_rve --run_test=extremes/table          also extremes/table/constrained_runs etc. alone;
//                                                           extremes/boundary, extremes/perturbed_starts
//   build/tests/test_rve --run_test=extremes/structures     bricks, hexagons, Laguerre cells, air spaces
#include "micro/laws/counter_random.h"
#include "run/number_text.h"
#include "rve/hydrostatic_rve.h"
#include "rve/make_rve.h"
#include "rve/sph_rve.h"
#include "tests/rve/matrix.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

using namespace turgor;
using turgor::test::matrix;

namespace {
struct Load {
  Tensor2<2> F, F_dot;
};

/// Corners of the range, one at a time, then random combinations of all of it.
std::vector<Load> loads(const unsigned int random_combinations) {
  const Tensor2<2> zero = Tensor2<2>::Zero();
  std::vector<Load> all;
  for (const double a : {0.5, 0.7, 1.4, 2.}) all.push_back({matrix(a, 0., 0., 1. / a), zero});
  for (const double b : {-1., 0.3, 1.}) all.push_back({matrix(1., b, 0., 1.), zero});
  for (const double J : {0.98, 1.02}) all.push_back({std::sqrt(J) * Tensor2<2>::Identity(), zero});
  for (const double rate : {1e3, 1e4, 1e5}) all.push_back({Tensor2<2>::Identity(), matrix(0., rate, 0., 0.)});
  std::uint64_t counter = 0;
  const auto between = [&](const double low, const double high) {
    return low + (high - low) * random_uniform(20, counter++);
  };
  for (unsigned int i = 0; i < random_combinations; ++i) {
    const double a = std::exp(between(-std::log(2.), std::log(2.))), J = between(0.98, 1.02),
                 b = between(-1., 1.);
    const double rate = std::pow(10., between(0., 5.));
    Load load;
    load.F = matrix(1., b, 0., 1.) * matrix(a, 0., 0., J / a);
    for (int k = 0; k < 4; ++k) load.F_dot(k / 2, k % 2) = rate * between(-1., 1.);
    all.push_back(load);
  }
  return all;
}

struct Outcome {
  int asked = 0, reached = 0, objective = 0;
  double most_seconds = 0., seconds = 0., worst_residual = 0., worst_rotation = 0., worst_spread = 0.;
  std::map<std::string, int> reasons;  ///< sentence up to its first number
};

/// The state with its positions (its first `positions` unknowns) moved by up to `most` (m).
RveState<2> disturbed(RveState<2> state, const std::size_t positions, const double most,
                      const std::uint64_t seed) {
  for (std::size_t i = 0; i < positions; ++i) state.unknowns[i] += most * (2. * random_uniform(seed, i) - 1.);
  return state;
}

/// A hundredth of a particle spacing, m.
double disturbance(const ParenchymaParameters &cell) {
  return 0.01 * cell.period / SphParameters().particles_per_side;
}

/// Asks for every load from the reference and for its rotation; for the first `spread_over` loads also from
/// three states whose `positions` first unknowns are disturbed.
Outcome ask(const Rve<2> &rve, const std::vector<Load> &all, const double objectivity_tolerance,
            const std::size_t spread_over = 0, const std::size_t positions = 0) {
  const Tensor2<2> Q = matrix(0.8, -0.6, 0.6, 0.8);
  const auto workspace = rve.make_workspace();
  const RveState<2> start = rve.initial_state();
  Outcome outcome;
  for (const Load &load : all) {
    const RveAnswer<2> a = rve.evaluate(start, load.F, load.F_dot, {}, *workspace),
                       b = rve.evaluate(start, Q * load.F, Q * load.F_dot, {}, *workspace);
    BOOST_TEST(a.sigma.allFinite());
    BOOST_TEST(a.P.allFinite());
    BOOST_TEST(std::isfinite(a.energy));
    BOOST_TEST((a.diagnostics.converged || a.diagnostics.message.size() > 20));
    BOOST_TEST((a.diagnostics.converged || a.trial.unknowns == start.unknowns));
    ++outcome.asked;
    outcome.seconds += a.diagnostics.cpu_seconds;
    outcome.most_seconds = std::max(outcome.most_seconds, a.diagnostics.cpu_seconds);
    if (!a.diagnostics.converged) {
      std::string reason = a.diagnostics.message;
      reason.erase(
          std::remove_if(reason.begin(), reason.end(), [](const char c) { return c >= '0' && c <= '9'; }),
          reason.end());
      ++outcome.reasons[reason];
      continue;
    }
    ++outcome.reached;
    outcome.worst_residual = std::max(outcome.worst_residual, a.diagnostics.residual);
    const double rotation = b.diagnostics.converged
                                ? (b.sigma - Q * a.sigma * Q.transpose()).norm() / (a.sigma.norm() + 200e3)
                                : HUGE_VAL;
    outcome.objective += rotation < objectivity_tolerance;
    if (b.diagnostics.converged) outcome.worst_rotation = std::max(outcome.worst_rotation, rotation);
    for (std::uint64_t seed = 1; seed <= 3 && outcome.asked <= int(spread_over) && positions > 0; ++seed) {
      const RveAnswer<2> c = rve.evaluate(disturbed(start, positions, disturbance({}), 100 + seed), load.F,
                                          load.F_dot, {}, *workspace);
      if (c.diagnostics.converged)
        outcome.worst_spread =
            std::max(outcome.worst_spread, (c.sigma - a.sigma).norm() / (a.sigma.norm() + 200e3));
      else
        ++outcome.reasons["from a disturbed start: " + c.diagnostics.message];
    }
  }
  return outcome;
}

const char *const rule_names[] = {"cauchy_born", "elastic_equilibrium", "constrained_runs"};

SphRveSettings settings_of(const int rule) {
  SphRveSettings settings;
  settings.rule = SphRule(rule);
  return settings;
}

/// n x n cells of one pressure each.
std::unique_ptr<Rve<2>> rve_of(const StructureKind kind, const unsigned int n, const double gap) {
  RveParameters p;
  p.structure.kind = kind;
  p.structure.gap = gap;
  p.columns = p.rows = n;
  p.tolerance = 1e-9;
  p.cell.fluid_viscosity = 1.;
  return make_rve(p);
}

/// One answer in a line.
void print(const char *what, const double value, const RveAnswer<2> &a) {
  if (a.diagnostics.converged)
    std::printf("| %s | %g | sigma_xx %.5g, xy %.5g, yy %.5g kPa, pressure %.4g kPa | %d | %.2g | %.3f |\n",
                what, value, 1e-3 * a.sigma(0, 0), 1e-3 * a.sigma(0, 1), 1e-3 * a.sigma(1, 1),
                1e-3 * a.pressure, a.diagnostics.iterations, a.diagnostics.residual,
                a.diagnostics.cpu_seconds);
  else
    std::printf("| %s | %g | none: \"%s\" | %d | %.2g | %.3f |\n", what, value, a.diagnostics.message.c_str(),
                a.diagnostics.iterations, a.diagnostics.residual, a.diagnostics.cpu_seconds);
  std::fflush(stdout);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(extremes)

BOOST_AUTO_TEST_CASE(hydrostatic_cells) {
  ParenchymaParameters cell;
  cell.fluid_viscosity = 1.;
  const HydrostaticRve rve(cell, {});
  const Outcome outcome = ask(rve, loads(100), 1e-6);
  BOOST_TEST_MESSAGE("hydrostatic: " << outcome.reached << " of " << outcome.asked << " reached");
  BOOST_TEST(outcome.reached >= 0.95 * outcome.asked);
  // Beyond buckling equilibria are not unique: round-off may choose another one for the rotated F.
  BOOST_TEST(outcome.objective >= 0.9 * outcome.reached);
}

BOOST_AUTO_TEST_CASE(cells_of_other_structures) {
  for (const StructureKind kind : {StructureKind::brick, StructureKind::hexagon})
    for (const double gap : {0., 20e-6}) {
      const Outcome outcome = ask(*rve_of(kind, 1, gap), loads(5), 1e-6);
      BOOST_TEST(outcome.reached == outcome.asked, word_of(kind) << ", gap " << gap);
      BOOST_TEST(outcome.objective == outcome.reached, word_of(kind) << ", gap " << gap);
    }
}

BOOST_AUTO_TEST_CASE(sph_cells) {
  ParenchymaParameters cell;
  cell.nodes_per_side = 10;
  cell.fluid_viscosity = 1.;
  for (int rule = 0; rule < 3; ++rule) {
    SphRveSettings settings = settings_of(rule);
    settings.sph.particles_per_side = 9;
    settings.sph.anneal_steps = 10000;
    settings.relax_steps = 2000;
    const Outcome outcome = ask(SphRve(cell, settings), loads(3), 1e-4);
    std::string why;
    for (const auto &[reason, count] : outcome.reasons) why += "\n  " + number_text(count) + " x " + reason;
    BOOST_TEST_MESSAGE(rule_names[rule] << ": " << outcome.reached << " of " << outcome.asked << " reached, "
                                        << outcome.objective << " of them the same under rotation, worst "
                                        << outcome.worst_rotation << why);
    BOOST_TEST(outcome.reached == outcome.asked, rule_names[rule] << why);
    BOOST_TEST(outcome.objective == outcome.reached, rule_names[rule] << ": " << outcome.worst_rotation);
  }
}

// What was reached, a row per case. Minutes of CPU.
BOOST_AUTO_TEST_SUITE(table, *boost::unit_test::disabled() * boost::unit_test::label("slow"))

void row(const std::string &name, const Outcome &o) {
  static bool headed = false;
  if (!headed)
    std::printf(
        "| RVE | asked | reached | same under rotation | largest difference under rotation | largest "
        "residual | "
        "largest change from 3 disturbed starts, first 12 | CPU s, mean | CPU s, most | why not |\n"
        "|---|---|---|---|---|---|---|---|---|---|\n");
  headed = true;
  std::printf("| %s | %d | %d | %d | %.2g | %.2g | %.2g | %.4f | %.4f | ", name.c_str(), o.asked, o.reached,
              o.objective, o.worst_rotation, o.worst_residual, o.worst_spread, o.seconds / o.asked,
              o.most_seconds);
  for (const auto &[reason, count] : o.reasons) std::printf("%d x \"%s\" ", count, reason.c_str());
  std::printf("|\n");
  std::fflush(stdout);
}

void sph_row(const int rule) {
  ParenchymaParameters cell;
  cell.fluid_viscosity = 1.;
  const SphRve rve(cell, settings_of(rule));
  const std::size_t positions = 2 * rve.particle_count();
  row(std::string("sph, ") + rule_names[rule], ask(rve, loads(100), 1e-5, 12, rule == 0 ? 0 : positions));
}

BOOST_AUTO_TEST_CASE(hydrostatic) {
  ParenchymaParameters cell;
  cell.fluid_viscosity = 1.;
  const HydrostaticRve rve(cell, {});
  row("hydrostatic, elastic_equilibrium",
      ask(rve, loads(100), 1e-6, 12, rve.initial_state().unknowns.size()));
}
BOOST_AUTO_TEST_CASE(cauchy_born) { sph_row(0); }
BOOST_AUTO_TEST_CASE(elastic_equilibrium) { sph_row(1); }
BOOST_AUTO_TEST_CASE(constrained_runs) { sph_row(2); }

BOOST_AUTO_TEST_SUITE_END()

// The same of cells that are not square, and of tissue with air spaces of 20 um. A minute of CPU.
BOOST_AUTO_TEST_SUITE(structures, *boost::unit_test::disabled() * boost::unit_test::label("slow"))

void structure_row(const StructureKind kind, const unsigned int n, const double gap = 0.) {
  const std::unique_ptr<Rve<2>> rve = rve_of(kind, n, gap);
  table::row(word_of(kind) + (gap > 0. ? ", sparse, " : ", ") + number_text(n * n),
             ask(*rve, loads(100), 1e-6, 12, rve->initial_state().unknowns.size()));
}

BOOST_AUTO_TEST_CASE(brick) { structure_row(StructureKind::brick, 1); }
BOOST_AUTO_TEST_CASE(bricks) { structure_row(StructureKind::brick, 2); }
BOOST_AUTO_TEST_CASE(hexagon) { structure_row(StructureKind::hexagon, 1); }
BOOST_AUTO_TEST_CASE(laguerre) { structure_row(StructureKind::voronoi, 3); }
BOOST_AUTO_TEST_CASE(sparse_brick) { structure_row(StructureKind::brick, 1, 20e-6); }
BOOST_AUTO_TEST_CASE(sparse_bricks) { structure_row(StructureKind::brick, 2, 20e-6); }
BOOST_AUTO_TEST_CASE(sparse_hexagon) { structure_row(StructureKind::hexagon, 1, 20e-6); }

BOOST_AUTO_TEST_SUITE_END()

// Where the SPH cell breaks, one entry at a time.
BOOST_AUTO_TEST_CASE(boundary, *boost::unit_test::disabled() * boost::unit_test::label("slow")) {
  ParenchymaParameters cell;
  cell.fluid_viscosity = 1.;
  std::printf("\n| what | value | answer | steps | residual | CPU s |\n|---|---|---|---|---|---|\n");
  const Tensor2<2> zero = Tensor2<2>::Zero();
  for (int rule = 0; rule < 3; ++rule) {
    const SphRve rve(cell, settings_of(rule));
    const auto workspace = rve.make_workspace();
    for (const double a : {0.7, 0.5, 0.4, 0.3, 0.2})
      print((std::string(rule_names[rule]) + ", isochoric, one step").c_str(), a,
            rve.evaluate(rve.initial_state(), matrix(a, 0., 0., 1. / a), zero, {}, *workspace));
    for (const double b : {1., 1.5, 2., 3.})
      print((std::string(rule_names[rule]) + ", shear, one step").c_str(), b,
            rve.evaluate(rve.initial_state(), matrix(1., b, 0., 1.), zero, {}, *workspace));
    for (const double J : {0.95, 0.9, 0.8, 1.05, 1.1, 1.3})
      print((std::string(rule_names[rule]) + ", J").c_str(), J,
            rve.evaluate(rve.initial_state(), std::sqrt(J) * Tensor2<2>::Identity(), zero, {}, *workspace));
    for (const double rate : {1e5, 1e6, 1e7, 1e8})
      print((std::string(rule_names[rule]) + ", shear rate, 1/s").c_str(), rate,
            rve.evaluate(rve.initial_state(), Tensor2<2>::Identity(), matrix(0., rate, 0., 0.), {},
                         *workspace));
  }
  for (const double fraction : {0.5, 0.9, 1., 1.1, 1.2, 1.4, 1.7, 2.})
    for (int rule = 1; rule < 3; ++rule) {
      SphRveSettings settings = settings_of(rule);
      settings.step_fraction = fraction;
      settings.burst = 2e-6;
      const SphRve rve(cell, settings);
      const auto workspace = rve.make_workspace();
      print((std::string(rule_names[rule]) + ", step fraction, shear 0.3").c_str(), fraction,
            rve.evaluate(rve.initial_state(), matrix(1., 0.3, 0., 1.), zero, {}, *workspace));
    }
  for (const double viscosity : {0., 1e-3, 1., 10., 100.}) {
    ParenchymaParameters other = cell;
    other.fluid_viscosity = viscosity;
    const SphRve rve(other, settings_of(2));
    const auto workspace = rve.make_workspace();
    print(
        "constrained_runs, viscosity, shear 0.3 at 1e4 1/s", viscosity,
        rve.evaluate(rve.initial_state(), matrix(1., 0.3, 0., 1.), matrix(0., 1e4, 0., 0.), {}, *workspace));
  }
  for (const double modulus : {3e5, 1e6, 6e6, 6e7, 6e8}) {
    ParenchymaParameters other = cell;
    other.fluid_modulus = modulus;
    try {
      const SphRve rve(other, settings_of(1));
      const auto workspace = rve.make_workspace();
      print("elastic_equilibrium, fluid modulus, shear 0.3", modulus,
            rve.evaluate(rve.initial_state(), matrix(1., 0.3, 0., 1.), zero, {}, *workspace));
    } catch (const std::exception &wrong) {
      std::printf("| elastic_equilibrium, fluid modulus | %g | none: \"%s\" | | | |\n", modulus,
                  wrong.what());
    }
  }
}

// Beyond buckling equilibria need not be unique: the same F from disturbed positions.
BOOST_AUTO_TEST_CASE(perturbed_starts, *boost::unit_test::disabled() * boost::unit_test::label("slow")) {
  ParenchymaParameters cell;
  cell.fluid_viscosity = 1.;
  const Tensor2<2> zero = Tensor2<2>::Zero();
  std::printf(
      "\n| sph, elastic_equilibrium | perturbed starts | sigma_xx, xy, yy mean, kPa | largest difference "
      "from the "
      "mean, kPa |\n|---|---|---|---|\n");
  SphRveSettings settings = settings_of(1);
  settings.relax_steps = 6000;
  const SphRve rve(cell, settings);
  const auto workspace = rve.make_workspace();
  for (const Tensor2<2> &F : {matrix(1., 0.3, 0., 1.), matrix(0.7, 0., 0., 1. / 0.7)}) {
    std::vector<Tensor2<2>> answers;
    for (std::uint64_t start = 0; start < 6; ++start) {
      const RveAnswer<2> a = rve.evaluate(disturbed(rve.initial_state(), 2 * rve.particle_count(),
                                                    start > 0 ? disturbance(cell) : 0., 100 + start),
                                          F, zero, {}, *workspace);
      if (a.diagnostics.converged) answers.push_back(a.sigma);
    }
    Tensor2<2> mean = zero;
    for (const auto &s : answers) mean += s / double(answers.size());
    double most = 0.;
    for (const auto &s : answers) most = std::max(most, (s - mean).cwiseAbs().maxCoeff());
    std::printf("| %s | %d | %.5g, %.5g, %.5g | %.3g |\n", F(0, 1) > 0. ? "shear 0.3" : "isochoric 0.7",
                int(answers.size()), 1e-3 * mean(0, 0), 1e-3 * mean(0, 1), 1e-3 * mean(1, 1), 1e-3 * most);
    std::fflush(stdout);
  }
}

BOOST_AUTO_TEST_SUITE_END()
