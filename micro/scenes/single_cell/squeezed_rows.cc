#include "micro/scenes/single_cell/squeezed_rows.h"

#include "run/judged.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace turgor {
namespace {
constexpr double degrees = 180. / std::numbers::pi;

template <int dim>
Vector<dim> wall_middle(const RoundCell<dim> &cell) {
  const std::uint32_t nw = cell.group().wall_count();
  Vector<dim> middle = Vector<dim>::Zero();
  for (std::uint32_t i = 0; i < nw; ++i) middle += cell.system.particles.position(i) / nw;
  return middle;
}

template <int dim>
double tilt_around(const RoundCell<dim> &cell, const Vector<dim> &middle, const std::size_t bond) {
  if constexpr (dim == 2)
    return 90.;
  else {
    const auto [a, b] = cell.ends(bond);
    const Vector<3> xa = cell.system.particles.position(a), xb = cell.system.particles.position(b);
    const Vector<3> out = 0.5 * (xa + xb) - middle, e = xb - xa, around(-out[1], out[0], 0.);
    const double size = around.norm() * e.norm();
    return size > 0. ? std::acos(std::min(1., std::abs(e.dot(around)) / size)) * degrees : 90.;
  }
}
}  // namespace

template <int dim>
PolarFrame<dim>::PolarFrame(const RoundCell<dim> &cell) {
  const std::vector<double> &x = cell.system.particles.x[dim - 1];
  const std::uint32_t nw = cell.group().wall_count();
  low = *std::min_element(x.begin(), x.begin() + nw);
  high = *std::max_element(x.begin(), x.begin() + nw);
  const double middle = wall_middle(cell)[dim - 1], radius = cell.mean_radius();
  for (std::uint32_t i = 0; i < nw; ++i) cosine.push_back((x[i] - middle) / radius);
}

template <int dim>
double polar_angle(const RoundCell<dim> &cell, const std::vector<double> &cosine, const std::size_t bond) {
  const auto [a, b] = cell.ends(bond);
  return std::acos(std::clamp(0.5 * (cosine[a] + cosine[b]), -1., 1.)) * degrees;
}

template <int dim>
double bond_tilt(const RoundCell<dim> &cell, const std::size_t bond) {
  return tilt_around<dim>(cell, wall_middle(cell), bond);
}

template <int dim>
SqueezedRow measure_squeezed(const RoundCell<dim> &cell, const Obstacles<dim> &plates,
                             const std::vector<double> &cosine, const double height) {
  constexpr int axis = dim - 1;
  const Particles<dim> &particles = cell.system.particles;
  const std::uint32_t nw = cell.group().wall_count();
  SqueezedRow row;
  const double low = plates[0].centre[axis], high = plates[1].centre[axis];
  row.deformation = 1. - (high - low) / height;
  row.force_lower = plates[0].pressing();
  row.force_upper = plates[1].pressing();
  row.pressure = cell.pressure();
  row.volume = cell.volume();
  row.kinetic = cell.system.kinetic_energy();
  row.behind_plate = plates.deepest();
  row.crossed = cell.fluid ? double(cell.fluid->crossed()) : 0.;
  row.broken = cell.damage ? cell.damage->cells[0].broken : 0.;
  const Vector<dim> middle = wall_middle(cell);
  double equator = 0., equator_count = 0.;
  for (std::uint32_t i = 0; i < nw; ++i) {
    Vector<dim> across = particles.position(i) - middle;
    across[axis] = 0.;
    if (particles.x[axis][i] >= high) row.contact_upper = std::max(row.contact_upper, across.norm());
    if (particles.x[axis][i] <= low) row.contact_lower = std::max(row.contact_lower, across.norm());
    if (std::abs(cosine[i]) < 0.1) {
      equator += particles.x[axis][i];
      equator_count += 1.;
    }
  }
  if (equator_count > 0.) row.height_share = (high - equator / equator_count) / (high - low);
  double count[2]{}, sum[2]{}, most[2]{1., 1.};
  std::size_t longest = cell.bonds();
  for (std::size_t k = 0; k < cell.bonds(); ++k) {
    if (cell.damage && cell.damage->cells[0].bond_broken[k]) continue;
    const auto [a, b] = cell.ends(k);
    const double stretch = cell.wall->stretch(particles, 0, k);
    if (stretch > row.largest || longest == cell.bonds()) {
      row.largest = stretch;
      longest = k;
    }
    if (cosine[a] * cosine[b] <= 0.) continue;
    const int half = cosine[a] > 0. ? 0 : 1;
    count[half] += 1.;
    sum[half] += stretch;
    most[half] = std::max(most[half], stretch);
  }
  if (longest < cell.bonds()) {
    row.largest_angle = polar_angle(cell, cosine, longest);
    row.largest_tilt = tilt_around<dim>(cell, middle, longest);
  }
  row.largest_upper = most[0];
  row.largest_lower = most[1];
  row.mean_upper = count[0] > 0. ? sum[0] / count[0] : 1.;
  row.mean_lower = count[1] > 0. ? sum[1] / count[1] : 1.;
  return row;
}

namespace squeezed {
double at(const Rows &rows, double SqueezedRow::*quantity, const double where) {
  for (std::size_t k = 1; k < rows.size(); ++k)
    if (rows[k].deformation >= where) {
      const SqueezedRow &a = rows[k - 1], &b = rows[k];
      return a.*quantity +
             (where - a.deformation) / (b.deformation - a.deformation) * (b.*quantity - a.*quantity);
    }
  return std::numeric_limits<double>::quiet_NaN();
}

Rows smoothed(const Rows &rows, const double window) {
  Rows mean = rows;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    // a + b u + c u^2 through the rows of the window, u: deformation from here, in windows; what is wanted is
    // a
    double moments[5]{}, sums[3]{};
    for (std::size_t j = 1; j < rows.size(); ++j)  // the first row has no interval before it
    {
      // a mean over an interval belongs to its middle
      const double u = (0.5 * (rows[j].deformation + rows[j - 1].deformation) - rows[k].deformation) / window;
      if (std::abs(u) > 1.) continue;
      const double force = 0.5 * (rows[j].mean_force_upper + rows[j].mean_force_lower);
      for (int m = 0; m < 5; ++m) moments[m] += std::pow(u, m);
      for (int m = 0; m < 3; ++m) sums[m] += std::pow(u, m) * force;
    }
    double a = 0.5 * (rows[k].force_upper + rows[k].force_lower);
    const double *m = moments;
    const double c0 = m[2] * m[4] - m[3] * m[3], c1 = m[2] * m[3] - m[1] * m[4],
                 c2 = m[1] * m[3] - m[2] * m[2];
    const double determinant = m[0] * c0 + m[1] * c1 + m[2] * c2;
    if (m[0] > 4. && determinant > 1e-9 * m[0] * m[0] * m[0])
      a = (c0 * sums[0] + c1 * sums[1] + c2 * sums[2]) / determinant;
    mean[k].force_upper = mean[k].force_lower = a;
  }
  return mean;
}

double slope(const Rows &rows, const double from, const double to) {
  return (at(rows, &SqueezedRow::force_lower, to) + at(rows, &SqueezedRow::force_upper, to) -
          at(rows, &SqueezedRow::force_lower, from) - at(rows, &SqueezedRow::force_upper, from)) /
         (2. * (to - from));
}

double upper_share(const Rows &rows, const double deformation) {
  return (0.5 - at(rows, &SqueezedRow::height_share, deformation) * (1. - deformation)) / deformation;
}

Swing transmitted_swing(const Rows &rows) {
  Swing swing;
  for (const SqueezedRow &row : rows) swing.largest = std::max(swing.largest, row.force_lower);
  if (!(swing.largest > 0.)) return swing;
  double extreme = rows.front().force_lower, highest = extreme;
  int direction = 1;
  for (const SqueezedRow &row : rows) {
    highest = std::max(highest, row.force_lower);
    swing.deepest_fall = std::max(swing.deepest_fall, (highest - row.force_lower) / swing.largest);
    if (direction * (row.force_lower - extreme) > 0.)
      extreme = row.force_lower;
    else if (std::abs(row.force_lower - extreme) > 0.03 * swing.largest) {
      ++swing.reversals;
      direction = -direction;
      extreme = row.force_lower;
    }
  }
  return swing;
}

double energy_balance_error(const Rows &rows, double scale) {
  double error = 0.;
  for (const SqueezedRow &row : rows) {
    const double missing = row.work - row.energy - row.heat - row.given_off;
    if (!(std::abs(missing) <= std::abs(error))) error = missing;
    scale = std::max(scale, std::abs(row.work));
  }
  return scale > 0. ? error / scale : 0.;
}

double largest(const Rows &rows, double SqueezedRow::*quantity) {
  double most = rows.front().*quantity;
  for (const SqueezedRow &row : rows) most = std::max(most, row.*quantity);
  return most;
}

void report_worth(RunContext &context, const Rows &rows, const double radius, const double fluid_particles,
                  const bool conservative, const double floor) {
  const double behind = largest(rows, &SqueezedRow::behind_plate),
               crossed = largest(rows, &SqueezedRow::crossed), error = energy_balance_error(rows, floor);
  context.result("deepest_behind_plate", behind, "m");
  if (fluid_particles > 0.) context.result("most_crossed", crossed, "");
  if (conservative) context.result("energy_balance_error", error, "1");
  judged(
      context, "deepest_behind_plate", behind / radius, {0.05, 0.5},
      "wall nodes stand up to " + number_text(100. * behind / radius) +
          " % of the cell's radius behind a plate (a larger Plate stiffness or a smaller Speed holds them)");
  judge_outside(context, crossed, fluid_particles, "a smaller Deformation leaves fewer");
  if (conservative)
    judged(context, "energy_balance_error", error, {0.02, 0.1},
           number_text(100. * std::abs(error)) + " % of the plates' work " +
               (error > 0. ? "is not found again" : "came from nothing") +
               " (a smaller Step fraction or Speed mends it)");
}

double energy_dissipated(const Rows &rows) {
  const SqueezedRow &last = rows.back();
  return last.work != 0. ? (last.work - last.energy) / last.work : 0.;
}
}  // namespace squeezed

template struct PolarFrame<2>;
template struct PolarFrame<3>;
template double polar_angle<2>(const RoundCell<2> &, const std::vector<double> &, std::size_t);
template double polar_angle<3>(const RoundCell<3> &, const std::vector<double> &, std::size_t);
template double bond_tilt<2>(const RoundCell<2> &, std::size_t);
template double bond_tilt<3>(const RoundCell<3> &, std::size_t);
template SqueezedRow measure_squeezed<2>(const RoundCell<2> &, const Obstacles<2> &,
                                         const std::vector<double> &, double);
template SqueezedRow measure_squeezed<3>(const RoundCell<3> &, const Obstacles<3> &,
                                         const std::vector<double> &, double);
}  // namespace turgor
