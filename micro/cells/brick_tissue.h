// An aggregate of cells laid like bricks (brick_layout.h), before it is inflated (thesis 3.3.2): walls free
// of stress, fluid free of pressure. Osmosis then makes the honeycomb by itself. Where walls are tied all
// along (dense) there are no spaces; where they are not (sparse: not within `gap` of a wall's end) the
// corners round and open the space between three cells. Walls that are not tied hold each other by contact.
//
// Particles: cell by cell, row by row; within a cell the ring, then its fluid.
#pragma once

#include "micro/cells/brick_layout.h"
#include "micro/cells/sph_parenchyma.h"
#include "micro/cells/tissue_strip.h"
#include "micro/cells/tissue_structure.h"
#include "micro/terms/cell_contact.h"
#include "micro/terms/enclosed_fluid.h"
#include "micro/terms/lamella_ties.h"
#include "micro/terms/ring_wall.h"
#include "micro/laws/yielding.h"

#include <memory>
#include <string>
#include <vector>

namespace turgor {
/// What is beside an aggregate.
enum class TissueSides {
  free,      ///< nothing: a block of bricks (brick_layout.h)
  cut,       ///< nothing: a block cut out of the tissue that RVEs have (tissue_strip.h)
  periodic,  ///< itself: a strip (tissue_strip.h) that keeps the width it has at turgor without ends
  widening   ///< itself, the width following so that no mean stress is left along x
};
constexpr const char *words_of(TissueSides) { return "free|cut|periodic|widening"; }

struct BrickParameters {
  unsigned int columns = 5, rows = 5;
  TissueSides sides = TissueSides::free;
  TissueStructure structure{.kind = StructureKind::brick};  ///< of what is cut out of an RVE's tissue
  double jitter = 0.06;   ///< largest displacement of a corner in x and in y / Period
  double gap = 0.;        ///< m, length without ties at either end of a shared wall; 0: dense
  unsigned int seed = 1;  ///< of the jitter
  static constexpr double usual_contact_ratio = 0.5;
  double contact_ratio =
      usual_contact_ratio;  ///< contact stiffness / tangent stiffness of one wall spring at rest
  Yielding yielding = Yielding::none;
  WallYield yield{15., 0.9};
  double critical_stretch = 0.;      ///< of a wall bond; 0: does not break
  double rest_residual = 5e-3;       ///< tissue_inflation.h
  unsigned int rest_steps = 200000;  ///< at most
  double lamella_strength = 0.;      ///< Pa on the wall's area that one tie stands for; 0: does not break

  NeoHookeanWall wall_law(const ParenchymaParameters &cell) const;  ///< while it is loaded, yielding included
  /// m, root of a cell's area in a regular honeycomb at turgor: the fluid's spacing is that over Particles
  /// per side.
  double turgid_side(const ParenchymaParameters &cell) const;
  ParenchymaParameters yielding_cell(const ParenchymaParameters &cell) const;
  /// Throws std::invalid_argument with a sentence for entries that do not go together.
  void check(const ParenchymaParameters &cell, const SphParameters &sph) const;
  void add_parameters(InputEntries &prm);

  bool cut_out() const { return sides != TissueSides::free; }  ///< of the tissue of `structure`
  BrickLayout lay(const ParenchymaParameters &cell) const;

 private:
  StripEnds ends() const { return sides == TissueSides::cut ? StripEnds::all : StripEnds::above_and_below; }
  /// What does not go together with these sides.
  void check_sides(const ParenchymaParameters &cell) const;
};

struct BrickTissue {
  BrickLayout layout;  ///< as laid
  ParticleSystem<2> system;
  RingWall *wall = nullptr;
  CellFluid<2> *fluid = nullptr;  ///< of particles; null where one pressure fills the cells
  LamellaTies *ties = nullptr;    ///< null where no cells touch
  CellContact *contact = nullptr;
  std::shared_ptr<WallDamage> damage;  ///< null where bonds do not break
  std::shared_ptr<WallFlow>
      flow;  ///< null without plastic yielding; the wall gets it when it is inflated (tissue_inflation.h)
  double spacing = 0.;           ///< m, mean length of a bond at rest
  double spring_stiffness = 0.;  ///< N/m, of one wall spring at rest
  double lightest_node = 0.;     ///< kg

  /// Bonds between a node of the ring and the nearest place where three cells meet; the whole ring where
  /// there is none.
  std::uint32_t to_junction(std::size_t cell, std::uint32_t node) const;
  double cell_area(std::size_t cell) const;              ///< m^2
  double mean_cell_area() const;                         ///< m^2
  double mean_stretch() const, largest_stretch() const;  ///< of all bonds of walls
  /// Share of the area not covered by any cell, in the box of the centres of the outermost cells (points on a
  /// grid).
  double void_fraction() const;
  /// rad; root mean square of (angle of a cell at a junction - 120 degrees), walls taken a quarter of a cell
  /// side long.
  double angle_deviation() const;
};

enum class BrickFilling {
  particles,  ///< SPH fluid, free of pressure; walls that can break and flow
  pressure    ///< no particles, turgor in every cell, held; walls stretch along the yield curve
};

std::unique_ptr<BrickTissue> make_brick_tissue(const ParenchymaParameters &cell, const SphParameters &sph,
                                               const BrickParameters &brick,
                                               BrickFilling filling = BrickFilling::particles);

/// Places the cell's fluid evenly within its ring, whatever its shape, a little at random (even_points.h).
void lay_fluid(Particles<2> &particles, std::size_t cell, unsigned int seed);
}  // namespace turgor
