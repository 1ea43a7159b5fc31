#include "micro/scenes/tissue/tissue_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace turgor {
namespace {
struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(const double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

Extent extent(const Particles<2> &p, const Group &g, const int axis) {
  Extent e;
  for (std::uint32_t i = g.begin; i < g.fluid; ++i) e.add(p.x[axis][i]);
  return e;
}
}  // namespace

TissueStart TissueStart::of(const BrickTissue &tissue) {
  const Particles<2> &p = tissue.system.particles;
  TissueStart start;
  Extent x, y;
  for (const Group &g : p.groups) {
    const Extent own = extent(p, g, 1), across = extent(p, g, 0);
    start.cell_height.push_back(own.high - own.low);
    y.add(own.low);
    y.add(own.high);
    x.add(across.low);
    x.add(across.high);
  }
  start.low = y.low;
  start.high = y.high;
  start.width = x.high - x.low;
  for (const Group &g : p.groups) {
    const Extent own = extent(p, g, 1);
    start.depth.push_back((y.high - 0.5 * (own.low + own.high)) / (y.high - y.low));
  }
  return start;
}

TissueSample measure(const BrickTissue &tissue, const TissueStart &start) {
  const Particles<2> &p = tissue.system.particles;
  TissueSample s;
  double weights = 0., near = 0.;
  std::size_t bonds = 0, bonds_near = 0;
  for (std::size_t c = 0; c < p.groups.size(); ++c) {
    const Extent y = extent(p, p.groups[c], 1);
    const double flattening = 1. - (y.high - y.low) / start.cell_height[c];
    s.flattest = std::max(s.flattest, flattening);
    s.centre += std::max(0., flattening) * start.depth[c];
    weights += std::max(0., flattening);
    for (std::size_t k = 0; k < p.groups[c].wall_count(); ++k) {
      if (tissue.damage && tissue.damage->cells[c].bond_broken[k]) continue;
      const double stretch = tissue.wall->stretch(p, c, k);
      s.stretch += stretch;
      s.largest_stretch = std::max(s.largest_stretch, stretch);
      ++bonds;
      if (start.depth[c] < 0.2) {
        near += stretch;
        ++bonds_near;
      }
    }
    if (tissue.damage && tissue.damage->cells[c].failed()) {
      s.failed_cells += 1.;
      s.broken_bonds += tissue.damage->cells[c].broken;
      s.failed_depth += start.depth[c];
    }
  }
  s.centre = weights > 0. ? s.centre / weights : 0.5;
  s.stretch /= double(std::max<std::size_t>(1, bonds));
  s.stretch_near = bonds_near > 0 ? near / double(bonds_near) : s.stretch;
  if (s.failed_cells > 0.) s.failed_depth /= s.failed_cells;
  if (tissue.ties) s.broken_ties = double(tissue.ties->broken_count());
  return s;
}

std::vector<double> flattening_of_rows(const BrickTissue &tissue, const TissueStart &start,
                                       const unsigned int rows) {
  const Particles<2> &p = tissue.system.particles;
  const std::size_t columns = p.groups.size() / rows;
  std::vector<double> mean(rows, 0.);
  for (std::size_t c = 0; c < p.groups.size(); ++c) {
    const Extent y = extent(p, p.groups[c], 1);
    mean[c / columns] += (1. - (y.high - y.low) / start.cell_height[c]) / double(columns);
  }
  return mean;
}

double slope_between(const std::vector<TissueSample> &history, const double from, const double to) {
  double n = 0., x = 0., y = 0., xx = 0., xy = 0.;
  for (const TissueSample &s : history)
    if (s.strain >= from && s.strain <= to) {
      n += 1.;
      x += s.strain;
      y += 0.5 * (s.bottom + s.top);
      xx += s.strain * s.strain;
      xy += s.strain * 0.5 * (s.bottom + s.top);
    }
  const double spread = n * xx - x * x;
  return n >= 2. && spread > 0. ? (n * xy - x * y) / spread : 0.;
}

double at_strain(const std::vector<TissueSample> &history, double TissueSample::*member,
                 const double strain) {
  for (std::size_t k = 1; k < history.size(); ++k)
    if (history[k].strain >= strain) {
      const TissueSample &a = history[k - 1], &b = history[k];
      const double t = b.strain > a.strain ? (strain - a.strain) / (b.strain - a.strain) : 1.;
      return a.*member + std::clamp(t, 0., 1.) * (b.*member - a.*member);
    }
  return history.empty() ? 0. : history.back().*member;
}

double mean_around(const std::vector<TissueSample> &history, double TissueSample::*member,
                   const double strain, const double half) {
  if (history.empty()) return 0.;
  const double from = std::max(strain - half, history.front().strain),
               to = std::min(strain + half, history.back().strain);
  if (!(to > from)) return at_strain(history, member, strain);
  double sum = 0., last_strain = from, last = at_strain(history, member, from);
  const auto add = [&](const double here, const double value) {
    sum += 0.5 * (last + value) * (here - last_strain);
    last_strain = here;
    last = value;
  };
  for (const TissueSample &s : history)
    if (s.strain > from && s.strain < to) add(s.strain, s.*member);
  add(to, at_strain(history, member, to));
  return sum / (to - from);
}

double oscillation(const std::vector<TissueSample> &history, const std::size_t window) {
  if (history.size() < window + 1) return 0.;
  std::vector<double> mean;
  for (std::size_t k = 0; k + window <= history.size(); ++k) {
    double sum = 0.;
    for (std::size_t i = 0; i < window; ++i) sum += history[k + i].bottom;
    mean.push_back(sum / double(window));
  }
  double falls = 0.;
  for (std::size_t k = 1; k < mean.size(); ++k) falls += std::max(0., mean[k - 1] - mean[k]);
  const auto [low, high] = std::minmax_element(mean.begin(), mean.end());
  return *high > *low ? falls / (*high - *low) : 0.;
}

Sigmoid fit_sigmoid(const std::vector<TissueSample> &history, double TissueSample::*count) {
  Sigmoid best;
  double mean = 0., variance = 0.;
  for (const TissueSample &s : history) mean += s.*count / double(history.size());
  for (const TissueSample &s : history) variance += (s.*count - mean) * (s.*count - mean);
  if (!(variance > 0.)) return best;
  const double end = history.back().strain;
  best.explained = -std::numeric_limits<double>::infinity();
  for (int k = 1; k <= 200; ++k)
    for (double width = 0.005 * end; width < end; width *= 1.1) {
      const double centre = end * k / 200.;
      double yy = 0., yc = 0., cc = 0.;
      for (const TissueSample &s : history) {
        const double y = 1. / (1. + std::exp(-(s.strain - centre) / width)), c = s.*count;
        yy += y * y;
        yc += y * c;
        cc += c * c;
      }
      const double explained = 1. - (cc - yc * yc / yy) / variance;
      if (explained > best.explained) best = {yc / yy, centre, width, explained};
    }
  return best;
}

double strain_reaching(const std::vector<TissueSample> &history, double TissueSample::*count,
                       const double value) {
  for (const TissueSample &s : history)
    if (s.*count >= value && s.*count > 0.) return s.strain;
  return -1.;
}
}  // namespace turgor
