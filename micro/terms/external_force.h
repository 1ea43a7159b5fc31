// Forces from outside: a body force (acceleration b, m/s^2, on every particle's mass) and dead
// forces (N, constant in size and direction, on single particles).
#pragma once

#include "micro/engine/term.h"

#include <utility>
#include <vector>

namespace turgor {
template <int dim>
class BodyForce final : public Term<dim> {
 public:
  explicit BodyForce(const Vector<dim> &acceleration_) : acceleration(acceleration_) {}
  std::string name() const override { return "body_force"; }
  void declare(Particles<dim> &) override {}
  void set(const Vector<dim> &value) { acceleration = value; }

  void add_forces(Particles<dim> &particles, const Box<dim> &, const std::size_t group) override {
    const Group &g = particles.groups[group];
    for (std::uint32_t i = g.begin; i < g.end; ++i)
      if (particles.inverse_mass[i] > 0.)
        for (int d = 0; d < dim; ++d) particles.f[d][i] += acceleration[d] / particles.inverse_mass[i];
  }

  /// J, zero at the coordinates' origin.
  double energy(const Particles<dim> &particles, const Box<dim> &, const std::size_t group) const override {
    const Group &g = particles.groups[group];
    double total = 0.;
    for (std::uint32_t i = g.begin; i < g.end; ++i)
      if (particles.inverse_mass[i] > 0.)
        total -= acceleration.dot(particles.position(i)) / particles.inverse_mass[i];
    return total;
  }

 private:
  Vector<dim> acceleration;
};

template <int dim>
class DeadForce final : public Term<dim> {
 public:
  struct Entry {
    std::uint32_t particle;
    Vector<dim> force;  ///< N
  };

  explicit DeadForce(std::vector<Entry> entries_, std::string called_ = "dead_force")
      : entries(std::move(entries_)), called(std::move(called_)) {}
  std::string name() const override { return called; }
  /// 0 until a load is put on, 1 from then on.
  void set_share(const double value) { share = value; }

  void declare(Particles<dim> &particles) override {
    of_group.assign(particles.groups.size(), {});
    for (const Entry &entry : entries)
      for (std::size_t group = 0; group < particles.groups.size(); ++group)
        if (entry.particle >= particles.groups[group].begin && entry.particle < particles.groups[group].end)
          of_group[group].push_back(entry);
    entries.clear();
  }

  void add_forces(Particles<dim> &particles, const Box<dim> &, const std::size_t group) override {
    for (const Entry &entry : of_group[group])
      for (int d = 0; d < dim; ++d) particles.f[d][entry.particle] += share * entry.force[d];
  }

  double energy(const Particles<dim> &particles, const Box<dim> &, const std::size_t group) const override {
    double total = 0.;
    for (const Entry &entry : of_group[group]) total -= entry.force.dot(particles.position(entry.particle));
    return share * total;
  }

 private:
  double share = 1.;
  std::vector<Entry> entries;
  std::string called;
  std::vector<std::vector<Entry>> of_group;
};
}  // namespace turgor
