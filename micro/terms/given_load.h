// Forces that a scene gives as they are (light, tweezers, a puller): no law of the particles, so no energy;
// what they do is active work.
//
//   system.add(std::make_unique<GivenLoad<3>>([this](const Particles<3> &p, std::size_t group, auto &f) {
//     f[0][tip] += pull; }));
//
// In: the function, which adds the forces (N) on the particles of the given group to f, where they begin with
// zero. It is called by one thread a group.
#pragma once

#include "micro/engine/term.h"

#include <algorithm>
#include <functional>

namespace turgor {
template <int dim>
class GivenLoad final : public Term<dim> {
 public:
  using Forces = typename Particles<dim>::Components;
  using Load = std::function<void(const Particles<dim> &, std::size_t group, Forces &)>;
  explicit GivenLoad(Load load_) : load(std::move(load_)) {}

  std::string name() const override { return "given_load"; }
  void declare(Particles<dim> &particles) override {
    for (auto &f : given) f.assign(particles.size(), 0.);
  }

  void add_forces(Particles<dim> &particles, const Box<dim> &, const std::size_t group) override {
    const Group &g = particles.groups[group];
    for (auto &f : given) std::fill(f.begin() + g.begin, f.begin() + g.end, 0.);
    load(particles, group, given);
    for (int d = 0; d < dim; ++d)
      for (std::size_t i = g.begin; i < g.end; ++i) particles.f[d][i] += given[d][i];
  }

  double energy(const Particles<dim> &, const Box<dim> &, std::size_t) const override { return 0.; }

  double active_work(const Particles<dim> &particles, const Box<dim> &, const std::size_t group,
                     const double h) const override {
    const Group &g = particles.groups[group];
    double work = 0.;
    for (int d = 0; d < dim; ++d)
      for (std::size_t i = g.begin; i < g.end; ++i) work += h * given[d][i] * particles.v[d][i];
    return work;
  }

 private:
  Load load;
  Forces given;  ///< N, where forces were last asked
};
}  // namespace turgor
