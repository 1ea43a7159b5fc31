// Implicit steps that are checked against making energy, by hand: a stiff pair of springs with and without
// its K, a wall that snaps through, a contact that opens while it is drawn, bodies of given velocity; same
// bits on threads and after a checkpoint.
#include "micro/engine/overdamped.h"
#include "micro/engine/system_motion.h"
#include "micro/geometry/plane.h"
#include "micro/laws/counter_random.h"
#include "micro/terms/obstacles.h"
#include "micro/terms/sphere_contacts.h"
#include "run/archive.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>
#include <numbers>

using namespace turgor;

namespace {
const auto digits = [](const double relative) { return boost::test_tools::tolerance(relative); };

/// Two particles on a line, in one group, whose energy is a function of their distance: shape(r) = {E, dE/dr,
/// what of d2E/dr2 the matrix has}.
struct Along {
  double energy, slope, stiffness;
};
class Spring final : public Term<3> {
 public:
  std::function<Along(double)> shape;
  int accepted = 0;

  std::string name() const override { return "spring"; }
  void declare(Particles<3> &) override {}
  void accept() override { ++accepted; }
  void add_forces(Particles<3> &p, const Box<3> &, std::size_t) override {
    const double f = shape(p.x[0][1] - p.x[0][0]).slope;
    p.f[0][0] += f;
    p.f[0][1] -= f;
  }
  void collect(MotionMatrix &matrix, const Particles<3> &p, const double h) override {
    if (const double k = shape(p.x[0][1] - p.x[0][0]).stiffness; h * k > 0.)
      matrix.link<3>(0, 1, Vector<3>::UnitX(), h * k, 0.);
  }
  double energy(const Particles<3> &p, const Box<3> &, std::size_t) const override {
    return shape(p.x[0][1] - p.x[0][0]).energy;
  }
};

struct SpringPair {
  ParticleSystem<3> system;
  Particles<3> &p = system.particles;
  SystemMotion<3> motion{system, {.tolerance = 1e-12}};
  Spring *spring;

  SpringPair(const double medium, const double distance, std::function<Along(double)> shape) {
    p.resize(2);
    p.groups = {{0, 0, 2}};
    spring = &system.add(std::make_unique<Spring>());
    spring->shape = std::move(shape);
    p.x[0] = {0., distance};
    motion.medium = {medium, medium};
    motion.own_length = 1.;
  }
  double distance() const { return p.x[0][1] - p.x[0][0]; }
};

OverdampedParameters checked(const double first_step, const EnergyCheck &check) {
  OverdampedParameters parameters{
      .method = OverdampedMethod::implicit, .tolerance = 1e12, .first_step = first_step, .least_step = 1e-12};
  parameters.energy = check;
  parameters.energy.on = true;
  return parameters;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(energy_step)

// gamma v = -2 k r for the distance's velocity. With its K a step is r/(1 + 2 h k/gamma), however long; the
// next one is 1.3 times as long.
BOOST_AUTO_TEST_CASE(a_stiff_spring_takes_any_step) {
  const double k = 1e6, gamma = 2.;
  SpringPair pair(gamma, 0.7, [=](const double r) { return Along{0.5 * k * r * r, k * r, k}; });
  Overdamped<3> stepper(checked(0.3, {.longest_move = 1e3}), pair.motion, 1);
  double r = 0.7, h = 0.3;
  for (int step = 0; step < 4; ++step, h *= 1.3) {
    BOOST_TEST(stepper.step(pair.p, 1e9) == h, digits(1e-14));
    r /= 1. + 2. * h * k / gamma;
    BOOST_CHECK_SMALL(
        pair.distance() - r,
        1e-6 * r + 1e-15);  // the solution's tolerance of what is left after 1e-6 each, round-off
    BOOST_TEST(pair.spring->accepted == step + 1);
  }
  BOOST_TEST(stepper.rejected() == 0u);
}

// Without its K the step is explicit, r (1 - a) with a = 2 h k/gamma, and 1/2 k r^2 (1 - a)^2 + 1/2 h D, D =
// 2 gamma (k r/gamma)^2, is at most 1/2 k r^2 for a <= 1: longer steps are halved.
BOOST_AUTO_TEST_CASE(a_spring_without_its_stiffness_is_halved_to_what_it_can_bear) {
  const double k = 50., gamma = 4.;
  SpringPair pair(gamma, 0.7, [=](const double r) { return Along{0.5 * k * r * r, k * r, 0.}; });
  double dt = 5.1 * gamma / (2. * k), r = 0.7;
  Overdamped<3> stepper(checked(dt, {.tolerance = 1e-9, .longest_move = 1e3}), pair.motion, 1);
  std::uint64_t halved = 0;
  for (int step = 0; step < 14; ++step) {
    for (; 2. * dt * k / gamma > 1.; dt *= 0.5) ++halved;
    BOOST_TEST(stepper.step(pair.p, 1e9) == dt, digits(1e-14));
    r *= 1. - 2. * dt * k / gamma;
    dt *= 1.3;
    BOOST_CHECK_SMALL(pair.distance() - r, 1e-9 * r + 1e-15);
    BOOST_TEST(stepper.rejected() == halved);
    BOOST_TEST(stepper.rejected_by_energy() == halved);
  }
  BOOST_TEST(halved > 4u);
}

// A wall that snaps through: E = (s^2 - 1)^2 with s = r - 3, from just beside its top, where K is negative
// and the matrix has none of it. Energy falls in every step by half of what friction takes at least, no step
// moves a body farther than it may, and it comes to rest in the near trough, which explicit steps of the
// first length would leap over.
BOOST_AUTO_TEST_CASE(a_wall_that_snaps_through) {
  const auto shape = [](const double r) {
    const double s = r - 3.;
    return Along{std::pow(s * s - 1., 2), 4. * s * (s * s - 1.), std::max(0., 12. * s * s - 4.)};
  };
  for (const double first : {1e-3, 100.}) {
    SpringPair pair(1., 3.02, shape);
    const EnergyCheck check{.tolerance = 1e-10, .longest_move = 0.2};
    Overdamped<3> stepper(checked(first, check), pair.motion, 1);
    double t = 0.;
    for (int step = 0; step < 60; ++step) {
      const double before = pair.distance(), h = stepper.step(pair.p, 1e9), moved = pair.distance() - before,
                   energy = shape(before).energy;
      BOOST_TEST(0.5 * std::abs(moved) <= 0.2 * (1. + 1e-12));
      BOOST_TEST(shape(pair.distance()).energy + h * std::pow(0.5 * moved / h, 2) <=
                 energy + 1e-10 * energy);  // 1/2 h 2 gamma v^2
      t += h;
    }
    BOOST_TEST(pair.distance() == 4., digits(1e-9));
    BOOST_TEST(t > 1.);
  }
}

// Two spheres that adhere and are drawn apart by an active force of more than 3/2 pi W R: the contact opens,
// and is remembered as open though it was found so in a trial. What the force does is work; uncounted, steps
// would become so short that none makes more energy than is tolerated.
BOOST_AUTO_TEST_CASE(a_contact_that_is_drawn_open) {
  const double R = 7e-6, W = 1e-4, pull = 2.2 * std::numbers::pi * W * 0.5 * R, gamma = 0.3;
  struct Active final : Term<3> {
    double pull = 0.;
    bool counted = true;
    std::string name() const override { return "active"; }
    void declare(Particles<3> &) override {}
    void add_forces(Particles<3> &p, const Box<3> &, const std::size_t group) override {
      p.f[0][group] += group == 0 ? -pull : pull;
    }
    double energy(const Particles<3> &, const Box<3> &, std::size_t) const override { return 0.; }
    double active_work(const Particles<3> &p, const Box<3> &, const std::size_t group,
                       const double h) const override {
      return counted ? h * (group == 0 ? -pull : pull) * p.v[0][group] : 0.;
    }
  };
  for (const bool counted : {true, false}) {
    ParticleSystem<3> system;
    Particles<3> &p = system.particles;
    p.resize(2);
    p.groups = {{0, 0, 1}, {1, 1, 2}};
    SphereContacts &contacts = system.add(std::make_unique<SphereContacts>(JkrContact{W}, 1e-6));
    Active &active = system.add(std::make_unique<Active>());
    active.pull = pull;
    active.counted = counted;
    p.field("radius") = {R, R};
    p.field("modulus") = {450., 450.};
    p.x[0] = {0., 1.97 * R};
    SystemMotion<3> motion(system, {.tolerance = 1e-10});
    motion.medium = {gamma, gamma};
    Overdamped<3> stepper(checked(1., {.longest_move = 0.01}), motion, 1);
    const double release = JkrContact{W}.release(0.5 * R, 225.);
    bool open = false;
    for (int step = 0; step < 400 && p.x[0][1] - p.x[0][0] < 2.3 * R; ++step) {
      stepper.step(p, 1e9);
      const double overlap = 2. * R - (p.x[0][1] - p.x[0][0]);
      open = contacts.contacts()[0].distance == 0.;
      BOOST_TEST(open == (overlap <= release));
    }
    BOOST_TEST_MESSAGE("steps taken back " << stepper.rejected_by_energy());
    BOOST_TEST(open == counted);
    BOOST_TEST((counted ? stepper.rejected_by_energy() == 0u : stepper.rejected_by_energy() > 5u));
    if (!open) continue;
    // alone, held by nothing: v = F/gamma; and it stays open where a contact that was not would still hold
    stepper.step(p, 1e9);
    BOOST_TEST(p.v[0][1] == pull / gamma, digits(1e-9));
    p.x[0][1] = p.x[0][0] + 2. * R - 0.5 * release;
    motion.forces(p, false);
    BOOST_TEST(p.f[0][1] == pull);
  }
}

// A plane that slides over a sphere and is pressed into it drags and pushes it. By hand, one step: along the
// plane (medium + a) v = a V; across it (medium + a + h k) v = F + (a + h k) V. Lost: medium v^2 + a (v -
// V)^2; the bodies' work is their friction's, -a (v - V).V, and what h k foresees, h k V v.
BOOST_AUTO_TEST_CASE(what_a_moving_body_does) {
  const double R = 0.5, medium = 3., friction = 2., h = 0.1;
  ParticleSystem<3> system;
  Particles<3> &p = system.particles;
  p.resize(1);
  p.groups = {{0, 0, 1}};
  Obstacles<3> &wall = system.add(std::make_unique<Obstacles<3>>(
      "wall", SphereOnSurface{{.friction = friction}},
      std::make_unique<Plane<3>>(Vector<3>(0., 0., 0.), Vector<3>(0., 0., 1.))));
  for (const char *const field : {"radius", "modulus"}) p.declare(field);
  p.field("radius") = {R};
  p.field("modulus") = {10.};
  p.x[2] = {0.9 * R};
  wall[0].velocity = Vector<3>(0.4, 0., 0.2);
  SystemMotion<3> motion(system, {.tolerance = 1e-13});
  motion.medium = {medium};
  motion.forces(p, false);
  motion.velocities(p, h);
  double a = 0., k = 0.;
  wall.for_touches(p, [&](const auto &touch) {
    a = friction * touch.does.area;
    k = touch.does.stiffness;
  });
  BOOST_TEST(a * k > 0.);
  const double along = a * 0.4 / (medium + a),
               across = (p.f[2][0] + (a + h * k) * 0.2) / (medium + a + h * k);
  BOOST_TEST(p.v[0][0] == along, digits(1e-10));
  BOOST_TEST(p.v[2][0] == across, digits(1e-10));
  const double lost = medium * (along * along + across * across) +
                      a * (std::pow(along - 0.4, 2) + std::pow(across - 0.2, 2)),
               by_friction = -a * ((along - 0.4) * 0.4 + (across - 0.2) * 0.2),
               foreseen = h * k * 0.2 * across;
  BOOST_TEST(motion.dissipation(p) == lost, digits(1e-10));
  BOOST_TEST(motion.work_of_bodies(p, 0.05) == 0.05 * (by_friction + foreseen), digits(1e-9));
}

/// Each particle to the origin, by a spring that the matrix does not know.
class Tether final : public Term<3> {
 public:
  double stiffness = 0.;
  std::string name() const override { return "tether"; }
  void declare(Particles<3> &) override {}
  void add_forces(Particles<3> &p, const Box<3> &, const std::size_t group) override {
    for (int d = 0; d < 3; ++d) p.f[d][group] -= stiffness * p.x[d][group];
  }
  double energy(const Particles<3> &p, const Box<3> &, const std::size_t group) const override {
    return 0.5 * stiffness * p.position(group).squaredNorm();
  }
};

// A crowd that is let go, deep in each other and each on its tether, steps taken back among them: the same
// bits on any number of threads and after a checkpoint in the middle; energy only falls.
BOOST_AUTO_TEST_CASE(same_bits_on_threads_and_after_a_checkpoint) {
  constexpr std::uint32_t n = 700;
  static constexpr double R = 7e-6;
  struct Crowd {
    ParticleSystem<3> system;
    Particles<3> &p = system.particles;
    SphereContacts *contacts;
    SystemMotion<3> motion{system, {.tolerance = 1e-5}};
    Overdamped<3> stepper;
    Crowd(const unsigned int threads) : stepper(checked(1e4, {.longest_move = 1e3}), motion, threads) {
      system.threads = threads;
      p.resize(n);
      for (std::uint32_t i = 0; i < n; ++i) p.groups.push_back({i, i, i + 1});
      contacts = &system.add(std::make_unique<SphereContacts>(JkrContact{1e-4}, 2e-6));
      system.add(std::make_unique<Tether>()).stiffness = 1e-4;
      contacts->friction = {.normal = 5e9, .tangential = 2e9};
      for (std::uint32_t i = 0; i < n; ++i) {
        for (int d = 0; d < 3; ++d)
          p.x[d][i] = 0.9 * R * std::cbrt(double(n)) * random_uniform(3, 3 * i + std::uint64_t(d));
        p.field("radius")[i] = R * (0.9 + 0.2 * random_uniform(4, i));
        p.field("modulus")[i] = 450.;
      }
      motion.medium.assign(n, 0.3);
    }
    void archive(Archive &a) {
      system.archive(a);
      a(stepper);
    }
  };
  Crowd whole(1), threads(2), first(2), rest(1);
  double energy = HUGE_VAL;
  for (int step = 0; step < 8; ++step) {
    if (step == 4) {
      Archive save;
      first.archive(save);
      const std::string bytes = save.finish();
      Archive load(bytes);
      rest.archive(load);
      load.finish();
    }
    const double h = whole.stepper.step(whole.p, 1e9);
    BOOST_TEST(threads.stepper.step(threads.p, 1e9) == h);
    BOOST_TEST((step < 4 ? first : rest).stepper.step((step < 4 ? first : rest).p, 1e9) == h);
    const Energies now = whole.motion.energy(whole.p);
    BOOST_TEST(now.sum <= energy + 2e-5 * now.size);
    energy = now.sum;
  }
  BOOST_TEST(whole.stepper.rejected_by_energy() > 0u);
  BOOST_CHECK(whole.p.x == threads.p.x);
  BOOST_CHECK(whole.p.x == rest.p.x);
  BOOST_CHECK(whole.p.v == rest.p.v);
  BOOST_TEST(whole.stepper.rejected() == rest.stepper.rejected());
}

// Forces that push up their energy: no step is short enough, and the run says so.
BOOST_AUTO_TEST_CASE(forces_that_are_no_slope_fail_with_a_sentence) {
  SpringPair pair(1., 1., [](const double r) { return Along{-r * r, 2. * r, 0.}; });
  OverdampedParameters parameters = checked(0.1, {});
  parameters.least_step = 1e-4;
  Overdamped<3> stepper(parameters, pair.motion, 1);
  BOOST_CHECK_EXCEPTION(stepper.step(pair.p, 1e9), std::runtime_error, [](const std::runtime_error &error) {
    return std::string(error.what()).find("every step makes energy") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(refuses_explicit_steps) {
  SpringPair pair(1., 1., [](const double r) { return Along{r * r, 2. * r, 2.}; });
  OverdampedParameters parameters = checked(1., {});
  parameters.method = OverdampedMethod::heun;
  BOOST_CHECK_THROW(Overdamped<3>(parameters, pair.motion, 1), std::logic_error);
}

BOOST_AUTO_TEST_SUITE_END()
