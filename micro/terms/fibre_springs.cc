#include "micro/terms/fibre_springs.h"

#include "micro/solve/motion_matrix.h"
#include "micro/solve/step_too_long.h"

#include <algorithm>

namespace turgor {
namespace {
struct Fibre {
  Vector<3> r;  ///< m, from the node to the other end
  double l, l0;
  LinearSpring spring;
  double tension() const { return spring.force(l, l0); }
  Vector<3> pull() const { return tension() / l * r; }  ///< N, on the node
};

void require_length(const double l) {
  if (!(l > 0.))
    throw StepTooLong(
        "two nodes of the fibre network lie upon each other: less strain or force, or smaller steps.");
}
}  // namespace

FibreSprings::FibreSprings(std::shared_ptr<FibreNetwork> network_, const FibreStiffness k_0_)
    : network(std::move(network_)), k_0(k_0_) {}

void FibreSprings::declare(Particles<3> &particles) {
  particles.declare("stiffness");
  std::vector<double> &k = particles.field("stiffness");
  for (std::size_t i = 0; i < network->nodes(); ++i) k[i] = k_0.at(particles.x[0][i]);
}

FibreSprings::Columns FibreSprings::columns(const Particles<3> &particles) const {
  return {particles.field("stiffness"), network->bond_table.column("rest_length"),
          network->anchor_table.column("rest_length")};
}

template <class Visit>
void FibreSprings::for_bonds_of(const std::size_t node, const Columns &of, const Particles<3> &particles,
                                const Box<3> &box, const Visit &visit) const {
  const auto [begin, end] = network->bonds_of(node);
  for (std::uint32_t own = begin; own < end; ++own) {
    const std::uint32_t number = network->own_bonds[own];
    const FibreNetwork::Bond &bond = network->bonds[number];
    const Vector<3> r = network->along(bond, particles, box);
    const double l = r.norm();
    require_length(l);
    const bool first = bond.a == node;
    visit(Fibre{first ? r : Vector<3>(-r), l, of.rest[number], {0.5 * (of.k[bond.a] + of.k[bond.b])}}, bond,
          first);
  }
}

template <class Visit>
void FibreSprings::for_anchors_of(const std::size_t node, const Columns &of, const Particles<3> &particles,
                                  const Visit &visit) const {
  const auto [begin, end] = network->anchors_of(node);
  for (std::uint32_t number = begin; number < end; ++number) {
    const FibreNetwork::Anchor &anchor = network->anchors[number];
    const Vector<3> r = anchor.at - particles.position(node);
    const double l = r.norm();
    require_length(l);
    visit(Fibre{r, l, of.anchor_rest[number], {0.5 * (of.k[node] + k_0.at(anchor.at[0]))}}, anchor);
  }
}

namespace {
/// Nodes of a group: what follows them in it (cells) is no business of the fibres.
std::array<std::size_t, 2> nodes_of(const Particles<3> &particles, const std::size_t group,
                                    const std::size_t nodes) {
  const Group &g = particles.groups[group];
  return {std::min<std::size_t>(g.begin, nodes), std::min<std::size_t>(g.end, nodes)};
}
}  // namespace

void FibreSprings::add_forces(Particles<3> &particles, const Box<3> &box, const std::size_t group) {
  const auto [begin, end] = nodes_of(particles, group, network->nodes());
  const Columns of = columns(particles);
  for (std::size_t i = begin; i < end; ++i) {
    Vector<3> force = Vector<3>::Zero();
    for_bonds_of(i, of, particles, box,
                 [&](const Fibre &fibre, const auto &, const bool) { force += fibre.pull(); });
    for_anchors_of(i, of, particles, [&](const Fibre &fibre, const auto &) { force += fibre.pull(); });
    for (int d = 0; d < 3; ++d) particles.f[d][i] += force[d];
  }
}

void FibreSprings::collect(MotionMatrix &matrix, const Particles<3> &particles, const double h) {
  if (h == 0.) return;
  const Columns of = columns(particles);
  const auto along = [h](const Fibre &fibre) { return h * fibre.spring.stiffness(fibre.l, fibre.l0); };
  const auto across = [h](const Fibre &fibre) { return h * std::max(0., fibre.tension() / fibre.l); };
  const std::uint32_t at_rest = network->anchors.empty() ? 0 : matrix.given<3>(Vector<3>::Zero());
  for (std::uint32_t i = 0; i < network->nodes(); ++i) {
    for_bonds_of(i, of, particles, last_box,
                 [&](const Fibre &fibre, const FibreNetwork::Bond &bond, const bool first) {
                   if (first) matrix.link<3>(bond.a, bond.b, fibre.r / fibre.l, along(fibre), across(fibre));
                 });
    for_anchors_of(i, of, particles, [&](const Fibre &fibre, const auto &) {
      matrix.link<3>(i, at_rest, fibre.r / fibre.l, along(fibre), across(fibre));
    });
  }
}

double FibreSprings::energy(const Particles<3> &particles, const Box<3> &box, const std::size_t group) const {
  double total = 0.;
  const auto [begin, end] = nodes_of(particles, group, network->nodes());
  const Columns of = columns(particles);
  for (std::size_t i = begin; i < end; ++i) {
    for_bonds_of(i, of, particles, box, [&](const Fibre &fibre, const auto &, const bool) {
      total += 0.5 * fibre.spring.energy(fibre.l, fibre.l0);
    });
    for_anchors_of(i, of, particles, [&](const Fibre &fibre, const auto &) {
      total += fibre.spring.energy(fibre.l, fibre.l0);
    });
  }
  return total;
}

Tensor2<3> FibreSprings::image_virial(const Particles<3> &particles, const Box<3> &box,
                                      const std::size_t group) const {
  Tensor2<3> total = Tensor2<3>::Zero();
  const auto [begin, end] = nodes_of(particles, group, network->nodes());
  const Columns of = columns(particles);
  for (std::size_t i = begin; i < end; ++i) {
    for_bonds_of(i, of, particles, box,
                 [&](const Fibre &fibre, const FibreNetwork::Bond &bond, const bool first) {
                   if (bond.shift != std::array<int, 3>{})
                     total += (first ? 0.5 : -0.5) * fibre.pull() * box.image(bond.shift).transpose();
                 });
    for_anchors_of(i, of, particles, [&](const Fibre &fibre, const FibreNetwork::Anchor &anchor) {
      total += fibre.pull() * anchor.at.transpose();
    });
  }
  return total;
}

std::vector<double> FibreSprings::tensions(const Particles<3> &particles, const Box<3> &box) const {
  const Columns of = columns(particles);
  std::vector<double> result(network->bonds.size());
  for (std::size_t n = 0; n < result.size(); ++n) {
    const FibreNetwork::Bond &bond = network->bonds[n];
    result[n] = LinearSpring{0.5 * (of.k[bond.a] + of.k[bond.b])}.force(
        network->along(bond, particles, box).norm(), of.rest[n]);
  }
  return result;
}
}  // namespace turgor
