// Rigid tools on the tissue: travel, penalty by hand, reactions, an elastic block against the closed form,
// energy, checkpoint.
#include "tests/macro/tissue_fixture.h"

#include "run/archive.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>

using namespace turgor;
using namespace turgor::test;

namespace {
TissueParameters<2> pressed(const std::string &shape = "plate") {
  TissueParameters<2> p;
  p.size = {width, width};
  p.elements = {6, 6};
  p.tool.shape = choice_of<ToolShape>(shape);
  p.tool.motion = ToolMotion::steady;
  p.tool.speed = 1.;
  p.tool.depth = 0.05 * width;
  p.tool.radius = width;
  return p;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(rigid_tools)

BOOST_AUTO_TEST_CASE(travel_by_hand) {
  ToolParameters tool;
  tool.motion = ToolMotion::steady;
  tool.speed = 2.;
  tool.depth = 3.;
  BOOST_TEST(tool.travel(1.) == 2.);
  BOOST_TEST(tool.travel(5.) == 3.);
  tool.motion = ToolMotion::rebound;  // 3 sin(2 t/3): deepest at t = 3 pi/4, at the speed 2 at t = 0 and,
                                      // away, at t = 3 pi/2 and later
  BOOST_TEST(std::abs(tool.travel(0.75 * std::numbers::pi) - 3.) < 1e-14);
  BOOST_TEST(std::abs(tool.travel(1e-6) / 1e-6 - 2.) < 1e-9);
  BOOST_TEST(std::abs(tool.travel(1.5 * std::numbers::pi)) < 1e-14);
  BOOST_TEST(std::abs(tool.travel(1.5 * std::numbers::pi + 1.) + 2.) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_cylinder_has_to_meet_a_node) {
  TissueParameters<2> p = pressed("cylinder");
  p.degree = 1;
  p.elements = {
      6, 3};  // its lowest point is between two nodes, (1 - cos) of 1/6 of its radius above them: 0.014 of it
  p.tool.depth = 0.013 * width;
  BOOST_CHECK_EXCEPTION(p.check(), std::invalid_argument, [](const std::invalid_argument &problem) {
    return std::string(problem.what()).find("comes down between two nodes") != std::string::npos;
  });
  p.tool.depth = 0.015 * width;
  p.check();
}

BOOST_AUTO_TEST_CASE(penalty_by_hand) {
  TissueParameters<2> p = pressed();
  p.left = LeftSide::plate;
  const TissueMesh<2> mesh(p);
  const double kappa = 1e9;
  const RigidTools<2> tools(mesh, p, kappa);
  std::vector<double> u(mesh.nodes * 2, 0.), force(mesh.nodes * 2, 0.);
  // pushed in by 1e-5 m everywhere, the lower side 2e-6 m into its plate: force kappa * width * penetration
  for (unsigned int n = 0; n < mesh.nodes; ++n)
    if (mesh.nodal_area_below[n] > 0.) u[2 * n] = -2e-6;
  const double time = 1e-5;  // 1 m/s: 1e-5 m
  const ToolReading reading = tools.read(time, u);
  BOOST_TEST(reading.force == kappa * width * 1e-5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(reading.support == kappa * width * 2e-6, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(reading.energy == 0.5 * kappa * width * (1e-10 + 4e-12), boost::test_tools::tolerance(1e-12));
  // forces on the nodes: -d energy/du by central differences, for plate and cylinder
  for (const std::string shape : {"plate", "cylinder"}) {
    p.tool.shape = choice_of<ToolShape>(shape);
    const RigidTools<2> tool(mesh, p, kappa);
    u = wavy(mesh, 3e-6, 0.3);
    std::fill(force.begin(), force.end(), 0.);
    tool.add_forces(time, u, force);
    double largest = 0., worst = 0.;
    for (std::size_t i = 0; i < u.size(); ++i) {
      const double h = 1e-9, before = u[i];
      u[i] = before + h;
      const double up = tool.read(time, u).energy;
      u[i] = before - h;
      const double down = tool.read(time, u).energy;
      u[i] = before;
      largest = std::max(largest, std::abs(force[i]));
      worst = std::max(worst, std::abs(force[i] + (up - down) / (2. * h)));
    }
    BOOST_TEST(largest > 0.);
    BOOST_TEST(worst < 1e-3 * largest,
               shape << ": " << worst << " of " << largest);  // h/penetration: nodes at the edge of contact
  }
}

BOOST_AUTO_TEST_CASE(overlap_between_nodes_is_told_from_that_at_nodes) {
  const TissueParameters<2> p = pressed("cylinder");
  const TissueMesh<2> mesh(p);
  const double time = 1e-5, face = width - time, R = p.tool.radius;  // 1 m/s
  // Every node of the side lies on the cylinder, a hair below it: the straight edges between them are chords.
  std::vector<double> u(mesh.nodes * 2, 0.);
  for (unsigned int n = 0; n < mesh.nodes; ++n)
    if (mesh.nodal_area[n] > 0.) {
      const double d = mesh.node_position[n][1] - 0.5 * width;
      u[2 * n] = face + R - std::sqrt(R * R - d * d) - 1e-12 - mesh.node_position[n][0];
    }
  const ToolReading between = RigidTools<2>(mesh, p, 1e9).read(time, u);
  const double edge = width / 6.;
  BOOST_TEST(between.penetration > 0.9 * edge * edge / (8. * R));
  BOOST_TEST(between.node_penetration == 0.);
  BOOST_TEST(between.force == 0.);
  const ToolReading flat =
      RigidTools<2>(mesh, pressed("plate"), 1e9).read(time, std::vector<double>(mesh.nodes * 2, 0.));
  BOOST_TEST(flat.node_penetration == flat.penetration);
}

// A tool that has gone through the side without a touch is as deep as it has gone, the moved side or not.
BOOST_AUTO_TEST_CASE(a_tool_behind_the_side_is_as_deep_as_its_lowest_point) {
  TissueParameters<2> p = pressed("cylinder");
  p.tool.depth = 0.8 * width;
  const TissueMesh<2> mesh(p);
  const std::vector<double> rest(mesh.nodes * 2, 0.);
  std::vector<double> moved = rest;
  for (unsigned int n = 0; n < mesh.nodes; ++n) moved[2 * n] = -0.05 * width;
  for (const double radius : {0.01 * width, 0.1 * width, 0.3 * width, width}) {
    p.tool.radius = radius;
    const RigidTools<2> tool(mesh, p, 1e9);
    for (const double share : {0.06, 0.1, 0.2, 0.4, 0.7}) {
      const double depth = share * width;  // 1 m/s
      BOOST_TEST(tool.read(depth, rest).penetration == depth, boost::test_tools::tolerance(1e-9));
      BOOST_TEST(tool.read(depth, moved).penetration == depth - 0.05 * width,
                 boost::test_tools::tolerance(1e-9));
    }
  }
}

// A block between two frictionless plates is in uniaxial stress. Small strain, plane strain: E' = 4 mu
// (lambda + mu)/(lambda + 2 mu); pressed slowly (a hundredth of the wave's speed) and damped, force = E'
// strain width, strain less what the penalties take.
BOOST_AUTO_TEST_CASE(elastic_block_between_plates) {
  const double soft = 4. * mu;  // lambda
  NeoHookeanLaw<2> law(mu, soft, 3., rho);
  TissueParameters<2> p = pressed();
  p.left = LeftSide::plate;
  p.tool.speed = 0.1;
  p.tool.depth = 0.01 * width;
  p.tool.stiffness = 10.;
  Tissue<2> tissue(p, law);
  tissue.start();
  tissue.advance_to(8. * p.tool.depth / p.tool.speed);  // until it swings no more
  const double modulus = 4. * mu * (soft + mu) / (soft + 2. * mu);
  const double kappa = p.tool.stiffness * law.wave_modulus() / (width / 6.);
  // strain e and pressure q: e width + 2 q/kappa = depth, q = modulus e
  const double expected = width * p.tool.depth / (width / modulus + 2. / kappa);
  const ToolReading reading = tissue.state().tool;
  // 1 %: the strain itself, of second order
  BOOST_TEST(std::abs(reading.force / expected - 1.) < 0.02,
             "force " << reading.force << ", closed form " << expected);
  BOOST_TEST(std::abs(reading.support / reading.force - 1.) < 1e-3,
             "support " << reading.support << ", force " << reading.force);
}

// Kinetic + internal + penalty = work of the tool, but for what the steps lend; the clamp's reaction is the
// impulse's other half.
BOOST_AUTO_TEST_CASE(energy_and_momentum_of_an_impact) {
  for (const auto &[shape, damping] :
       {std::pair<std::string, double>{"plate", 0.}, {"cylinder", 0.}, {"plate", 0.3}, {"cylinder", 1.}}) {
    double error[2];
    for (int level = 0; level < 2; ++level) {
      NeoHookeanLaw<2> law(mu, 4. * mu, 0., rho);
      TissueParameters<2> p = pressed(shape);
      p.tool.motion = ToolMotion::rebound;
      p.tool.speed = 2.;
      p.tool.damping = damping;
      p.cfl = level == 0 ? 0.4 : 0.2;
      p.estimate_every = 0;
      Tissue<2> tissue(p, law);
      tissue.start();
      double impulse = 0., work = 0., momentum = 0.;
      while (tissue.time() < 4e-5) {
        const ToolReading before = tissue.state().tool;
        tissue.step(4e-5);
        const ToolReading &after = tissue.state().tool;
        impulse += tissue.last_step() *
                   (0.5 * (before.support + after.support) - after.force);  // the tool's: mean of the step
      }
      work = tissue.state().tool_work;
      const auto &mass = tissue.forces().mass();
      for (std::size_t i = 0; i < mass.size(); i += 2) momentum += mass[i] * tissue.state().v[i];
      BOOST_TEST(work > 0.);
      BOOST_TEST(std::abs(momentum - impulse) < 1e-9 * std::abs(impulse),
                 "momentum " << momentum << ", impulse " << impulse);
      const TissueEnergies energies = tissue.energies();
      BOOST_TEST((damping > 0. ? energies.heat > 1e-4 * work : std::abs(energies.heat) <= 1e-12 * work),
                 shape << ": heat " << energies.heat << " of " << work);
      error[level] = std::abs(energies.taken() - energies.heat) / work;
    }
    // The elastic law is linear in a step to the third order.
    BOOST_TEST(error[0] < 1e-3, shape << ": energy error " << error[0]);
    BOOST_TEST(error[1] < 0.5 * error[0] + 1e-6, shape << ": " << error[0] << ", " << error[1]);
  }
}

// A dashpot stops a node by itself as exp(-2 zeta w t) and pulls no node back.
BOOST_AUTO_TEST_CASE(dashpots_by_hand) {
  NeoHookeanLaw<2> law(mu, 4. * mu, 0., rho);
  TissueParameters<2> p = pressed();
  p.tool.damping = 0.25;
  Tissue<2> tissue(p, law);
  const RigidTools<2> &tools = *tissue.tools();
  const std::vector<double> &mass = tissue.forces().mass();
  unsigned int node = 0;
  while (!(tissue.mesh().nodal_area[node] > 0.)) ++node;
  const double area = tissue.mesh().nodal_area[node], kappa = tools.frequency2(mass) * mass[2 * node] / area,
               w = std::sqrt(kappa * area / mass[2 * node]), h = 0.1 / w;
  std::vector<double> u(mass.size(), -1.), v(mass.size(), 0.), impulse(mass.size(), 0.);
  u[2 * node] = 1e-3 * width;
  u[2 * node + 1] = 0.;
  v[2 * node] = 1e-3 * width / h * 1e-3;
  const double speed = 2. * v[2 * node], against = v[2 * node] + speed;
  ToolForces push = tools.add_dashpots({0., h, speed}, u, v, mass, impulse);
  const double expected = mass[2 * node] * against * (1. - std::exp(-2. * 0.25 * w * h));
  BOOST_TEST(push.tool == expected, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(impulse[2 * node] == -expected, boost::test_tools::tolerance(1e-9));
  impulse.assign(mass.size(), 0.);
  v[2 * node] = -1e6 * width / h;  // away, faster than any penalty pushes
  push = tools.add_dashpots({0., h, 0.}, u, v, mass, impulse);
  BOOST_TEST(push.tool == -kappa * area * u[2 * node] * h, boost::test_tools::tolerance(1e-9));
}

// The plate that hits an elastic block feels rho c v until the wave comes back; without the dashpot the force
// swings between nothing and twice that.
BOOST_AUTO_TEST_CASE(the_force_of_a_blow_does_not_swing) {
  double swing[2];
  for (int damped = 0; damped < 2; ++damped) {
    NeoHookeanLaw<2> law(mu, 4. * mu, 0., rho);
    TissueParameters<2> p = pressed();
    p.elements = {16, 2};
    p.lateral = LateralSides::periodic;
    p.tool.speed = 0.1;
    p.tool.stiffness = 4.;
    p.tool.damping = damped ? 0.3 : 0.;
    p.estimate_every = 0;
    Tissue<2> tissue(p, law);
    tissue.start();
    const double wave = std::sqrt((4. * mu + 2. * mu) / rho), end = width / wave;
    double sum = 0., sum2 = 0., time = 0.;
    while (tissue.time() < end) {
      tissue.step(end);
      if (tissue.time() < 0.3 * end) continue;
      const double h = tissue.last_step(), force = tissue.state().tool.force;
      sum += h * force;
      sum2 += h * force * force;
      time += h;
    }
    const double mean = sum / time, expected = rho * wave * p.tool.speed * width;
    BOOST_TEST(std::abs(mean / expected - 1.) < (damped ? 0.01 : 0.05),
               "mean force " << mean << ", rho c v " << expected);
    swing[damped] = std::sqrt(std::max(0., sum2 / time - mean * mean)) / mean;
  }
  BOOST_TEST_MESSAGE("swing of the force over its mean: " << swing[0] << ", with a dashpot " << swing[1]);
  BOOST_TEST(swing[0] > 0.3);
  BOOST_TEST(swing[1] < 0.05);
}

// At the full CFL fraction nothing blows up, however stiff the contact.
BOOST_AUTO_TEST_CASE(stable_step_knows_the_contact) {
  double steps[2];
  for (int stiff = 0; stiff < 2; ++stiff) {
    NeoHookeanLaw<2> law(mu, 4. * mu, 0., rho);
    TissueParameters<2> p = pressed();
    p.left = LeftSide::plate;
    p.tool.stiffness = stiff ? 100. : 1.;
    p.tool.speed = 1.;
    p.cfl = 0.95;
    Tissue<2> tissue(p, law);
    tissue.start();
    steps[stiff] = tissue.stable_step();
    tissue.advance_to(1e-3);
    // Undamped, the contacts open and close for hundreds of steps. The energy they make must stay small
    // beside the work.
    BOOST_TEST(tissue.steps() > 100u);
    BOOST_TEST(std::abs(tissue.energies().dissipated()) < 0.2 * tissue.state().tool_work,
               "dissipated " << tissue.energies().dissipated() << " of " << tissue.state().tool_work
                             << " J/m after " << tissue.steps());
  }
  BOOST_TEST(steps[1] < 0.3 * steps[0]);
}

BOOST_AUTO_TEST_CASE(saved_and_loaded_impact_gives_the_same_bits) {
  for (const std::string integrator : {"central_differences", "dormand_prince"}) {
    TissueParameters<2> p = pressed("cylinder");
    p.integrator = choice_of<TimeIntegration>(integrator);
    p.shock_viscosity = 1.;
    p.estimate_every = 3;
    // a law each: its bounds are those of the states committed to it
    NeoHookeanLaw<2> whole_law(mu, lambda, 1., rho), first_law(mu, lambda, 1., rho),
        second_law(mu, lambda, 1., rho);
    Tissue<2> whole(p, whole_law), first(p, first_law), second(p, second_law);
    whole.start();
    whole.advance_to(1e-5);
    first.start();
    first.advance_to(1e-5, [](double, unsigned long step) { return step < 5; });
    restore(archived(first), second);
    second.advance_to(1e-5);
    BOOST_TEST((second.state().u == whole.state().u));
    BOOST_TEST(second.state().tool_work == whole.state().tool_work);
    BOOST_TEST(second.state().tool.force == whole.state().tool.force);
    BOOST_TEST(second.steps() == whole.steps());
  }
}

BOOST_AUTO_TEST_CASE(wrong_input_names_the_entry) {
  const auto fails = [](TissueParameters<2> p, const char *entry) {
    BOOST_CHECK_EXCEPTION(p.check(), std::invalid_argument, [&](const auto &e) {
      return std::string(e.what()).find(entry) != std::string::npos;
    });
  };
  TissueParameters<2> p = pressed();
  p.right = RightSide::clamped;
  fails(p, "Right side");
  p = pressed();
  p.tool.depth = 2. * width;
  fails(p, "Impact/Depth");
  p = pressed("cylinder");  // 6 elements
  for (const unsigned int degree : {1u, 2u}) {
    p.degree = degree;
    const double spacing = width / (6. * degree);
    p.tool.radius = 0.99 * spacing;
    fails(p, "Impact/Radius");
    fails(p, "'Tissue/Elements y' of at least 7");
    p.tool.radius = spacing;
    BOOST_CHECK_NO_THROW(p.check());
    p.tool.radius = 1e-9;
    fails(p, "Take a larger one.");
  }
}

BOOST_AUTO_TEST_SUITE_END()
