#include "micro/processes/protruding.h"

#include "micro/laws/counter_random.h"
#include "run/archive.h"

#include <algorithm>
#include <cmath>

namespace turgor {
Protruding::Protruding(const ProtrudingParameters &parameters_, std::shared_ptr<RodSet> rods_,
                       Protrusions &protrusions_, const RodContacts &contacts_, const std::uint32_t nodes_)
    : parameters(parameters_),
      rods(std::move(rods_)),
      protrusions(protrusions_),
      contacts(contacts_),
      nodes(nodes_),
      cells(rods->size()) {}

void Protruding::after_step(Particles<3> &particles, const double h) {
  protrusions.contract(particles, h);
  time += h;
  by_place.reset();
  for (std::size_t rod = 0; rod < cells.size(); ++rod) {
    orient(particles, rod);
    round_up(particles, rod);
    take_hold(particles, rod, h);
  }
  if (parameters.degradation > 0.) degrade(particles, h);
  ++step;
}

void Protruding::orient(const Particles<3> &particles, const std::size_t rod) {
  Cell &cell = cells[rod];
  if (!cell.polarised && time - cell.round_since < parameters.spreading) return;
  Vector<3> sum = Vector<3>::Zero();
  for (std::uint32_t k = 0; k < protrusions.most(); ++k)
    sum += protrusions.force(particles, rod, protrusions.arm(rod, k));
  const double size = sum.norm();
  if (!(size > 0.)) return;
  cell.polarity = sum / size;
  cell.polarised = true;
}

void Protruding::round_up(const Particles<3> &particles, const std::size_t rod) {
  Cell &cell = cells[rod];
  if (cell.placed && time - cell.looked < parameters.patience) return;
  const RodSet::Line line = rods->line(particles, rod);
  const Vector<3> middle = 0.5 * (line.a + line.b);
  if (cell.placed && cell.polarised && (middle - cell.place).norm() < parameters.stuck) {
    protrusions.release_all(rod);
    cell.polarised = false;
    cell.polarity = Vector<3>::Zero();
    cell.round_since = time;
    ++roundings;
  }
  cell.place = middle;
  cell.looked = time;
  cell.placed = true;
}

void Protruding::take_hold(const Particles<3> &particles, const std::size_t rod, const double h) {
  const std::uint32_t idle = protrusions.most() - protrusions.count(rod);
  const std::uint64_t seed = mix_bits(parameters.seed ^ mix_bits(step));
  if (idle == 0 || random_uniform(seed, 4 * rod) > -std::expm1(-h * idle / parameters.waiting)) return;
  const Cell &cell = cells[rod];
  const RodSet::Line line = rods->line(particles, rod);
  const std::uint32_t end =
      cell.polarised ? (line.b - line.a).dot(cell.polarity) > 0. : random_uniform(seed, 4 * rod + 1) < 0.5;
  const Vector<3> from = end == 0 ? line.a : line.b;
  const std::vector<std::uint32_t> found = within_reach(particles, rod, from);
  if (found.empty()) return;
  const std::uint32_t node = found[std::min(
      found.size() - 1, std::size_t(random_uniform(seed, 4 * rod + 2) * double(found.size())))];
  if (cell.polarised) {
    const Vector<3> to = (particles.position(node) - from).normalized();
    const double alpha = std::atan2(to.cross(cell.polarity).norm(), to.dot(cell.polarity));
    if (random_uniform(seed, 4 * rod + 3) > std::exp(-0.5 * std::pow(alpha / parameters.spread, 2))) return;
  }
  protrusions.attach(particles, rod, end, node);
  ++holds;
}

std::vector<std::uint32_t> Protruding::within_reach(const Particles<3> &particles, const std::size_t rod,
                                                    const Vector<3> &from) {
  if (!by_place) {
    const double *const x[2] = {particles.x[0].data(), particles.x[1].data()};
    double low[2], high[2];
    for (int d = 0; d < 2; ++d) {
      const auto [least, most] = std::minmax_element(x[d], x[d] + nodes);
      low[d] = *least;
      high[d] = *most;
    }
    by_place.emplace(x, nodes, 0.5 * parameters.reach, low, high);
  }
  const RodSet::Line line = rods->line(particles, rod);
  const double radius = rods->shape[rod].radius(line.L);
  std::vector<std::uint32_t> found;
  by_place->near(from.data(), [&](const std::uint32_t i) {
    const Vector<3> x = particles.position(i), to = x - from;
    if (!(to.squaredNorm() <= parameters.reach * parameters.reach)) return;
    const double along = std::clamp((x - line.a).dot(line.u), 0., line.L);
    if ((x - line.a - along * line.u).norm() > radius && !protrusions.holds(rod, i)) found.push_back(i);
  });
  std::sort(found.begin(), found.end());
  return found;
}

void Protruding::degrade(Particles<3> &particles, const double h) const {
  std::vector<double> &stiffness = particles.field("stiffness");
  const std::vector<Pair> &pairs = contacts.pairs();
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const auto [node, body] = pairs[p];
    if (contacts.contacts()[p].area == 0. || node >= nodes || body < nodes) continue;
    const std::size_t rod = body - nodes;
    if (!cells[rod].polarised) continue;
    const RodSet::Line line = rods->line(particles, rod);
    const Vector<3> to = particles.position(node) - 0.5 * (line.a + line.b);
    if (to.dot(cells[rod].polarity) >= std::cos(0.25 * std::numbers::pi) * to.norm())
      stiffness[node] *= std::exp(-parameters.degradation * h);
  }
}

void Protruding::Cell::archive(Archive &a) { a(polarity, place, round_since, looked, polarised, placed); }

void Protruding::archive(Archive &a) {
  a.section("protruding");
  a.fixed(cells);
  a(time, step, roundings, holds);
}
}  // namespace turgor
