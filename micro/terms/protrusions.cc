#include "micro/terms/protrusions.h"

#include "micro/solve/motion_matrix.h"
#include "run/archive.h"

#include <algorithm>
#include <stdexcept>

namespace turgor {
Protrusions::Protrusions(std::shared_ptr<RodSet> rods_, const std::uint32_t nodes_, const ProtrusionLaw &law_,
                         const std::uint32_t most_)
    : rods(std::move(rods_)), nodes(nodes_), law(law_), most_of_rod(most_) {}

void Protrusions::declare(Particles<3> &) { arms.assign(rods->size() * most_of_rod, {}); }

std::uint32_t Protrusions::count(const std::size_t rod) const {
  std::uint32_t total = 0;
  for (std::uint32_t k = 0; k < most_of_rod; ++k) total += arm(rod, k).holds();
  return total;
}

bool Protrusions::holds(const std::size_t rod, const std::uint32_t node) const {
  for (std::uint32_t k = 0; k < most_of_rod; ++k)
    if (arm(rod, k).node == node) return true;
  return false;
}

double Protrusions::length(const Particles<3> &particles, const std::size_t rod, const Arm &one) const {
  return (particles.position(one.node) - particles.position(particle(rod, one))).norm();
}

Vector<3> Protrusions::force(const Particles<3> &particles, const std::size_t rod, const Arm &one) const {
  if (!one.holds()) return Vector<3>::Zero();
  const Vector<3> r = particles.position(one.node) - particles.position(particle(rod, one));
  const double l = r.norm();
  return l > 0. ? Vector<3>(law.tension(one.state, l) / l * r) : Vector<3>::Zero();
}

void Protrusions::attach(const Particles<3> &particles, const std::size_t rod, const std::uint32_t end,
                         const std::uint32_t node) {
  for (std::uint32_t k = 0; k < most_of_rod; ++k)
    if (Arm &one = arms[rod * most_of_rod + k]; !one.holds()) {
      one.node = node;
      one.end = end;
      one.state = law.begin(length(particles, rod, one));
      sorted = false;
      return;
    }
  throw std::logic_error("a rod has no protrusion left");
}

void Protrusions::release(const std::size_t rod, const std::uint32_t k) {
  arms[rod * most_of_rod + k] = {};
  sorted = false;
}

void Protrusions::release_all(const std::size_t rod) {
  for (std::uint32_t k = 0; k < most_of_rod; ++k) release(rod, k);
}

void Protrusions::contract(const Particles<3> &particles, const double h) {
  for (std::size_t n = 0; n < arms.size(); ++n) {
    if (!arms[n].holds()) continue;
    const std::size_t rod = n / most_of_rod;
    law.advance(arms[n].state, length(particles, rod, arms[n]), h);
    if (law.is_over(arms[n].state)) release(rod, std::uint32_t(n % most_of_rod));
  }
}

void Protrusions::sort() {
  first_of.assign(nodes + 1, 0);
  for (const Arm &one : arms)
    if (one.holds()) ++first_of[one.node + 1];
  for (std::uint32_t i = 0; i < nodes; ++i) first_of[i + 1] += first_of[i];
  of_node.resize(first_of[nodes]);
  std::vector<std::uint32_t> next(first_of.begin(), first_of.end() - 1);
  for (std::uint32_t n = 0; n < arms.size(); ++n)
    if (arms[n].holds()) of_node[next[arms[n].node]++] = n;
  sorted = true;
}

/// visit(arm's rod, arm, particle, sign of the force there): of nodes and of rods' ends.
template <class Visit>
void Protrusions::for_arms_of(const Particles<3> &particles, const std::size_t group,
                              const Visit &visit) const {
  const Group &g = particles.groups[group];
  for (std::uint32_t i = g.begin; i < std::min(g.end, nodes); ++i)
    for (std::uint32_t k = first_of[i]; k < first_of[i + 1]; ++k)
      visit(of_node[k] / most_of_rod, arms[of_node[k]], i, -1.);
  const auto [begin, end] = rods->of_group(particles, group);
  for (std::size_t rod = begin; rod < end; ++rod)
    for (std::uint32_t k = 0; k < most_of_rod; ++k)
      if (arm(rod, k).holds()) visit(rod, arm(rod, k), particle(rod, arm(rod, k)), 1.);
}

void Protrusions::add_forces(Particles<3> &particles, const Box<3> &, const std::size_t group) {
  for_arms_of(particles, group,
              [&](const std::size_t rod, const Arm &one, const std::uint32_t at, const double sign) {
                const Vector<3> f = sign * force(particles, rod, one);
                for (int d = 0; d < 3; ++d) particles.f[d][at] += f[d];
              });
}

double Protrusions::energy(const Particles<3> &particles, const Box<3> &, const std::size_t group) const {
  double total = 0.;
  for_arms_of(particles, group, [&](const std::size_t rod, const Arm &one, std::uint32_t, double) {
    total += 0.5 * law.energy(one.state, length(particles, rod, one));
  });
  return total;
}

void Protrusions::collect(MotionMatrix &matrix, const Particles<3> &particles, const double h) {
  if (h == 0.) return;
  for (std::size_t n = 0; n < arms.size(); ++n) {
    const std::size_t rod = n / most_of_rod;
    if (!arms[n].holds()) continue;
    const double l = length(particles, rod, arms[n]), F = law.tension(arms[n].state, l);
    if (!(F > 0.)) continue;
    const std::uint32_t end = particle(rod, arms[n]);
    matrix.link<3>(end, arms[n].node, (particles.position(arms[n].node) - particles.position(end)) / l,
                   h * law.stiffness, h * F / l);
  }
}

void Protrusions::archive(Archive &a, Particles<3> &) {
  a.section("protrusions");
  a.fixed(arms);
  if (a.loading()) sorted = false;
}
}  // namespace turgor
