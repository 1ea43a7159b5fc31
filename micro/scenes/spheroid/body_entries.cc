#include "micro/scenes/spheroid/body_entries.h"

#include "micro/geometry/surface_file.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/user_text.h"
#include "run/word_or_file.h"

#include <algorithm>

namespace turgor {
namespace {
Vector<3> vector_of(const std::string &text, const std::string &entry) {
  const std::vector<double> values = read_numbers(text, 3, entry, "x, y, z");
  return {values[0], values[1], values[2]};
}

/// What the cells do to the body, summed over the cells' own side of every contact.
struct Touching {
  double count = 0., pressing = 0.;        ///< N
  Vector<3> on_cells = Vector<3>::Zero();  ///< N
};

Touching touching(const Obstacles<3> &walls, const Particles<3> &particles) {
  Touching sum;
  walls.for_touches(particles, [&](const Obstacles<3>::Touch &t) {
    sum.count += 1.;
    sum.pressing += t.does.force;
    sum.on_cells += t.force;
  });
  return sum;
}

/// Three digits that keep to a bound: none is refused again for the digits left out.
std::string rounded_up(const double x) { return number_text(x * 1.01, 3); }
std::string rounded_down(const double x) { return number_text(x * 0.99, 3); }

}  // namespace

void BodyEntries::declare(InputEntries &prm) {
  using namespace Patterns;
  prm.enter_subsection("Body");
  prm.add_parameter("File", file,
                    "A rigid body that the cells grow around: file with its closed surface of "
                    "triangles (.stl, .off or .obj, counter-clockwise seen from outside); none: no body, and "
                    "the other entries here are without effect. Units: "
                    "none.",
                    WordOrFile("none"));
  prm.add_parameter("Unit", unit, "Length of one unit of the file. Units: m.", Double(1e-12, 1e3));
  prm.add_parameter(
      "Position", position,
      "Place of the mean of the body's nodes at the start; the first cells are about the origin: x, "
      "y, z. Units: m.",
      List(Double(-1e3, 1e3), 3, 3, ","));
  prm.add_parameter(
      "Motion", motion,
      "fixed: it stays where it is; drag: load and cells move it against a drag of its own, without "
      "inertia. Units: none.");
  prm.add_parameter("Load", load, "Force on the body with Motion = drag, as its weight: x, y, z. Units: N.",
                    List(Double(-1e6, 1e6), 3, 3, ","));
  prm.add_parameter("Drag", drag,
                    "Force over velocity of the body alone in the medium, with Motion = drag (Stokes: 6 pi "
                    "viscosity times radius). Units: N s/m.",
                    Double(1e-15, 1e15));
  prm.add_parameter(
      "Turning drag", turning_drag,
      "Torque over angular velocity of the body alone in the medium, with Motion = drag (Stokes: 8 "
      "pi viscosity times radius cubed); 0: it does not turn. Units: N m s.",
      Double(0., 1e15));
  prm.add_parameter("Modulus", modulus,
                    "Young's modulus of the body where cells press on it: by Hertz, and without adhesion "
                    "whatever holds the cells together. Units: Pa.",
                    Double(1e-3, 1e15));
  prm.add_parameter("Poisson ratio", poisson,
                    "Poisson ratio of the body where cells press on it. Units: none.", Double(0., 0.5));
  prm.add_parameter(
      "Friction", friction,
      "Friction of cells with the body: force over velocity and area of contact. Units: N s/m^3.",
      Double(0., 1e20));
  prm.leave_subsection();
}

std::unique_ptr<TriangulatedBody> BodyEntries::make() const {
  SurfaceOfTriangles surface = read_surface(file, unit);
  auto body =
      std::make_unique<TriangulatedBody>(std::move(surface.mesh), surface.nodes, ParticlesAre::outside);
  body->centre = vector_of(position, "Body/Position");
  if (motion == BodyMotion::drag) {
    body->drag = drag;
    body->turning_drag = turning_drag;
    body->load = vector_of(load, "Body/Load");
  }
  return body;
}

void BodyEntries::check(const FirstCells &cells) const {
  if (!is_there()) return;
  const std::unique_ptr<TriangulatedBody> body = make();
  Vector<3> low = body->node(0), high = low;
  for (std::size_t k = 1; k < body->mesh().nodes; ++k) {
    low = low.cwiseMin(body->node(k));
    high = high.cwiseMax(body->node(k));
  }
  if (const double extent = (high - low).maxCoeff(); extent < 0.1 * cells.radius)
    throw InputError("Body/Unit is " + number_text(unit) + " m, which makes the body of Body/File " +
                     number_text(extent) + " m long, less than a tenth of a cell's radius of " +
                     number_text(cells.radius) +
                     " m: a cell would hardly meet it. Give the length of one unit of the file in m, so that "
                     "the body is at least " +
                     number_text(0.1 * cells.radius) + " m long.");
  std::size_t inside = 0;
  double least = HUGE_VAL;
  for (const Vector<3> &x : cells.centres) {
    const double distance = body->at(x).distance;
    inside += distance < 0.8 * cells.radius;
    least = std::min(least, distance);
  }
  if (inside > 0)
    throw InputError(
        "Body/Position is " + position + ", but " + number_text(inside) + " of the " +
        number_text(cells.centres.size()) +
        " first cells, which lie about the origin, would be in the body or deep in its surface (the "
        "nearest centre at " +
        number_text(least) + " m, allowed are " + number_text(0.8 * cells.radius) +
        " m and more): lay it farther away, or check Body/Unit.");
  if (motion == BodyMotion::drag) check_drag(cells, *body);
}

void BodyEntries::check_drag(const FirstCells &cells, const TriangulatedBody &body) const {
  const double weight = body.load.norm();
  constexpr double farthest = 1e4;  // radii of a cell
  const double way = weight / drag * cells.duration, allowed = farthest * cells.radius;
  if (way > allowed)
    throw InputError(
        "Body/Load over Body/Drag moves the body by " + number_text(way, 3) + " m until End time, " +
        number_text(way / cells.radius, 3) + " radii of a cell: at most " + number_text(farthest) +
        " are allowed. Use a Body/Load of at most " + rounded_down(allowed * drag / cells.duration) +
        " N, a Body/Drag of at least " + rounded_up(weight * cells.duration / allowed) +
        " N s/m, or an End time of at most " + rounded_down(allowed * drag / weight) + " s.");
  // It turns to where no moment acts in so much less time than it travels: steps follow that.
  if (const double least = 1e-5 * drag * body.extent() * body.extent();
      turning_drag > 0. && turning_drag < least)
    throw InputError(
        "Body/Turning drag is " + number_text(turning_drag) +
        " N m s: a body that turns so much more easily than it travels needs more steps than any "
        "run has. Use at least " +
        rounded_up(least) +
        " N m s (1e-5 of Body/Drag times its size squared), or 0: it does "
        "not turn.");
}

Surroundings BodyEntries::surroundings(const std::optional<LocalStiffness> &stiffness) const {
  WallMaterial material{.modulus = modulus / (1. - poisson * poisson), .friction = friction};
  material.stiffness = stiffness;
  std::unique_ptr<TriangulatedBody> made = make();
  const TriangulatedBody &body = *made;
  Surroundings around;
  const Obstacles<3> &walls =
      *(around.walls =
            &around.add(std::make_unique<Obstacles<3>>("body", SphereOnSurface{material}, std::move(made))));
  around.values = [&body, &walls](const Particles<3> &particles) {
    const Touching now = touching(walls, particles);
    const double imbalance = (body.force() + now.on_cells).norm();
    return std::vector<Surroundings::Value>{
        {"body_x", "m", body.centre[0]},
        {"body_y", "m", body.centre[1]},
        {"body_z", "m", body.centre[2]},
        {"body_speed", "m/s", body.velocity.norm()},
        {"force_on_body", "N", body.force().norm()},
        {"body_pressing", "N", now.pressing},
        {"body_imbalance", "1", now.pressing > 0. ? imbalance / now.pressing : 0.},
        {"cells_on_body", "", now.count}};
  };
  if (motion != BodyMotion::drag) return around;
  if (body.load.norm() > 0.) around.drivers = "Body/Load";
  return around;
}

FieldFrame BodyEntries::frame(const Obstacles<3> &walls, const double time) {
  const auto &body = dynamic_cast<const TriangulatedBody &>(walls[0]);
  FieldFrame now;
  now.time = time;
  now.nodes_per_cell = 3;
  NamedField velocity{"velocity [m/s]", 3, {}, false};
  for (const auto &triangle : body.mesh().faces)
    for (const auto node : triangle) now.cells.push_back(node);
  for (std::size_t k = 0; k < body.mesh().nodes; ++k) {
    const Vector<3> x = body.node(k), v = body.velocity + body.spin.cross(x - body.centre);
    for (int d = 0; d < 3; ++d) {
      now.points.push_back(x[d]);
      velocity.values.push_back(v[d]);
    }
  }
  now.fields = {std::move(velocity)};
  return now;
}

Outputs BodyEntries::outputs() {
  Outputs all;
  const char *there = "with a Body/File";
  all.results(
         {{"body_travel", "m", "Distance between the body's centres at the start and at the end.", there},
          {"body_pressing", "N", "Sum of the sizes of all forces between cells and body at the end.", there},
          {"largest_body_imbalance", "1",
           "Largest body_imbalance of any row of growth.csv: action and reaction are the same.", there}})
      .table("growth", "",
             {{"body_x", "m", "Place of the body's centre along x.", there},
              {"body_y", "m", "Place of the body's centre along y.", there},
              {"body_z", "m", "Place of the body's centre along z.", there},
              {"body_speed", "m/s", "Speed of the body's centre in the last step.", there},
              {"force_on_body", "N", "Size of the force that the cells put on the body.", there},
              {"body_pressing", "N", "Sum of the sizes of all forces between cells and body.", there},
              {"body_imbalance", "1",
               "Force on the body plus the forces on the cells, each summed by itself, over body_pressing: 0 "
               "but "
               "for round-off.",
               there},
              {"cells_on_body", "", "Number of cells that touch the body.", there}})
      .fields(
          "body", "The surface of the body as triangles.",
          {{"velocity", "m/s", "Velocity of the body's surface there.", "with a Body/File and Frames > 0"}});
  return all;
}
}  // namespace turgor
