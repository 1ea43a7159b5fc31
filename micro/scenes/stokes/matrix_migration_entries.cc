// Entries of matrix_migration and what they make.
#include "micro/scenes/stokes/matrix_migration.h"

#include "run/input_entries.h"
#include "run/number_text.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace turgor {
void MatrixMigration::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter(
      "Domain", domain,
      "Shape of the matrix, held at its rim: rectangle, Length by Width; disc, of diameter Width "
      "with the cell in its middle. Units: none.");
  prm.add_parameter("Length", length, "Length of a rectangle, along the preferred direction. Units: m.",
                    Double(1e-9, 1e3));
  prm.add_parameter("Width", width, "Width of a rectangle, diameter of a disc. Units: m.", Double(1e-9, 1e3));
  prm.add_parameter("Spacing", spacing, "Distance between particles of the matrix. Units: m.",
                    Double(1e-10, 1e2));
  prm.add_parameter(
      "Start", start,
      "Distance of the cell from the left rim of a rectangle at the start, over its length. Units: none.",
      Double(0.01, 0.99));
  declare_cell(prm);
  course.declare(prm, "migration.csv");
  solid.declare(prm);
  solid.steps.longest_step = 0.02;
  solid.steps.tolerance = 5e-3;
  solid.steps.shifting = 0.3;
  solid.steps.packing = StokesPacking::disordered;
  solid.declare_motion(prm);
}

void MatrixMigration::declare_cell(InputEntries &prm) {
  using namespace Patterns;
  prm.enter_subsection("Cell");
  prm.add_parameter("Radius", radius, "Radius of the rigid cell. Units: m.", Double(1e-9, 1e3));
  prm.add_parameter("Force", F0, "Constant size of the force that drives it, F_0. Units: N.",
                    Double(0., 1e6));
  prm.add_parameter("Force depth", depth,
                    "Depth of matrix that Force moves, of which its source says nothing: metre, one metre; "
                    "cell, the cell's diameter. Units: none.");
  prm.add_parameter("Persistence", persistence,
                    "Time tau of Eq. 2.10 in which the force forgets its direction. Units: s.",
                    Double(1e-9, 1e12));
  prm.add_parameter("Spread", spread,
                    "Standard deviation of each component of P in Eq. 2.10, P_0 = (1, 0); 0: the direction "
                    "stays. Units: none.",
                    Double(0., 10.));
  prm.leave_subsection();
  prm.enter_subsection("Degradation");
  prm.add_parameter("Rate", rate, "1/tau of Eq. 6.2, at the cell's surface. Units: 1/s.", Double(0., 1e9));
  prm.add_parameter("Decay", decay,
                    "Distance over which the rate falls by e, over the cell's radius (0.25 in Eq. 6.2). "
                    "Units: none.",
                    Double(1e-3, 1e9));
  prm.add_parameter("Cut-off", cutoff,
                    "Distance from the cell's centre beyond which nothing is degraded, over its radius. "
                    "Units: none.",
                    Double(1., 1e9));
  prm.add_parameter("Angle", angle,
                    "Largest angle with the direction of the force at which matrix is degraded; 180: all "
                    "around. Units: degrees.",
                    Double(0., 180.));
  prm.add_parameter("Ring", ring,
                    "Depth of matrix around the cell that is degraded wholly at the start, over its radius. "
                    "Units: none.",
                    Double(0., 1e9));
  prm.leave_subsection();
}

Vector<2> MatrixMigration::extent() const {
  return domain == MatrixDomain::disc ? Vector<2>(width, width) : Vector<2>(length, width);
}

MatrixDegradation MatrixMigration::degradation() const {
  return {.rate = rate,
          .radius = radius,
          .decay = decay * radius,
          .cutoff = cutoff * radius,
          .least_cosine = angle >= 180. ? -1. : std::cos(angle * std::numbers::pi / 180.)};
}

void MatrixMigration::check() const {
  solid.check();
  if (radius < 2. * spacing)
    throw std::invalid_argument("Spacing is " + number_text(spacing) + " m, but has to be at most " +
                                number_text(0.5 * radius) +
                                " m, half of Cell/Radius: coarser particles do not see a round cell.");
  const double room = radius + solid.steps.support * spacing;
  const double narrowest = domain == MatrixDomain::disc
                               ? 0.5 * width
                               : std::min({0.5 * width, start * length, (1. - start) * length});
  if (narrowest < room)
    throw std::invalid_argument(
        "The rim is " + number_text(narrowest) +
        " m from the cell's centre at the start, but has to be at least " + number_text(room) +
        " m away, Cell/Radius and the kernel's radius: change Length, Width or Start.");
  const Vector<2> box = extent();
  if (const double count = box[0] * box[1] / (spacing * spacing); count > 60000.)
    throw std::invalid_argument("Spacing is " + number_text(spacing) + " m: " + number_text(count) +
                                " particles, but at most 60000 are taken.");
}
}  // namespace turgor
