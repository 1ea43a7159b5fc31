// What one RVE call costs: hydrostatic elastic equilibrium along a path in steps of |dF| = 1e-4
// (warm) and constrained runs of 0.1 us with SPH fluid.
//
//   build-bench/benchmarks/benchmark_rve --benchmark_repetitions=5 --benchmark_report_aggregates_only
//
// structure: RVEs of n x n square cells or bricks; an iteration is a Newton iteration with its share of all
// else in a call, a wall node one of the RVE's.
#include "rve/hydrostatic_rve.h"
#include "rve/make_rve.h"
#include "rve/sph_rve.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace {
using namespace turgor;

void walk(benchmark::State &state, const Rve<2> &rve) {
  const auto workspace = rve.make_workspace();
  RveState<2> committed = rve.initial_state();
  double s = 0.;
  std::size_t iterations = 0, calls = 0;
  for (auto _ : state) {
    s += 1e-4;
    Tensor2<2> F, F_dot;
    F << 1., 0.1 * std::sin(10. * s), 0., 1.;
    F_dot << 0., 300., 0., 0.;
    RveAnswer<2> answer = rve.evaluate(committed, F, F_dot, RveRequest(), *workspace);
    iterations += std::size_t(answer.diagnostics.iterations);
    ++calls;
    committed = std::move(answer.trial);
  }
  using benchmark::Counter;
  state.counters["iterations"] = double(iterations) / double(calls);
  // CPU time over these: a time when inverted
  state.counters["an_iteration"] = Counter(double(iterations), Counter::kIsRate | Counter::kInvert);
  state.counters["state_bytes"] = double(committed.unknowns.size() * sizeof(double));
}

void hydrostatic(benchmark::State &state) {
  HydrostaticRveSettings settings;
  settings.equilibrium.tolerance = 1e-6;
  const HydrostaticRve rve(ParenchymaParameters(), settings);
  walk(state, rve);
}
BENCHMARK(hydrostatic)->Unit(benchmark::kMicrosecond);

void structure(benchmark::State &state, const StructureKind kind) {
  RveParameters p;
  p.structure.kind = kind;
  p.columns = p.rows = static_cast<unsigned int>(state.range(0));
  p.tolerance = 1e-6;
  const std::unique_ptr<Rve<2>> rve = make_rve(p);
  walk(state, *rve);
  const double nodes = 0.5 * double(rve->initial_state().unknowns.size());
  state.counters["wall_nodes"] = nodes;
  state.counters["iteration_and_node"] =
      benchmark::Counter(nodes * double(state.iterations()) * state.counters["iterations"].value,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(structure, square, StructureKind::square)
    ->ArgName("side")
    ->Arg(1)
    ->Arg(2)
    ->Arg(4)
    ->Arg(8)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(structure, brick, StructureKind::brick)
    ->ArgName("side")
    ->Arg(1)
    ->Arg(2)
    ->Arg(4)
    ->Arg(8)
    ->Unit(benchmark::kMicrosecond);

void constrained_runs(benchmark::State &state) {
  ParenchymaParameters cell;
  cell.fluid_viscosity = 1.;
  SphRveSettings settings;
  settings.burst = 1e-7;
  settings.window = 5e-8;
  static const SphRve rve(cell, settings);
  walk(state, rve);
}
BENCHMARK(constrained_runs)->Unit(benchmark::kMicrosecond);
}  // namespace

BENCHMARK_MAIN();
