// The turgid, stress-balanced reference (F = I) of periodic cells filled with particles.
//
// From where the fluid is laid the cells are inflated and annealed: damped motion until the
// fluid is at rest, while osmosis (thesis Eq. 3.2, corrected: a cell's water is shared
// by its particles) fills them, all by one factor, until the fluid's virial pressure balances the walls, that
// is until the mean stress of the period is zero. Wall tension of a square cell then equals turgor times the
// period, so the pressure meant everywhere by p(A) is the VIRIAL pressure of the fluid; the mean of the
// particles' EOS pressure is reported beside it (they differ by particle disorder). turgid_layout.h has the
// same of cells with one pressure each.
#pragma once

#include "micro/cells/sph_parenchyma.h"

#include <functional>

namespace turgor {
/// What is left over at F = I, and the pressures there.
struct AtRest {
  double residual_stress[3]{};  ///< Pa, sxx, syy, sxy left over at F = I
  double mean_pressure = 0.;    ///< Pa, mean EOS pressure at F = I
  double residual = 0.;         ///< largest unbalanced force / (turgor spacing depth)
  double fluid_pressure = 0.;   ///< Pa, virial pressure of the fluid at F = I
};

struct AnnealedCells : AtRest {
  std::vector<CellContents> cells;
};

struct ReferenceCell : AtRest, CellContents {};

/// Cells of any layout that is periodic both ways, each annealed for itself. progress(fraction) is called now
/// and then. Throws std::runtime_error when the cells do not come to rest.
AnnealedCells anneal(const CellLayout &layout, const SphParameters &sph,
                     const std::vector<CellContents> &start,
                     const std::function<void(double)> &progress = {});

/// One square cell, of which a grid is made of copies.
ReferenceCell anneal_square_cell(const ParenchymaParameters &cell, const SphParameters &sph,
                                 const std::function<void(double)> &progress = {});
}  // namespace turgor
