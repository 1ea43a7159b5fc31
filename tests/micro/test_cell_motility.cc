// Random and persistent motion of cells alone: mean squared displacements, correlation, order of convergence
// in the step.
#include "micro/processes/polarity.h"
#include "micro/scenes/spheroid/cell_culture.h"
#include "micro/terms/cell_motility.h"

#include <boost/test/unit_test.hpp>

#include <numbers>
#include <numeric>

using namespace turgor;

namespace {
struct Walkers {
  Particles<3> particles;
  std::vector<std::uint64_t> id;
  std::vector<double> gamma;

  explicit Walkers(const std::size_t n) : id(n), gamma(n, 0.3) {
    particles.resize(n);
    particles.cells.resize(n);
    declare_polarity(particles.cells);
    std::iota(id.begin(), id.end(), 7u);
    particles.cells.declare<std::uint64_t>("id");
    particles.cells.column<std::uint64_t>("id") = id;
  }

  void clear() {
    for (auto &f : particles.f) f.assign(id.size(), 0.);
  }

  /// m^2, mean over all.
  double squared() const {
    double sum = 0.;
    for (std::size_t i = 0; i < id.size(); ++i) sum += particles.position(i).squaredNorm();
    return sum / double(id.size());
  }
};
}  // namespace

BOOST_AUTO_TEST_SUITE(cell_motility)

BOOST_AUTO_TEST_CASE(normal_numbers_have_the_moments_of_a_gaussian) {
  const int n = 100000;
  double mean[3] = {}, square[3] = {}, fourth[3] = {}, mixed = 0.;
  for (int i = 0; i < n; ++i) {
    const auto xi = random_normals(1, std::uint64_t(i % 1000), std::uint64_t(i / 1000));
    for (std::size_t d = 0; d < 3; ++d) {
      mean[d] += xi[d] / n;
      square[d] += xi[d] * xi[d] / n;
      fourth[d] += std::pow(xi[d], 4) / n;
    }
    mixed += xi[0] * xi[1] / n;
  }
  // four standard errors: of the mean 1, square sqrt 2, fourth sqrt 96, product 1 over sqrt n
  const double s = 4. / std::sqrt(double(n));
  for (std::size_t d = 0; d < 3; ++d) {
    BOOST_CHECK_SMALL(mean[d], s);
    BOOST_CHECK_SMALL(square[d] - 1., s * std::sqrt(2.));
    BOOST_CHECK_SMALL(fourth[d] - 3., s * std::sqrt(96.));
  }
  BOOST_CHECK_SMALL(mixed, s);
}

// <x^2> = 6 D t at any step; the relative standard error of a mean of n squares of 3 Gaussians is sqrt(2/(3
// n)).
BOOST_AUTO_TEST_CASE(free_diffusion) {
  constexpr double D = 1e-16, t = 3600.;
  for (const int steps : {1, 7, 60}) {
    Walkers w(20000);
    for (int k = 0; k < steps; ++k) {
      const double h = t / steps;
      w.clear();
      CellMotility(D, 11).add_random_forces(w.particles, w.gamma, h, std::uint64_t(k));
      for (std::size_t d = 0; d < 3; ++d)
        for (std::size_t i = 0; i < w.id.size(); ++i)
          w.particles.x[d][i] += h * w.particles.f[d][i] / w.gamma[i];
    }
    BOOST_CHECK_SMALL(w.squared() / (6. * D * t) - 1., 4. * std::sqrt(2. / (3. * 20000.)));
  }
}

BOOST_AUTO_TEST_CASE(random_numbers_follow_the_cell_not_its_place) {
  Walkers w(5), turned(5);
  turned.particles.cells.column<std::uint64_t>("id") = {11, 10, 9, 8, 7};
  for (Walkers *all : {&w, &turned})
    CellMotility(1e-16, 1).add_random_forces(all->particles, all->gamma, 10., 3);
  for (std::size_t i = 0; i < 5; ++i) BOOST_TEST(w.particles.f[0][i] == turned.particles.f[0][4 - i]);
}

// Correlation s^2 exp(-t/tau) around P_0 at any step.
BOOST_AUTO_TEST_CASE(polarity_keeps_its_direction_for_tau) {
  MigrationParameters parameters{.persistence = 600., .spread = 0.5, .preferred = Vector<3>(0.3, 0., 0.)};
  for (const int steps : {1, 5}) {
    Walkers w(40000);
    advance_polarity(w.particles.cells, w.id, parameters, 1e9, 3, 1000);  // at rest
    const std::vector<double> start = w.particles.cells.column("polarity_x");
    for (int k = 0; k < steps; ++k)
      advance_polarity(w.particles.cells, w.id, parameters, 420. / steps, 3, std::uint64_t(k));
    const std::vector<double> &end = w.particles.cells.column("polarity_x");
    double mean = 0., correlation = 0.;
    for (std::size_t i = 0; i < end.size(); ++i) {
      mean += end[i] / double(end.size());
      correlation += (end[i] - 0.3) * (start[i] - 0.3) / double(end.size());
    }
    const double error =
        4. / std::sqrt(double(end.size()));  // standard errors: s, and s^2 sqrt(1 + exp(-2 t/tau))
    BOOST_CHECK_SMALL(mean - 0.3, 0.5 * error);
    BOOST_CHECK_SMALL(correlation - 0.25 * std::exp(-0.7), 0.25 * 1.2 * error);
  }
}

// Alone, P_0 = 0: <x^2> = 6 D [t - tau (1 - exp(-t/tau))]. Stepping holds P during a step, from its start;
// the expectation of that scheme is h^2 sum_jk s^2 exp(-|j-k| h/tau) a component, so its weak error is known
// without sampling: first order.
BOOST_AUTO_TEST_CASE(persistent_walk_and_its_weak_order) {
  const double tau = 600., t = 1800., speed = 1e-9, s2 = 1. / 3.;  // F_0/gamma, m/s
  const double exact = 6. * speed * speed * s2 * tau * (t - tau * (1. - std::exp(-t / tau)));
  const auto expectation = [&](const int steps) {
    const double h = t / steps;
    double sum = 0.;
    for (int j = 0; j < steps; ++j)
      for (int k = 0; k < steps; ++k) sum += std::exp(-std::abs(j - k) * h / tau);
    return 3. * speed * speed * s2 * h * h * sum;
  };
  MigrationParameters parameters{.force = 0.3e-9, .persistence = tau};
  for (const int steps : {10, 40}) {
    Walkers w(20000);
    advance_polarity(w.particles.cells, w.id, parameters, 1e9, 5, 1000);
    for (int k = 0; k < steps; ++k) {
      w.clear();
      add_migration_forces(w.particles, parameters, 0, w.particles.size(), [](std::size_t) { return true; });
      for (std::size_t d = 0; d < 3; ++d)
        for (std::size_t i = 0; i < w.id.size(); ++i)
          w.particles.x[d][i] += t / steps * w.particles.f[d][i] / w.gamma[i];
      advance_polarity(w.particles.cells, w.id, parameters, t / steps, 5, std::uint64_t(k));
    }
    BOOST_CHECK_SMALL(w.squared() / expectation(steps) - 1., 4. * std::sqrt(2. / (3. * 20000.)));
  }
  const double coarse = expectation(20) - exact, middle = expectation(40) - exact,
               fine = expectation(80) - exact;
  // the leading term here is of second order: the trapezoidal rule's but for the ends, which are the same in
  // the mean
  BOOST_TEST(coarse / middle == 4., boost::test_tools::tolerance(0.1));
  BOOST_TEST(middle / fine == 4., boost::test_tools::tolerance(0.05));
}

// One path of the noise at three steps: coarse increments are composed of fine ones, the position errs in
// first order.
BOOST_AUTO_TEST_CASE(persistent_walk_converges_strongly) {
  const double tau = 600., t = 1200.;
  const int finest = 4096, paths = 200;
  const auto rms = [&](const int steps) {
    double sum = 0.;
    const int ratio = finest / steps;
    const double h = t / finest, fine_decay = std::exp(-h / tau), decay = std::exp(-h * ratio / tau);
    for (int path = 0; path < paths; ++path) {
      double P = 0., x = 0., P_fine = 0., x_fine = 0.;
      for (int k = 0; k < steps; ++k) {
        double noise = 0.;
        for (int j = 0; j < ratio; ++j) {
          const double xi = random_normals(9, std::uint64_t(path), std::uint64_t(k * ratio + j))[0];
          x_fine += h * P_fine;
          P_fine = polarity_after(P_fine, 0., fine_decay, 1., xi);
          noise = noise * fine_decay + std::sqrt(1. - fine_decay * fine_decay) * xi;
        }
        x += h * ratio * P;
        P = polarity_after(P, 0., decay, 1., noise / std::sqrt(1. - decay * decay));
      }
      BOOST_CHECK_SMALL(P - P_fine, 1e-12);
      sum += (x - x_fine) * (x - x_fine) / paths;
    }
    return std::sqrt(sum);
  };
  const double coarse = rms(16), fine = rms(64);
  BOOST_TEST(std::log(coarse / fine) / std::log(4.) == 1., boost::test_tools::tolerance(0.1));
}

// Cells of a culture that crawl alone, far from each other: the persistent walk's mean squared displacement,
// in space and in a plane.
BOOST_AUTO_TEST_CASE(cells_of_a_culture_crawl) {
  const double t = 3600., tau = 900., F_0 = 1e-9, apart = 1e-3;
  std::vector<double> first;
  for (const auto &[in_plane, threads] : {std::pair(false, 1u), std::pair(false, 2u), std::pair(true, 1u)}) {
    CultureParameters parameters;
    parameters.life.variability.spread = 0.;
    parameters.life.growth.inhibition = Inhibition::none;
    parameters.life.cycle.mitosis = 1e4;  // in which nothing grows: radius and friction stay
    parameters.life.cycle_time = 1e5;
    parameters.migration = {.force = F_0, .persistence = tau};
    parameters.in_plane = in_plane;
    parameters.motion.longest_step = 30.;
    parameters.motion.tolerance = 0.1;
    CellCulture culture(parameters, {}, threads);
    const int columns = 90, rows = 100;  // more than a chunk of any loop
    for (int a = 0; a < columns; ++a)
      for (int b = 0; b < rows; ++b) culture.life.add(culture.cells, Vector<3>(apart * a, apart * b, 0.), 0.);
    while (culture.time() < t) culture.advance(t);
    double squared = 0., across = 0.;
    std::vector<double> x(culture.cells.size());
    for (std::size_t i = 0; i < culture.cells.size();
         ++i) {  // the order in memory is that of places; each is still nearest to where it started
      const Vector<3> at = culture.cells.particles.position(i);
      const Vector<3> home(apart * std::round(at[0] / apart), apart * std::round(at[1] / apart), 0.);
      squared += (at - home).squaredNorm() / (columns * rows);
      across = std::max(across, std::abs(at[2]));
      x[i] = at[0];
    }
    const double R = parameters.life.birth_radius,
                 speed = F_0 / (4. * std::numbers::pi * R * R * parameters.medium_friction);
    const double directions = in_plane ? 2. : 3.;
    const double exact = 2. * directions * speed * speed / 3. * tau * (t - tau * (1. - std::exp(-t / tau)));
    BOOST_CHECK_SMALL(squared / exact - 1., 4. * std::sqrt(2. / (directions * columns * rows)));
    BOOST_TEST((across == 0.) == in_plane);
    if (first.empty())
      first = x;
    else if (threads == 2)
      BOOST_CHECK(x == first);
  }
}

BOOST_AUTO_TEST_SUITE_END()
