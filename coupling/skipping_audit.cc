#include "coupling/skipping_audit.h"

#include "micro/laws/counter_random.h"
#include "run/archive.h"
#include "run/number_text.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
constexpr double z = 1.6448536269514722;  // 95 % of a normal variable are below
constexpr double quantile = 0.99, confidence = 0.95;
constexpr double smallest = 1e-6, ratio = 1.02;  // Pa; of the scale of sizes
constexpr std::size_t sizes = 1600;              // up to 5e7 Pa
constexpr std::uint64_t enough_for_mean = 30;

std::size_t size_of(const double error) {
  if (!(error > smallest)) return 0;
  return std::min(sizes - 1, 1 + std::size_t(std::log(error / smallest) / std::log(ratio)));
}

// P(B(n, p) < k), from the largest terms down.
double below(const std::uint64_t n, const double p, const std::uint64_t k) {
  double sum = 0.;
  for (std::uint64_t i = k; i-- > 0;) {
    const double m = double(n), j = double(i);
    const double term = std::exp(std::lgamma(m + 1.) - std::lgamma(j + 1.) - std::lgamma(m - j + 1.) +
                                 j * std::log(p) + (m - j) * std::log1p(-p));
    sum += term;
    if (j < m * p && term < 1e-12) break;
  }
  return sum;
}
}  // namespace

bool skipping_drawn(const std::uint64_t seed, const std::uint64_t ask, const double share) {
  return random_uniform(seed, ask) < share;
}

SkippingAudit::SkippingAudit() : counts(sizes, 0) {}

void SkippingAudit::add(const double error) {
  const double e2 = error * error;
  ++n;
  most = std::max(most, error);
  powers[0] += e2;
  powers[1] += e2 * e2;
  powers[2] += e2 * e2 * e2;
  ++counts[size_of(error)];
}

double SkippingAudit::rms() const { return n > 0 ? std::sqrt(powers[0] / double(n)) : 0.; }

double SkippingAudit::rms_bound() const {
  if (n < enough_for_mean) return HUGE_VAL;
  const double m = double(n), mean = powers[0] / m, second = powers[1] / m, third = powers[2] / m;
  const double variance = std::max(0., second - mean * mean) * m / (m - 1.);
  if (!(variance > 0.)) return std::sqrt(mean);
  const double skew = (third - 3. * mean * second + 2. * mean * mean * mean) / std::pow(variance, 1.5);
  return std::sqrt(mean + std::sqrt(variance / m) *
                              (z + std::max(0., skew) * (2. * z * z + 1.) / (6. * std::sqrt(m))));
}

double SkippingAudit::order_statistic(const std::uint64_t k) const {
  std::uint64_t so_far = 0;
  for (std::size_t size = 0; size < sizes; ++size)
    if ((so_far += counts[size]) >= k) return std::min(most, smallest * std::pow(ratio, double(size)));
  return most;
}

double SkippingAudit::percentile() const {
  return n > 0 ? order_statistic(std::uint64_t(std::ceil(quantile * double(n)))) : 0.;
}

double SkippingAudit::percentile_bound() const {
  if (n < enough) return HUGE_VAL;
  std::uint64_t low = std::uint64_t(quantile * double(n)), high = n;  // P(B < n) = 1 - 0.99^n is enough
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    if (below(n, quantile, middle) >= confidence)
      high = middle;
    else
      low = middle + 1;
  }
  return order_statistic(low);
}

void SkippingAudit::archive(Archive &a) {
  a(n, most, powers);
  a.fixed(counts);
}

std::string beside(const double error, const double turgor, const double largest) {
  std::string text;
  const auto add = [&](const double size, const std::string &of, const std::string &what) {
    if (!(size > 0.)) return;
    text += (text.empty() ? number_text(error, 3) + " Pa are " : " and ") +
            number_text(100. * error / size, 2) + " % of " + of + " (" + number_text(1e-3 * size, 3) +
            " kPa" + what + ")";
  };
  add(turgor, "turgor", "");
  add(largest, "the run's largest stress", ", norm of P");
  return text;
}
}  // namespace turgor
