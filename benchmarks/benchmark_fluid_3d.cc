// The fluid of one 3D cell with a wall of 1962 nodes (3920 triangles), in ns, one thread: the sweeps and the
// whole step.
//
//   cmake -S . -B build-bench -G Ninja -DTURGOR_BENCHMARKS=ON && ninja -C build-bench benchmark_fluid_3d
//   build-bench/benchmarks/benchmark_fluid_3d --benchmark_repetitions=5 --benchmark_report_aggregates_only
//
// force: pair forces; density: kernel sums, wall and law; pairs_only: the same without wall; lists: one
// build; step: kick-drift-kick with all lists built as they are due, per particle (fluid and wall). fill:
// particle spacings in a radius; 5.6, 11.1 and 13.8 give about 600, 5000 and 10 000 fluid particles.
// TURGOR_SIMD=avx2 or portable measures those sweeps.
#include "micro/engine/kick_drift_kick.h"
#include "micro/terms/sph_wall_view.h"
#include "tests/micro/small_sphere.h"

#include <benchmark/benchmark.h>

#include <cstdlib>

namespace {
using namespace turgor;

test::SmallSphere settings(const benchmark::State &state) {
  test::SmallSphere sphere;
  sphere.frequency = 14;
  sphere.fill = 0.1 * double(state.range(0));
  sphere.fluid.viscosity = state.range(1) ? 1. : 0.;
  sphere.fluid.barrier = 0.;
  sphere.wall_jitter = 0.;
  return sphere;
}

/// Everything a CellView points to.
struct Cell {
  std::unique_ptr<test::SmallSphere::Cell> cell;
  SphLists<3> lists;
  std::vector<double> rho, gamma, pressure, f[3];
  std::unique_ptr<double, void (*)(void *)> scratch{nullptr, &std::free};
  std::unique_ptr<WallView<3>> wall;
  sph::CellView<3> view;
  double reach = 0., neighbours = 0.;  ///< m; within the support, all particles

  Cell(const benchmark::State &state, const bool with_wall) : cell(settings(state).make()) {
    const Particles<3> &p = cell->system.particles;
    const Group &g = p.groups[0];
    const std::uint32_t n = g.fluid_count();
    view.support = cell->fluid->support();
    reach = view.support + 0.3 * cell->spacing;
    build();
    if (!with_wall) lists.wall.clear(n);
    cell->system.compute_forces();
    neighbours = n * cell->fluid->mean_neighbours(p);
    wall = std::make_unique<WallView<3>>(lists.wall, g, WallSettings{1., false, cell->mesh.get()});
    const std::size_t rows = (std::size_t(n + 1) * sph::row_doubles + 7) / 8 * 8, push = (n + 7) / 8 * 8;
    scratch.reset(
        static_cast<double *>(std::aligned_alloc(64, (rows + push + wall->doubles()) * sizeof(double))));
    view.n = n;
    view.rows = scratch.get();
    view.push = view.rows + rows;
    wall->attach(view, p, view.push + push);
    view.mass = cell->fluid->particle_mass()[0];
    view.volume = wall->volume();
    view.ordering = 60e3;
    view.eos = [](const void *, const std::uint32_t count, const double *, double *out) {
      std::fill(out, out + count, 200e3);
    };
    for (auto *field : {&rho, &gamma, &pressure, &f[0], &f[1], &f[2]}) field->assign(n, 0.);
    for (int d = 0; d < 3; ++d) {
      view.x[d] = p.x[d].data() + g.fluid;
      view.f[d] = f[d].data();
    }
    view.rho = rho.data();
    view.gamma = gamma.data();
    view.pressure = pressure.data();
    view.neighbours = lists.fluid.neighbours.data();
    view.first_neighbour = lists.fluid.first_neighbour.data();
    sph::sweeps<3>().density(view);
  }

  void build() {
    const Particles<3> &p = cell->system.particles;
    ListOrigin<3> origin;
    origin.take(p.x, p.groups[0]);
    const std::uint32_t nw = p.groups[0].wall_count();
    lists.fluid.build(origin, nw, reach);
    lists.wall.build(origin, nw, *cell->mesh, reach, 0.3 * cell->spacing, 0., nullptr);
  }

  void report(benchmark::State &state) const {
    // Seconds per neighbour and per particle; printed in ns.
    using benchmark::Counter;
    state.counters["per_neighbour"] =
        Counter(neighbours, Counter::kIsIterationInvariantRate | Counter::kInvert);
    state.counters["per_particle"] = Counter(view.n, Counter::kIsIterationInvariantRate | Counter::kInvert);
    state.counters["particles"] = view.n;
    state.counters["neighbours"] = neighbours / view.n;
    state.counters["listed"] = double(lists.fluid.neighbours.size()) / view.n;
    double faces[sph::quadratures] = {};
    for (const sph::FaceList &list : lists.wall.faces)
      for (int q = 0; q < sph::quadratures; ++q) faces[q] += list.count[q];
    for (int q = 0; q < sph::quadratures; ++q)
      state.counters["faces" + std::to_string(q)] = faces[q] / view.n;
    state.counters["sides"] = double(lists.wall.rim_nodes.size()) / view.n;  // of rims, with padding
    state.SetLabel(sph::sweeps<3>().name);
  }
};

void sweep(benchmark::State &state, void (*const which)(sph::CellView<3> &), const bool wall) {
  Cell cell(state, wall);
  for (auto _ : state) {
    which(cell.view);
    benchmark::DoNotOptimize(cell.view.f[0][0]);
  }
  cell.report(state);
}
void force(benchmark::State &state) { sweep(state, sph::sweeps<3>().force, true); }
void density(benchmark::State &state) { sweep(state, sph::sweeps<3>().density, true); }
void density_pairs_only(benchmark::State &state) { sweep(state, sph::sweeps<3>().density, false); }
void lists(benchmark::State &state) {
  Cell cell(state, true);
  for (auto _ : state) cell.build();
  cell.report(state);
}
void step(benchmark::State &state) {
  const auto cell = settings(state).make();
  ParticleSystem<3> &system = cell->system;
  const Group &g = system.particles.groups[0];
  for (std::uint32_t i = g.begin; i < g.fluid; ++i) system.particles.inverse_mass[i] = 0.;
  KickDriftKick<3> integrator(system);
  system.compute_forces();
  const double dt = 0.5 * system.stable_time_step();
  for (int s = 0; s < 60; ++s)  // calm the lattice, which starts with pressures of MPa
  {
    integrator.step(dt);
    for (auto &v : system.particles.v)
      for (double &component : v) component *= 0.8;
  }
  const std::size_t builds = cell->fluid->list_builds();
  for (auto _ : state) integrator.step(dt);
  state.counters["per_particle"] =
      benchmark::Counter(double(system.particles.size()),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["per_fluid_particle"] = benchmark::Counter(
      g.fluid_count(), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["particles"] = double(system.particles.size());
  state.counters["steps_a_list"] =
      double(state.iterations()) / std::max<double>(1., double(cell->fluid->list_builds() - builds));
}
const std::vector<std::vector<std::int64_t>> sizes = {{56, 111, 138}, {0, 1}};
BENCHMARK(force)->ArgNames({"fill", "viscous"})->ArgsProduct(sizes);
BENCHMARK(density_pairs_only)->ArgNames({"fill", "viscous"})->ArgsProduct(sizes);
BENCHMARK(density)->ArgNames({"fill", "viscous"})->ArgsProduct(sizes);
BENCHMARK(lists)->ArgNames({"fill", "viscous"})->ArgsProduct({{56, 111, 138}, {0}});
BENCHMARK(step)->ArgNames({"fill", "viscous"})->ArgsProduct(sizes);
}  // namespace

BENCHMARK_MAIN();
