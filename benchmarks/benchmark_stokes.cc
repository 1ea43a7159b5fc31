// The friction solve of a Stokes fluid of SPH particles (thesis 2.3.1, "NSPH"), 12 096 of them in 3D with
// about 63 neighbours each, one thread, to 1e-6 of the forces.
//
//   cmake -S . -B build-bench -G Ninja -DTURGOR_BENCHMARKS=ON && ninja -C build-bench benchmark_stokes
//   build-bench/benchmarks/benchmark_stokes
//
// A periodic box of 24 x 24 x 21 spacings, jittered and evened out, whose lowest three layers are held (a
// medium that is next to infinite): what flows is a channel of 18 layers, driven along it and stirred at
// random. form: 0 least_squares, 1 morris, 2 monaghan.
//
// product: A p in single precision as conjugate gradients ask for it, alone. cold: from rest. warm: from the
// velocities before, after the fastest particle has moved by a twentieth of a spacing. assembly: pairs of
// given lists made into the matrix. Counters: ns_neighbour of a product, or of all a solution takes over its
// iterations; iterations; cpu_ms.
#include "micro/engine/system_motion.h"
#include "micro/laws/counter_random.h"
#include "micro/terms/bulk_fluid.h"
#include "micro/terms/external_force.h"
#include "run/choice.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace {
using namespace turgor;

double cpu() { return double(std::clock()) / CLOCKS_PER_SEC * 1e9; }
constexpr DragForm forms[] = {DragForm::least_squares, DragForm::morris, DragForm::monaghan};
constexpr int nx = 24, ny = 24, nz = 21, n = nx * ny * nz, held = 3 * nx * ny;
constexpr double support = 2.44;  // spacings; 63 neighbours

/// Mass, density, viscosity and spacing are 1.
struct Fluid {
  ParticleSystem<3> system;
  BulkFluid<3> *fluid;
  SystemMotion<3> motion{system, {.tolerance = 1e-6}};

  explicit Fluid(const DragForm form) {
    Particles<3> &p = system.particles;
    const int lengths[3] = {nx, ny, nz};
    system.box.periodic = {true, true, true};
    for (int d = 0; d < 3; ++d) system.box.H(d, d) = lengths[d];
    p.resize(n);
    p.groups = {{0, 0, n}};
    for (int k = 0; k < n; ++k) {
      int rest = k;
      for (int d = 0; d < 3; ++d, rest /= lengths[d - 1]) {
        const double off = 0.5 * random_uniform(1, std::uint64_t(3 * k + d)) - 0.25;
        p.x[std::size_t(d)][std::size_t(k)] = rest % lengths[d] + 0.5 + off;
      }
      p.inverse_mass[std::size_t(k)] = 1.;
    }
    fluid = &system.add(std::make_unique<BulkFluid<3>>(
        BulkFluidParameters{.support = support, .skin = 0.3, .viscosity = 1., .form = form},
        EquationOfState(1., 100. / 7., -10.), 1., std::vector<BulkWall>{}));
    system.add(std::make_unique<BodyForce<3>>(Vector<3>(1., 0., 0.)));
    motion.medium.assign(n, 0.);
    std::fill(motion.medium.begin(), motion.medium.begin() + held, 1e6);
    fluid->even_out(p, system.box, 30);
    motion.own_length = 1.;
  }
  void stir() {
    for (int d = 0; d < 3; ++d)
      for (std::size_t i = 0; i < n; ++i)
        system.particles.f[std::size_t(d)][i] += random_uniform(2, 3 * i + std::uint64_t(d)) - 0.5;
  }
  void at_rest() {
    for (auto &v : system.particles.v) std::fill(v.begin(), v.end(), 0.);
  }
  void forces() {
    system.compute_forces();
    stir();
  }
  /// Fluid of a solution moved by `way`, the fastest.
  void move(const double way) {
    Particles<3> &p = system.particles;
    double fastest = 0.;
    for (std::size_t i = 0; i < n; ++i)
      fastest = std::max(fastest, std::hypot(p.v[0][i], p.v[1][i], p.v[2][i]));
    for (int d = 0; d < 3; ++d)
      for (std::size_t i = held; i < n; ++i) p.x[std::size_t(d)][i] += way / fastest * p.v[std::size_t(d)][i];
  }
};

void solve(benchmark::State &state, const bool warm) {
  Fluid all(forms[state.range(0)]);
  double time = 0., iterations = 0., solutions = 0.;
  all.forces();
  all.motion.velocities(all.system.particles, 0.);
  for (auto _ : state) {
    state.PauseTiming();
    if (warm)
      all.move(0.05);
    else
      all.at_rest();
    all.forces();
    state.ResumeTiming();
    const double start = cpu();
    all.motion.velocities(all.system.particles, 0.);
    time += cpu() - start;
    iterations += all.motion.solver().iterations();
    ++solutions;
  }
  const double neighbours = all.fluid->mean_neighbours();
  state.counters["ns_neighbour"] = time / (iterations * neighbours * n);
  state.counters["iterations"] = iterations / solutions;
  state.counters["cpu_ms"] = 1e-6 * time / solutions;
  state.counters["neighbours"] = neighbours;
  state.SetLabel(word_of(forms[state.range(0)]));
}
void cold(benchmark::State &state) { solve(state, false); }
void warm(benchmark::State &state) { solve(state, true); }

/// A drag of its own, from lists of all within the support.
struct Pairs {
  std::vector<Vector<3>> r;
  std::vector<std::uint16_t> other;
  std::vector<double> w;
  std::vector<std::uint32_t> first{0};

  Pairs() {
    const Fluid all(DragForm::morris);
    const auto &x = all.system.particles.x;
    const double lengths[3] = {nx, ny, nz};
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        Vector<3> apart;
        for (std::size_t d = 0; d < 3; ++d) {
          const double one = x[d][j] - x[d][i];
          apart[Eigen::Index(d)] = one - lengths[d] * std::round(one / lengths[d]);
        }
        const double length = apart.norm();
        if (i == j || length >= support) continue;
        r.push_back(apart);
        other.push_back(std::uint16_t(j));
        w.push_back(std::pow(1. - length / support, 3));
      }
      first.push_back(std::uint32_t(other.size()));
    }
  }
  void into(SphDrag<3> &drag, const DragForm form) const {
    drag.clear(form, 1.);
    for (std::size_t i = 0; i < n; ++i) {
      drag.body();
      for (std::uint32_t k = first[i]; k < first[i + 1]; ++k) drag.pair(other[k], r[k], w[k]);
    }
    drag.finish(1);
  }
};
const Pairs &pairs() {
  static const Pairs one;
  return one;
}

void product(benchmark::State &state) {
  SphDrag<3> drag;
  pairs().into(drag, forms[state.range(0)]);
  std::vector<FloatRow> p(n), product(n);
  for (std::size_t i = 0; i < n; ++i)
    for (int d = 0; d < 3; ++d) p[i][d] = float(random_uniform(3, 3 * i + std::uint64_t(d)));
  double time = 0., count = 0.;
  for (auto _ : state) {
    const double start = cpu();
    for (int k = 0; k < 10; ++k) {
      std::fill(product.begin(), product.end(), FloatRow{});
      drag.begin(p.data(), 1);
      drag.add(p.data(), 0, n, product.data());
      benchmark::DoNotOptimize(product.data());
    }
    time += cpu() - start;
    count += 10.;
  }
  state.counters["ns_neighbour"] = time / (count * double(pairs().other.size()));
  state.SetLabel(word_of(forms[state.range(0)]));
}

void assembly(benchmark::State &state) {
  pairs();
  SphDrag<3> drag;
  double time = 0., count = 0.;
  for (auto _ : state) {
    const double start = cpu();
    pairs().into(drag, forms[state.range(0)]);
    time += cpu() - start;
    ++count;
  }
  state.counters["ns_neighbour"] = time / (count * double(pairs().other.size()));
  state.counters["cpu_ms"] = 1e-6 * time / count;
  state.SetLabel(word_of(forms[state.range(0)]));
}

BENCHMARK(product)->DenseRange(0, 2)->ArgName("form")->Unit(benchmark::kMillisecond);
BENCHMARK(assembly)->DenseRange(0, 2)->ArgName("form")->Unit(benchmark::kMillisecond);
BENCHMARK(cold)->DenseRange(0, 2)->ArgName("form")->Unit(benchmark::kMillisecond);
BENCHMARK(warm)->DenseRange(0, 2)->ArgName("form")->Unit(benchmark::kMillisecond)->Iterations(10);
}  // namespace

BENCHMARK_MAIN();
