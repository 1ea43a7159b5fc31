#include "rve/mixed_control.h"

#include "run/number_text.h"
#include "run/stop_flag.h"
#include "rve/elastic_tangent.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
constexpr const char *names[4] = {"xx", "xy", "yx", "yy"};
constexpr double crushed = 0.5;    // of the size along one direction: there walls are slack
constexpr double longest = 0.05;   // of a step of Newton's method, in a component of F
constexpr double farthest = 0.1;   // from one balance to the next: beyond it is another one, not reached so
constexpr double at_break = 1e-5;  // from a balance to where a wall breaks: that is where it breaks
}  // namespace

struct MixedControl::Search {
  RveAnswer<2> answer;
  Eigen::MatrixXd K;  ///< Pa
  Eigen::VectorXd r;  ///< Pa, what P is too much
  bool found = false;
};

MixedControl::MixedControl(const Rve<2> &rve_, const LoadingPath &loading_,
                           const MixedControlSettings &settings_)
    : rve(rve_), loading(loading_), settings(settings_) {}

Eigen::MatrixXd MixedControl::model(const RveAnswer<2> &answer, const double dt) const {
  Tensor4<2> all = answer.tangent;
  if (loading.rates_follow() && dt > 0.) all += answer.rate_tangent / dt;
  return all(loading.found(), loading.found());
}

Eigen::VectorXd MixedControl::excess(const RveAnswer<2> &answer, const LoadingPath::Load &load) const {
  Eigen::VectorXd r(loading.found().size());
  for (int i = 0; const int k : loading.found()) r[i++] = answer.P(k / 2, k % 2) - load.P(k / 2, k % 2);
  return r;
}

RveAnswer<2> MixedControl::evaluate(const RveState<2> &from, const double dt, LoadingPath::Load &load,
                                    Rve<2>::Workspace &workspace) {
  if (loading.rates_follow())
    for (const int k : loading.found())
      load.F_dot(k / 2, k % 2) = dt > 0. ? (load.F(k / 2, k % 2) - from.F(k / 2, k % 2)) / dt : 0.;
  RveRequest request;
  request.time_since_commit = dt;
  request.tangent = true;
  request.rate_tangent = loading.rates_follow() && dt > 0.;
  RveAnswer<2> answer;
  if (!(load.F.determinant() > 0.)) {
    answer.withdraw(from);
    answer.diagnostics.converged = false;
    answer.diagnostics.message = "the search led to det F <= 0";
    return answer;
  }
  answer = rve.evaluate(from, load.F, load.F_dot, request, workspace);
  iterations += answer.diagnostics.iterations;
  cpu += answer.diagnostics.cpu_seconds;
  const double away = (load.F - from.F).cwiseAbs().maxCoeff();
  if (answer.diagnostics.converged && answer.whole && away < breaking.away) breaking = {away, answer};
  return answer;
}

bool MixedControl::newton_step(Search &search, const RveState<2> &from, const double dt,
                               LoadingPath::Load &load, Rve<2>::Workspace &workspace) {
  const auto lu = search.K.fullPivLu();
  const Eigen::VectorXd step = -lu.solve(search.r);
  const double size = step.cwiseAbs().maxCoeff();
  if (!lu.isInvertible() || !std::isfinite(size)) return false;
  const double enough =
      torn ? std::max(settings.stress_accuracy, settings.torn_accuracy) : settings.stress_accuracy;
  search.found = size <= settings.strain_accuracy || search.r.cwiseAbs().maxCoeff() <= enough;
  if (search.found) return true;
  const LoadingPath::Load here = load;
  for (double part = std::min(1., longest / size); part > 1e-3; part *= 0.5) {
    load = here;
    for (int i = 0; const int k : loading.found()) {
      load.F(k / 2, k % 2) += part * step[i];
      ++i;
    }
    RveAnswer<2> there = evaluate(from, dt, load, workspace);
    if (!there.diagnostics.converged) {
      search.answer.diagnostics.message = there.diagnostics.message;
      continue;
    }
    const Eigen::VectorXd r = excess(there, load);
    // Near the end of what double precision and the RVE's own tolerance leave, nothing falls any more.
    if (lu.solve(r).norm() > (1. - 0.25 * part) * step.norm() && size > 1e3 * settings.strain_accuracy)
      continue;
    if (settings.exact_tangent)
      search.K = model(there, dt);
    else {
      const Eigen::VectorXd moved = part * step;
      search.K += (r - search.r - search.K * moved) * moved.transpose() / moved.squaredNorm();
    }
    search.r = r;
    search.answer = std::move(there);
    return true;
  }
  load = here;
  return false;
}

RveAnswer<2> MixedControl::find(const RveState<2> &from, const double dt, LoadingPath::Load &load,
                                Rve<2>::Workspace &workspace) {
  for (const int k : loading.found()) load.F(k / 2, k % 2) = from.F(k / 2, k % 2);  // where the search begins
  breaking = {};
  Search search;
  search.answer = evaluate(from, dt, load, workspace);
  if (!search.answer.diagnostics.converged) return search.answer;
  search.K = model(search.answer, dt);
  search.r = excess(search.answer, load);
  for (int step = 0; step < 60 && !search.found; ++step) {
    stop_here("while the F that carries the stress was searched for");
    if (!newton_step(search, from, dt, load, workspace)) break;
  }
  if (!search.found) {
    search.answer.diagnostics.converged = false;
    if (search.answer.diagnostics.message.empty())
      search.answer.diagnostics.message = "the search for F came to no end";
    return search.answer;
  }
  double jump = 0.;
  for (const int k : loading.found()) jump = std::max(jump, std::abs((load.F - from.F)(k / 2, k % 2)));
  if (jump > farthest && !just_broken) {
    search.answer.diagnostics.converged = false;
    search.answer.diagnostics.message =
        "the next balance is a jump of F by " + number_text(jump, 3) + " away";
  }
  return search.answer;
}

void MixedControl::explain(RveAnswer<2> &answer, const LoadingPath::Load &last,
                           const LoadingPath::Load &wanted) const {
  std::string asked, had;
  for (const int k : loading.found()) {
    asked += (asked.empty() ? "" : ", ") + std::string("P_") + names[k] + " = " +
             number_text(wanted.P(k / 2, k % 2)) + " Pa";
    had +=
        (had.empty() ? "" : ", ") + std::string("F_") + names[k] + " = " + number_text(last.F(k / 2, k % 2));
  }
  std::string reason = answer.diagnostics.message;
  if (reason.ends_with('.')) reason.pop_back();
  std::string text = "no F is found that carries " + asked + " (" + reason + "). The last found is at time " +
                     number_text(last.time) + " s, " + had + ". ";
  if (any && smallest < 0.1 * at_first)
    text += "There the tissue's stiffness along these components has fallen to " + number_text(smallest) +
            " Pa, from " + number_text(at_first) +
            " Pa: it can hardly carry more (a limit point). Give the largest of them as F, in "
            "Path/Keyframes, to go on beyond it.";
  else if (const double flat = std::sqrt(
               Eigen::SelfAdjointEigenSolver<Tensor2<2>>(last.F.transpose() * last.F).eigenvalues()[0]);
           flat < crushed)
    text +=
        "There the tissue is pressed to " + number_text(100. * flat, 3) +
        " % of its size: walls so slack fold in many ways, and steps down to 1/2048 of a point's have led "
        "to none that lies near. More Path/Points hardly lead on; end the path before, at an F of that "
        "size.";
  else
    text +=
        "Steps down to 1/2048 of a point's have not led on, so that more Path/Points hardly will. It may be "
        "the most the walls carry: they break there, or stretch without end. End the path at less of a "
        "change.";
  answer.diagnostics.message = text;
}

RveAnswer<2> MixedControl::advance(RveState<2> &state, double &time, const double end,
                                   LoadingPath::Load &load, Rve<2>::Workspace &workspace) {
  iterations = 0;
  cpu = 0.;
  parts.clear();
  RveAnswer<2> answer;
  LoadingPath::Load last = load;
  const double whole = end - time;
  double part = whole, balanced = time;
  while (true) {
    const double to = part >= end - time ? end : time + part;
    LoadingPath::Load next = loading.at(to);
    // Nothing moves before the first point: what is found has no rate, and what is given no slope.
    if (searches() && loading.rates_follow() && !(whole > 0.)) next.F_dot.setZero();
    answer = find(state, to - time, next, workspace);
    if (answer.diagnostics.converged) {
      const Tensor4<2> tangent = elastic_tangent(rve, answer);
      const Eigen::MatrixXd K = tangent(loading.found(), loading.found());
      smallest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(0.5 * (K + K.transpose())).eigenvalues()[0];
      if (!any) at_first = smallest;
      any = true;
      good = answer;
      torn = torn || answer.whole;
      parts.push_back({to, to - time, answer});
      just_broken = false;
      load = last = next;
      time = balanced = to;
      if (to == end) break;
      state = answer.trial;
      part = std::min(2. * part, whole);
    } else if (breaking.away < at_break) {
      state = breaking.answer.trial;
      parts.push_back({to, to - time, breaking.answer});
      just_broken = torn = true;
      time = to;
    } else if (part *= 0.5; !(part > whole / 2048.)) {
      explain(answer, last, next);
      load = last;
      time = balanced;
      if (any) state = good.trial;
      break;
    }
  }
  answer.diagnostics.iterations = int(iterations);
  answer.diagnostics.cpu_seconds = cpu;
  return answer;
}
}  // namespace turgor
