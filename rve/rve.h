// One representative volume element: a periodic piece of cell structure that is
// deformed by F and F_dot and answers with its stress.
//
//   evaluate(state, F, F_dot, request, workspace) -> stress, trial state, diagnostics, cost
//
// An Rve is shared by all points and const; all history is in RveState, which only the
// caller's commit replaces. Stress is the virial stress (thesis Eq. 3.17) in the current volume.
#pragma once

#include "micro/geometry/tensor.h"
#include "run/archive.h"

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace turgor {
/// Everything that affects the answer of a later evaluate(). Plain data: copied,
/// written to checkpoints and sent between ranks as it is.
template <int dim>
struct RveState {
  Tensor2<dim> F = Tensor2<dim>::Identity();  ///< at which the unknowns below were reached
  Tensor2<dim> F_dot = Tensor2<dim>::Zero();  ///< 1/s
  std::vector<double> unknowns;  ///< positions (m), then velocities (m/s) where the rule has them
  std::vector<double> history;   ///< what walls and cells have been through; empty where nothing stays

  void archive(Archive &a) { a(F, F_dot, unknowns, history); }
};

/// What has happened to the cells for good, for pictures and results. All zero where nothing stays.
struct RveCondition {
  double failed = 0.;              ///< share of the cells that have failed
  double permanent = 0.;           ///< mean permanent stretch of the walls over that of the reference, less 1
  double flow_dissipated = 0.;     ///< J/m^3 of reference volume, by yielding
  double failure_dissipated = 0.;  ///< J/m^3, set free by breaking walls
  double torn_dissipated = 0.;     ///< J/m^3, lost by failed cells after that: leaking fluid, drag
  double dissipated() const { return flow_dissipated + failure_dissipated + torn_dissipated; }
};

struct RveRequest {
  double time_since_commit = 0.;  ///< s
  bool tangent = false;           ///< also dP/dF
  bool rate_tangent = false;      ///< also dP/dF_dot
};

/// How an answer was reached.
struct RveDiagnostics {
  bool converged = true;
  std::string message;       ///< a sentence when !converged, else empty
  int iterations = 0;        ///< Newton iterations or micro steps
  double residual = 0.;      ///< largest unbalanced force / (turgor * spacing * depth)
  bool dragged = false;      ///< no equilibrium near by: nodes held back by drag, which the residual contains
  double energy_drift = 0.;  ///< relative, over a rule's dynamics; 0 without dynamics
  double stress_spread = 0.;  ///< Pa, rms of the stress over the window tau_0; 0 without window
  double cpu_seconds = 0.;
  double air = 0.;                    ///< share of the area that is air between the cells
  double air_pressure = 0.;           ///< Pa, above that outside: of gas shut up there, mean over the spaces
  std::array<double, 4> air_slope{};  ///< its change with F_aB at rest, [2 a + B], of an answer with tangent
};

template <int dim>
struct RveAnswer {
  Tensor2<dim> sigma = Tensor2<dim>::Zero();         ///< Pa, Cauchy
  Tensor2<dim> P = Tensor2<dim>::Zero();             ///< Pa, first Piola-Kirchhoff J sigma F^-T
  Tensor4<dim> tangent = Tensor4<dim>::Zero();       ///< Pa, dP/dF at fixed F_dot; only if asked
  Tensor4<dim> rate_tangent = Tensor4<dim>::Zero();  ///< Pa s, dP/dF_dot at fixed F; only if asked
  double energy = 0.;  ///< J/m^3 of reference volume, elastic and of motion that F does not show, 0 at F = I
  Tensor2<dim> viscous =
      Tensor2<dim>::Zero();  ///< Pa, the part of P whose work is all heat; see knows_heating()
  /// Pa, P less `viscous` with which F was reached, where walls broke there: what the work of getting there
  /// is by. Empty where none broke.
  std::optional<Tensor2<dim>> whole;
  double heating = 0.;   ///< W/m^3 of reference volume, heat besides, of motion that F does not show
  double pressure = 0.;  ///< Pa, mean fluid pressure
  RveCondition condition;
  /// Green strain |dE| from here within which nothing happens to walls and cells for good, a lower bound;
  /// negative: something has happened.
  double safe_strain = std::numeric_limits<double>::infinity();
  RveState<dim> trial;
  RveDiagnostics diagnostics;

  /// What did not converge has no number to build on, never NaN, and leaves the committed state.
  void withdraw(const RveState<dim> &committed) {
    sigma.setZero();
    P.setZero();
    viscous.setZero();
    whole.reset();
    tangent.setZero();
    rate_tangent.setZero();
    energy = heating = pressure = 0.;
    condition = {};
    trial = committed;
    if (!std::isfinite(diagnostics.residual)) diagnostics.residual = HUGE_VAL;
  }
};

/// Throws std::invalid_argument for what no RVE can be asked.
template <int dim>
void check_motion(const Tensor2<dim> &F, const Tensor2<dim> &F_dot) {
  if (!F.allFinite() || !F_dot.allFinite() || !(F.determinant() > 0.))
    throw std::invalid_argument("An RVE needs a finite F with positive determinant and a finite F_dot.");
}

template <int dim>
class Rve {
 public:
  /// Scratch memory of one thread; reused between calls, carries no state.
  struct Workspace {
    virtual ~Workspace() = default;

    /// Of a state nobody needs any more: the next trial is written where it lay. Freeing and asking for
    /// the memory of states that have left the cache costs more than the finite elements of a point.
    std::vector<double> spare;
  };

  virtual ~Rve() = default;
  virtual std::unique_ptr<Workspace> make_workspace() const = 0;

  /// The turgid, stress-balanced reference (F = I).
  virtual RveState<dim> initial_state() const = 0;

  /// Const in the committed state; never throws for a state that cannot be reached
  /// (diagnostics.converged = false and a sentence), throws std::invalid_argument for non-finite or det F <=
  /// 0 input.
  virtual RveAnswer<dim> evaluate(const RveState<dim> &committed, const Tensor2<dim> &F,
                                  const Tensor2<dim> &F_dot, const RveRequest &request,
                                  Workspace &workspace) const = 0;

  /// Whether states have a history, so that conditions are worth keeping.
  virtual bool has_history() const { return false; }

  /// Whether answers know what viscosity turns into heat. Then work = energy + work of `viscous` + heating
  /// over time + what the condition has dissipated.
  virtual bool knows_heating() const { return false; }

  /// Pa s, mu, where the stress is that of the affine flow of such a fluid (affine_flow.h; of the cells'
  /// share where there is air) and an elastic one that is a function of F alone while nothing has happened
  /// for good. Negative: it is not.
  virtual double flow_viscosity() const { return -1.; }

  /// Whether there is air between the cells.
  virtual bool has_air() const { return false; }

  /// Orthogonal Q with P(F Q) = P(F) Q while nothing has happened for good; the identity need not be among
  /// them.
  virtual std::vector<Tensor2<dim>> symmetries() const { return {}; }

  virtual double micro_step() const {
    return 0.;
  }  ///< s, of one iteration where those are steps in time; 0 where not
  virtual double burst() const {
    return 0.;
  }  ///< s, that the cells live through in a call; 0 where they relax or follow F

  virtual double density() const = 0;          ///< kg/m^3 of reference volume, fluid + walls
  virtual double stiffness_bound() const = 0;  ///< Pa, dF : dP/dF : dF <= stiffness |dF|^2 for every dF
  virtual double viscosity_bound() const = 0;  ///< Pa s, the same of dP/dF_dot
  /// Pa, how stiff it is to plane waves: the modulus of a side that is pressed. A scale, no bound of the
  /// step.
  virtual double wave_modulus() const { return stiffness_bound(); }
  virtual Tensor2<dim> lattice() const = 0;  ///< m, columns = periods of the reference (H0)

  /// Outlines of the cells in a state, for pictures: per cell a closed ring of points (m).
  virtual std::vector<std::vector<Vector<dim>>> outlines(const RveState<dim> &state) const = 0;
};
}  // namespace turgor
