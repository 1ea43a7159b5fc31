// Scene `network_shear`: shear and Young's modulus of a fibre network (thesis 2.3.3, Fig. 2.9A) against
// stiffness and pore size, and one of them sheared far.
//
// For each of Pore sizes, Stiffnesses, Kept bonds and seeds a periodic piece of network is strained by +- a
// small strain along x, along y and in shear, comes to rest each time, and its stress gives G, E and nu.
// Beside them: the affine limit in closed form and the exact linear response of the same network by one
// sparse factorisation without the engine (reference/network_moduli.h); where fibres are missing also the
// effective medium. Then the first network is sheared in Steps to the Largest strain, with
// its energy held against the work of the stress, two computations that know nothing of each other.
#pragma once

#include "micro/scenes/matrix/network_sample.h"
#include "run/scenario.h"

#include <memory>
#include <vector>

namespace turgor {
class NetworkShear final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  class Run;
  /// How many networks are measured; the number of one decides its values, seeds fastest, pore sizes slowest.
  std::size_t samples() const { return pores.size() * stiffnesses.size() * kept.size() * seeds; }
  NetworkParameters sample(std::size_t number) const;
  /// Columns and rows of nodes that fit best into the side, the latter even.
  unsigned int columns(double pore) const;
  unsigned int rows(double pore) const;

  NetworkNodes nodes = NetworkNodes::random;
  std::vector<double> pores{2.4e-6, 4.8e-6, 9.6e-6}, stiffnesses{1e-4, 1e-3, 1e-2}, kept{1.};
  double side = 4.8e-5, height = 0., depth = 0.;
  bool anchors = false;
  unsigned int seeds = 3, first_seed = 1;
  double small_strain = 1e-4, largest_strain = 0.3, tolerance = 1e-8;
  unsigned int steps = 30, frames = 3;
};

std::unique_ptr<Scenario> make_network_shear();
}  // namespace turgor
