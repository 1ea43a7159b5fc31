// The sweeps of the fluid alone, on the reference cell, in cache, one thread: ns per neighbour within the
// support.
//
//   build-bench/benchmarks/benchmark_sweeps --benchmark_repetitions=5 --benchmark_report_aggregates_only
//
// force: the force sweep (target: at most 1.2 ns per neighbour). density: the density sweep with the wall's
// part; pairs_only: the same with no wall in reach, so that the difference of the two is the wall. viscosity:
// all of an impulse. lists: one build of a cell's. Lists have the skin of a run. No EOS to speak of.
#include "micro/cells/sph_parenchyma.h"
#include "micro/processes/annealed_cells.h"
#include "micro/terms/sph_lists.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

namespace {
using namespace turgor;

/// Everything a CellView points to.
struct Cell {
  std::unique_ptr<SphPatch> patch;
  SphLists<2> lists;
  std::vector<double> ring[8], rho, gamma, pressure, push, f[2];
  std::unique_ptr<double, void (*)(void *)> scratch{nullptr, &std::free};
  sph::CellView<2> view;
  double neighbours = 0.;  ///< within the support, all particles

  explicit Cell(const bool wall) {
    const ParenchymaParameters cell;
    const SphParameters sph;
    static const ReferenceCell reference = anneal_square_cell(cell, sph);
    patch = make_sph_patch(make_parenchyma(cell, 1, 1, true, true), sph, reference);
    const Particles<2> &p = patch->system.particles;
    const Group &g = p.groups[0];
    const std::uint32_t n = g.fluid_count(), nw = g.wall_count();
    const double dx = cell.period / sph.particles_per_side;
    view.support = sph.support_ratio * dx;
    ListOrigin<2> origin;
    origin.take(p.x, g);
    lists.fluid.build(origin, nw, view.support + sph.skin_ratio * dx);
    lists.wall.build(origin, nw, view.support + sph.skin_ratio * dx, nullptr);
    if (!wall) {
      lists.wall.clear(n);
    }
    patch->system.compute_forces();
    neighbours = n * patch->fluid->mean_neighbours(p);

    view.n = n;
    view.n_wall = nw;
    view.mass = reference.particle_mass;
    view.depth = cell.depth;
    view.viscosity = 1.;
    view.particle_volume = cell.period * cell.period * cell.depth / n;
    view.volume = cell.period * cell.period * cell.depth;
    view.ordering = sph.ordering * cell.fluid_modulus;
    view.eos = [](const void *, const std::uint32_t count, const double *, double *pressure_out) {
      std::fill(pressure_out, pressure_out + count, 200e3);
    };
    for (auto *field : {&rho, &gamma, &pressure, &push, &f[0], &f[1]}) field->assign(n, 0.);
    const std::size_t used = 2 * nw + sph::list_padding + 1;
    for (auto &values : ring) values.assign(used + sph::list_padding, 0.);
    for (int d = 0; d < 2; ++d) {
      for (std::size_t k = 0; k < used; ++k) ring[d][k] = p.x[d][g.begin + k % nw];
      view.x[d] = p.x[d].data() + g.fluid;
      view.v[d] = p.v[d].data() + g.fluid;
      view.f[d] = f[d].data();
      view.wall_x[d] = ring[d].data();
      view.wall_v[d] = ring[2 + d].data();
      view.wall_f[d] = ring[4 + d].data();
      view.wall_f_next[d] = ring[6 + d].data();
    }
    view.rho = rho.data();
    view.gamma = gamma.data();
    view.pressure = pressure.data();
    view.push = push.data();
    view.neighbours = lists.fluid.neighbours.data();
    view.first_neighbour = lists.fluid.first_neighbour.data();
    view.arcs = lists.wall.arcs.data();
    view.first_arc = lists.wall.first_arc.data();
    view.arc_stride = std::uint32_t((lists.wall.arcs.size() + 7) / 8 * 8);
    const std::size_t rows = (std::size_t(n + 1) * sph::row_doubles + 7) / 8 * 8,
                      faces = 4 * sph::list_padding * std::size_t(lists.wall.chunks),
                      viscous = std::size_t(n + 1) * sph::viscous_row<2>,
                      doubles = rows + faces + 5 * view.arc_stride + 2 * viscous;
    scratch.reset(static_cast<double *>(std::aligned_alloc(64, (doubles * sizeof(double) + 63) / 64 * 64)));
    view.rows = scratch.get();
    view.scratch = view.rows + rows;
    view.arc_ends = view.scratch + faces;
    view.viscous_rows = view.arc_ends + 5 * view.arc_stride;
    view.moments = view.viscous_rows + viscous;
    sph::sweeps<2>().density(view);
  }
};

void sweep(benchmark::State &state, void (*const which)(sph::CellView<2> &), const bool wall) {
  Cell cell(wall);
  for (auto _ : state) {
    which(cell.view);
    benchmark::DoNotOptimize(cell.view.f[0][0]);
  }
  // Seconds per neighbour; printed in ns.
  state.counters["per_neighbour"] = benchmark::Counter(
      cell.neighbours, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["neighbours"] = cell.neighbours / cell.view.n;
  state.counters["listed"] =
      double(cell.lists.fluid.neighbours.size()) / cell.view.n;  // with skin and padding
  state.SetLabel(sph::sweeps<2>().name);
}
/// One build of the lists of a cell, from positions as they are in a run; per particle, fluid and wall.
void lists(benchmark::State &state) {
  Cell cell(true);
  const Particles<2> &p = cell.patch->system.particles;
  const double reach = cell.view.support + SphParameters().skin_ratio * ParenchymaParameters().period /
                                               SphParameters().particles_per_side;
  ListOrigin<2> origin;
  for (auto _ : state) {
    origin.take(p.x, p.groups[0]);
    cell.lists.fluid.build(origin, cell.view.n_wall, reach);
    cell.lists.wall.build(origin, cell.view.n_wall, reach, nullptr);
  }
  state.counters["per_particle"] = benchmark::Counter(
      double(p.size()), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["listed"] = double(cell.lists.fluid.neighbours.size()) / cell.view.n;
}
void force(benchmark::State &state) { sweep(state, sph::sweeps<2>().force, true); }
void density(benchmark::State &state) { sweep(state, sph::sweeps<2>().density, true); }
void density_pairs_only(benchmark::State &state) { sweep(state, sph::sweeps<2>().density, false); }
void viscosity(benchmark::State &state) { sweep(state, sph::sweeps<2>().viscosity, true); }
BENCHMARK(force);
BENCHMARK(density);
BENCHMARK(density_pairs_only);
BENCHMARK(viscosity);
BENCHMARK(lists);
}  // namespace

BENCHMARK_MAIN();
