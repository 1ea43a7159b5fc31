// What a tissue of RVEs leaves behind in files: fields of the mesh over time, the mean
// displacement of every cell, and the outlines of a few RVEs at their quadrature points.
#pragma once

#include "coupling/rve_law.h"
#include "macro/tissue.h"
#include "run/field_file.h"
#include "run/run_context.h"

#include <array>
#include <vector>

namespace turgor {
/// The deformed mesh with displacement (m), velocity (m/s) at the nodes; Cauchy stress (Pa), pressure
/// -tr(sigma)/2 (Pa) mean fluid pressure of the RVEs (Pa) and, where cells can fail or flow, the share of
/// failed cells and the permanent stretch of the walls, per element.
FieldFrame tissue_frame(const Tissue<2> &tissue, const RveLaw<2> &law);

/// The mesh in the last trial in which a point failed, displacement (m), and per element whether one of its
/// points did; no points where none has.
FieldFrame failing_tissue_frame(const Tissue<2> &tissue);

/// cell_displacement.csv: the displacement averaged over each of the cells[0] x cells[1] rectangles of
/// cell_size (m), by samples x samples points each. The piece is as large as all of them.
void write_cell_displacement(RunContext &context, const Tissue<2> &tissue,
                             const std::array<unsigned int, 2> &cells, const std::array<double, 2> &cell_size,
                             unsigned int samples);

/// rve_outlines.csv: rings of points (m) of the RVEs nearest to some places of the piece, with their
/// quadrature point (m, deformed), F, periods (m; all four components where they are oblique), fluid pressure
/// and shear stress (Pa); one block a call.
class RveOutlines {
 public:
  /// lattice: m, of the RVEs; places: shares of width and height, the most telling first; how_many of them,
  /// none twice.
  RveOutlines(RunContext &context, const Tissue<2> &tissue, const Tensor2<2> &lattice, unsigned int how_many,
              const std::vector<std::array<double, 2>> &places);

  /// The committed state. Collective.
  void write(const Tissue<2> &tissue, const RveLaw<2> &law, const Rve<2> &rve);

 private:
  bool oblique;  ///< the RVEs' periods are not those of x and y
  std::vector<std::size_t> chosen;
  std::unique_ptr<Series> table;
};
}  // namespace turgor
