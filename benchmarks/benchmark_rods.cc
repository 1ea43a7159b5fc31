// ns per rod and step of rods that touch (thesis 2.3.3): 10 000 of them in a heap, on 1 and 2 threads.
//
//   cmake -S . -B build-bench -G Ninja -DTURGOR_BENCHMARKS=ON && ninja -C build-bench benchmark_rods
//   build-bench/benchmarks/benchmark_rods
//
// explicit_steps: shapes, lists as often as the rods need them, contacts, forces, and the matrix of motion
// with the rods' own friction; rubbing: with friction of the contacts in all directions beside; implicit:
// with the stiffness of contacts and rods. Counters: cpu_ns_rod (CPU time of all threads, a step), contacts
// (a rod), iterations (of the last solution), bytes_rod (lists and contacts). The time column is wall time.
#include "micro/engine/overdamped.h"
#include "micro/engine/system_motion.h"
#include "micro/laws/counter_random.h"
#include "micro/terms/rod_contacts.h"

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <cmath>
#include <ctime>

namespace {
using namespace turgor;

double cpu() { return double(std::clock()) / CLOCKS_PER_SEC * 1e9; }

/// Rods of 0 to 6 um on a cubic lattice of 11 um, turned at random: about 3 contacts each.
void steps(benchmark::State &state, const OverdampedMethod method, const double friction) {
  constexpr std::size_t n = 10000;
  constexpr double R_0 = 6e-6, apart = 11e-6;
  const unsigned int threads = unsigned(state.range(0));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  ParticleSystem<3> system;
  system.threads = threads;
  const auto rods = std::make_shared<RodSet>();
  std::vector<Vector<3>> a, b;
  for (std::size_t k = 0; k < n; ++k) {
    const Vector<3> x = apart * Vector<3>(double(k % 22), double(k / 22 % 22), double(k / 484));
    const double height = 2. * random_uniform(1, 2 * k) - 1., turn = 6.2832 * random_uniform(1, 2 * k + 1);
    const Vector<3> half = 3e-6 * random_uniform(2, k) *
                           Vector<3>(std::sqrt(1. - height * height) * std::cos(turn),
                                     std::sqrt(1. - height * height) * std::sin(turn), height);
    a.push_back(x - half);
    b.push_back(x + half);
    rods->shape.push_back({R_0, 1e-3});
  }
  rods->inner_friction = 0.2;
  rods->add(system.particles, a, b);
  system.add(std::make_unique<RodBodies>(rods));
  const RodContacts &contacts = system.add(std::make_unique<RodContacts>(
      rods,
      RodContactParameters{.skin = 0.15 * R_0, .modulus = 600., .normal = friction, .tangential = friction}));
  SystemMotion<3> motion(system, {});
  motion.medium.assign(2 * n, 0.1);
  motion.own_length = R_0;
  Overdamped<3> stepper({.method = method, .tolerance = 1e-2, .first_step = 1., .longest_step = 5.}, motion,
                        threads);
  for (int k = 0; k < 5; ++k) stepper.step(system.particles, 5.);
  double time = 0., count = 0.;
  for (auto _ : state) {
    const double start = cpu();
    stepper.step(system.particles, 5.);
    time += cpu() - start;
    ++count;
  }
  double touch = 0.;
  for (const RodContact &c : contacts.contacts()) touch += 2. * (c.area > 0.);
  state.counters["cpu_ns_rod"] = time / count / double(n);
  state.counters["contacts"] = touch / double(n);
  state.counters["iterations"] = motion.solver().iterations();
  state.counters["bytes_rod"] = double(contacts.memory_bytes() + motion.solver().memory_bytes()) / double(n);
}

void explicit_steps(benchmark::State &state) { steps(state, OverdampedMethod::euler, 0.); }
void rubbing(benchmark::State &state) { steps(state, OverdampedMethod::euler, 1e9); }
void implicit(benchmark::State &state) { steps(state, OverdampedMethod::implicit, 0.); }
BENCHMARK(explicit_steps)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->Iterations(100);
BENCHMARK(rubbing)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->Iterations(100);
BENCHMARK(implicit)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->Iterations(100);
}  // namespace

BENCHMARK_MAIN();
