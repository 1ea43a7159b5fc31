#include "micro/scenes/deformable/doublet.h"

#include "micro/laws/random_turn.h"
#include "run/input_entries.h"
#include "run/judged.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
namespace {
constexpr double degrees = 180. / std::numbers::pi;

std::vector<OutputDefinition> state_columns() {
  return {
      {"contact_radius", "m",
       "Radius of a disc with the area of contact, where what is at the gap at rest counts whole and what "
       "is at the end of the contact's range not at all."},
      {"contact_angle", "degrees",
       "Angle between the plane of contact and the free surfaces, of spheres laid through the outer "
       "halves of both cells by least squares, where they are the gap at rest from each other."},
      {"pressure", "Pa", "Pressure inside the cells over that outside, mean of both."}};
}

struct Ball {
  Vector<3> centre;
  double radius;
};

/// Through the nodes of a cell that lie farther in the direction `out` than the mean of all.
Ball ball_through(const Particles<3> &p, const Group &group, const Vector<3> &out) {
  Vector<3> middle = Vector<3>::Zero();
  for (std::uint32_t i = group.begin; i < group.end; ++i)
    middle += p.position(i) / double(group.wall_count());
  Eigen::Matrix4d square = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (std::uint32_t i = group.begin; i < group.end; ++i) {
    const Vector<3> x = (p.position(i) - middle) * 1e6;
    if (!(x.dot(out) > 0.)) continue;
    const Eigen::Vector4d row(2. * x[0], 2. * x[1], 2. * x[2], 1.);
    square += row * row.transpose();
    right += x.squaredNorm() * row;
  }
  const Eigen::Vector4d found = square.ldlt().solve(right);
  const Vector<3> centre = found.head<3>();
  return {middle + 1e-6 * centre, 1e-6 * std::sqrt(found[3] + centre.squaredNorm())};
}

double angle_of(const Particles<3> &p, const double gap) {
  Vector<3> away = Vector<3>::Zero();
  for (std::size_t cell = 0; cell < 2; ++cell)
    for (std::uint32_t i = p.groups[cell].begin; i < p.groups[cell].end; ++i)
      away += (cell == 0 ? -1. : 1.) * p.position(i);
  away.normalize();
  const Ball first = ball_through(p, p.groups[0], -away), second = ball_through(p, p.groups[1], away);
  const double apart = (second.centre - first.centre).norm() - gap;
  return degrees * std::acos(std::clamp(apart / (first.radius + second.radius), -1., 1.));
}
}  // namespace

void Doublet::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("End time", end, "Time that the cells have to come to rest. Units: s.",
                    Double(1e-6, 1e12));
  prm.add_parameter("First step", first_step,
                    "Length of the first step, and time of the first row of history.csv behind the start; "
                    "rows are spread over the logarithm of time. Units: s.",
                    Double(1e-9, 1e3));
  prm.add_parameter("Seed", seed, "Number of the nets' random orientations. Units: none.",
                    Integer(0, 100000));
  declare_cells(prm, material, output, true);
}

void Doublet::check() const {
  material.check_contact();
  if (!(material.adhesion > 0.))
    throw InputError(
        "Contact/Adhesion is 0: nothing holds the two cells together. Use a positive energy "
        "(J/m^2).");
  if (material.tension > 0. && !(material.adhesion < 1.8 * material.tension))
    throw InputError("Contact/Adhesion (" + number_text(material.adhesion) +
                     " J/m^2) is more than 1.8 times Cell/Cortex tension (" + number_text(material.tension) +
                     " N/m): at twice the tension cells spread on each other without end.");
  if (!(first_step < end))
    throw InputError("First step (" + number_text(first_step) + " s) has to be shorter than End time (" +
                     number_text(end) + " s).");
}

Outputs Doublet::outputs() const {
  const char *tense = "with a Cell/Cortex tension above 0";
  Outputs all = outputs_of_cells(
      "One row at the start, then spread evenly over the logarithm of time, and one at the end.",
      state_columns());
  all.results(state_columns());
  all.results(
      {{"young_dupre_angle", "degrees", "The angle theta of cos theta = 1 - W/(2 tau).", tense},
       {"angle_deviation", "degrees", "contact_angle at the end less young_dupre_angle.", tense},
       {"stress_in_contact", "N/m",
        "In-plane stress of the net of edges, without active tension, mean over the nodes in contact: "
        "negative "
        "where it is compressed."},
       {"stress_outside", "N/m", "The same, mean over all other nodes."},
       {"rest", "1",
        "Largest force on a node at the end over the adhesion that an edge bears, W times a mean edge."}});
  return all;
}

void Doublet::run(RunContext &context) {
  const double half = material.radius + 0.5 * material.rest;
  std::vector<DeformableShape> shapes;
  for (const double side : {-1., 1.})
    shapes.push_back(placed(sphere_shape(material.nu, material.radius), random_turn(seed, shapes.size()),
                            Vector<3>(side * half, 0., 0.)));
  DeformableCells cells(material, shapes, context.threads());
  cells.begin(first_step);
  const Particles<3> &p = cells.system.particles;
  const auto state = [&] {
    return std::vector<double>{std::sqrt(cells.contact_area() / std::numbers::pi), angle_of(p, material.rest),
                               0.5 * (cells.inside->pressure(p, 0) + cells.inside->pressure(p, 1))};
  };
  const std::vector<OutputDefinition> columns = state_columns();
  CellsRun run(context, cells,
               {.stops = {end},
                .output = output,
                .first_sample = first_step,
                .columns = columns,
                .row = state,
                .doing = "adhering",
                .advice = "A larger Tolerance or Longest step lengthens them.",
                .reach = 1e3 * material.radius});
  run.go();
  const std::vector<double> at_end = run.state_as_results();
  if (material.tension > 0.) {
    const double angle = degrees * std::acos(1. - 0.5 * material.adhesion / material.tension);
    context.result("young_dupre_angle", angle, "degrees");
    context.result("angle_deviation", at_end[1] - angle, "degrees");
  }
  std::vector<bool> touches(p.size(), false);
  for (std::size_t cell = 0; cell < 2; ++cell)
    for (const SurfaceContacts::Touch &t : cells.touching->touches(cell))
      if (const auto of = cells.touching->where().nodes_of(cell, t.point); of.count == 1)
        touches[of.node[0]] = touches[of.node[0]] || material.law().closeness(t.gap) > 0.5;
  const std::vector<double> stress = in_plane_stress(*cells.surfaces, *cells.edges, p);
  double sum[2] = {}, count[2] = {};
  for (std::size_t i = 0; i < p.size(); ++i) {
    sum[touches[i]] += stress[i];
    ++count[touches[i]];
  }
  context.result("stress_in_contact", sum[1] / std::max(count[1], 1.), "N/m");
  context.result("stress_outside", sum[0] / std::max(count[0], 1.), "N/m");
  report_rest(context, rest_of(cells, material), "the cells are not at rest", "End time");
  report_cells(context, cells, material, run.steps());
}

std::unique_ptr<Scenario> make_doublet() { return std::make_unique<Doublet>(); }
}  // namespace turgor
