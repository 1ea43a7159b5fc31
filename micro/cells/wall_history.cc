#include "micro/cells/wall_history.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace turgor {
namespace {
// Round-off in the positions must not count as flow, or a bond at rest on the yield curve would creep.
constexpr double noise = 1e-12;

void require(const bool good, const char *entry, const double value, const char *allowed) {
  if (good) return;
  std::ostringstream text;
  text << entry << " is " << value << "; allowed is " << allowed << ".";
  throw std::invalid_argument(text.str());
}

// Integral of the loaded force over [from, to]; panels so short that 4-point Gauss is exact to 1e-10 beside
// atan's singularities at lambda = 1 +- i/A.
double work(const NeoHookeanWall &loaded, const double from, const double to) {
  constexpr double x[2] = {0.33998104358485626480, 0.86113631159405257522};
  constexpr double w[2] = {0.65214515486254614263, 0.34785484513745385737};
  const double longest = 0.5 / std::max(10., loaded.yielding().sharpness);
  const int panels = std::max(1, static_cast<int>(std::ceil((to - from) / longest)));
  const double h = 0.5 * (to - from) / panels;
  double sum = 0.;
  for (int k = 0; k < panels; ++k) {
    const double c = from + (2 * k + 1) * h;
    for (int i = 0; i < 2; ++i) sum += h * w[i] * (loaded.force(c - h * x[i]) + loaded.force(c + h * x[i]));
  }
  return sum;
}
}  // namespace

void WallLimits::check(const WallYield &yield) const {
  require(!plastic || yield.active(), "Wall/Yield drop", yield.drop,
          "more than 0 with 'Yielding = plastic' (there is nothing to yield otherwise)");
  require(critical_stretch == 0. || critical_stretch > 1., "Wall/Critical stretch", critical_stretch,
          "0 (bonds do not break) or more than 1");
  require(leak_time >= 0., "Wall/Leak time", leak_time, "zero or positive (s)");
  require(residue >= 0. && residue < 1., "Wall/Residue", residue, "0 to less than 1");
  require(broken_share > 0. && broken_share <= 0.1, "Wall/Broken bond stiffness", broken_share,
          "more than 0, at most 0.1");
}

std::size_t WallHistory::failed_cells() const {
  return static_cast<std::size_t>(
      std::count_if(failed.begin(), failed.end(), [](unsigned char f) { return f != 0; }));
}

double WallHistory::mean_permanent() const {
  double sum = 0.;
  for (const double p : permanent) sum += p;
  return permanent.empty() ? 1. : sum / double(permanent.size());
}

std::vector<double> WallHistory::pack() const {
  std::vector<double> numbers;
  if (empty()) return numbers;
  numbers = {flow_dissipated, failure_dissipated};
  numbers.insert(numbers.end(), reached.begin(), reached.end());
  numbers.insert(numbers.end(), broken.begin(), broken.end());
  numbers.insert(numbers.end(), mass.begin(), mass.end());
  if (!broken.empty()) numbers.push_back(torn_dissipated);
  return numbers;
}

std::size_t WallHistory::packed_size(const WallLimits &limits, const std::size_t bonds,
                                     const std::size_t cells) {
  return limits.history() ? 2 + (limits.plastic ? bonds : 0) + (limits.failure() ? bonds + cells + 1 : 0) : 0;
}

void WallHistory::unpack(const std::vector<double> &numbers, const NeoHookeanWall &loaded,
                         const NeoHookeanWall &elastic) {
  if (empty() && numbers.empty()) return;
  const std::size_t expected = 2 + reached.size() + broken.size() + mass.size() + (broken.empty() ? 0 : 1);
  if (numbers.size() != expected)
    throw std::invalid_argument("The history of the committed state does not belong to this RVE.");
  flow_dissipated = numbers[0];
  failure_dissipated = numbers[1];
  std::size_t at = 2;
  permanent.resize(reached.size());
  for (std::size_t i = 0; i < reached.size(); ++i, ++at) {
    if (!(numbers[at] >= 1.) || !std::isfinite(numbers[at]))
      throw std::invalid_argument(
          "The history of the committed state holds a stretch that no wall has reached.");
    // neighbouring bonds have often flowed alike
    permanent[i] = i > 0 && numbers[at] == reached[i - 1] ? permanent[i - 1]
                                                          : permanent_at(loaded, elastic, numbers[at]);
    reached[i] = numbers[at];
  }
  for (unsigned char &bond : broken) bond = numbers[at++] != 0.;
  for (double &m : mass) {
    m = numbers[at++];
    if (!(m >= 0.) || !std::isfinite(m))
      throw std::invalid_argument(
          "The history of the committed state holds a fluid mass that no cell can have.");
  }
  if (!broken.empty()) torn_dissipated = numbers[at];
}

double WallHistory::permanent_at(const NeoHookeanWall &loaded, const NeoHookeanWall &elastic,
                                 const double reached) {
  return reached > 1. ? std::max(1., reached / elastic.stretch_at(loaded.force(reached))) : 1.;
}

bool WallHistory::flows(const std::size_t bond, const double lambda) const {
  return lambda > reached[bond] * (1. + noise) && !is_broken(bond);
}

double WallHistory::force(const NeoHookeanWall &loaded, const NeoHookeanWall &elastic,
                          const double broken_share, const std::size_t bond, const double lambda,
                          double &slope) const {
  if (!reached.empty() && flows(bond, lambda)) return loaded.force(lambda, slope);
  const bool plastic = !reached.empty();
  const double rest = plastic ? permanent[bond] : 1., share = is_broken(bond) ? broken_share : 1.;
  const double F = share * (plastic ? elastic : loaded).force(lambda / rest, slope);
  slope *= share / rest;
  return F;
}

double WallHistory::potential(const NeoHookeanWall &loaded, const NeoHookeanWall &elastic,
                              const double broken_share, const std::size_t bond, const double lambda) const {
  if (!(lambda > 0.)) return HUGE_VAL;
  if (!reached.empty() && flows(bond, lambda))
    return permanent[bond] * elastic.energy(reached[bond] / permanent[bond]) +
           work(loaded, reached[bond], lambda);
  const bool plastic = !reached.empty();
  const double rest = plastic ? permanent[bond] : 1., share = is_broken(bond) ? broken_share : 1.;
  return share * rest * (plastic ? elastic : loaded).energy(lambda / rest);
}

double WallHistory::stored(const NeoHookeanWall &loaded, const NeoHookeanWall &elastic,
                           const double broken_share, const std::size_t bond, const double lambda) const {
  if (!reached.empty() && flows(bond, lambda)) {
    const double rest = permanent_at(loaded, elastic, lambda);
    return rest * elastic.energy(lambda / rest);
  }
  return potential(loaded, elastic, broken_share, bond, lambda);
}

double WallHistory::flow(const NeoHookeanWall &loaded, const NeoHookeanWall &elastic, const std::size_t bond,
                         const double lambda) {
  if (reached.empty() || !flows(bond, lambda)) return 0.;
  const double before = permanent[bond] * elastic.energy(reached[bond] / permanent[bond]);
  const double done = work(loaded, reached[bond], lambda);
  reached[bond] = lambda;
  permanent[bond] = permanent_at(loaded, elastic, lambda);
  return done - (permanent[bond] * elastic.energy(lambda / permanent[bond]) - before);
}
}  // namespace turgor
