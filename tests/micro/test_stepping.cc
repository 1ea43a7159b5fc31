// Steps: r-RESPA against kick-drift-kick and its order, the measured stable step against closed forms and
// what a cell really stands, the step that is chosen and shortened.
#include "micro/engine/measured_step.h"
#include "micro/engine/respa.h"
#include "micro/engine/step_control.h"
#include "micro/engine/stepper.h"
#include "run/archive.h"
#include "tests/micro/small_patch.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace turgor;

BOOST_AUTO_TEST_SUITE(stepping)

namespace {
/// Every particle on a spring of its own and in a drag; energy and forces by hand.
class Springs final : public Term<2> {
 public:
  Springs(const double k, const double c, const bool quick) : stiffness(k), drag(c), is_fast(quick) {}
  std::string name() const override { return "springs"; }
  void declare(Particles<2> &) override {}
  bool fast() const override { return is_fast; }
  void add_forces(Particles<2> &p, const Box<2> &, const std::size_t group) override {
    for (std::uint32_t i = p.groups[group].begin; i < p.groups[group].end; ++i)
      for (int d = 0; d < 2; ++d) p.f[d][i] -= stiffness * p.x[d][i] + drag * p.v[d][i];
  }
  double energy(const Particles<2> &p, const Box<2> &, const std::size_t group) const override {
    double total = 0.;
    for (std::uint32_t i = p.groups[group].begin; i < p.groups[group].end; ++i)
      for (int d = 0; d < 2; ++d) total += 0.5 * stiffness * p.x[d][i] * p.x[d][i];
    return total;
  }
  Rates rates(const Particles<2> &) const override {
    Rates bound;
    bound.wall = {stiffness, drag};
    return bound;
  }

  double stiffness;

 private:
  double drag;
  bool is_fast;
};

/// Four particles of mass 1 in two groups, on springs 1 (slow) and 100 (fast).
void fill(ParticleSystem<2> &system, const double slow_drag = 0.) {
  system.particles.resize(4);
  system.particles.groups = {{0, 2, 2}, {2, 4, 4}};
  for (std::size_t i = 0; i < 4; ++i) {
    system.particles.inverse_mass[i] = 1.;
    system.particles.x[0][i] = 0.3 + double(i);
    system.particles.x[1][i] = -0.2 * double(i * i);
    system.particles.v[0][i] = 1. - 0.5 * double(i);
  }
  system.add(std::make_unique<Springs>(1., slow_drag, false));
  system.add(std::make_unique<Springs>(100., 0., true));
}

double error_at_one(const double dt, const unsigned int substeps) {
  ParticleSystem<2> system;
  fill(system);
  const double x0 = system.particles.x[0][1], v0 = system.particles.v[0][1], w = std::sqrt(101.);
  Stepper<2> stepper(system, substeps);
  stepper.compute_forces();
  const int n = int(std::lround(1. / dt));
  for (int k = 0; k < n; ++k) stepper.step(dt);
  return std::abs(system.particles.x[0][1] - (x0 * std::cos(w) + v0 / w * std::sin(w)));
}
}  // namespace

BOOST_AUTO_TEST_CASE(respa_is_of_second_order) {
  const double coarse = error_at_one(0.02, 4), fine = error_at_one(0.01, 4);
  BOOST_TEST(std::log2(coarse / fine) > 1.9);
  BOOST_TEST(std::log2(coarse / fine) < 2.1);
  // The fast force is resolved four times better than with the one step for all.
  BOOST_TEST(coarse < 0.1 * error_at_one(0.02, 1));
}

BOOST_AUTO_TEST_CASE(one_substep_is_kick_drift_kick) {
  ParticleSystem<2> a, b;
  fill(a);
  fill(b);
  KickDriftKick<2> plain(a);
  Respa<2> split(b, 1);
  a.compute_forces();
  split.compute_forces();
  for (int k = 0; k < 100; ++k) {
    plain.step(0.05);
    split.step(0.05);
  }
  // Sums in another order: 100 steps of round-off.
  for (std::size_t i = 0; i < 4; ++i) BOOST_TEST(std::abs(a.particles.x[0][i] - b.particles.x[0][i]) < 1e-12);
  BOOST_TEST((a.virial() - b.virial()).norm() < 1e-9);
}

BOOST_AUTO_TEST_CASE(respa_resumes_with_the_same_bits) {
  ParticleSystem<2> a, b;
  fill(a, 0.1);
  fill(b, 0.1);
  Respa<2> whole(a, 3), resumed(b, 3);
  whole.compute_forces();
  for (int k = 0; k < 10; ++k) whole.step(0.02);
  restore(archived(a, whole), b, resumed);
  for (int k = 0; k < 10; ++k) {
    whole.step(0.02);
    resumed.step(0.02);
  }
  BOOST_TEST(a.particles.x[0] == b.particles.x[0]);
  BOOST_TEST(a.particles.v[1] == b.particles.v[1]);
}

BOOST_AUTO_TEST_CASE(measured_step_by_hand) {
  // w^2 = 101 without drag: dt = 2/w; with drag c: w^2 dt^2 + 2 c dt = 4. Differences of linear forces are
  // exact to 1e-7.
  ParticleSystem<2> system;
  fill(system);
  const auto x = system.particles.x;
  BOOST_TEST(measure_stable_step(system, 0.01).dt == 2. / std::sqrt(101.),
             boost::test_tools::tolerance(2e-3));
  BOOST_TEST(measure_stable_step(system, 0.01, Pace::slow).dt == 2., boost::test_tools::tolerance(2e-3));
  BOOST_TEST(measure_stable_step(system, 0.01, Pace::fast).dt == 0.2, boost::test_tools::tolerance(2e-3));
  BOOST_TEST(system.particles.x[0] == x[0]);
  BOOST_TEST(step_eigenvalue(system, 0.1) == 1.01, boost::test_tools::tolerance(1e-5));

  ParticleSystem<2> dragged;
  fill(dragged, 30.);
  const double exact = (-30. + std::sqrt(900. + 4. * 101.)) / 101.;
  BOOST_TEST(measure_stable_step(dragged, 1.).dt == exact, boost::test_tools::tolerance(2e-3));
  BOOST_TEST(dragged.stable_time_step() == exact, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(measuring_changes_nothing) {
  const auto a = test::SmallPatch().disturbed(1, 1, 1.), b = test::SmallPatch().disturbed(1, 1, 1.);
  for (const auto *patch : {&a, &b}) {
    ParticleSystem<2> &system = (*patch)->system;
    KickDriftKick<2> integrator(system);
    system.compute_forces();
    const double dt = 0.5 * system.stable_time_step();
    for (int k = 0; k < 20; ++k) {
      if (patch == &a && k % 5 == 0) measure_stable_step(system, dt);
      integrator.step(dt);
    }
  }
  BOOST_TEST(a->system.particles.x[0] == b->system.particles.x[0]);
  BOOST_TEST(a->system.particles.v[1] == b->system.particles.v[1]);
}

BOOST_AUTO_TEST_CASE(a_fast_cell_gets_a_shorter_step) {
  ParticleSystem<2> system;
  fill(system);
  StepControl<2> control(system, 0.9);
  const double first = control.dt();
  BOOST_TEST(first <= 0.9 * 2. / std::sqrt(101.) * (1. + 1e-12));
  // The two of a cell leave each other at 200 m/s: 0.0045 of the spacing a step.
  system.particles.v[0][0] = 100.;
  system.particles.v[0][1] = -100.;
  BOOST_TEST(!control.after_step(99));
  BOOST_TEST(control.after_step(100));
  BOOST_TEST(control.dt() < 0.1 * first);
  // Viscosity smooths it: v d/nu = 0.4, so 101 times that step, which is no bound any more.
  StepControl<2> calm(system, 0.9, collision_spacings, 1e3);
  BOOST_TEST(calm.dt() > 0.9 * first);
  StepControl<2> again(system, 0.9);
  restore(archived(control), again);
  BOOST_TEST(again.dt() == control.dt());
}

// Of two cells at the same speed the one whose particles are nearer each other decides; of two that are
// copies of each other neither does.
BOOST_AUTO_TEST_CASE(every_cell_counts_by_its_own_spacing) {
  const auto step_of = [](const double first, const double second) {
    ParticleSystem<2> system;
    system.particles.resize(4);
    system.particles.groups = {{0, 2, 2}, {2, 4, 4}};
    std::fill(system.particles.inverse_mass.begin(), system.particles.inverse_mass.end(), 1.);
    system.particles.x[0] = {0., first, 7., 7. + second};
    system.particles.x[1] = {0., first, 0., second};
    for (const int i : {0, 2}) {
      system.particles.v[0][i] = 100.;
      system.particles.v[0][i + 1] = -100.;
    }
    system.add(std::make_unique<Springs>(100., 0., false));
    return StepControl<2>(system, 0.9).dt();
  };
  const double coarse = step_of(0.3, 0.3), fine = step_of(0.1, 0.1);
  BOOST_TEST(3. * fine == coarse, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(step_of(0.3, 0.1) == fine, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(step_of(0.1, 0.3) == fine);
  BOOST_TEST(coarse == collision_spacings * (0.3 / std::sqrt(2.)) / 100.,
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(the_state_is_looked_at_again_where_particles_have_moved_by_a_spacing) {
  // Springs become four times as stiff: seen, and the step halved, once a particle has moved by a spacing
  // against the mean of its cell.
  ParticleSystem<2> system;
  system.particles.resize(4);
  system.particles.groups = {{0, 2, 2}, {2, 4, 4}};
  std::fill(system.particles.inverse_mass.begin(), system.particles.inverse_mass.end(), 1.);
  system.particles.x[0] = {0., 1., 2., 3.};
  system.particles.x[1] = {0., 0.5, 0., 0.5};
  Springs &springs = system.add(std::make_unique<Springs>(100., 0., false));
  StepControl<2> control(system, 0.9);
  const double first = control.dt(), spacing = 0.5;  // two particles in a box of 1 x 0.5
  BOOST_TEST(first == 0.9 * 0.2, boost::test_tools::tolerance(2e-3));
  springs.stiffness = 400.;
  BOOST_TEST(!control.after_step(100));  // nothing has moved
  for (int i = 0; i < 4; ++i) system.particles.x[0][i] += 50.;
  BOOST_TEST(!control.after_step(200));             // all have moved alike
  system.particles.x[1][3] += 2. * spacing * 0.98;  // one of two: half of it against their mean
  BOOST_TEST(!control.after_step(300));
  system.particles.x[1][3] += 2. * spacing * 0.04;
  BOOST_TEST(!control.after_step(301));  // looked at every hundredth step only
  BOOST_TEST(control.after_step(400));
  BOOST_TEST(control.dt() == 0.5 * first, boost::test_tools::tolerance(5e-3));
  springs.stiffness = 1600.;
  BOOST_TEST(!control.after_step(500));  // has not moved since
  system.particles.x[0][0] -= 2. * spacing * 1.02;
  BOOST_TEST(control.after_step(600));
  BOOST_TEST(control.dt() == 0.25 * first, boost::test_tools::tolerance(5e-3));
  springs.stiffness = 100.;
  system.particles.x[0][0] += 4. * spacing;
  BOOST_TEST(!control.after_step(700));  // never longer again
}

BOOST_AUTO_TEST_SUITE_END()
