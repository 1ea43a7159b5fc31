// Images of particles and walls around the box, and lists of who is near whom.
#include "micro/terms/bulk_fluid.h"

#include "run/number_text.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
/// visit(k): all images but the box itself, one beside it in each periodic direction.
template <int dim, class Visit>
void for_images(const Box<dim> &box, const Visit &visit) {
  int most[3] = {};
  for (int d = 0; d < dim; ++d) most[d] = box.periodic[d] ? 1 : 0;
  for (int z = -most[2]; z <= most[2]; ++z)
    for (int y = -most[1]; y <= most[1]; ++y)
      for (int x = -most[0]; x <= most[0]; ++x) {
        const int all[3] = {x, y, z};
        Vector<dim> by;
        for (int d = 0; d < dim; ++d) by[d] = all[d] * box.H(d, d);
        visit(by);
      }
}
}  // namespace

/// Images of walls near the box, each a chain of its own: joins of chains are left out of the lists.
template <int dim>
void BulkFluid<dim>::build_walls(const Box<dim> &box, const double reach) {
  node_of.clear();
  node_shift.clear();
  gone.clear();
  for (auto &x : around.x) x.clear();
  if constexpr (dim == 2) {
    std::uint32_t first = 0;
    for (const BulkWall &wall : walls) {
      const std::uint32_t count = std::uint32_t(wall.nodes.size());
      for_images<2>(box, [&](const Vector<2> &by) {
        bool near = false;
        for (std::uint32_t k = 0; k <= count; ++k) {
          const Vector<2> x = node_place(wall, k, box) + by;
          bool in = true;
          for (int d = 0; d < 2; ++d)
            in = in && (!box.periodic[d] || (x[d] > -1.5 * reach && x[d] < box.H(d, d) + 1.5 * reach));
          near = near || in;
        }
        if (!near) return;
        for (std::uint32_t k = 0; k <= count; ++k) {
          const Vector<2> x = node_place(wall, k, box) + by;
          for (int d = 0; d < 2; ++d) around.x[d].push_back(x[d]);
          node_of.push_back(first + k % count);
          node_shift.push_back(x - wall.nodes[k % count]);
          gone.push_back(k == count);
        }
      });
      first += count;
    }
  }
  layout = {0, std::uint32_t(node_of.size()), 0};
}

template <int dim>
void BulkFluid<dim>::build(const Box<dim> &box) {
  built = true;
  const std::uint32_t n = std::uint32_t(origin.size());
  const double reach = parameters.support + parameters.skin;
  for (int d = 0; d < dim; ++d)
    if (box.periodic[d] && box.H(d, d) < reach)
      throw std::invalid_argument("the period of " + number_text(box.H(d, d)) +
                                  " m is shorter than the reach of the particles, " + number_text(reach) +
                                  " m: use more particles");
  lay_bodies(true);
  build_walls(box, reach);
  lay_bodies(false);
  shift.assign(n, Vector<dim>::Zero());
  ghost_of.clear();
  ghost_shift.clear();
  if (!origin.finite()) {  // the scene sees the positions themselves and says that it diverged
    lists.fluid.clear(n);
    lists.wall.clear(n);
    return;
  }
  for (std::uint32_t i = 0; i < n; ++i)
    for (int d = 0; d < dim; ++d) {
      if (box.periodic[d]) shift[i][d] = -box.H(d, d) * std::floor(origin[d][i] / box.H(d, d));
      around.x[d].push_back(origin[d][i] + shift[i][d]);
    }
  for_images<dim>(box, [&](const Vector<dim> &by) {
    if (by == Vector<dim>::Zero()) return;
    for (std::uint32_t i = 0; i < n; ++i) {
      bool in = true;
      for (int d = 0; d < dim; ++d) {
        const double x = around.x[d][layout.fluid + i] + by[d];
        in = in && (!box.periodic[d] || (x > -reach && x < box.H(d, d) + reach));
      }
      if (!in) continue;
      ghost_of.push_back(i);
      ghost_shift.push_back(shift[i] + by);
    }
  });
  const std::uint32_t ghosts = std::uint32_t(ghost_of.size());
  if (n + ghosts > 65534 || layout.fluid > 30000)
    throw std::invalid_argument("bulk fluid: " + number_text(n) + " particles with " + number_text(ghosts) +
                                " images and " + number_text(layout.fluid) +
                                " wall nodes; the neighbour lists number at most 65534 and 30000");
  for (std::uint32_t g = 0; g < ghosts; ++g)
    for (int d = 0; d < dim; ++d) around.x[d].push_back(origin[d][ghost_of[g]] + ghost_shift[g][d]);
  layout.end = layout.fluid + n + ghosts;
  around.resize(layout.end);
  ListOrigin<dim> at;
  at.take(around.x, layout);
  lists.fluid.build(at, layout.fluid, reach, ghosts);
  if constexpr (dim == 2)
    lists.wall.build(at, layout.fluid, reach, &gone);
  else
    lists.wall.clear(n + ghosts);
}

template <int dim>
Vector<2> BulkFluid<dim>::node_place(const BulkWall &wall, const std::size_t k, const Box<dim> &box) {
  const std::size_t count = wall.nodes.size();
  if (k < count) return wall.nodes[k];
  if (wall.closed) return wall.nodes[0];
  const double period = box.H(0, 0), ahead = wall.nodes.back()[0] > wall.nodes[0][0] ? period : -period;
  return wall.nodes[0] + Vector<2>(ahead, 0.);
}

template <int dim>
void BulkFluid<dim>::follow(const Particles<dim> &particles) {
  const std::size_t n = shift.size(), ghosts = ghost_of.size();
  for (int d = 0; d < dim; ++d) {
    double *to = around.x[d].data() + layout.fluid;
    for (std::size_t i = 0; i < n; ++i) to[i] = particles.x[d][i] + shift[i][d];
    for (std::size_t g = 0; g < ghosts; ++g) to[n + g] = particles.x[d][ghost_of[g]] + ghost_shift[g][d];
  }
  if (bodies.empty()) return;
  std::vector<Vector<2>> places;
  for (const BulkWall &wall : walls) places.insert(places.end(), wall.nodes.begin(), wall.nodes.end());
  for (std::size_t k = 0; k < node_of.size(); ++k)
    for (int d = 0; d < 2; ++d) around.x[d][k] = places[node_of[k]][d] + node_shift[k][d];
}

template class BulkFluid<2>;
template class BulkFluid<3>;
}  // namespace turgor
