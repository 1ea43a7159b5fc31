#include "micro/scenes/instruments/two_cells.h"

#include "micro/solve/bisection.h"
#include "micro/terms/external_force.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_failed_by.h"
#include "run/stop_flag.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace turgor {
void TwoCells::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Law", law, "Contact law of the cells. " + contact_law_text() + ". Units: none.",
                    Selection(contact_law_names()));
  prm.add_parameter("Radius", radius, "Radius of each of the two cells. Units: m.", Double(1e-9, 1.));
  prm.add_parameter("Modulus", modulus, "Young's modulus of each of the two cells. Units: Pa.",
                    Double(1e-3, 1e12));
  prm.add_parameter("Poisson ratio", poisson, "Poisson ratio of each of the two cells. Units: none.",
                    Double(0., 0.5));
  prm.add_parameter(
      "Adhesion", adhesion,
      "Energy of adhesion W per area of contact; without effect with Law = hertz. Units: J/m^2.",
      Double(0., 1e3));
  prm.add_parameter("Medium friction", gamma, "Force over velocity of one cell in the medium. Units: N s/m.",
                    Double(1e-12, 1e12));
  prm.add_parameter("Cell friction", friction,
                    "Friction between the cells along and across their line: force over velocity and area of "
                    "contact; changes no result but time. Units: N s/m^3.",
                    Double(0., 1e20));
  prm.add_parameter("Deepest overlap", deepest,
                    "Overlap at which the approach turns: sum of the radii minus the distance of the "
                    "centres, over Radius. Units: none.",
                    Double(1e-6, 1.));
  prm.add_parameter("Samples", samples,
                    "Rows of approach.csv on the way in, and as many on the way out. Units: none.",
                    Integer(10, 1000000));
  prm.add_parameter("Accuracy", accuracy,
                    "Relative accuracy to which the pull-off force is searched by bisection. Units: none.",
                    Double(1e-12, 0.1));
}

void TwoCells::check() const {
  if (const std::string wrong = wrong_adhesion(contact_law(), modulus, radius, "Radius"); !wrong.empty())
    throw InputError(wrong);
  if (is_adhesive(contact_law()) && !(adhesion > 0.))
    throw InputError(
        "Adhesion is 0, so these cells never hold on to each other: give it in J/m^2, or Law = hertz.");
}

ContactLaw TwoCells::contact_law() const { return make_contact_law(law, adhesion); }

Particles<3> TwoCells::pair(const double overlap) const {
  Particles<3> p;
  p.resize(2);
  p.groups = {{0, 0, 2}};
  p.declare("radius");
  p.declare("modulus");
  p.field("radius") = {radius, radius};
  p.field("modulus").assign(2, modulus / (1. - poisson * poisson));
  p.x[0] = {0., 2. * radius - overlap};
  return p;
}

double TwoCells::pull_off_closed_form() const {
  return std::visit([this](const auto &one) { return one.pull_off(0.5 * radius); }, contact_law());
}

bool TwoCells::holds(const double force) const {
  ParticleSystem<3> system;
  system.particles = pair(0.05 * radius);  // in contact
  Particles<3> &p = system.particles;
  SphereContacts &contacts = system.add(std::make_unique<SphereContacts>(contact_law(), 0.2 * radius));
  contacts.friction = {.normal = friction, .tangential = friction};
  SystemMotion<3> motion(system, {.tolerance = 1e-12});
  motion.medium.assign(2, gamma);
  system.add(std::make_unique<DeadForce<3>>(
      std::vector<DeadForce<3>::Entry>{{0, Vector<3>(-force, 0., 0.)}, {1, Vector<3>(force, 0., 0.)}}));
  Overdamped<3> stepper({.method = OverdampedMethod::heun,
                         .tolerance = 1e-5,
                         .first_step = 1e-3,
                         .least_step = 1e-15,
                         .longest_step = HUGE_VAL},
                        motion, 1);
  // It holds once the net force apart is a hundredth of the accuracy asked for, or turns: between there and
  // the start it was nothing. Or once the way left to rest is the round-off of the cells' places. It is free
  // where there is no contact any more. The net force itself: beside the friction between the cells that of
  // the medium may be nothing, so that velocity times Medium friction says nothing.
  //
  // A step lasts half the time in which the contact relaxes: force over overlap bends upwards, so that none
  // passes the place of rest, and the force left is halved in every second or so. The tolerance of the steps
  // alone lets them grow until the pair dances about its rest, as far from it as the tolerance, for ever.
  constexpr int most_steps = 100000;  // hundreds are enough
  double relaxation = HUGE_VAL;
  for (int k = 0; k < most_steps; ++k) {
    stepper.step(p, 0.5 * relaxation);
    stop_here("during the search for the pull-off force");
    motion.forces(p, true);
    if (contacts.contacts().empty() || !(contacts.contacts()[0].area > 0.)) return false;
    const PairContact &contact = contacts.contacts()[0];
    const double place = 8. * radius * std::numeric_limits<double>::epsilon();  // m
    if (p.f[0][1] < std::max(0.01 * accuracy * force, contact.stiffness * place)) return true;
    relaxation =
        contact.stiffness > 0. ? 0.5 * (gamma + 2. * friction * contact.area) / contact.stiffness : HUGE_VAL;
  }
  throw RunFailed("the search for the pull-off force: a pair drawn apart by " + number_text(force) +
                  " N neither came to rest nor let go within " + number_text(most_steps) +
                  " steps. Use a larger Medium friction (" + number_text(gamma) +
                  " N s/m) or a larger Accuracy (" + number_text(accuracy) + "); approach.csv is whole.");
}

void TwoCells::run(RunContext &context) {
  context.active({SphereContacts::name(contact_law()), friction > 0. ? "cell_friction" : "medium_friction"},
                 pair(0.).field_names());
  const auto table =
      context.series("approach", {{"overlap", "m"}, {"force", "N"}, {"area", "m^2"}, {"energy", "J"}});
  Particles<3> p = pair(0.);
  SphereContacts contacts(contact_law(), 0.2 * radius);
  const bool is_hertz = std::holds_alternative<HertzContact>(contact_law());
  const double top = deepest * radius, R = 0.5 * radius, E = 0.5 * modulus / (1. - poisson * poisson);
  const double hold = hold_of(contact_law(), R, E), bottom = hold > 0. ? -1.2 * hold : -0.05 * top;
  double imbalance = 0., largest = 0., work = 0., before = 0., overlap_before = bottom, hertz_error = 0.,
         least = 0.;
  const auto measure = [&](const double overlap) {
    p.x[0][1] = 2. * radius - overlap;
    for (auto &f : p.f) f = {0., 0.};
    contacts.add_forces(p, 1);
    const PairContact c = contacts.contacts().empty() ? PairContact() : contacts.contacts()[0];
    const double force = p.f[0][1];
    imbalance = std::max(imbalance, std::abs(p.f[0][0] + p.f[0][1]));
    largest = std::max(largest, std::abs(force));
    least = std::min(least, force);
    work += 0.5 * (force + before) * (overlap - overlap_before);
    before = force;
    overlap_before = overlap;
    if (is_hertz && overlap > 0.)
      hertz_error =
          std::max(hertz_error, std::abs(force / (4. / 3. * E * std::sqrt(R) * std::pow(overlap, 1.5)) - 1.));
    table->add_row({overlap, force, c.area, c.energy});
  };
  for (unsigned int k = 0; k <= samples; ++k) measure(bottom + (top - bottom) * k / samples);
  for (unsigned int k = 1; k <= samples; ++k) measure(top + (bottom - top) * k / samples);

  context.result("largest_force", largest, "N");
  context.result("momentum_imbalance", imbalance / largest, "1");
  context.result("hysteresis_work", work, "J");
  if (!is_adhesive(contact_law())) {
    if (is_hertz) context.result("hertz_force_error", hertz_error, "1");
    return;
  }
  const double expected = pull_off_closed_form();
  context.result("largest_pull_of_the_curve", -least, "N");
  const int halvings = std::max(1, int(std::ceil(std::log2(1. / accuracy))));
  int asked = 0;
  const double pull_off = run_failed_by([&] {
    return bisect(
        0.5 * expected, 1.5 * expected,
        [&](const double force) {
          context.progress(std::min(1., ++asked / (halvings + 2.)), "pull-off force by bisection");
          return holds(force);
        },
        "the pull-off force (N)", halvings);
  });
  context.result("pull_off", pull_off, "N");
  context.result("pull_off_closed_form", expected, "N");
  context.result("pull_off_error", pull_off / expected - 1., "1");
}

std::unique_ptr<Scenario> make_two_cells() { return std::make_unique<TwoCells>(); }
}  // namespace turgor
