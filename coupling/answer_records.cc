#include "coupling/answer_records.h"

#include "micro/laws/counter_random.h"
#include "run/archive.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
constexpr double bins_to_first_radius = 3.;
constexpr double least_share =
    0.1;                   // of the tolerance: a smaller difference of two answers tells nothing of curvature
constexpr int enough = 2;  // neighbours that a curvature is believed of
}  // namespace

template <int dim>
AnswerRecords<dim>::AnswerRecords(const double tolerance_, const double guess_)
    : tolerance(tolerance_),
      guess(guess_),
      bin(bins_to_first_radius * caution * std::sqrt(2. * tolerance / guess)) {}

template <int dim>
double AnswerRecords<dim>::radius_of(const double curvature) const {
  return std::min(bin, caution * std::sqrt(2. * tolerance / curvature));
}

template <int dim>
typename AnswerRecords<dim>::Cell AnswerRecords<dim>::cell(const StrainVector<dim> &E) const {
  Cell c;
  for (int d = 0; d < strain_size<dim>; ++d)
    c[std::size_t(d)] = static_cast<std::int64_t>(std::floor(E[d] / bin));
  return c;
}

template <int dim>
std::uint64_t AnswerRecords<dim>::key(const Cell &c) {
  std::uint64_t k = 0;
  for (const std::int64_t i : c) k = mix_bits(k ^ static_cast<std::uint64_t>(i));
  return k;
}

// All cells that the box of that half width around E touches.
template <int dim>
template <class Visit>
void AnswerRecords<dim>::visit(const StrainVector<dim> &E, const double distance, const Visit &what) const {
  const Cell first = cell(E - StrainVector<dim>::Constant(distance)),
             last = cell(E + StrainVector<dim>::Constant(distance));
  Cell c = first;
  while (true) {
    what(key(c));
    std::size_t d = 0;
    for (; d < c.size() && c[d] == last[d]; ++d) c[d] = first[d];
    if (d == c.size()) return;
    ++c[d];
  }
}

template <int dim>
template <class Visit>
void AnswerRecords<dim>::each_near(const StrainVector<dim> &E, const std::size_t but,
                                   const Visit &what) const {
  visit(E, bin, [&](const std::uint64_t k) {
    if (const auto found = centre.find(k); found != centre.end())
      for (const std::uint32_t j : found->second)
        if (const double d2 = (records[j].E - E).squaredNorm(); j != but && d2 > 0. && d2 < bin * bin)
          what(std::size_t(j), d2);
  });
}

template <int dim>
std::size_t AnswerRecords<dim>::find(const StrainVector<dim> &E, const std::size_t hint) const {
  if (hint < records.size() &&
      (E - records[hint].E).squaredNorm() <= records[hint].radius * records[hint].radius)
    return hint;
  const auto found = reach.find(key(cell(E)));
  std::size_t best = none;
  double least = 1.;
  if (found != reach.end())
    for (const std::uint32_t k : found->second)
      if (const double share = (E - records[k].E).squaredNorm() / (records[k].radius * records[k].radius);
          share <= least) {
        least = share;
        best = k;
      }
  return best;
}

template <int dim>
std::size_t AnswerRecords<dim>::add(AnswerRecord<dim> record, const double most) {
  int told = 0;
  double seen = 0., around = 0.;
  each_near(record.E, none, [&](const std::size_t j, const double d2) {
    const AnswerRecord<dim> &other = records[j];
    const double error =
        std::max((other.rest_at(record.E) - record.S).norm(), (record.rest_at(other.E) - other.S).norm());
    around = std::max(around, other.curvature);
    if (error < least_share * tolerance) return;
    ++told;
    seen = std::max(seen, 2. * error / d2);
  });
  record.curvature = told >= enough ? seen : std::max({seen, around, told == 0 && around == 0. ? guess : 0.});
  record.radius = record.registered = std::min(radius_of(record.curvature), most);
  records.push_back(record);
  put(records.size() - 1);
  return records.size() - 1;
}

template <int dim>
void AnswerRecords<dim>::put(const std::size_t k) {
  visit(records[k].E, records[k].registered,
        [&](const std::uint64_t c) { reach[c].push_back(std::uint32_t(k)); });
  centre[key(cell(records[k].E))].push_back(std::uint32_t(k));
}

template <int dim>
void AnswerRecords<dim>::learn(const std::size_t first) {
  for (std::size_t k = first; k < records.size(); ++k)
    each_near(records[k].E, k, [&](const std::size_t j, const double d2) {
      AnswerRecord<dim> &other = records[j];
      const double error = (other.rest_at(records[k].E) - records[k].S).norm();
      if (error < least_share * tolerance || 2. * error / d2 <= other.curvature) return;
      other.curvature = 2. * error / d2;
      other.radius = std::min(other.radius, radius_of(other.curvature));
    });
}

template <int dim>
void AnswerRecords<dim>::refute(const std::size_t k, const double error, const double distance) {
  AnswerRecord<dim> &record = records[k];
  record.curvature = std::max(record.curvature, 2. * error / (distance * distance));
  record.radius = std::min(record.radius, radius_of(record.curvature));
}

template <int dim>
void AnswerRecords<dim>::truncate(const std::size_t size) {
  for (std::size_t k = records.size(); k-- > size;) {
    visit(records[k].E, records[k].registered, [&](const std::uint64_t c) { reach[c].pop_back(); });
    centre[key(cell(records[k].E))].pop_back();
  }
  records.resize(size);
}

template <int dim>
void AnswerRecords<dim>::archive(Archive &a, const std::size_t kept) {
  std::vector<AnswerRecord<dim>> first(records.begin(), records.begin() + static_cast<std::ptrdiff_t>(kept));
  a(first);
  if (!a.loading()) return;
  reach.clear();
  centre.clear();
  records = std::move(first);
  for (std::size_t k = 0; k < records.size(); ++k) put(k);
}

template class AnswerRecords<2>;
template class AnswerRecords<3>;
}  // namespace turgor
