#include "micro/scenes/instruments/two_cells.h"

#include "micro/solve/bisection.h"
#include "micro/terms/external_force.h"
#include "run/input_entries.h"
#include "run/judged.h"
#include "run/number_text.h"
#include "run/run_failed_by.h"
#include "run/stop_flag.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace turgor {
namespace {
constexpr long most_samples = 1000000;
constexpr double least_deepest = 1e-6,  // over a radius
    rows_enough = 10.;                  // of approach.csv, between touching and letting go
}  // namespace

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
                    Double(least_deepest, 1.));
  prm.add_parameter("Samples", samples,
                    "Rows of approach.csv on the way in, and as many on the way out. Units: none.",
                    Integer(10, most_samples));
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
  if (const double least = least_adhesion(); is_adhesive(contact_law()) && adhesion < least)
    throw InputError(
        "Adhesion is " + number_text(adhesion) +
        " J/m^2: with this Radius, Modulus and Accuracy the overlap of cells that hold on to each "
        "other, or their forces, drown in round-off. Use at least " +
        number_text(1.01 * least, 3) + ", softer cells or a larger Accuracy.");
}

/// Places are known to a few units of the last place of a distance. At the pull-off force the force depends
/// on the overlap by its square where the law has a largest pull (JKR), else by its power 3/2 (Hertz's own).
/// Both rest at overlaps of about the depth below. Forces a thousandth of a millionth of those at play have
/// to be within single precision.
double TwoCells::least_adhesion() const {
  const bool has_largest = hold_of(make_contact_law(law, 1.), 1., 1.) > 0.;
  const double place = 8. * radius * std::numeric_limits<double>::epsilon(),
               depth =
                   place * std::pow(accuracy, has_largest ? -1. / 2. : -2. / 3.),  // 3/4 cbrt((pi W/E)^2 R)
      R = 0.5 * radius, E = 0.5 * modulus / (1. - poisson * poisson),
               of_places = E / std::numbers::pi * std::sqrt(std::pow(depth / 0.75, 3) / R),
               of_forces = 1e-33 / (accuracy * std::numbers::pi * R);
  return std::max(of_places, of_forces);
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
    try {
      stepper.step(p, 0.5 * relaxation);
    } catch (const RunStopped &) {
      throw;
    } catch (const std::runtime_error &) {  // in terms of a solver and of steps that nobody chose
      throw RunFailed("the search for the pull-off force: a pair drawn apart by " + number_text(force) +
                      " N moves too fast for any step. Use a larger Medium friction (" + number_text(gamma) +
                      " N s/m); approach.csv is whole.");
    }
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

std::string TwoCells::more_rows(const double hold, const double way) const {
  const double needed = std::ceil(1.01 * rows_enough * way / hold),
               shallow = hold * (double(most_samples) / rows_enough - 1.2) / radius;
  if (needed <= double(most_samples))
    return "Use Samples = " + number_text(std::uint64_t(needed)) + " or more.";
  if (shallow >= least_deepest)
    return "Use Samples = " + number_text(most_samples) + " with a Deepest overlap of at most " +
           number_text(0.9 * shallow, 2) + ".";
  return "Use more Adhesion, or softer cells.";
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
  // m, of the way on which the cells hold on to each other: to where JKR lets go, or to Hertz's rest
  const double reach = hold > 0. || !is_adhesive(contact_law())
                           ? hold
                           : std::pow(0.75 * pull_off_closed_form() / (E * std::sqrt(R)), 2. / 3.),
               rows = reach * samples / (top - bottom);
  constexpr double fewest = 1., enough = rows_enough;
  const bool told = reach == 0. || rows >= fewest;
  if (reach > 0. && rows < enough)
    remarked(context, "hysteresis_work",
             "the cells hold on to each other over " + number_text(reach, 3) + " m of their way, which " +
                 (rows < fewest ? "lies between two rows" : "has " + number_text(rows, 2) + " rows") +
                 " of approach.csv: hysteresis_work and largest_pull_of_the_curve are " +
                 (told ? "rough" : "left out") + ". " + more_rows(reach, top - bottom));
  if (told) context.result("hysteresis_work", work, "J");
  if (!is_adhesive(contact_law())) {
    if (is_hertz) context.result("hertz_force_error", hertz_error, "1");
    return;
  }
  const double expected = pull_off_closed_form();
  if (told) context.result("largest_pull_of_the_curve", -least, "N");
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
