// us per node and step of deformable cells that touch: linearly implicit steps, checked against making
// energy, cells of 162 nodes with the material of inputs/capsule_compression.prm.
//
//   cmake -S . -B build-bench -G Ninja -DTURGOR_BENCHMARKS=ON && ninja -C build-bench benchmark_surfaces
//   build-bench/benchmarks/benchmark_surfaces --benchmark_filter='cells:13/'
//
// shrinking: in a sphere that closes to a volume strain of about 0.27 in half an hour by steps of 45 s, those
// of
//   the second half are measured: all cells touch all around.
// growing: a free clump whose cells double in volume within a day by steps of 120 s; those of 25 minutes,
//   behind twenty minutes in which they swell by a fifth (at once, which no cell does, that costs thousands
//   of iterations a step, of which the first is tried a dozen times).
//
// Counters, CPU time of all threads: us_node_step (every step that was tried counts), iterations (a solve),
// s_per_s (CPU time of a simulated second), rejected (steps). Each is measured once: run it several times, in
// turns.
#include "micro/geometry/compact_cluster.h"
#include "micro/geometry/sphere_surface.h"
#include "micro/laws/random_turn.h"
#include "micro/scenes/deformable/deformable_cells.h"

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <cmath>
#include <ctime>

namespace {
using namespace turgor;

double cpu() { return double(std::clock()) / CLOCKS_PER_SEC; }

TouchingMaterial material_of(const double longest_step) {
  TouchingMaterial material;
  material.nu = 4;
  material.bulk_modulus = 2500.;
  material.viscosity = 1e-3;
  material.range = 0.4e-6;
  material.tolerance = 0.05;
  material.longest_step = longest_step;
  return material;
}

std::vector<DeformableShape> clump(const TouchingMaterial &material, const std::size_t count) {
  std::vector<DeformableShape> shapes;
  for (const Vector<3> &x : compact_cluster(count, 2. * material.radius + material.rest, false))
    shapes.push_back(placed(sphere_shape(material.nu, material.radius), random_turn(1, shapes.size()), x));
  return shapes;
}

double extent(const std::vector<DeformableShape> &shapes) {
  double farthest = 0.;
  for (const DeformableShape &shape : shapes)
    for (const Vector<3> &x : shape.nodes) farthest = std::max(farthest, x.norm());
  return farthest;
}

/// Steps that are timed.
struct Timed {
  DeformableCells &cells;
  double time = 0., simulated = 0., iterations = 0., tried = 0., steps = 0.;

  void step() {
    const double start = cpu(), rejected = double(cells.rejected());
    simulated += cells.step(HUGE_VAL);
    time += cpu() - start;
    iterations += double(cells.motion.solver().iterations());
    tried += 1. + double(cells.rejected()) - rejected;
    steps += 1.;
  }
  void tell(benchmark::State &state) const {
    state.counters["us_node_step"] = 1e6 * time / (tried * double(cells.system.particles.size()));
    state.counters["iterations"] = iterations / steps;
    state.counters["s_per_s"] = time / simulated;
    state.counters["rejected"] = tried - steps;
  }
};

void shrinking(benchmark::State &state) {
  const unsigned int threads = unsigned(state.range(1));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  constexpr double duration = 1800.;
  const TouchingMaterial material = material_of(duration / 40.);
  const std::vector<DeformableShape> shapes = clump(material, std::size_t(state.range(0)));
  for (auto _ : state) {
    DeformableCells cells(material, shapes, threads);
    const double first = extent(shapes) + material.rest,
                 last = material.radius * std::cbrt(0.76 * double(shapes.size())) + material.rest;
    auto sphere = std::make_unique<SphereSurface<3>>(Vector<3>::Zero(), first, ParticlesAre::inside);
    sphere->growth = (first - last) / duration;
    cells.add_bodies("sphere", material.law(), std::move(sphere));
    cells.begin(duration / 400.);
    while (cells.time() < 0.5 * duration) cells.step(HUGE_VAL);
    Timed timed{cells};
    while (cells.time() < duration) timed.step();
    timed.tell(state);
  }
}

void growing(benchmark::State &state) {
  const unsigned int threads = unsigned(state.range(1));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  constexpr double day = 86400., rest = 1200.;
  const TouchingMaterial material = material_of(120.);
  const std::vector<DeformableShape> shapes = clump(material, std::size_t(state.range(0)));
  for (auto _ : state) {
    DeformableCells cells(material, shapes, threads);
    const double volume = cells.surfaces->cells.column("rest_volume")[0];
    const auto grow = [&] {
      for (std::size_t cell = 0; cell < shapes.size(); ++cell)
        cells.surfaces->grow(cell,
                             volume * (1. + 0.2 * std::min(1., cells.time() / rest) + cells.time() / day));
      cells.system.compute_forces();
    };
    cells.begin(1.);
    for (int k = 0; k < 10 || cells.time() < rest; ++k) {
      grow();
      cells.step(HUGE_VAL);
    }
    Timed timed{cells};
    while (timed.simulated < 1500.) {
      grow();
      timed.step();
    }
    timed.tell(state);
  }
}

void sizes(benchmark::internal::Benchmark *one) {
  one->ArgNames({"cells", "threads"})
      ->ArgsProduct({{13, 100, 200, 1000}, {1, 2}})
      ->Iterations(1)
      ->MeasureProcessCPUTime()
      ->UseRealTime();
}
BENCHMARK(shrinking)->Apply(sizes);
BENCHMARK(growing)->Apply(sizes);
}  // namespace

BENCHMARK_MAIN();
