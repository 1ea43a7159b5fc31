// The turgid, stress-balanced reference (F = I) of a periodic grid of cells.
//
// From a jittered lattice of fluid the cell is inflated and annealed: damped motion until the
// fluid is at rest, while osmosis (thesis Eq. 3.2, corrected: the whole cell's water is shared
// by its particles) fills it until the fluid's virial pressure balances the walls, that is
// until the mean stress of the periodic cell is zero. Wall tension then equals turgor times
// the period, so the pressure meant everywhere by p(A) is the VIRIAL pressure of the fluid; the
// mean of the particles' EOS pressure is reported beside it (they differ by particle disorder).
#pragma once

#include "micro/cells/sph_parenchyma.h"

#include <functional>

namespace turgor
{
/// progress(fraction) is called now and then. Throws std::runtime_error when the cell does not come to rest.
ReferenceCell make_turgid_reference(const ParenchymaParameters &cell, const SphParameters &sph,
                                    const std::function<void(double)> &progress = {});
} // namespace turgor
