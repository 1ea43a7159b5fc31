#include "micro/scenes/spheroid/friction_advice.h"

#include "micro/scenes/spheroid/cell_culture.h"
#include "run/number_text.h"

#include <algorithm>
#include <numbers>

namespace turgor {
namespace {
constexpr double overlap = 0.1;            // of a radius, of the contact that all is told by
constexpr double most_ratio = 1e10;        // of contacts over medium that is solved for; advised is a tenth
constexpr double fewest_steps = 1e3;       // shortest steps in which a contact has to relax
constexpr double steps_an_interval = 1e3;  // as long as a contact relaxes, where the advice is followed
}  // namespace

std::string friction_advice(const CultureParameters &p, const bool not_solved, const double interval) {
  const double radius = p.life.birth_radius, R = 0.5 * radius,
               E = 0.5 * p.life.modulus / (1. - p.life.poisson * p.life.poisson);
  const SphereContact contact = HertzContact()(R, E, overlap * radius);
  const double medium = 4. * std::numbers::pi * radius * radius * p.medium_friction,
               tied = contact.area * std::max(p.friction.normal, p.friction.tangential);
  const std::string now = "Contact/Medium friction is " + number_text(p.medium_friction) + " N s/m^3: ";
  if (const double ratio = tied / medium; not_solved && ratio > most_ratio)
    return "the velocities of the cells were not found. " + now + "contacts tie cells to one another " +
           number_text(ratio, 2) +
           " times as firmly as the medium holds each, more than can be solved for. Use a Contact/Medium "
           "friction of at least " +
           number_text(10. * ratio / most_ratio * p.medium_friction, 2) +
           ", or a Contact/Normal friction and a Contact/Tangential friction of at most " +
           number_text(0.1 * most_ratio / ratio * std::max(p.friction.normal, p.friction.tangential), 2) +
           ".";
  // s, in which two cells come to rest against each other
  const double relaxes = 0.5 * (medium + 2. * tied) / contact.stiffness,
               wanted = interval / steps_an_interval;
  if (relaxes < fewest_steps * p.motion.least_step)
    return "the cells have too little friction for any step: with a Contact/Medium friction of " +
           number_text(p.medium_friction) + " N s/m^3 a contact relaxes within " + number_text(relaxes, 2) +
           " s. Use a Contact/Medium friction of about " +
           number_text(wanted / relaxes * (medium + 2. * tied) / medium * p.medium_friction, 2) +
           ", with which it takes a thousandth of the " + number_text(interval, 3) +
           " s between two looks at the cells' life.";
  return "";
}
}  // namespace turgor
