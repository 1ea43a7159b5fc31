// Entries of an aggregate of bricks, and what of them goes together.
#include "micro/cells/brick_tissue.h"
#include "micro/cells/tissue_strip.h"
#include "micro/cells/turgid_limit.h"
#include "run/input_entries.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace turgor {
void BrickParameters::add_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Columns", columns, "Number of cells in each row of the aggregate. Units: none.",
                    Integer(1, 1000));
  prm.add_parameter("Rows", rows, "Number of rows of cells from the lower to the upper plate. Units: none.",
                    Integer(1, 1000));
  prm.add_parameter(
      "Sides", sides,
      "What is beside the aggregate. free: nothing, it is a block of bricks. cut: nothing, it is a block cut "
      "out of the tissue of the subsection Structure, whose RVEs have the same cells. periodic: itself "
      "without end, a strip of that tissue; it keeps the width that it has at turgor. widening: such a "
      "strip, whose width follows so that the mean stress along x is zero, as slow loading between plates "
      "leaves it. Units: none.");
  prm.add_parameter("Jitter", jitter,
                    "Sides = free: largest random displacement of a cell corner in x and in y over "
                    "Cell/Period; what is cut out has "
                    "Structure/Corner jitter. Units: none.",
                    Double(0., 0.2));
  prm.add_parameter("Gap", gap,
                    "Length without lamella ties at either end of a wall shared by two cells: 0 gives dense "
                    "tissue, more opens the "
                    "spaces between three cells; only with Sides = free, otherwise Structure/Gap. Units: m.",
                    Double(0., 1e-2));
  prm.add_parameter("Tissue seed", seed,
                    "Seed of the random displacements of Jitter: another one, another tissue. Units: none.",
                    Integer(0));
  prm.add_parameter("Rest residual", rest_residual,
                    "Largest force that may be left on a particle of the inflated tissue, over turgor times "
                    "the wall of a node (spacing times "
                    "depth). Units: none.",
                    Double(1e-5, 0.1));
  prm.add_parameter("Rest steps", rest_steps,
                    "Most steps in which the inflated tissue has to come to rest. Units: steps.",
                    Integer(1000, 100000000));
  prm.add_parameter("Contact ratio", contact_ratio,
                    "Stiffness of the contact between walls, and with the plates, over that of one wall "
                    "spring at rest. Where walls "
                    "break, it is between them at least what stops a torn wall that recoils, 59 (Critical "
                    "stretch - 1)^2. With Structure/Gap walls touch as across the air of RVEs, "
                    "in proportion to this: 0.5 is as there, the same force at half the contact's range. "
                    "Units: none.",
                    Double(1e-3, 100.));
  prm.add_parameter("Yielding", yielding,
                    "Wall yielding, thesis Eq. 3.8: none; reversible: force g(lambda) F(lambda) on the way "
                    "out and back; plastic: "
                    "what goes beyond that curve stays longer. Units: none.");
  declare_yield(prm, yield);
  prm.add_parameter(
      "Critical stretch", critical_stretch,
      "Length over rest length at which a wall bond breaks and its cell has failed; 0: never. Units: none.",
      Double(0., 100.));
  prm.add_parameter("Lamella strength", lamella_strength,
                    "Stress at which a lamella tie breaks, force over the wall area it stands for (spacing "
                    "times depth); 0: never. "
                    "Units: Pa.",
                    Double(0., 1e10));
  prm.enter_subsection("Structure");
  structure.add_parameters(prm);
  prm.leave_subsection();
}

ParenchymaParameters BrickParameters::yielding_cell(const ParenchymaParameters &cell) const {
  ParenchymaParameters yielding_cell = cell;
  yielding_cell.wall_yield = yielding == Yielding::none ? WallYield{} : yield;
  return yielding_cell;
}

NeoHookeanWall BrickParameters::wall_law(const ParenchymaParameters &cell) const {
  return yielding_cell(cell).wall_law();
}

void BrickParameters::check_sides(const ParenchymaParameters &cell) const {
  if (cut_out()) {
    check_strip(structure, yielding_cell(cell), rows, ends());
    if (gap > 0.)
      throw std::invalid_argument("Gap is not 0, but tissue cut out of RVEs (Sides = " + word_of(sides) +
                                  ") has their air spaces: use Gap = 0 and Structure/Gap, or Sides = free.");
    return;
  }
  if (structure.kind != StructureKind::brick || structure.jitter > 0. || structure.rotation != 0. ||
      structure.gap > 0. || structure.measured())
    throw std::invalid_argument(
        "The subsection Structure asks for other cells than bricks as they are laid, but with Sides = free "
        "the aggregate is a block of bricks (Jitter, Gap, Tissue seed): use Sides = cut, periodic or "
        "widening.");
}

double BrickParameters::turgid_side(const ParenchymaParameters &cell) const {
  // a honeycomb's cell of perimeter P has the area P^2/(8 sqrt(3))
  const double perimeter = 4. * cell.period;
  return perimeter * turgid_stretch(wall_law(cell), hexagonal_cell, perimeter, cell.depth, cell.turgor) /
         std::sqrt(hexagonal_cell);
}

void BrickParameters::check(const ParenchymaParameters &cell, const SphParameters &sph) const {
  const auto refuse = [](const auto &...parts) {
    std::ostringstream sentence;
    (sentence << ... << parts);
    throw std::invalid_argument(sentence.str());
  };
  check_sides(cell);
  const TurgidLimit limit = turgid_limit(wall_law(cell), round_cell, 4. * cell.period, cell.depth);
  if (!(cell.turgor < limit.pressure))
    refuse("Cell/Turgor is ", cell.turgor,
           " Pa, but a round cell with walls of Cell/Wall stiffness = ", cell.wall_stiffness,
           " N/m and a perimeter of four Cell/Period (", cell.period, " m) at rest",
           yielding == Yielding::none ? "" : ", with Yielding,", " holds at most ", limit.pressure,
           " Pa: beyond it walls stretch without end. Use less turgor, stiffer walls",
           yielding == Yielding::none ? "" : ", a smaller Yield drop", " or smaller cells.");
  if (cell.nodes_per_side % 2 != 0)
    refuse("Cell/Nodes per side is ", cell.nodes_per_side,
           ", but bricks need an even number: the row below meets a side in its middle.");
  if (sph.formulation != SphFormulation::variational)
    refuse("SPH/Formulation is ", word_of(sph.formulation),
           ", but tissue of bricks has only the variational fluid: use variational.");
  if (!(gap < 0.25 * cell.period))
    refuse("Gap is ", gap, " m, but it has to be less than a quarter of Cell/Period (", 0.25 * cell.period,
           " m): nothing would tie the cells of neighbouring rows.");
  if (critical_stretch > 0. && critical_stretch <= 1.)
    refuse("Critical stretch is ", critical_stretch,
           ", but it has to be above 1, or 0 for walls that do not break.");
  if (double(columns) * rows *
          (sph.particles_per_side * double(sph.particles_per_side) + 4. * cell.nodes_per_side) >
      1e8)
    refuse("Columns x Rows x Particles per side^2 is more than 1e8 particles: choose a smaller tissue.");
}
}  // namespace turgor
