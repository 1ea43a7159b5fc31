// HydrostaticNetwork, its walls' history: begun, flowed, leaked, read back.
#include "micro/cells/hydrostatic_network.h"
#include "micro/cells/ring_geometry.h"

#include <algorithm>

namespace turgor {
WallHistory HydrostaticNetwork::new_history(const std::vector<double> &x) const {
  WallHistory history;
  if (limits.plastic) {
    history.reached.assign(geometry.nodes.size(), 1.);
    for (const WallRing &ring : geometry.rings)
      for (std::size_t i = ring.first; i < ring.first + ring.count; ++i)
        history.reached[i] = std::max(1., stretch(x, ring, i));
    for (const double reached : history.reached)
      history.permanent.push_back(WallHistory::permanent_at(wall, elastic, reached));
  }
  if (limits.failure()) {
    history.broken.assign(geometry.nodes.size(), 0);
    history.failed.assign(geometry.rings.size(), 0);
    for (std::size_t c = 0; c < geometry.rings.size(); ++c) history.mass.push_back(fluid_mass(c));
  }
  return history;
}

void HydrostaticNetwork::unpack(const std::vector<double> &numbers, WallHistory &history) const {
  history.unpack(numbers, wall, elastic);
  for (std::size_t c = 0; c < history.failed.size(); ++c)
    history.failed[c] = std::any_of(history.broken.begin() + geometry.rings[c].first,
                                    history.broken.begin() + std::ptrdiff_t(geometry.rings[c].end()),
                                    [](const unsigned char broken) { return broken != 0; });
}

double HydrostaticNetwork::stretch(const std::vector<double> &x, const WallRing &ring,
                                   const std::size_t bond) const {
  return (at(x, ring.after(bond)) - at(x, bond)).norm() / geometry.rest_length[bond];
}

void HydrostaticNetwork::flow(const std::vector<double> &x, WallHistory &history) const {
  if (history.reached.empty()) return;
  for (const WallRing &ring : geometry.rings)
    for (std::size_t i = ring.first; i < ring.first + ring.count; ++i)
      history.flow_dissipated +=
          geometry.rest_length[i] * history.flow(wall, elastic, i, stretch(x, ring, i));
}

double HydrostaticNetwork::given_up(const std::vector<double> &x, const WallHistory &history) const {
  double sum = 0.;
  for (std::size_t c = 0; c < history.mass.size(); ++c)
    if (history.failed[c])
      sum += (1. - history.pressure_share) *
             fluid.energy(history.mass[c], depth() * polygon_area(x, geometry.rings[c]));
  return sum;
}

void HydrostaticNetwork::leak(const std::vector<double> &x, WallHistory &history) const {
  for (std::size_t c = 0; c < history.mass.size(); ++c)
    if (history.failed[c]) {
      const double volume = depth() * polygon_area(x, geometry.rings[c]);
      const double left = history.pressure_share * fluid.pressure(history.mass[c], volume);
      history.torn_dissipated += history.pressure_share * fluid.energy(history.mass[c], volume);
      history.mass[c] = volume * fluid.fluid.density_at(left);
      history.torn_dissipated -= fluid.energy(history.mass[c], volume);
    }
}

double HydrostaticNetwork::stored_energy(const std::vector<double> &x, const Tensor2<2> &H,
                                         const WallHistory &history) const {
  WallHistory settled = history;
  settled.pressure_share = 1.;
  NetworkEvaluation e;
  evaluate(x, H, NetworkOrder::energy, e, &settled);
  return e.energy;
}
}  // namespace turgor
