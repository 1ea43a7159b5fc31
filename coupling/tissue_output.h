// What a tissue of RVEs leaves behind in files: fields of the mesh over time, the mean
// displacement of every cell, and the outlines of a few RVEs at their quadrature points.
#pragma once

#include "coupling/rve_law.h"
#include "macro/tissue.h"
#include "micro/io/field_file.h"
#include "micro/io/run_context.h"

namespace turgor
{
/// The deformed mesh with displacement (m), velocity (m/s) at the nodes; Cauchy stress (Pa), pressure -tr(sigma)/2 (Pa)
/// and mean fluid pressure of the RVEs (Pa) per element.
FieldFrame tissue_frame(const Tissue<2> &tissue, const RveLaw<2> &law);

/// cell_displacement.csv: the displacement averaged over each of the cells x cells squares of side `period` (m),
/// by samples x samples points each. The square piece is [0, cells period]^2.
void write_cell_displacement(RunContext &context, const Tissue<2> &tissue, unsigned int cells, double period,
                             unsigned int samples);

/// rve_outlines.csv: rings of points (m) of the RVEs nearest to up to 9 spread places of the piece, with their
/// quadrature point (m, deformed), F, period (m), fluid pressure and shear stress (Pa); one block a call.
class RveOutlines
{
public:
  /// width: m, of the square piece.
  RveOutlines(RunContext &context, const Tissue<2> &tissue, unsigned int how_many, double width);

  /// The committed state. Collective.
  void write(const Tissue<2> &tissue, const RveLaw<2> &law, const Rve<2> &rve);

private:
  std::vector<std::size_t> chosen;
  std::unique_ptr<Series> table;
};
} // namespace turgor
