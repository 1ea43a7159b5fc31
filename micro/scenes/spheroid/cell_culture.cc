#include "micro/scenes/spheroid/cell_culture.h"

#include "run/archive.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "micro/engine/space_order.h"
#include "micro/processes/polarity.h"
#include "micro/scenes/spheroid/friction_advice.h"
#include "micro/solve/step_too_long.h"
#include "micro/terms/cell_motility.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace turgor {
namespace {
/// m; the pair list looks farther than adhesion holds on.
double skin_of(const CultureParameters &p) {
  const double R = 0.5 * p.life.birth_radius * std::cbrt(2.),
               E = 0.5 * p.life.modulus / (1. - p.life.poisson * p.life.poisson);
  const double hold = hold_of(contact_law(p), R, 0.6 * E);  // the softest pairs hold longest
  return std::max(0.2 * p.life.birth_radius, 1.1 * hold);
}
}  // namespace

ContactLaw contact_law(const CultureParameters &parameters) {
  return make_contact_law(parameters.law, parameters.adhesion);
}

CellCulture::CellCulture(const CultureParameters &parameters_, Surroundings surroundings_,
                         const unsigned int threads_)
    : life(parameters_.life),
      surroundings(std::move(surroundings_)),
      parameters(parameters_),
      contacts(cells.add(std::make_unique<SphereContacts>(contact_law(parameters_), skin_of(parameters_),
                                                          parameters_.stiffness, parameters_.compression))),
      motion(cells, parameters_.solve),
      stepper(parameters_.motion, motion, threads_),
      h(parameters_.interval > 0.
            ? parameters_.interval
            : 3. * parameters_.growth_tolerance * parameters_.life.cycle_time / std::numbers::ln2) {
  cells.threads = threads_;
  contacts.friction = parameters.friction;
  if (migrates())
    life.add(
        std::make_unique<Polarity>(parameters.migration, parameters.life.variability.seed, directions()));
  life.declare(cells.particles);
  if (parameters.motility > 0.)
    cells.add(
        std::make_unique<CellMotility>(parameters.motility, parameters.life.variability.seed, directions()));
  surroundings.join(cells, contacts);
  if (migrates()) cells.add(std::make_unique<CellMigration>(parameters.migration));
}

std::vector<std::string> CellCulture::term_names() const {
  std::vector<std::string> names = {SphereContacts::name(contact_law(parameters)), "medium_friction"};
  if (parameters.friction.normal > 0. || parameters.friction.tangential > 0.)
    names.push_back("cell_friction");
  if (parameters.stiffness) names.push_back("local_stiffness");
  for (const std::string &name : cells.term_names())
    if (name != names.front()) names.push_back(name);
  return names;
}

const std::vector<double> &CellCulture::pressures() {
  cells.compute_forces();
  return life.measure_pressures(cells, contacts, cells.threads);
}

void CellCulture::set_friction() {
  const std::vector<double> &R = cells.particles.field("radius");
  std::vector<double> &gamma = motion.medium;
  gamma.resize(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    gamma[i] = 4. * std::numbers::pi * R[i] * R[i] * parameters.medium_friction;
}

void CellCulture::sort() {
  if (10 * cells.size() < 11 * sorted_size) return;
  sorted_size = cells.size();
  const Rearrangement places = space_order(cells.particles, 2. * parameters.life.birth_radius);
  cells.gather(places);
  stepper.gather(places);
}

void CellCulture::begin_interval() {
  sort();
  cells.compute_forces();
  life.advance(cells, contacts, surroundings, until - t, steps, cells.threads,
               [this](const Rearrangement &places) { stepper.gather(places); });
  if (cells.size() == 0)
    throw std::runtime_error(
        "none is left: all have died and were removed. End the run earlier (End time), or keep the dead "
        "(Death/Remove lysed = false).");
  surroundings.update(cells.particles, t);
  set_friction();
  from = cells.particles.x;
  way = 0.;
}

double CellCulture::longest_step() const {
  double longest = life.longest_step();
  if (parameters.motility > 0.) {  // half a radius in the mean: 6 D h = (R/2)^2
    const double R = parameters.life.birth_radius;
    longest = std::min(longest, R * R / (24. * parameters.motility));
  }
  return longest;
}

std::string CellCulture::drivers() const {
  std::string names = surroundings.drivers;
  const auto add = [&](const char *name) { names += (names.empty() ? "" : ", ") + std::string(name); };
  if (migrates()) add("Motion/Migration force");
  if (parameters.motility > 0.) add("Motion/Motility");
  return names.empty() ? "" : " (" + names + ")";
}

double CellCulture::step(const double limit) {
  try {
    return stepper.step(cells.particles, limit);
  } catch (const RunStopped &) {
    throw;
  } catch (const std::runtime_error &error) {
    std::string cause = friction_advice(parameters, dynamic_cast<const NotSolved *>(&error) != nullptr, h);
    if (cause.empty() && dynamic_cast<const NoNumbers *>(&error) != nullptr)
      cause = std::string(error.what()) +
              " Use stiffer cells (Cell/Bulk modulus, Cell/Modulus), or less that drives them" + drivers() +
              ".";
    if (cause.empty()) throw;
    throw std::runtime_error(cause);
  }
}

void CellCulture::follow_ways() {
  way += stepper.last_move();
  constexpr double far = 10., too_far = 100.;  // radii
  const double R = motion.length(cells.particles);
  if (way <= far * R || (t < until && way <= too_far * R)) return;
  double square = 0.;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    double one = 0.;
    for (int d = 0; d < 3; ++d) one += std::pow(cells.particles.x[d][i] - from[d][i], 2);
    square = std::max(square, one);
  }
  const double gone = std::sqrt(square) / R;
  most = std::max(most, gone);
  if (gone > too_far)
    throw std::runtime_error(
        "a cell has moved by " + number_text(gone, 3) +
        " radii since pressures and growth of the cells were last looked at: they "
        "belong to another place, and so do its neighbours. Use less that drives the cells" +
        drivers() + ", more friction, or look more often (a smaller Motion/Growth tolerance).");
  if (t < until) way = gone * R;
}

bool CellCulture::advance(const double end, const std::function<bool()> &stop) {
  if (!(t < until)) {
    until = std::min(end, t + h);
    begin_interval();
  }
  const double longest = longest_step();
  while (t < until) {
    const double dt = step(std::min(until - t, longest));
    life.after_step(cells, dt, steps);
    cells.advance(dt);
    t = until - t > dt ? t + dt : until;
    ++steps;
    follow_ways();
    if (stop && t < until && stop()) return false;
  }
  return true;
}

void CellCulture::archive(Archive &a) {
  a.section("culture");
  a(t, until, motion.medium, steps, sorted_size, life.count, cells, from, way, most);
  a(stepper);
}
}  // namespace turgor
