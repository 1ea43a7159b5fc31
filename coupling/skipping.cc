#include "coupling/skipping.h"

#include "coupling/tensor_conversion.h"
#include "run/archive.h"
#include "rve/affine_flow.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
// Curvature to begin with over the stiffness of the RVE, where the fluid's is known and where it is not.
constexpr double guess_with_fluid = 1., guess_without = 10.;
constexpr double apart = 0.5;  // of a first radius: calls of one batch that are nearer wait for each other
// A look-up takes as long as 3 unknowns in an iteration of Newton's method (0.3 us and 0.1 us,
// doc/skipping.md).
constexpr double work_of_look_up = 3., look_ups_worth_a_call = 3.;
constexpr std::uint64_t calls_to_decide = 100;
constexpr int most_rounds = 4;  // of a batch: whoever still waits then is called

template <int dim>
double checked_viscosity(const Rve<dim> &rve) {
  if (!(rve.flow_viscosity() >= 0.) || rve.has_air())
    throw std::invalid_argument(
        "Skipping needs RVEs whose elastic stress is a function of F alone, without air between the cells.");
  return rve.flow_viscosity();
}
}  // namespace

template <int dim>
Skipping<dim>::Skipping(const Rve<dim> &rve, const SkippingSettings &settings_)
    : settings(settings_),
      viscosity(checked_viscosity(rve)),
      keeps_history(rve.has_history()),
      unknowns(double(rve.initial_state().unknowns.size())),
      folding(rve.symmetries()),
      table(settings.tolerance, (settings.content ? guess_with_fluid : guess_without) * rve.wave_modulus()) {}

template <int dim>
void Skipping<dim>::set_points(const std::size_t n) {
  hint.assign(n, AnswerRecords<dim>::none);
  virgin.assign(n, 1);
  next = virgin;
  asked.assign(n, Ask());
}

template <int dim>
void Skipping<dim>::begin(const std::vector<dealii::Tensor<2, dim>> &F, const LawRequest &request) {
  teaches = request.time_since_commit > 0.;
  at_begin = table.size();
  rounds = 0;
  now.clear();
  waiting.clear();
  next = virgin;
  std::vector<std::size_t> missing;
  for (std::size_t p = 0; p < asked.size(); ++p) {
    Ask &ask = asked[p];
    ask.F = to_eigen<dim>(F[p]);
    ask.kind = Kind::plain;
    ask.record = AnswerRecords<dim>::none;
    if (!worth || !virgin[p] || !(ask.F.determinant() > 0.)) {
      now.push_back(p);
      since.with_history += teaches && !virgin[p];
      continue;
    }
    ask.E = green_strain<dim>(ask.F);
    ask.symmetry = folding.fold(ask.E);
    ask.record = table.find(ask.E, hint[p]);
    if (ask.record == AnswerRecords<dim>::none)
      missing.push_back(p);
    else
      serve(p);
  }
  since.asks += teaches ? asked.size() : 0;
  batches_since += teaches;
  choose(missing);
}

// A point that a record reaches is answered from it, or called to audit it.
template <int dim>
void Skipping<dim>::serve(const std::size_t p) {
  const std::uint64_t batch =
      batches + batches_since - (rounds > 0);  // the batch under way is counted after its first look
  const bool audit = teaches && skipping_drawn(settings.seed, batch * asked.size() + p, settings.audit_share);
  asked[p].kind = audit ? Kind::audit : Kind::table;
  if (audit) now.push_back(p);
}

// Of the points that no record reaches: who is called, and who waits for them.
template <int dim>
void Skipping<dim>::choose(const std::vector<std::size_t> &missing) {
  const double near = ++rounds < most_rounds ? apart * table.first_radius() : 0.;
  std::vector<std::size_t> chosen;
  for (const std::size_t p : missing) {
    bool waits = false;
    for (const std::size_t other : chosen)
      if ((waits = (asked[p].E - asked[other].E).squaredNorm() < near * near)) break;
    asked[p].kind = waits ? Kind::waiting : Kind::record;
    (waits ? waiting : chosen).push_back(p);
  }
  const auto middle = static_cast<std::ptrdiff_t>(now.size());
  now.insert(now.end(), chosen.begin(), chosen.end());
  std::inplace_merge(now.begin(), now.begin() + middle, now.end());
}

template <int dim>
void Skipping<dim>::learn(const std::vector<dealii::Tensor<2, dim>> &F_dot, const AnswerTable<dim> &answers) {
  for (const std::size_t p : now) {
    Ask &ask = asked[p];
    if (answers.failed(p)) continue;
    if (teaches) {
      ++since.calls;
      since.work += std::uint64_t(double(answers.diagnostics(p).iterations + 1) * unknowns);
    }
    const double safe = keeps_history ? answers.safe_strain(p) : HUGE_VAL;
    next[p] = safe >= 0.;
    if (ask.kind == Kind::plain) continue;
    const AffineFlow<dim> flow(viscosity, ask.F, to_eigen<dim>(F_dot[p]));
    const Tensor2<dim> P = answers.P(p) - flow.P();
    if (ask.kind == Kind::audit) {
      if (teaches)
        findings.push_back({ask.record, (P - elastic_P(ask)).norm(), (ask.E - table[ask.record].E).norm()});
    } else if (safe > 0.)
      ask.record =
          table.add(AnswerRecord<dim>::from(ask.F, P, answers.tangent(p) - flow.tangent(), answers.energy(p),
                                            answers.pressure(p), folding, settings.content),
                    safe);
  }
  now.clear();
  std::vector<std::size_t> missing, were_waiting;
  were_waiting.swap(waiting);
  for (const std::size_t p : were_waiting) {
    asked[p].record = table.find(asked[p].E, AnswerRecords<dim>::none);
    if (asked[p].record == AnswerRecords<dim>::none)
      missing.push_back(p);
    else
      serve(p);
  }
  choose(missing);
}

template <int dim>
Tensor2<dim> Skipping<dim>::elastic_P(const Ask &ask) const {
  const VolumeLaw<dim> water(settings.content, ask.E);
  return ask.F *
         to_tensor<dim>(folding.image(ask.symmetry).transpose() * table[ask.record].stress_at(ask.E, water));
}

template <int dim>
RveAnswer<dim> Skipping<dim>::answer(const std::size_t point, const Tensor2<dim> &F_dot,
                                     const LawRequest &request) const {
  const Ask &ask = asked[point];
  const AnswerRecord<dim> &record = table[ask.record];
  const AffineFlow<dim> flow(viscosity, ask.F, F_dot);
  const VolumeLaw<dim> water(settings.content, ask.E);
  const StrainMatrix<dim> &image = folding.image(ask.symmetry);
  const StrainVector<dim> S = image.transpose() * record.stress_at(ask.E, water);
  RveAnswer<dim> a;
  a.viscous = flow.P();
  a.P = ask.F * to_tensor<dim>(S) + a.viscous;
  a.sigma = a.P * ask.F.transpose() / ask.F.determinant();
  a.energy = record.energy_at(ask.E, water);
  a.pressure = record.pressure + water.pressure();
  if (request.rate_tangents) a.rate_tangent = flow.rate_tangent();
  if (request.tangents)
    a.tangent = elastic_tangent<dim>(ask.F, S, image.transpose() * (record.C + water.tangent()) * image) +
                flow.tangent();
  return a;
}

template <int dim>
void Skipping<dim>::end() {
  if (!teaches) {
    table.truncate(at_begin);
    return;
  }
  for (const Ask &ask : asked) since.answered += ask.kind == Kind::table;
}

template <int dim>
void Skipping<dim>::commit() {
  table.learn(committed);
  for (const Finding &f : findings) {
    audited.add(f.error);
    if (f.error <= settings.tolerance) continue;
    ++since.refuted;
    table.refute(f.record, f.error, f.distance);
  }
  findings.clear();
  committed = table.size();
  for (std::size_t p = 0; p < asked.size(); ++p) hint[p] = asked[p].record;
  virgin = next;
  batches += batches_since;
  batches_since = 0;
  total.asks += since.asks;
  total.answered += since.answered;
  total.with_history += since.with_history;
  total.refuted += since.refuted;
  total.work += since.work;
  total.calls += since.calls;
  since = {};
  decide();
}

template <int dim>
void Skipping<dim>::decide() {
  if (worth && total.calls >= calls_to_decide)
    worth = double(total.work) > look_ups_worth_a_call * work_of_look_up * double(total.calls);
}

template <int dim>
void Skipping<dim>::archive(Archive &a) {
  a.section("skipping");
  table.archive(a, committed);
  a(audited, total, worth, batches);
  a.fixed(hint, virgin);
  if (!a.loading()) return;
  committed = table.size();
  next = virgin;
  since = {};
  batches_since = 0;
  findings.clear();
}

template class Skipping<2>;
template class Skipping<3>;
}  // namespace turgor
