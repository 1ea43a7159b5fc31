#include "micro/scenes/matrix/rod_cells.h"

#include "run/archive.h"

#include <algorithm>
#include <cmath>

namespace turgor {
RodCells::RodCells(const RodMaterial &material_, const unsigned int threads)
    : SteppedCells(material_.steps(), threads), material(material_) {}

void RodCells::add_network(const PlaneNet &net, const FibreStiffness stiffness, const double node_friction,
                           const double height, const std::uint64_t seed) {
  network = std::make_shared<FibreNetwork>(system.particles, system.box, net);
  // ends as far aside as the middle of a triangle of nodes
  if (height > 0.) network->add_anchors(system.particles, height, net.mean_length() / std::sqrt(3.), seed);
  network_stiffness = stiffness;
  motion.medium.assign(system.particles.size(), node_friction);
}

void RodCells::add_rods(const std::vector<Vector<3>> &a, const std::vector<Vector<3>> &b) {
  rods->shape.assign(a.size(), material.shape());
  rods->inner_friction = material.inner_friction();
  rods->add(system.particles, a, b);
  motion.medium.insert(motion.medium.end(), 2 * a.size(), 0.5 * material.medium);
  if (network) springs = &system.add(std::make_unique<FibreSprings>(network, network_stiffness));
  system.add(std::make_unique<RodBodies>(rods));
}

RodContacts &RodCells::add_contacts(const ContactLaw &law, const double node_radius) {
  const std::uint32_t nodes = network ? std::uint32_t(network->nodes()) : 0;
  contacts = &system.add(std::make_unique<RodContacts>(rods, material.contacts(law, nodes, node_radius)));
  return *contacts;
}

Protrusions &RodCells::add_protrusions(const ProtrusionLaw &law, const std::uint32_t most) {
  protrusions = &system.add(
      std::make_unique<Protrusions>(rods, network ? std::uint32_t(network->nodes()) : 0, law, most));
  return *protrusions;
}

double RodCells::step(const double limit) {
  const double h = move(limit);
  if (after_step) {
    const double before = energy();
    after_step(h);
    if (network) std::fill(system.particles.x[2].begin(), system.particles.x[2].end(), 0.);
    system.compute_forces();
    const double change = energy() - before;
    fed += change;
    fed_and_taken += std::abs(change);
  }
  if (plates != nullptr) {
    system.advance(h);
    system.compute_forces();
  }
  return h;
}

FieldFrame RodCells::frame() const {
  FieldFrame frame;
  frame.time = time();
  frame.nodes_per_cell = 2;
  std::vector<double> radius;
  for (std::size_t rod = 0; rod < rods->size(); ++rod) {
    const RodSet::Line line = rods->line(system.particles, rod);
    for (const Vector<3> &end : {line.a, line.b}) {
      frame.cells.push_back(std::uint32_t(frame.points.size() / 3));
      frame.points.insert(frame.points.end(), end.data(), end.data() + 3);
    }
    radius.push_back(rods->shape[rod].radius(line.L));
  }
  frame.fields = {{"radius [m]", 1, radius, true}};
  return frame;
}

void RodCells::archive(Archive &a) {
  a.section("rod_cells");
  archive_steps(a);
  a(fed, fed_and_taken);
  if (network) a(*network);
}
}  // namespace turgor
