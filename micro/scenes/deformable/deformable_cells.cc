#include "micro/scenes/deformable/deformable_cells.h"

#include "micro/geometry/triangle_hinge.h"
#include "run/archive.h"
#include "run/number_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace turgor {
namespace {
/// Cells. Of 13 it saves few iterations, of 100 just what it costs, of 200 up to a fifth of the time.
constexpr std::size_t second_level_from = 128;
}  // namespace

DeformableShape placed(DeformableShape shape, const Tensor2<3> &turn, const Vector<3> &centre) {
  for (Vector<3> &node : shape.nodes) node = centre + turn * node;
  return shape;
}

DeformableCells::DeformableCells(const TouchingMaterial &material_,
                                 const std::vector<DeformableShape> &shapes, const unsigned int threads,
                                 const bool grows)
    : SteppedCells(material_.steps(), threads), material(material_) {
  for (const DeformableShape &shape : shapes) surfaces->add(system.particles, shape.mesh, shape.nodes);
  motion.correct_clusters = true;
  motion.second_level_from = second_level_from;
  add_terms(shapes.size() > 1 || grows);
  for (const Group &group : system.particles.groups)
    motion.medium.insert(
        motion.medium.end(), group.wall_count(),
        6. * std::numbers::pi * material.viscosity * material.radius / double(group.wall_count()));
}

DeformableCells::DeformableCells(const DeformableCells &others, const std::vector<std::uint32_t> &some,
                                 const std::size_t moving)
    : SteppedCells(others.material.steps(), 1), material(others.material) {
  constexpr double held = 1e9;  // N s/m, of a node: a nanonewton moves it by a femtometre in 1000 s
  all_surfaces = std::make_shared<CellSurfaces>();
  Particles<3> of_moving;
  const Particles<3> &p = others.system.particles;
  for (std::size_t k = 0; k < some.size(); ++k) {
    const Group &group = p.groups[some[k]];
    std::vector<Vector<3>> nodes;
    for (std::uint32_t i = group.begin; i < group.end; ++i) {
      nodes.push_back(p.position(i));
      motion.medium.push_back(k < moving ? others.motion.medium[i] : held);
    }
    all_surfaces->add(system.particles, *others.surfaces, some[k], nodes);
    if (k < moving) surfaces->add(of_moving, *others.surfaces, some[k], nodes);
  }
  motion.correct_clusters = some.size() == moving;
  add_terms(some.size() > 1);
  if (touching != nullptr) touching->hold_from(moving);
}

void DeformableCells::add_terms(const bool several) {
  edges = &system.add(std::make_unique<CortexEdges<LinearSpring>>(surfaces, LinearSpring{material.spring()},
                                                                  material.dashpots));
  system.add(std::make_unique<CortexHinges>(surfaces, material.hinge()));
  if (material.area_modulus > 0. || material.tension > 0.)
    areas = &system.add(std::make_unique<CortexArea>(
        surfaces, AreaStiffness{.local = material.area_modulus, .tension = material.tension}));
  inside = &system.add(std::make_unique<Cytoplasm>(surfaces, material.bulk_modulus));
  if (several)
    touching = &system.add(std::make_unique<SurfaceContacts>(all_surfaces, material.law(), material.friction,
                                                             material.blend, 0.4e-6));
}

CentreSpring &DeformableCells::add_spring(const Vector<3> &along, const double stiffness) {
  spring = &system.add(std::make_unique<CentreSpring>(along, stiffness));
  return *spring;
}

void DeformableCells::begin_anew(const double first_step) {
  SteppedCells::begin_anew(first_step);
  motion.forces_are_known(false);  // what drives the cells may be another
  power = power_of_walls();
}

namespace {
/// rad, largest angle between the normals of two triangles that share an edge.
double sharpest_fold(const CellSurfaces &surfaces, const Particles<3> &p) {
  double least = 1.;
  for (const auto &[a, b, c, d] : surfaces.edges) {
    const HingeSlope hinge(p.position(a), p.position(b), p.position(c), p.position(d));
    least = std::min(least, hinge.cosine() / std::sqrt(hinge.n1_squared * hinge.n2_squared));
  }
  return std::acos(std::clamp(least, -1., 1.));
}
}  // namespace

// Active tension and adhesion are the same in all directions of a triangle's plane: but for springs and
// dashpots nothing keeps nodes from sliding within the surface until a triangle has no width, where its
// gradients, and with them the matrix, are no numbers to work with.
double DeformableCells::move_or_tell(const double limit) {
  try {
    return move(limit);
  } catch (const std::runtime_error &error) {
    constexpr double degrees = 180. / std::numbers::pi;
    const double least = degrees * least_angle(), fold = degrees * sharpest_fold(*surfaces, system.particles);
    const std::string what = std::string(" (") + error.what() + ")";
    if (least < 3.)
      throw std::runtime_error(
          "a triangle of a cell's net has collapsed (its smallest angle is " + number_text(least, 3) +
          " degrees): tension and adhesion have drawn its nodes along the surface until velocities cannot be "
          "found any more. A larger Cell/Cortex friction lets nodes slide less, and the cells come to rest "
          "later; a larger Cell/Cortex modulus or Area modulus holds them, but shares in the tension." +
          what);
    if (material.adhesion > 0. && fold > 120.)
      throw std::runtime_error(
          "an edge of a cell's net has folded by " + number_text(fold, 3) +
          " degrees: adhesion bends the cortex more sharply than its net can follow (an edge is " +
          number_text(material.mesh_ratio(), 3) +
          " times the length sqrt(D/W) in which it would bend, and no fold of an edge costs more than twice "
          "its "
          "bending stiffness). Use less Contact/Adhesion." +
          what);
    throw;
  }
}

// Cells give way to walls in the same step as walls move, so that both are where they belong at its end, and
// the work, of pressure and of friction, is that between two ends. The spring's end moves with the cells at
// rest, from a pull to a larger one.
double DeformableCells::step(const double limit) {
  const double h = move_or_tell(limit);
  const bool walls_move = walls != nullptr && walls->moves(),
             draws = spring != nullptr && spring->speed != 0.;
  if (!walls_move && !draws) return h;
  if (draws) done += 0.5 * h * spring->power();
  system.advance(h);
  system.compute_forces();
  motion.forces_are_known();
  if (draws) done += 0.5 * h * spring->power();
  done += 0.5 * h * power;
  power = power_of_walls();
  done += 0.5 * h * power;
  return h;
}

double DeformableCells::slope_of_growth(const std::size_t cell) const {
  const Particles<3> &p = system.particles;
  return edges->slope_of_growth(p, cell) + inside->slope_of_growth(p, cell) +
         (areas != nullptr ? areas->slope_of_growth(p, cell) : 0.);
}

double DeformableCells::volume() const {
  double total = 0.;
  for (std::size_t cell = 0; cell < surfaces->size(); ++cell)
    total += surfaces->volume(system.particles, cell);
  return total;
}

double DeformableCells::contact_area() const {
  double total = 0.;
  for (std::size_t cell = 0; cell < surfaces->size(); ++cell) {
    if (walls != nullptr)
      for (const SurfaceObstacles::Touch &t : walls->touches(cell))
        total += walls->where().area[t.point] * walls->law_of_contact().closeness(t.contact.distance);
    if (touching != nullptr)
      for (const SurfaceContacts::Touch &t : touching->touches(cell))
        total += t.weight * material.law().closeness(t.gap);
  }
  return total;
}

double DeformableCells::least_angle() const {
  double largest_cosine = -1.;
  for (const CellSurfaces::Triangle &triangle : surfaces->triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector<3> at_corner = system.particles.position(triangle[k]),
                      u = system.particles.position(triangle[(k + 1) % 3]) - at_corner,
                      v = system.particles.position(triangle[(k + 2) % 3]) - at_corner;
      largest_cosine = std::max(largest_cosine, u.dot(v) / std::sqrt(u.squaredNorm() * v.squaredNorm()));
    }
  return std::acos(std::min(1., largest_cosine));
}

FieldFrame DeformableCells::frame() const {
  const Particles<3> &p = system.particles;
  FieldFrame frame;
  frame.time = time();
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int d = 0; d < 3; ++d) frame.points.push_back(p.x[d][i]);
  frame.nodes_per_cell = 3;
  for (const CellSurfaces::Triangle &triangle : surfaces->triangles)
    frame.cells.insert(frame.cells.end(), triangle.begin(), triangle.end());
  std::vector<double> pressure(p.size()), contact(p.size(), 0.), number(p.size()), area(p.size(), 0.);
  for (std::size_t cell = 0; cell < surfaces->size(); ++cell) {
    const Group &group = p.groups[cell];
    for (std::uint32_t i = group.begin; i < group.end; ++i) {
      pressure[i] = inside->pressure(p, cell);
      number[i] = double(cell);
    }
    // N, of points, shared by their nodes as their areas are
    const auto share = [&](const SurfacePoints &points, const std::uint32_t point, const double force) {
      const SurfacePoints::Nodes of = points.nodes_of(cell, point);
      for (const std::uint32_t node : of.all()) contact[node] += of.share * force;
    };
    if (walls != nullptr)
      for (const SurfaceObstacles::Touch &t : walls->touches(cell))
        share(walls->where(), t.point, -walls->where().area[t.point] * t.does.slope);
    if (touching != nullptr)
      for (const SurfaceContacts::Touch &t : touching->touches(cell))
        share(touching->where(), t.point, -2. * t.pull);
    const auto [begin, end] = surfaces->triangles_of(cell);
    for (std::uint32_t k = begin; k < end; ++k) {
      const auto &[i, j, l] = surfaces->triangles[k];
      const double a = 0.5 * twice_area(p.position(i), p.position(j), p.position(l)).norm();
      for (const std::uint32_t node : surfaces->triangles[k]) area[node] += a / 3.;
    }
  }
  for (std::size_t i = 0; i < p.size(); ++i) contact[i] /= area[i];
  frame.fields = {{"in_plane_stress [N/m]", 1, in_plane_stress(*surfaces, *edges, p), false},
                  {"contact_pressure [Pa]", 1, contact, false},
                  {"pressure [Pa]", 1, pressure, false},
                  {"cell", 1, number, false}};
  return frame;
}

void DeformableCells::archive(Archive &a) {
  a.section("deformable_cells");
  archive_steps(a);
  a(done, power, *surfaces);
  if (a.loading()) system.compute_forces();  // which energies are kept with
}
}  // namespace turgor
