// Forces that a scene gives as they are (light, tweezers, a puller): no law of the particles, so no energy;
// what they do is active work.
//
//   system.add(std::make_unique<GivenLoad<3>>([this](Particles<3> &p, std::size_t) { p.f[0][tip] += pull;
//     }));
//
// In: the function, which adds forces (N) to particles.f of the given group alone. It is called by one thread
// a group.
#pragma once

#include "micro/engine/term.h"

#include <algorithm>
#include <functional>

namespace turgor {
template <int dim>
class GivenLoad final : public Term<dim> {
 public:
  using Load = std::function<void(Particles<dim> &, std::size_t group)>;
  explicit GivenLoad(Load load_) : load(std::move(load_)) {}

  std::string name() const override { return "given_load"; }
  void declare(Particles<dim> &particles) override {
    for (auto &f : given) f.assign(particles.size(), 0.);
  }

  void add_forces(Particles<dim> &particles, const Box<dim> &, const std::size_t group) override {
    const Group &g = particles.groups[group];
    for (int d = 0; d < dim; ++d)
      std::swap_ranges(particles.f[d].begin() + g.begin, particles.f[d].begin() + g.end,
                       given[d].begin() + g.begin);
    for (int d = 0; d < dim; ++d)
      std::fill(particles.f[d].begin() + g.begin, particles.f[d].begin() + g.end, 0.);
    load(particles, group);
    for (int d = 0; d < dim; ++d)
      for (std::size_t i = g.begin; i < g.end; ++i) {
        const double others = given[d][i];
        given[d][i] = particles.f[d][i];
        particles.f[d][i] += others;
      }
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
  typename Particles<dim>::Components given;  ///< N, where forces were last asked
};
}  // namespace turgor
