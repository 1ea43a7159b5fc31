#include "micro/scenes/tissue/lattice_block.h"

#include "micro/cells/parenchyma.h"
#include "micro/cells/turgid_layout.h"
#include "run/run_context.h"

#include <sstream>

namespace turgor {
LatticeBlock::LatticeBlock(const CellLayout &laid, const CellLayout &turgid, const Surfaces surfaces_)
    : LatticeBlock(cut_out(laid, turgid, surfaces_), surfaces_) {}

LatticeBlock::LatticeBlock(const ParenchymaParameters &cell, const unsigned int columns,
                           const unsigned int rows, const Surfaces surfaces_)
    : LatticeBlock(make_parenchyma(cell, columns, rows, true, true),
                   turgid_parenchyma(cell, columns, rows, true, true), surfaces_) {}

LatticeBlock::LatticeBlock(const CutBlock &block, const Surfaces surfaces_)
    : network(std::make_unique<HydrostaticNetwork>(block.layout)),
      clamped(block.clamped),
      probe(block.probe),
      reference(block.layout.positions()),
      relaxed(reference),
      x(reference),
      width(block.width),
      density(block.density),
      surfaces(surfaces_),
      right(block.right) {
  NetworkEvaluation at_reference;
  network->evaluate(x, block.layout.lattice, NetworkOrder::gradient, at_reference);
  reference_pressure = at_reference.pressure[0];  // all cells have it: turgor

  const auto pulls = block.pulls([&](const std::uint32_t node) { return block.layout.nodes[node]; });
  if (!pulls.empty()) {
    dead.assign(x.size(), 0.);
    for (const CutBlock::Pull &pull : pulls)
      for (int d = 0; d < 2; ++d) dead[2 * pull.node + d] += pull.force[d];
    network->set_dead_forces(dead);
  }
  equilibrium = std::make_unique<NetworkEquilibrium>(*network, clamped);
}

LatticeEffort LatticeBlock::relax(const EquilibriumSettings &settings) {
  const auto solve = [&] {
    const EquilibriumReport report = equilibrium->solve(x, network->layout().lattice, settings);
    if (!report.converged)
      throw RunFailed("The unloaded block finds no equilibrium: " + report.message +
                      " Smaller Cell/Turgor or a larger Tolerance may help.");
    return report;
  };
  LatticeEffort effort;
  const auto count = [&](const EquilibriumReport &report) {
    effort.iterations += report.iterations;
    effort.factorisations += report.factorisations;
    effort.escapes += report.escapes;
    effort.residual = report.residual;
  };
  network->set_body_acceleration(Vector<2>::Zero());
  if (surfaces == Surfaces::osmosis) {
    network->hold_pressure(reference_pressure);
    count(solve());
    network->release_water(equilibrium->last_evaluation().volume);
  }
  count(solve());
  relaxed = x;
  return effort;
}

void LatticeBlock::carry(const BlockLoad &load, const double share) {
  network->set_body_acceleration(share * acceleration);
  if (load.traction.norm() == 0.) return;
  std::vector<double> forces = dead;
  forces.resize(x.size(), 0.);
  on_right.setZero();
  for (const CutBlock::SideNode &one : right) {
    const Vector<2> force = share * one.height * network->layout().parameters.depth * load.traction;
    on_right += force;
    for (int d = 0; d < 2; ++d) forces[2 * one.node + d] += force[d];
  }
  network->set_dead_forces(std::move(forces));
}

LatticeEffort LatticeBlock::load(const BlockLoad &wanted, const EquilibriumSettings &settings,
                                 const std::function<void(double)> &after) {
  acceleration = wanted.acceleration(density, width);
  LatticeEffort effort;
  double reached = 0., increment = 1.;
  while (reached < 1.) {
    const double next = std::min(1., reached + increment);
    carry(wanted, next);
    std::vector<double> there = x;
    const EquilibriumReport report = equilibrium->solve(there, network->layout().lattice, settings);
    effort.iterations += report.iterations;
    effort.factorisations += report.factorisations;
    effort.escapes += report.escapes;
    effort.residual = report.residual;
    if (report.converged) {
      x = there;
      reached = next;
      ++effort.increments;
      if (after) after(reached);
      continue;
    }
    failed = there;
    increment *= 0.5;
    if (increment < 1. / 256.) {
      std::ostringstream sentence;
      sentence << "The block finds no equilibrium beyond " << 100. * reached << " % of Load = " << wanted.size
               << " Pa" << (wanted.traction.norm() > 0. ? " and its Traction: " : ": ") << report.message
               << " Use a smaller " << (wanted.traction.norm() > 0. ? "load." : "Load.");
      throw RunFailed(sentence.str());
    }
  }
  return effort;
}

Vector<2> LatticeBlock::probe_displacement() const {
  Vector<2> mean = Vector<2>::Zero();
  for (const std::uint32_t node : probe)
    for (int d = 0; d < 2; ++d) mean[d] += x[2 * node + d] - relaxed[2 * node + d];
  return mean / double(probe.size());
}

Vector<2> LatticeBlock::centroid(const std::vector<double> &at, const std::size_t cell) const {
  const WallRing &ring = network->layout().rings[cell];
  const Vector<2> origin(at[2 * ring.first], at[2 * ring.first + 1]);
  Vector<2> moment = Vector<2>::Zero();
  double twice_area = 0.;
  for (std::uint32_t k = 0; k < ring.count; ++k) {
    const std::size_t i = ring.first + k, j = ring.first + (k + 1) % ring.count;
    const Vector<2> p = Vector<2>(at[2 * i], at[2 * i + 1]) - origin,
                    q = Vector<2>(at[2 * j], at[2 * j + 1]) - origin;
    const double cross = p[0] * q[1] - p[1] * q[0];
    moment += cross * (p + q);
    twice_area += cross;
  }
  return origin + moment / (3. * twice_area);
}

std::vector<Vector<2>> LatticeBlock::cell_displacement() const {
  std::vector<Vector<2>> result;
  for (std::size_t c = 0; c < network->layout().rings.size(); ++c)
    result.push_back(centroid(x, c) - centroid(relaxed, c));
  return result;
}

Vector<2> LatticeBlock::clamp_reaction() const {
  const std::vector<double> &gradient = equilibrium->last_evaluation().gradient;
  Vector<2> sum = Vector<2>::Zero();
  for (const std::uint32_t node : clamped) sum += Vector<2>(gradient[2 * node], gradient[2 * node + 1]);
  return sum;
}

Vector<2> LatticeBlock::weight() const {
  const CellLayout &layout = network->layout();
  double mass = layout.total_wall_mass();
  for (const double fluid : layout.fluid_mass) mass += fluid;
  return mass * acceleration;
}

Vector<2> LatticeBlock::dead_force() const {
  Vector<2> sum = on_right;
  for (std::size_t i = 0; i < dead.size(); ++i) sum[i % 2] += dead[i];
  return sum;
}
}  // namespace turgor
