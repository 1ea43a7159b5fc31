#include "micro/scenes/plate_descent.h"

#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"

namespace turgor {
void PlateDescent::declare(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Plate distance", distance,
                    "Distance of the plates at the end; at the start they just touch the cell. Units: m.",
                    Double(1e-8, 1e-2));
  prm.add_parameter("Compression time", compression,
                    "Time in which the upper plate comes down, with one speed. Units: s.", Double(1e-3, 1e9));
  prm.add_parameter("Hold time", hold,
                    "Time for which it stands still then, before the force is measured. Units: s.",
                    Double(0., 1e9));
}

void PlateDescent::check(const double first, const double flattest, const std::string &why) const {
  if (!(distance < first))
    throw InputError("Plate distance (" + number_text(1e6 * distance) + " um) has to be less than the " +
                     number_text(1e6 * first) + " um at which the plates just touch the cell.");
  if (!(distance > flattest * first))
    throw InputError("Plate distance (" + number_text(1e6 * distance) +
                     " um) squeezes the cell flatter than " + number_text(flattest) + " of its height, " +
                     number_text(1e6 * flattest * first) + " um: " + why + ".");
}

std::vector<double> PlateDescent::stops() const {
  std::vector<double> all{compression};
  if (hold > 0.) all.push_back(compression + hold);
  return all;
}

std::unique_ptr<Plane<3>> PlateDescent::floor() const {
  return std::make_unique<Plane<3>>(Vector<3>::Zero(), Vector<3>::UnitZ());
}

std::unique_ptr<Plane<3>> PlateDescent::lid(const double first) const {
  auto plane = std::make_unique<Plane<3>>(Vector<3>(0., 0., first), -Vector<3>::UnitZ());
  plane->velocity[2] = -(first - distance) / compression;
  return plane;
}

std::function<void(std::size_t)> PlateDescent::ends(SteppedCells &cells, Plane<3> &lid) const {
  return [this, &cells, &lid](const std::size_t stop) {
    if (stop > 0 || hold == 0.) return;
    lid.velocity = Vector<3>::Zero();
    cells.begin_anew(first_step());
  };
}
}  // namespace turgor
