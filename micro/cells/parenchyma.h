// How a patch of 2D parenchyma is put together: n x m square cells, each a closed
// ring of wall nodes filled with fluid, glued by middle-lamella ties.
//
// A 2D scene is a slab of depth z0: masses, forces and energies are those of the slab.
// The builder makes the TURGID reference: cells are squares of the inflated period L,
// wall springs carry the tension that balances turgor (errata, closed forms): every wall
// edge has length spacing = L/nodes_per_side and rest length spacing/lambda_0, where
// 2 F(lambda_0) / (L z0) = turgor (two wall layers per period), F with its yielding where walls yield.
#pragma once

#include "micro/geometry/tensor.h"
#include "micro/laws/lamella_tie.h"
#include "micro/laws/wall_yield.h"

#include <array>
#include <cstdint>
#include <vector>

namespace turgor
{
class InputEntries;
/// Physical parameters of a parenchyma cell (thesis 3.2); SI units.
struct ParenchymaParameters
{
  double period = 100e-6;           ///< m, inflated cell side L
  double depth = 50e-6;             ///< m, slab depth z0
  unsigned int nodes_per_side = 25; ///< wall nodes per cell side (a cell has 4 times as many)
  double wall_stiffness = 100.;     ///< N/m, G t0 (thesis 3.2)
  double wall_thickness = 1e-6;     ///< m, t0
  double wall_density = 1300.;      ///< kg/m^3
  double wall_beta = 0.5;           ///< axial over hoop stress, Eq. 3.5
  WallYield wall_yield = {};        ///< Eq. 3.8; no yielding unless a scene asks for it
  bool wall_bending = true;         ///< bending stiffness E t^3/12 of the wall, E = 4 G (plane strain, incompressible)
  double lamella_ratio = 5.;        ///< tie stiffness / tangent stiffness of one wall spring at rest
  double turgor = 200e3;            ///< Pa
  double fluid_density = 1000.;     ///< kg/m^3, rho_0
  double fluid_modulus = 6e6;       ///< Pa, K of the EOS (2.22); bulk modulus is 7 K
  double fluid_viscosity = 1e-3;    ///< Pa s
  double cavitation_pressure = -100e3; ///< Pa gauge, where liquid gives way (see micro/laws/equation_of_state.h)

  /// Declares every entry above in the current subsection of prm.
  void add_parameters(InputEntries &prm);
};

/// A closed, counter-clockwise ring of wall nodes [first, first + count).
struct WallRing
{
  std::uint32_t first = 0, count = 0;
};

/// Geometry and topology of the reference patch.
struct ParenchymaPatch
{
  ParenchymaParameters parameters;
  unsigned int columns = 0, rows = 0;
  bool periodic_x = true, periodic_y = true;
  Tensor2<2> lattice = Tensor2<2>::Identity(); ///< m, H0 = diag(columns L, rows L)
  std::vector<Vector<2>> nodes;                ///< m, reference positions; node 0 of a ring is the lower left corner
  std::vector<WallRing> rings;                 ///< cell (i, j) is ring j * columns + i
  std::vector<LamellaTie> ties;                ///< each once
  double spacing = 0.;                         ///< m, current length of every wall edge
  double rest_length = 0.;                     ///< m, l0 of every wall edge
  double lambda_0 = 1.;                        ///< spacing / rest_length
  double node_mass = 0.;                       ///< kg
  double tie_stiffness = 0.;                   ///< N/m
  double bending_stiffness = 0.;               ///< N m^2, B of the wall; hinge energy B (theta - theta_0)^2 / (2 spacing)
};

/// Throws std::invalid_argument with a sentence for parameters outside their range.
ParenchymaPatch make_parenchyma(const ParenchymaParameters &parameters, unsigned int columns,
                                unsigned int rows, bool periodic_x, bool periodic_y);
} // namespace turgor
