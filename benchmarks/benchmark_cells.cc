// ns per cell of the over-damped population: a ball of cells, about 11 neighbours each, 10^3 to 10^6 cells on
// 1 and 2 threads.
//
//   cmake -S . -B build-bench -G Ninja -DTURGOR_BENCHMARKS=ON && ninja -C build-bench benchmark_cells
//   build-bench/benchmarks/benchmark_cells
//
// pair_mechanics: whole explicit steps without pair friction (is the list still good, lists as often as the
// moving cells need,
//   forces of all contacts, velocities, positions). Counters: cpu_ns_cell (CPU time of all threads, a step:
//   step_ns_cell with the list of the step before, list_ns_cell more with a new one, which is made every
//   steps_per_list), neighbours (in the list), contacts, bytes_cell (lists, contacts and friction matrix).
// friction: the matrix at one state, pair friction 10 times the medium's, half of it sideways;
// friction_isotropic: all of it,
//   which needs no directions (and is what explicit steps of the scenes have). assembly_ns_cell: with the
//   right-hand side and one product; iteration_ns_cell: of conjugate gradients to 1e-6.
// friction_iterations: their number at 10^4 cells, by pair over medium friction and digits of the tolerance,
// all directions the same. rows: walls of deformable cells of 162 nodes, their springs as links, hinges,
// areas and volumes as rows (31 entries a node); push_ns_node: giving
//   them to the matrix; assembly and iteration as above, of conjugate gradients to 1e-2.
// The time column is wall time.
#include "micro/laws/counter_random.h"
#include "micro/engine/overdamped.h"
#include "micro/engine/space_order.h"
#include "micro/engine/system_motion.h"
#include "micro/geometry/geodesic_sphere.h"
#include "micro/terms/sphere_contacts.h"

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <ctime>

namespace {
using namespace turgor;

constexpr double R_0 = 7e-6;

double cpu() { return double(std::clock()) / CLOCKS_PER_SEC * 1e9; }

/// Face-centred ball with a jitter, neighbours overlapping by a tenth of the radius, cells in the order that
/// populations are sorted into.
Particles<3> ball(const std::size_t n) {
  const double nearest = 1.9 * R_0, a = nearest / std::sqrt(2.);
  const int reach = int(std::cbrt(double(n) * 2. / 4.19)) + 2;
  std::vector<std::array<double, 4>> sites;
  for (int z = -reach; z <= reach; ++z)
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x)
        if ((x + y + z) % 2 == 0)
          sites.push_back({double(x * x + y * y + z * z), double(x), double(y), double(z)});
  std::stable_sort(sites.begin(), sites.end(), [](const auto &p, const auto &q) { return p[0] < q[0]; });
  sites.resize(n);
  Particles<3> p;
  p.resize(n);
  p.groups = {{0, 0, std::uint32_t(n)}};
  p.declare("radius");
  p.declare("modulus");
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t d = 0; d < 3; ++d)
      p.x[d][i] = a * sites[i][d + 1] + 0.1 * R_0 * (random_uniform(1, 4 * i + d) - 0.5);
    p.field("radius")[i] = R_0 * (1. + 0.05 * (random_uniform(1, 4 * i + 3) - 0.5));
    p.field("modulus")[i] = 590.;
  }
  p.gather(space_order(p, 2. * R_0));
  return p;
}

/// Each cell a group of its own, with contacts and friction between the cells.
struct Population {
  ParticleSystem<3> system;
  SphereContacts &contacts;

  Population(const std::size_t n, const unsigned int threads, const PairFriction &friction)
      : contacts(system.add(std::make_unique<SphereContacts>(HertzContact(), 0.2 * R_0))) {
    system.threads = threads;
    system.particles = ball(n);
    system.particles.groups.clear();
    for (std::uint32_t i = 0; i < n; ++i) system.particles.groups.push_back({i, i, i + 1});
    contacts.friction = friction;
  }
};

void pair_mechanics(benchmark::State &state) {
  const std::size_t n = std::size_t(state.range(0));
  const unsigned int threads = unsigned(state.range(1));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  Population population(n, threads, {});
  const SphereContacts &contacts = population.contacts;
  Particles<3> &cells = population.system.particles;
  // 5 s steps: about 1 % of a radius a step in the beginning, and unrest goes on by the moving radii below
  SystemMotion<3> motion(population.system, {});
  Overdamped<3> stepper(
      {.method = OverdampedMethod::euler, .tolerance = 1e9, .first_step = 5., .longest_step = 5.}, motion,
      threads);
  motion.medium.assign(n, 0.3);
  std::size_t step = 0;
  const auto advance = [&] {
    stepper.step(cells, 5.);
    for (std::size_t i = step % 7; i < n; i += 7)  // growth and shrinking keep cells moving
      cells.field("radius")[i] = R_0 * (1. + 0.1 * (random_uniform(2, i + n * step) - 0.5));
    ++step;
  };
  while (step < 14)  // all cells have another radius
    advance();
  double time[2] = {0., 0.},
         count[2] = {0., 0.};  // of steps with the list of the last one, and with a new one
  for (auto _ : state) {
    const std::size_t lists = contacts.list().builds();
    const double start = cpu();
    advance();
    const bool new_list = contacts.list().builds() > lists;
    time[new_list] += cpu() - start;
    count[new_list] += 1.;
  }
  const double old_list = time[0] / std::max(1., count[0]), steps = count[0] + count[1];
  state.counters["cpu_ns_cell"] = (time[0] + time[1]) / (steps * double(n));
  state.counters["step_ns_cell"] = old_list / double(n);
  state.counters["list_ns_cell"] = (time[1] / std::max(1., count[1]) - old_list) / double(n);
  state.counters["neighbours"] = 2. * double(contacts.list().pairs().size()) / double(n);
  double touching = 0.;
  for (const PairContact &c : contacts.contacts()) touching += 2. * (c.area > 0.);
  state.counters["contacts"] = touching / double(n);
  state.counters["steps_per_list"] = steps / count[1];
  state.counters["bytes_cell"] = double(contacts.memory_bytes() + motion.solver().memory_bytes()) / double(n);
}
/// The same steps on one thread and on two: lists are made when the cells' unrest wants them, which changes
/// from step to step.
void same_steps(benchmark::internal::Benchmark *all, const std::int64_t cells, const std::int64_t steps) {
  all->ArgNames({"cells", "threads"})
      ->Args({cells, 1})
      ->Args({cells, 2})
      ->Iterations(steps)
      ->MeasureProcessCPUTime()
      ->UseRealTime();
}
void few(benchmark::internal::Benchmark *all) { same_steps(all, 1000, 280); }
void some(benchmark::internal::Benchmark *all) { same_steps(all, 10000, 280); }
void many(benchmark::internal::Benchmark *all) { same_steps(all, 100000, 42); }
void most(benchmark::internal::Benchmark *all) { same_steps(all, 1000000, 14); }
BENCHMARK(pair_mechanics)->Apply(few);
BENCHMARK(pair_mechanics)->Apply(some);
BENCHMARK(pair_mechanics)->Apply(many);
BENCHMARK(pair_mechanics)->Apply(most);

constexpr double pair = 5e10;  // N s/m^3

/// Medium friction: that of a cell's pairs is `ratio` times as much.
std::vector<double> medium(const std::size_t n, const double ratio) {
  const double area = 3.14 * 0.5 * R_0 * 0.1 * R_0;
  return std::vector<double>(n, 11. * area * pair / ratio);
}

/// sideways: tangential over normal friction.
void solve_friction(benchmark::State &state, const double sideways) {
  const std::size_t n = std::size_t(state.range(0));
  const unsigned int threads = unsigned(state.range(1));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  Population population(n, threads, {.normal = pair, .tangential = sideways * pair});
  Particles<3> &cells = population.system.particles;
  SystemMotion<3> assembled(population.system, {.tolerance = 1e9}), solved(population.system, {});
  solved.forces(cells, false);
  for (SystemMotion<3> *warm : {&assembled, &solved})  // memory is there
  {
    warm->medium = medium(n, 10.);
    warm->velocities(cells, 0.);
  }
  double assembly = 0., all = 0., iterations = 0.;
  for (auto _ : state) {
    const double t0 = cpu();
    assembled.velocities(cells, 0.);
    const double t1 = cpu();
    for (auto &v : cells.v) std::fill(v.begin(), v.end(), 0.);
    const double t2 = cpu();
    solved.velocities(cells, 0.);
    all += cpu() - t2;
    assembly += t1 - t0;
    iterations += solved.solver().iterations();
  }
  const double runs = double(state.iterations());
  state.counters["assembly_ns_cell"] = assembly / (runs * double(n));
  state.counters["iteration_ns_cell"] = (all - assembly) / (iterations * double(n));
  state.counters["iterations"] = iterations / runs;
  state.counters["bytes_cell"] = double(solved.solver().memory_bytes()) / double(n);
}
void friction(benchmark::State &state) { solve_friction(state, 0.5); }
void friction_isotropic(benchmark::State &state) { solve_friction(state, 1.); }
BENCHMARK(friction)
    ->ArgNames({"cells", "threads"})
    ->ArgsProduct({{1000, 10000, 100000, 1000000}, {1, 2}})
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(friction_isotropic)
    ->ArgNames({"cells", "threads"})
    ->ArgsProduct({{1000, 10000, 100000, 1000000}, {1, 2}})
    ->MeasureProcessCPUTime()
    ->UseRealTime();
void friction_iterations(benchmark::State &state) {
  const std::size_t n = 10000;
  Population population(n, 1, {.normal = pair, .tangential = pair});
  Particles<3> &cells = population.system.particles;
  SystemMotion<3> motion(population.system, {.tolerance = std::pow(10., -double(state.range(1)))});
  motion.medium = medium(n, double(state.range(0)));
  motion.forces(cells, false);
  for (auto _ : state) motion.velocities(cells, 0.);
  state.counters["iterations"] = motion.solver().iterations();
}
BENCHMARK(friction_iterations)
    ->ArgNames({"ratio", "digits"})
    ->ArgsProduct({{1, 10, 100, 1000}, {6, 10}})
    ->Iterations(1);

/// A new matrix of spheres of triangles side by side.
void push_walls(MotionMatrix &matrix, const GeodesicSphere &sphere, const std::uint32_t cells) {
  const std::uint32_t nodes = sphere.mesh.nodes;
  matrix.clear(cells * nodes);
  matrix.medium.assign(cells * nodes, 0.05);
  const auto x = [&](const std::size_t i) -> const Vector<3> & { return sphere.positions[i]; };
  std::vector<Vector<3>> outwards;
  for (std::size_t i = 0; i < nodes; ++i) outwards.push_back(0.01 * x(i));
  for (std::uint32_t at = 0; at < cells * nodes; at += nodes) {
    for (const TriangleMesh::Edge &e : sphere.mesh.edges) {
      matrix.link<3>(at + e.a, at + e.b, (x(e.a) - x(e.b)).normalized(), 1., 0.02);
      const Vector<3> n = (x(e.a) + x(e.b)).normalized();
      matrix.row<3>(std::array{at + e.a, at + e.b, at + e.c, at + e.d},
                    std::array<Vector<3>, 4>{-n, -n, n, n}, 0.3);
    }
    for (const auto &f : sphere.mesh.faces) {
      const std::array bodies{at + f[0], at + f[1], at + f[2]};
      const Vector<3> n = (x(f[1]) - x(f[0])).cross(x(f[2]) - x(f[0])).normalized();
      std::array<Vector<3>, 3> grow, tilt;
      for (std::size_t k = 0; k < 3; ++k) grow[k] = n.cross(x(f[(k + 2) % 3]) - x(f[(k + 1) % 3]));
      matrix.row<3>(bodies, grow, 0.5);
      for (const int side : {0, 1}) {
        for (std::size_t k = 0; k < 3; ++k) tilt[k] = grow[k][side] * n;
        matrix.row<3>(bodies, tilt, 0.1);
      }
    }
    matrix.whole<3>(at, outwards, 1.);
  }
}
void rows(benchmark::State &state) {
  const std::uint32_t cells = std::uint32_t(state.range(0));
  const unsigned int threads = unsigned(state.range(1));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  GeodesicSphere sphere = make_geodesic_sphere(4);
  sphere.mesh.complete();
  const std::uint32_t n = cells * sphere.mesh.nodes;
  MotionMatrix assembled({.tolerance = 1e9}), solved({.tolerance = 1e-2});
  std::array<std::vector<double>, 3> f, v;
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t i = 0; i < n; ++i) f[d].push_back(random_uniform(3, 3 * i + d) - 0.5);
  double push = 0., assembly = 0., all = 0., iterations = 0.;
  const auto once = [&] {
    const double t0 = cpu();
    push_walls(assembled, sphere, cells);
    push += cpu() - t0;
    push_walls(solved, sphere, cells);
    for (MotionMatrix *matrix : {&assembled, &solved}) {
      for (auto &one : v) one.assign(n, 0.);
      const double start = cpu();
      matrix->solve<3>(f, v, threads);
      (matrix == &solved ? all : assembly) += cpu() - start;
    }
    iterations += solved.iterations();
  };
  once();  // memory is there
  push = assembly = all = iterations = 0.;
  for (auto _ : state) once();
  const double runs = double(state.iterations());
  state.counters["push_ns_node"] = push / (runs * n);
  state.counters["assembly_ns_node"] = assembly / (runs * n);
  state.counters["iteration_ns_node"] = (all - assembly) / (iterations * n);
  state.counters["iterations"] = iterations / runs;
  state.counters["bytes_node"] = double(solved.memory_bytes()) / n;
}
BENCHMARK(rows)
    ->ArgNames({"cells", "threads"})
    ->ArgsProduct({{13, 100}, {1, 2}})
    ->MeasureProcessCPUTime()
    ->UseRealTime();
}  // namespace

BENCHMARK_MAIN();
