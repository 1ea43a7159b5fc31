#include "micro/terms/bulk_fluid_frame.h"

#include "micro/terms/sph_scratch.h"
#include "run/archive.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
void eos_pressure(const void *data, const std::uint32_t n, const double *rho, double *p) {
  const EquationOfState eos = *static_cast<const EquationOfState *>(data);
  for (std::uint32_t i = 0; i < n; ++i) p[i] = eos.pressure(rho[i]);
}

const TriangleMesh no_mesh{};
}  // namespace

template <int dim>
BulkFluid<dim>::BulkFluid(const BulkFluidParameters &parameters_, const EquationOfState &eos_,
                          const double mass_, std::vector<BulkWall> walls_)
    : parameters(parameters_), eos(eos_), mass(mass_), walls(std::move(walls_)) {
  if (dim == 3) {
    parameters.depth = 1.;
    if (!walls.empty()) throw std::logic_error("a bulk fluid has walls in 2D only");
  }
}

template <int dim>
void BulkFluid<dim>::declare(Particles<dim> &particles) {
  if (particles.groups.size() != 1 || particles.groups[0].wall_count() > 0)
    throw std::invalid_argument("a bulk fluid is one group of fluid particles");
  for (const char *field : {"density", "pressure", "wall_share"}) particles.declare(field);
  if (is_solid()) declare_stress(particles);
}

template <int dim>
void BulkFluid<dim>::prepare(const Particles<dim> &particles, const Box<dim> &box,
                             const unsigned int threads_, bool) {
  threads = threads_;
  drag_built = false;
  const Group &g = particles.groups[0];
  lay_bodies(false);
  if (origin.stale(particles, g, parameters.skin) || bodies_left_lists()) {
    origin.take(particles.x, g);
    for (std::size_t k = 0; k < bodies.size(); ++k) body_of[k].listed = bodies[k]->place();
    built = false;
    ++builds;
  }
  if (!built) build(box);
  follow(particles);
}

template <int dim>
typename BulkFluid<dim>::Frame BulkFluid<dim>::look() {
  const std::uint32_t n = std::uint32_t(shift.size()), ghosts = std::uint32_t(ghost_of.size());
  Frame frame{WallView<dim>(lists.wall, layout, {parameters.depth, false, &no_mesh}), {}};
  const std::size_t rows = SphScratch::round_up(std::size_t(n + ghosts + 1) * sph::row_doubles);
  thread_local SphScratch scratch;
  double *memory = scratch.get(rows + SphScratch::round_up(n) + frame.wall.doubles());
  sph::CellView<dim> &view = frame.view;
  view.n = n;
  view.ghosts = ghosts;
  view.ghost_of = ghost_of.data();
  view.rows = memory;
  view.push = memory + rows;
  frame.wall.attach(view, around, view.push + SphScratch::round_up(n));
  view.support = parameters.support;
  view.mass = mass;
  view.depth = parameters.depth;
  view.eos = &eos_pressure;
  view.eos_data = &eos;
  view.neighbours = lists.fluid.neighbours.data();
  view.first_neighbour = lists.fluid.first_neighbour.data();
  view.layer_linear = parameters.layer.linear;
  view.layer_square = parameters.layer.square;
  view.scale = scale;
  for (int d = 0; d < dim; ++d) view.x[d] = around.x[d].data() + layout.fluid;
  return frame;
}

template <int dim>
void BulkFluid<dim>::add_forces(Particles<dim> &particles, const Box<dim> &, const std::size_t) {
  if (parameters.density == BulkDensity::continuity) {
    build_drag(particles);
    std::vector<double> &rho = particles.field("density"), &p = particles.field("pressure");
    for (double &one : rho)
      if (one == 0.) one = eos.reference_density();  // the start
    std::vector<Vector<dim>> on_nodes(nodes(), Vector<dim>::Zero());
    if (is_solid())
      pull_of_stress(particles, on_nodes);
    else {
      eos_pressure(&eos, std::uint32_t(rho.size()), rho.data(), p.data());
      drag.push(p, mass / eos.reference_density(), particles.f, on_nodes);
    }
    if constexpr (dim == 2) pushed = on_nodes;
    push_bodies();
    return;
  }
  Frame frame = look();
  sph::CellView<dim> &view = frame.view;
  view.rho = particles.field("density").data();
  view.pressure = particles.field("pressure").data();
  view.gamma = particles.field("wall_share").data();
  for (int d = 0; d < dim; ++d) view.f[d] = particles.f[d].data();
  if (parameters.volume > 0.) {
    view.volume = parameters.volume;
    view.ordering = parameters.ordering;
  } else
    view.scale = 1.;
  sph::sweeps<dim>().density(view);
  sph::sweeps<dim>().force(view);
  outside = view.crossed;
  scale = view.scale;
  if constexpr (dim == 2) {
    double *to[2];
    for (int d = 0; d < 2; ++d) {
      std::fill(around.f[d].begin(), around.f[d].begin() + layout.fluid, 0.);
      to[d] = around.f[d].data();
    }
    frame.wall.add_forces(view, to);
    pushed.assign(nodes(), Vector<2>::Zero());
    for (std::uint32_t k = 0; k < layout.fluid; ++k)
      pushed[node_of[k]] += Vector<2>(around.f[0][k], around.f[1][k]);
    push_bodies();
  }
}

template <int dim>
double BulkFluid<dim>::energy(const Particles<dim> &particles, const Box<dim> &, const std::size_t) const {
  const std::vector<double> &rho = particles.field("density");
  if (is_solid()) return stored_in_solid(particles);
  double total = parameters.volume > 0. && parameters.density == BulkDensity::summation
                     ? parameters.ordering * parameters.volume * (1. - scale)
                     : 0.;
  for (const double one : rho) total += mass * eos.energy(one);
  return total;
}

template <int dim>
void BulkFluid<dim>::archive(Archive &a, Particles<dim> &particles) {
  a.section("bulk fluid");
  a(origin, builds, scale);
  for (std::vector<double> *field : carried(particles)) a.fixed(*field);
  archive_bodies(a);
  a(pattern);
  if (a.loading()) built = drag_built = false;
}

template class BulkFluid<2>;
template class BulkFluid<3>;
}  // namespace turgor
