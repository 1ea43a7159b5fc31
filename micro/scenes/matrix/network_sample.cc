#include "micro/scenes/matrix/network_sample.h"

#include "micro/engine/at_rest.h"
#include "micro/engine/overdamped.h"
#include "run/archive.h"
#include "run/number_text.h"
#include "run/stop_flag.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
PlaneNet net_of(const NetworkParameters &p) {
  PlaneNet net = p.nodes == NetworkNodes::sixfold ? sixfold_net(p.pore, p.columns, p.rows)
                                                  : random_net(p.pore, p.columns, p.rows, p.seed);
  if (p.kept < 1.) remove_bonds(net, p.kept, p.seed);
  return net;
}
}  // namespace

NetworkSample::NetworkSample(const NetworkParameters &parameters_, const unsigned int threads)
    : parameters(parameters_), motion(system, {.tolerance = 1e-4, .max_iterations = 20000}) {
  system.threads = threads;
  network = std::make_shared<FibreNetwork>(system.particles, system.box, net_of(parameters));
  // ends as far aside as the middle of a triangle of nodes
  if (parameters.height > 0.)
    network->add_anchors(system.particles, parameters.height, parameters.pore / std::sqrt(3.),
                         parameters.seed);
  springs = &system.add(std::make_unique<FibreSprings>(network, parameters.stiffness));
  motion.own_length = parameters.pore;
  motion.medium.assign(system.particles.size(), parameters.stiffness);  // relaxes within a second
}

void NetworkSample::deform(const Tensor2<2> &F) {
  Tensor2<3> whole = Tensor2<3>::Identity();
  whole.topLeftCorner<2, 2>() = F;
  Particles<3> &p = system.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector<3> x = whole * p.position(i);
    for (int d = 0; d < 3; ++d) p.x[d][i] = x[d];
  }
  system.box.H = whole * system.box.H;
  for (FibreNetwork::Anchor &anchor : network->anchors) anchor.at = whole * anchor.at;
}

unsigned int NetworkSample::relax(const double tolerance, const double strain) {
  // A mode of a stiffness of k/100 falls to a tenth in a step. Longer steps want fewer of them, each with far
  // more iterations.
  constexpr double longest = 1e3;  // s
  constexpr unsigned int most = 2000;
  const double allowed = tolerance * parameters.stiffness * parameters.pore * std::abs(strain);
  for (auto &v : system.particles.v) std::fill(v.begin(), v.end(), 0.);
  Overdamped<3> stepper({.method = OverdampedMethod::implicit,
                         .tolerance = 10.,
                         .first_step = longest,
                         .longest_step = longest,
                         .energy = {.on = true, .longest_move = 0.2, .growth = 2.}},
                        motion, system.threads);
  for (unsigned int steps = 0; steps < most; ++steps) {
    system.compute_forces();
    if (largest_force(system.particles) <= allowed) return steps;
    stepper.step(system.particles, longest);
    stop_here("while the network came to rest");
  }
  throw std::runtime_error("the network did not come to rest in " + number_text(most) +
                           " steps. Use less strain at once (Steps, Small strain), a larger Tolerance, or "
                           "more bonds (Kept bonds), which leave fewer soft modes.");
}

double NetworkSample::volume() const {
  return system.box.H.topLeftCorner<2, 2>().determinant() * parameters.depth;
}

Tensor2<2> NetworkSample::stress() const { return system.virial().topLeftCorner<2, 2>() / volume(); }

double NetworkSample::energy() const { return system.potential_energy(); }

NetworkModuli NetworkSample::moduli(const double strain, const double tolerance) {
  const Particles<3>::Components x = system.particles.x;
  const Box<3> box = system.box;
  const std::vector<FibreNetwork::Anchor> anchors = network->anchors;
  NetworkModuli result;
  for (int k = 0; k < 3; ++k)
    for (const double sign : {-1., 1.}) {
      Tensor2<2> F = Tensor2<2>::Identity();
      (k < 2 ? F(k, k) : F(0, 1)) += sign * strain;
      deform(F);
      relax(tolerance, strain);
      const Tensor2<2> s = stress();
      result.C.col(k) += sign / (2. * strain) * Vector<3>(s(0, 0), s(1, 1), 0.5 * (s(0, 1) + s(1, 0)));
      system.particles.x = x;
      system.box = box;
      network->anchors = anchors;
    }
  return result;
}

FieldFrame NetworkSample::frame(const double time) const {
  FieldFrame frame;
  frame.time = time;
  frame.nodes_per_cell = 2;
  for (const FibreNetwork::Bond &bond : network->bonds) {
    const Vector<3> a = system.particles.position(bond.a),
                    b = a + network->along(bond, system.particles, system.box);
    for (const Vector<3> &end : {a, b}) {
      frame.cells.push_back(std::uint32_t(frame.points.size() / 3));
      frame.points.insert(frame.points.end(), end.data(), end.data() + 3);
    }
  }
  frame.fields = {{"tension [N]", 1, springs->tensions(system.particles, system.box), true}};
  return frame;
}

void NetworkSample::archive(Archive &a) {
  a.section("network_sample");
  a(system, *network);
}
}  // namespace turgor
