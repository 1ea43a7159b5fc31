// The law the tissue solver asks for stress: (F, F_dot) at all quadrature points
// as one batch -> first Piola-Kirchhoff stress P of all points.
//
// Trial and commit: evaluate() never changes history. commit() makes the states of
// the LAST evaluate() the history; without it they are dropped. So a step can be
// rejected, repeated or searched along.
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace turgor {
class Archive;

/// What a batch is asked for.
struct LawRequest {
  double time = 0.;               ///< s, time of the batch's F
  double time_since_commit = 0.;  ///< s, since the last commit(); 0 for a probe of the committed time
  bool tangents = false;          ///< also dP/dF
  bool rate_tangents = false;     ///< also dP/dF_dot
};

/// A point whose law could not answer. A non-empty list is a recoverable error:
/// the integrator shortens its step.
struct FailedPoint {
  unsigned int point = 0;  ///< index in the batch
  std::string reason;      ///< a sentence for the user
};

template <int dim>
struct LawAnswer {
  std::vector<dealii::Tensor<2, dim>> P;  ///< Pa, P_aB = dW/dF_aB (+ viscous part)
  std::vector<double> energy;             ///< J/m^3 of reference volume, elastic part; may be empty
  std::vector<dealii::Tensor<2, dim>>
      viscous;  ///< Pa, the part of P whose work is all heat; empty if not known
  std::vector<double>
      heating;  ///< W/m^3 of reference volume, heat besides, of motion that F does not show; may be empty
  std::vector<double> spent;  ///< J/m^3 lost so far by what has no rate (flow, breaking); empty: nothing
  std::vector<dealii::Tensor<4, dim>>
      tangent;  ///< Pa, dP_aB/dF_cD at fixed F_dot; empty unless asked and known
  std::vector<dealii::Tensor<4, dim>>
      rate_tangent;                 ///< Pa s, dP_aB/dF_dot_cD at fixed F; empty unless asked and known
  std::vector<FailedPoint> failed;  ///< in order of point
};

template <int dim>
class MaterialLaw {
 public:
  virtual ~MaterialLaw() = default;

  /// Called once: the reference positions (m) of all points of every later batch.
  virtual void set_points(const std::vector<dealii::Point<dim>> &points) = 0;

  /// Stress of the whole batch. F and F_dot (1/s) have one entry per point.
  virtual void evaluate(const std::vector<dealii::Tensor<2, dim>> &F,
                        const std::vector<dealii::Tensor<2, dim>> &F_dot, const LawRequest &request,
                        LawAnswer<dim> &answer) = 0;

  /// The trial states of the last evaluate() become history.
  virtual void commit() = 0;

  /// Reference density, kg/m^3.
  virtual double density() const = 0;

  /// Upper bounds for the step, at the committed states: stiffness (Pa) with dP : dF <= stiffness |dF|^2 for
  /// every dF, viscosity (Pa s) with dP : dF_dot <= viscosity |dF_dot|^2. E.g. an isotropic solid: dim lambda
  /// + 2 mu; a Newtonian fluid 2 eta D: 2 eta; mu (L + L^T + tr(L) I): (2 + dim) mu.
  virtual double stiffness_bound() const = 0;
  virtual double viscosity_bound() const = 0;

  /// Pa, how stiff it is to plane waves at most: what a side is like that is pressed, the scale of tools'
  /// penalty and of round-off. No bound of the step.
  virtual double wave_modulus() const { return stiffness_bound(); }

  /// Committed states to and from a checkpoint (binary). A law without history writes nothing.
  virtual void archive(Archive &a) = 0;
};
}  // namespace turgor
