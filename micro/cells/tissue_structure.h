// How the cells of a tissue lie: the entries of the subsection Structure, one set for every scene, and the
// tissue they make.
//
//   square   square cells (parenchyma.h), of the inflated side Cell/Period
//   hexagon  regular honeycomb            |
//   brick    rows moved by half a cell    |  flat walls without stress, cells of the mean area Cell/Period^2
//            before turgor stretches them
//   voronoi  Laguerre cells of given areas|
//   polygons, image   Laguerre cells as large, and of areas as different, as the cells of a tissue that is
//                     given: corners in a table, or a
//            segmented picture; what is given is bounded, an RVE is periodic
//
// With a gap there are air spaces between the cells (air_spaces.h), and square cells too are laid with flat
// walls and find their period at turgor.
//
//   TissueStructure structure; structure.add_parameters(prm); ... structure.check();
//   HydrostaticNetwork network(turgid_tissue(structure, cell, 4, 4));
//
// A table of polygons has the columns cell, x, y (m): one row a corner, those of a cell one after the other.
// In and out: m, degrees where it says so.
#pragma once

#include "micro/cells/cell_layout.h"
#include "micro/geometry/tiling.h"
#include "run/choice.h"

#include <string>

namespace turgor {
class InputEntries;
enum class StructureKind { square, hexagon, brick, voronoi, polygons, image };
constexpr const char *words_of(StructureKind) { return "square|hexagon|brick|voronoi|polygons|image"; }

/// Of many cells: copies side by side as their own lattice has them, which leans where rows are moved by half
/// a cell; or at right angles, as a block with sides has them.
enum class Periods { leaning, upright };

struct TissueStructure {
  StructureKind kind = StructureKind::square;
  unsigned int seed = 1;
  double rotation = 0.;       ///< degrees, counter-clockwise
  double jitter = 0.;         ///< of hexagons' and bricks' corners, over Cell/Period
  double gap = 0.;            ///< m, without ties at either end of a wall that two cells share; 0: dense
  double area_scatter = 0.2;  ///< of Laguerre cells: standard deviation of their areas over the mean
  unsigned int ordering = 5;  ///< of Laguerre cells: rounds in which seeds go to the centroids of their cells

  std::string file = "none";    ///< of polygons or image
  double pixel = 1e-6;          ///< m
  unsigned int line_width = 2;  ///< pixels, of the lines without label between cells

  bool measured() const { return kind == StructureKind::polygons || kind == StructureKind::image; }
  /// The tissue of the file, bounded. Throws InputError where it is none.
  Tiling given() const;

  /// Square cells as they have always been: dense, of a period that is known at turgor.
  bool square() const { return kind == StructureKind::square && !(gap > 0.); }
  /// " brick", " hexagon" ...: how to call such cells in a sentence; nothing of square ones.
  std::string words() const { return square() ? "" : " " + word_of(kind); }

  /// Declares the entries above in the current subsection of prm.
  void add_parameters(InputEntries &prm);
  /// Throws std::invalid_argument, entry and what is allowed in one sentence.
  void check() const;
  /// Throws InputError for what is wrong with Tissue file, and for cells of it that are too small for walls
  /// of this thickness (m); nothing without a file.
  void check_file(double wall_thickness) const;

  /// columns x rows cells before they are turned, without sides shorter than `shortest` (m).
  Tiling tiling(double side, unsigned int columns, unsigned int rows, double shortest,
                Periods periods = Periods::leaning) const;
};

/// Throws std::invalid_argument for turgor that no wall of cells of another shape than squares holds.
void require_walls_that_hold(const TissueStructure &structure, const ParenchymaParameters &cell);

/// columns x rows periodic cells as they are laid, before turgor: nodes, bonds and ties are those of
/// turgid_tissue(). Throws std::invalid_argument.
CellLayout laid_tissue(const TissueStructure &structure, ParenchymaParameters cell, unsigned int columns,
                       unsigned int rows, Periods periods = Periods::leaning);

/// The same at turgor, turned: the reference F = I of an RVE. Throws std::invalid_argument.
CellLayout turgid_tissue(const TissueStructure &structure, const ParenchymaParameters &cell,
                         unsigned int columns, unsigned int rows, Periods periods = Periods::leaning);
}  // namespace turgor
