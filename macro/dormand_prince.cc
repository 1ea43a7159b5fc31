#include "macro/dormand_prince.h"

#include "run/archive.h"
#include "run/number_text.h"

#include <arkode/arkode_arkstep.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
constexpr unsigned int most_halvings = 8;

void check(int flag, const char *call) {
  if (flag < 0)
    throw std::runtime_error(std::string("SUNDIALS: ") + call + " failed with code " + number_text(flag) +
                             ".");
}

template <int dim>
int call_right_hand_side(realtype t, N_Vector y, N_Vector y_dot, void *user) {
  return static_cast<DormandPrince<dim> *>(user)->right_hand_side(t, N_VGetArrayPointer(y),
                                                                  N_VGetArrayPointer(y_dot));
}

void keep_message(int, const char *, const char *, char *message, void *user) {
  *static_cast<std::string *>(user) = message;
}
}  // namespace

template <int dim>
struct DormandPrince<dim>::Sundials {
  SUNContext context = nullptr;
  N_Vector y = nullptr, tolerance = nullptr;
  void *arkode = nullptr;
  std::string message;

  ~Sundials() {
    if (arkode) ARKStepFree(&arkode);
    if (y) N_VDestroy(y);
    if (tolerance) N_VDestroy(tolerance);
    if (context) SUNContext_Free(&context);
  }
};

template <int dim>
DormandPrince<dim>::DormandPrince(TissueOperator<dim> &op_, const TissueParameters<dim> &parameters_)
    : Integrator<dim>(op_, parameters_),
      sundials(std::make_unique<Sundials>()),
      u(op_.size(), 0.),
      v(op_.size(), 0.),
      a(op_.size(), 0.) {
  for (std::size_t i = 0; i < op_.size(); ++i)
    if (!op_.fixed(i)) free_entries.push_back(i);
  Sundials &s = *sundials;
  const std::size_t n = free_entries.size();
  check(SUNContext_Create(nullptr, &s.context), "SUNContext_Create");
  s.y = N_VNew_Serial(static_cast<sunindextype>(2 * n), s.context);
  s.tolerance = N_VNew_Serial(static_cast<sunindextype>(2 * n), s.context);
  if (!s.y || !s.tolerance) throw std::runtime_error("SUNDIALS: no memory for the state of the tissue.");
  N_VConst(0., s.y);
  for (std::size_t i = 0; i < n; ++i) {
    N_VGetArrayPointer(s.tolerance)[i] = parameters_.displacement_tolerance;
    N_VGetArrayPointer(s.tolerance)[n + i] = parameters_.velocity_tolerance;
  }
  s.arkode = ARKStepCreate(call_right_hand_side<dim>, nullptr, 0., s.y, s.context);
  if (!s.arkode) throw std::runtime_error("SUNDIALS: ARKStepCreate failed.");
  check(ARKStepSetErrHandlerFn(s.arkode, keep_message, &s.message), "ARKStepSetErrHandlerFn");
  check(ARKStepSetUserData(s.arkode, this), "ARKStepSetUserData");
  check(ARKStepSVtolerances(s.arkode, parameters_.relative_tolerance, s.tolerance), "ARKStepSVtolerances");
  check(ARKStepSetTableNum(s.arkode, ARKODE_DIRK_NONE, ARKODE_DORMAND_PRINCE_7_4_5), "ARKStepSetTableNum");
  check(ARKStepSetAdaptivityMethod(s.arkode, ARK_ADAPT_I, 1, 0, nullptr), "ARKStepSetAdaptivityMethod");
  check(ARKStepSetMaxFirstGrowth(s.arkode, 5.), "ARKStepSetMaxFirstGrowth");
  // no dense output: one right-hand side less per step
  check(ARKStepSetInterpolantType(s.arkode, ARK_INTERP_LAGRANGE), "ARKStepSetInterpolantType");
}

template <int dim>
DormandPrince<dim>::~DormandPrince() = default;

template <int dim>
int DormandPrince<dim>::right_hand_side(double t, const double *y, double *y_dot) noexcept {
  try {
    const std::size_t n = free_entries.size();
    // at the committed time the acceleration is known
    const bool committed = t == this->state.time;
    if (!committed) {
      for (std::size_t i = 0; i < n; ++i) {
        u[free_entries[i]] = y[i];
        v[free_entries[i]] = y[n + i];
      }
      if (!this->op.evaluate(t, t - this->state.time, u, v)) {
        point_failed = true;
        last_failure = this->op.failure();
        ++this->counters.failures;
        return 1;
      }
      this->op.acceleration(a);
    }
    const std::vector<double> &acceleration = committed ? this->state.a : a;
    for (std::size_t i = 0; i < n; ++i) {
      y_dot[i] = y[n + i];
      y_dot[n + i] = acceleration[free_entries[i]];
    }
    return 0;
  } catch (...) {
    thrown = std::current_exception();
    return -1;
  }
}

template <int dim>
double DormandPrince<dim>::stable_step() const {
  const double omega = this->stability.frequency(), c = this->stability.damping();
  const double oscillation = c >= 0.1 * omega ? 2. : 0.997;
  return this->parameters.cfl * std::min(oscillation / omega, c > 0. ? 3.3 / c : oscillation / omega);
}

template <int dim>
double DormandPrince<dim>::first_try(double limit) const {
  const double largest = stable_step();
  return std::min(next_step > 0. ? std::min(next_step, largest) : largest, limit - this->state.time);
}

// The last stage is the accepted state but for round-off: take it as it was given to the law.
template <int dim>
bool DormandPrince<dim>::take_result(const double reached) {
  const TissueState<dim> &now = this->state;
  const std::size_t n = free_entries.size();
  const realtype *y = N_VGetArrayPointer(sundials->y);
  bool same = true;
  for (std::size_t i = 0; i < n && same; ++i) {
    const std::size_t k = free_entries[i];
    same = std::abs(y[i] - u[k]) <= 1e-6 * this->parameters.displacement_tolerance + 1e-13 * std::abs(u[k]) &&
           std::abs(y[n + i] - v[k]) <= 1e-6 * this->parameters.velocity_tolerance + 1e-13 * std::abs(v[k]);
  }
  if (same) return true;
  for (std::size_t i = 0; i < n; ++i) {
    u[free_entries[i]] = y[i];
    v[free_entries[i]] = y[n + i];
  }
  if (this->op.evaluate(reached, reached - now.time, u, v)) return true;
  point_failed = true;
  last_failure = this->op.failure();
  ++this->counters.failures;
  return false;
}

template <int dim>
void DormandPrince<dim>::step(double limit) {
  this->refresh();
  TissueState<dim> &now = this->state;
  Sundials &s = *sundials;
  const std::size_t n = free_entries.size();
  const double largest = stable_step();
  const auto before = this->counters;
  double tried = next_step > 0. ? std::min(next_step, largest) : largest;
  for (unsigned int halvings = 0;; ++halvings) {
    realtype *y = N_VGetArrayPointer(s.y);
    for (std::size_t i = 0; i < n; ++i) {
      y[i] = now.u[free_entries[i]];
      y[n + i] = now.v[free_entries[i]];
    }
    point_failed = false;
    thrown = nullptr;
    s.message.clear();
    double reached = now.time;
    check(ARKStepReInit(s.arkode, call_right_hand_side<dim>, nullptr, now.time, s.y), "ARKStepReInit");
    check(ARKStepSetInitStep(s.arkode, std::min(tried, limit - now.time)), "ARKStepSetInitStep");
    check(ARKStepSetMaxStep(s.arkode, largest), "ARKStepSetMaxStep");
    check(ARKStepSetStopTime(s.arkode, limit), "ARKStepSetStopTime");
    const int flag = ARKStepEvolve(s.arkode, limit, s.y, &reached, ARK_ONE_STEP);
    if (thrown) {
      this->counters = before;  // this step has not been
      std::rethrow_exception(thrown);
    }
    long int attempts = 1;
    check(ARKStepGetNumStepAttempts(s.arkode, &attempts), "ARKStepGetNumStepAttempts");
    this->counters.rejected += static_cast<unsigned long>(std::max(0l, attempts - (flag >= 0 ? 1 : 0)));

    if (flag >= 0 && take_result(reached)) {
      double next = 0.;
      check(ARKStepGetCurrentStep(s.arkode, &next), "ARKStepGetCurrentStep");
      // a step cut short by the limit says nothing against the longer one
      const bool cut = reached == limit && attempts == 1 && limit - now.time < tried;
      next_step = cut ? std::max(next, tried) : next;
      this->last_step = reached - now.time;
      now.u = u;
      now.v = v;
      this->accept(reached == limit ? limit : reached);
      this->op.law().commit();
      ++this->counters.steps;
      ++this->since_estimate;
      return;
    }
    if (!point_failed)
      throw std::runtime_error("The integrator dormand_prince gave up at t = " + number_text(now.time) +
                               " s (code " + number_text(flag) + "): " + s.message);
    if (halvings == most_halvings) throw TissueFailed(last_failure, now.time, tried, most_halvings);
    tried = 0.5 * std::min(tried, limit - now.time);
  }
}

template <int dim>
void DormandPrince<dim>::archive(Archive &list) {
  Integrator<dim>::archive(list);
  list(next_step);
}

template class DormandPrince<2>;
template class DormandPrince<3>;
}  // namespace turgor
