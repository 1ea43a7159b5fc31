// One piece of fibre network, periodic in the plane, that is strained and comes to rest: what scenes of the
// matrix are made of.
//
//   NetworkSample sample({.pore = 2e-6, .stiffness = 1e-3, .columns = 20, .rows = 24}, threads);
//   sample.deform(F);                 F: 2 x 2; nodes, periods and anchors go with it
//   sample.relax(1e-8, 1e-3);         steps of over-damped motion, linearly implicit and long
//   sample.stress();                  Pa
//
// Quasi-static: nothing depends on friction, which only keeps the matrix of motion regular.
#pragma once

#include "micro/engine/particle_system.h"
#include "micro/engine/system_motion.h"
#include "micro/scenes/reference/network_moduli.h"
#include "micro/terms/fibre_springs.h"
#include "run/choice.h"
#include "run/field_file.h"

#include <memory>

namespace turgor {
enum class NetworkNodes { random, sixfold };
constexpr const char *words_of(NetworkNodes) { return "random|sixfold"; }

struct NetworkParameters {
  NetworkNodes nodes = NetworkNodes::random;
  double pore = 2.4e-6;     ///< m, mean length of the bonds
  double stiffness = 1e-3;  ///< N/m, k_ECM
  unsigned int columns = 20, rows = 24;
  double kept = 1.;    ///< share of the bonds that are there
  double height = 0.;  ///< m, of the anchors over the plane; 0: none
  double depth = 0.;   ///< m, by which stresses per length are stresses
  std::uint64_t seed = 1;
};

class NetworkSample {
 public:
  NetworkSample(const NetworkParameters &parameters, unsigned int threads);
  NetworkSample(const NetworkSample &) = delete;
  NetworkSample &operator=(const NetworkSample &) = delete;

  /// Everything goes with F, on top of what was before.
  void deform(const Tensor2<2> &F);
  /// Until no node feels more than `tolerance` times k_ECM pore strain (N); how many steps that took. Throws
  /// std::runtime_error where it does not come to rest.
  unsigned int relax(double tolerance, double strain);

  Tensor2<2> stress() const;  ///< Pa, Cauchy, in the plane, positive in tension
  double energy() const;      ///< J
  double volume() const;      ///< m^3, of the present box
  /// Pa, by central differences of relaxed states at +-strain.
  NetworkModuli moduli(double strain, double tolerance);
  NetworkModuli affine() const {
    return affine_moduli(system.particles, system.box, *network, parameters.stiffness, parameters.depth);
  }
  NetworkModuli relaxed() const {
    return relaxed_moduli(system.particles, system.box, *network, parameters.stiffness, parameters.depth);
  }
  /// Lines with the tension of each bond; those across the period end at the image.
  FieldFrame frame(double time) const;

  void archive(Archive &a);

  ParticleSystem<3> system;
  std::shared_ptr<FibreNetwork> network;

 private:
  NetworkParameters parameters;
  FibreSprings *springs = nullptr;
  SystemMotion<3> motion;
};
}  // namespace turgor
