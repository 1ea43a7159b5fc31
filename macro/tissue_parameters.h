// What the user says about the piece of tissue and its time integration.
//
// The piece is a block [0, width] x [0, height] (x [0, depth] in 3D), clamped at x = 0 or resting on a plate
// there. In 2D all masses and forces are per metre of depth, plane strain.
#pragma once

#include "macro/tool_parameters.h"
#include "run/choice.h"

#include <deal.II/base/tensor.h>

#include <array>
#include <string>

namespace turgor {
class InputEntries;
/// Of elements that are nearly incompressible: f_bar.h, or plain full integration.
enum class Locking { f_bar, full };
constexpr const char *words_of(Locking) { return "f_bar|full"; }

/// The sides normal to y (and z).
enum class LateralSides { free, periodic, clamped };
constexpr const char *words_of(LateralSides) { return "free|periodic|clamped"; }

/// The side x = width.
enum class RightSide { free, clamped };
constexpr const char *words_of(RightSide) { return "free|clamped"; }

/// The side x = 0; the plate is one of rigid_tools.h.
enum class LeftSide { clamped, plate };
constexpr const char *words_of(LeftSide) { return "clamped|plate"; }

enum class TimeIntegration { central_differences, dormand_prince };
constexpr const char *words_of(TimeIntegration) { return "central_differences|dormand_prince"; }

template <int dim>
struct TissueParameters {
  std::array<double, dim> size;            ///< m
  std::array<unsigned int, dim> elements;  ///< per direction
  unsigned int degree = 1;                 ///< 1 bilinear, 2 biquadratic
  Locking locking = Locking::f_bar;
  LateralSides lateral = LateralSides::free;
  RightSide right = RightSide::free;
  LeftSide left = LeftSide::clamped;  ///< scenes with a tool ask for it
  ToolParameters tool;                ///< on the side x = width; none unless a scene declares it
  dealii::Tensor<1, dim> body_force;  ///< N/kg, on from t = 0
  dealii::Tensor<1, dim> traction;    ///< Pa of reference area, on the side x = width, from t = 0

  TimeIntegration integrator = TimeIntegration::central_differences;
  double end_time = 0.47e-3;          ///< s
  double cfl = 0.9;                   ///< fraction of the stable step
  double shock_viscosity = 0.;        ///< over the usual one (shock_viscosity.h)
  unsigned int estimate_every = 100;  ///< steps between stable steps from the law's tangents; 0: bounds only
  double relative_tolerance = 1e-4;   ///< dormand_prince
  double displacement_tolerance = 1e-9;  ///< m, dormand_prince
  double velocity_tolerance = 1e-4;      ///< m/s, dormand_prince
  double output_interval = 1e-5;         ///< s, between field frames
  double checkpoint_interval = 60.;      ///< s of wall time

  TissueParameters();

  /// Declares subsections "Tissue" and "Time"; without size and body force where the scene finds them itself.
  void declare(InputEntries &prm, bool with_size_and_body_force = true);
  /// The first of them alone.
  void declare_piece(InputEntries &prm, bool with_size_and_body_force = true);

  /// What the patterns cannot say; std::invalid_argument with the entry and what is allowed.
  void check() const;

 private:
  void declare_time(InputEntries &prm);
  void check_cylinder() const;
};
}  // namespace turgor
