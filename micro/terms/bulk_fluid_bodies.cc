// Rigid bodies in the bulk fluid: chains of nodes that it sticks to and forces move.
#include "micro/terms/bulk_fluid.h"

#include "run/archive.h"

#include <cmath>
#include <stdexcept>

namespace turgor {
template <int dim>
RigidChain &BulkFluid<dim>::add_body(std::unique_ptr<RigidChain> body) requires(dim == 2) {
  if (!(body->drag > 0.)) throw std::logic_error("a body in the bulk fluid needs a drag of its own");
  RigidChain &chain_ = *body;
  if constexpr (dim == 2) {  // some compilers look into it in 3D, too
    BulkWall wall;
    for (std::size_t k = 0; k < chain_.size(); ++k) wall.nodes.push_back(chain_.node(k));
    wall.velocity.assign(chain_.size(), Vector<2>::Zero());
    walls.push_back(std::move(wall));
    body_of.push_back({walls.size() - 1, chain_.declare_pusher(), chain_.place()});
    chain_.set_groups(body_of.back().pusher, 1);
    bodies.push_back(std::move(body));
    arms.emplace_back();
  }
  return chain_;
}

template <int dim>
MovedBodies<dim> *BulkFluid<dim>::moved_bodies() {
  return dragged.choose(bodies) ? &dragged : nullptr;
}

template <int dim>
void BulkFluid<dim>::advance(const Particles<dim> &, const double dt) {
  for (const auto &body : bodies) body->advance(dt);
}

template <int dim>
const RigidChain &BulkFluid<dim>::chain(const std::size_t k) const {
  return dynamic_cast<const RigidChain &>(*bodies[k]);
}

template <int dim>
std::size_t BulkFluid<dim>::body_at(const std::uint32_t node) const {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const std::size_t first = first_node(body_of[k].wall);
    if (node >= first && node < first + walls[body_of[k].wall].nodes.size()) return k;
  }
  return bodies.size();
}

template <int dim>
bool BulkFluid<dim>::bodies_left_lists() const {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const auto now = bodies[k]->place();
    const double moved = (now.gone - body_of[k].listed.gone) +
                         bodies[k]->extent() * (now.turned_by - body_of[k].listed.turned_by);
    if (moved > 0.5 * parameters.skin) return true;
  }
  return false;
}

template <int dim>
void BulkFluid<dim>::lay_bodies(const bool where_listed) {
  if constexpr (dim == 2)
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const auto now = bodies[k]->place();
      if (where_listed) bodies[k]->put_back(body_of[k].listed);
      BulkWall &wall = walls[body_of[k].wall];
      arms[k].resize(wall.nodes.size());
      for (std::size_t node = 0; node < wall.nodes.size(); ++node) {
        arms[k][node] = chain(k).arm(node);
        wall.nodes[node] = chain(k).node(node);
      }
      if (where_listed) bodies[k]->put_back(now);
    }
}

template <int dim>
void BulkFluid<dim>::push_bodies() {
  if constexpr (dim == 2)
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      bodies[k]->clear(body_of[k].pusher, 0);
      const std::size_t first = first_node(body_of[k].wall);
      for (std::size_t node = 0; node < arms[k].size(); ++node)
        bodies[k]->pull(body_of[k].pusher, 0, walls[body_of[k].wall].nodes[node], pushed[first + node]);
    }
}

/// Of the matrix of motion, in which they are alone behind the n particles (dragged_bodies.h).
template <int dim>
std::vector<typename SphDrag<dim>::Carrier> BulkFluid<dim>::rows_of_bodies(const std::size_t rows,
                                                                           const std::size_t n) const {
  std::vector<typename SphDrag<dim>::Carrier> all;
  std::uint32_t row = std::uint32_t(n);
  for (const auto &body : bodies) {
    const bool turns = body->turning_drag > 0.;
    all.push_back({row, turns ? std::sqrt(body->turning_drag / body->drag) : 0.});
    row += turns ? 2 : 1;
  }
  if (!bodies.empty() && row != rows)
    throw std::logic_error("beside rigid bodies in a bulk fluid no other bodies are moved by forces");
  return all;
}

template <int dim>
void BulkFluid<dim>::archive_bodies(Archive &a) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    bodies[k]->archive(a);
    auto &listed = body_of[k].listed;
    const auto now = bodies[k]->place();
    // how far it has gone counts from where a run was begun or resumed
    double gone_since = now.gone - listed.gone, turned_since = now.turned_by - listed.turned_by;
    a(listed.centre, listed.turned, gone_since, turned_since);
    if (a.loading()) {
      listed.gone = now.gone - gone_since;
      listed.turned_by = now.turned_by - turned_since;
    }
  }
}

template class BulkFluid<2>;
template class BulkFluid<3>;
}  // namespace turgor
