// What is measured of a round cell between two plates, and what is read off the rows afterwards.
//
// Polar angles are those of the turgid cell, degrees: 0 under the upper plate, 90 at the equator, 180 at the
// lower one. The tilt of a bond is its angle to the circle around the axis: 0 around it (hoop), 90 along the
// meridian.
//
//   share of the upper half in the deformation   (1/2 - s (1 - e))/e,  s: upper share of the height, e:
//                                                deformation 1/2: symmetric, 1: the lower half has not
//                                                noticed
//   energy balance     work of the plates = energy of the cell + heat (of viscosity and damping) + given off
//                      by bonds that broke; the error is the largest difference, either way, over the largest
//                      work
//   energy dissipated  (work - energy)/work at the end
#pragma once

#include "micro/cells/round_cell.h"
#include "run/run_context.h"
#include "micro/terms/obstacles.h"

#include <vector>

namespace turgor {
struct SqueezedRow {
  double time = 0., deformation = 0.;                   ///< s, 1
  double force_upper = 0., force_lower = 0.;            ///< N
  double mean_force_upper = 0., mean_force_lower = 0.;  ///< N, over all steps since the row before
  double pressure = 0., volume = 0.;                    ///< Pa, m^3
  double contact_upper = 0., contact_lower = 0.;        ///< m, radius of the contact
  double largest_upper = 1., largest_lower = 1.;  ///< largest stretch of a bond of the upper and lower half
  double mean_upper = 1., mean_lower = 1.;        ///< mean stretch of the halves
  double height_share = 0.5;                      ///< of the upper half in the height
  double largest = 1., largest_angle = 90., largest_tilt = 0.;  ///< largest stretch of all, degrees, degrees
  double kinetic = 0., energy = 0., work = 0.;  ///< J; energy: kinetic and potential, since the start
  double heat = 0., given_off = 0.;             ///< J, of viscosity and damping; by bonds that broke
  double behind_plate = 0.,
         crossed = 0.;  ///< m, the wall node farthest behind a plate; fluid particles outside the wall
  double broken = 0.;
};

/// Cosine of the polar angle of each wall node around the wall's middle; lowest and highest node along the
/// axis (m).
template <int dim>
struct PolarFrame {
  std::vector<double> cosine;
  double low = 0., high = 0.;

  explicit PolarFrame(const RoundCell<dim> &cell);
};

/// Degrees, of the middle of a bond, and its tilt as it is now.
template <int dim>
double polar_angle(const RoundCell<dim> &cell, const std::vector<double> &cosine, std::size_t bond);
template <int dim>
double bond_tilt(const RoundCell<dim> &cell, std::size_t bond);

/// All but time, energy, work, heat, what was given off, and mean forces. height: between the plates at the
/// start, m; plates 0 below and 1 above.
template <int dim>
SqueezedRow measure_squeezed(const RoundCell<dim> &cell, const Obstacles<dim> &plates,
                             const std::vector<double> &cosine, double height);

namespace squeezed {
using Rows = std::vector<SqueezedRow>;

/// A quantity at a deformation, linear between rows; NaN beyond the last.
double at(const Rows &rows, double SqueezedRow::*quantity, double deformation);
/// The mean of both plates' forces over +- window of deformation around each row (a parabola of least squares
/// at its middle, so that the bend of the curve does not enter; one-sided at the ends of the run), as both
/// forces of the rows. Nodes that a plate touches one after the other knock on it; what a slow test measures
/// is the mean.
Rows smoothed(const Rows &rows, double window);
/// Mean slope of the force (mean of both plates) between two deformations, N.
double slope(const Rows &rows, double from, double to);
/// Of the upper half in the deformation, 1.
double upper_share(const Rows &rows, double deformation);
/// Of the force on the lower plate: its largest value; reversals by more than 3 % of that; and the deepest
/// fall below an earlier value, over the largest.
struct Swing {
  double largest = 0., deepest_fall = 0.;
  int reversals = 0;
};
Swing transmitted_swing(const Rows &rows);
/// Signed: positive where work is not found again, negative where energy came from nothing. `scale`: J, at
/// least what it is measured against.
double energy_balance_error(const Rows &rows, double scale = 0.);
double energy_dissipated(const Rows &rows);
/// Results deepest_behind_plate, most_crossed and, where the scene is conservative but for what is counted,
/// energy_balance_error; with a note where one of them is large, and RunFailed where the run means nothing.
/// radius: m; fluid_particles: how many there are; floor: J, an energy below which errors are not measured
/// against the work.
void report_worth(RunContext &context, const Rows &rows, double radius, double fluid_particles,
                  bool conservative, double floor);
/// The largest of a quantity.
double largest(const Rows &rows, double SqueezedRow::*quantity);
}  // namespace squeezed
}  // namespace turgor
