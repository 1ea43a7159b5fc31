// What answers that were not computed are off by, from a sample of them that was computed after all.
//
// Each is drawn with the same probability by a counter-based generator, whatever it is; so the sample tells
// of all, with
//
//   rms          sqrt(mean e^2); upper bound by the studentised mean of e^2 corrected for its skewness g
//                (Edgeworth's second term):
//                mean + s/sqrt(n) (z + g (2 z^2 + 1)/(6 sqrt(n))),  z = 1.645
//   percentile   of 99 %; upper bound by the smallest order statistic k that lies above it with probability
//                >= 95 %, P(B(n, 0.99) < k) >= 0.95, which needs n >= 299
//
// The order statistics are taken from counts on a scale of 2 %, rounded up: memory does not grow with the
// run.
//
// In: errors e (Pa). Out: Pa.
//
//   if (skipping_drawn(seed, ask, share))  audit.add((P_computed - P_answered).norm());
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace turgor {
class Archive;

/// Whether the ask of this number is computed after all; a function of its arguments alone.
bool skipping_drawn(std::uint64_t seed, std::uint64_t ask, double share);

class SkippingAudit {
 public:
  SkippingAudit();

  void add(double error);

  std::uint64_t count() const { return n; }
  double worst() const { return most; }
  double rms() const;
  double percentile() const;  ///< the 99th
  /// Upper bounds that hold with 95 %; HUGE_VAL while too few have been drawn. That of the percentile
  /// whatever errors are like, that of the rms unless a few answers, of which the sample has none, are far
  /// worse.
  double rms_bound() const;
  double percentile_bound() const;

  static constexpr std::uint64_t enough = 299;  ///< for a bound of the percentile

  void archive(Archive &a);

 private:
  double order_statistic(std::uint64_t k) const;

  std::uint64_t n = 0;
  double most = 0.;
  std::array<double, 3> powers = {};  ///< sums of e^2, e^4, e^6
  std::vector<std::uint64_t> counts;  ///< by size, on a logarithmic scale
};

/// "90 Pa are 0.045 % of turgor (200 kPa) and 0.3 % of the run's largest stress (30 kPa, norm of P)":
/// what an error of a stress (Pa) is to be seen beside; what is zero is left out.
std::string beside(double error, double turgor, double largest);
}  // namespace turgor
