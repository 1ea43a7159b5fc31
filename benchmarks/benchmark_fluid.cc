// ns per particle step and per pair of the particle engine: whole kick-drift-kick steps of
// 1, 16 and 256 turgid cells (584 particles each), with and without viscosity, on 1 and 2 threads.
//
//   cmake -S . -B build-bench -G Ninja -DTURGOR_BENCHMARKS=ON && ninja -C build-bench benchmark_fluid
//   build-bench/benchmarks/benchmark_fluid --benchmark_repetitions=5 --benchmark_report_aggregates_only
//
// Counters: cpu_ns_particle (CPU time of all threads, a step, over particles), cpu_ns_neighbour (over the
// neighbours within the support), neighbours, list_bytes_particle. The time column is wall time.
// TURGOR_SIMD=avx2 or portable measures those sweeps.
#include "micro/cells/sph_parenchyma.h"
#include "micro/processes/annealed_cells.h"
#include "micro/engine/kick_drift_kick.h"

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <ctime>

namespace {
using namespace turgor;

void step(benchmark::State &state) {
  const unsigned int cells = unsigned(state.range(0)), threads = unsigned(state.range(2));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  ParenchymaParameters cell;
  cell.fluid_viscosity = state.range(1) ? 1. : 0.;
  SphParameters sph;
  static const ReferenceCell reference = anneal_square_cell(cell, sph);
  const auto patch = make_sph_patch(make_parenchyma(cell, cells, cells, true, true), sph, reference);
  ParticleSystem<2> &system = patch->system;
  system.threads = threads;
  KickDriftKick<2> integrator(system);
  system.compute_forces();
  const double dt = 0.9 * system.stable_time_step();
  const std::clock_t start = std::clock();
  for (auto _ : state) integrator.step(dt);
  const double ns = double(std::clock() - start) / CLOCKS_PER_SEC * 1e9 / double(state.iterations());
  const double n = double(system.particles.size()),
               neighbours = patch->fluid->mean_neighbours(system.particles);
  const double fluid = double(sph.particles_per_side) * sph.particles_per_side * cells * cells;
  state.counters["cpu_ns_particle"] = ns / n;
  state.counters["cpu_ns_neighbour"] = ns / (fluid * neighbours);
  state.counters["neighbours"] = neighbours;
  state.counters["particles"] = n;
  state.counters["list_bytes_particle"] = double(patch->fluid->memory_bytes()) / n;
}
BENCHMARK(step)
    ->ArgNames({"cells_a_side", "viscous", "threads"})
    ->ArgsProduct({{1}, {0, 1}, {1}})
    ->ArgsProduct({{4, 16}, {0, 1}, {1, 2}})
    ->MeasureProcessCPUTime()
    ->UseRealTime();
}  // namespace

BENCHMARK_MAIN();
