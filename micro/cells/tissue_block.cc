#include "micro/cells/tissue_block.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace turgor
{
Surfaces surfaces_from(const std::string &name)
{
  if (name == "frozen")
    return Surfaces::frozen;
  if (name == "free")
    return Surfaces::free;
  if (name == "osmosis")
    return Surfaces::osmosis;
  if (name == "slab")
    return Surfaces::slab;
  throw std::invalid_argument("Surfaces is '" + name + "', but it has to be frozen, free, osmosis or slab.");
}

TissueBlock make_tissue_block(const ParenchymaParameters &cell, const SphParameters &sph,
                              const CellContents &reference, const unsigned int columns, const unsigned int rows,
                              const Surfaces surfaces)
{
  TissueBlock block;
  const bool slab = surfaces == Surfaces::slab;
  const CellLayout layout = make_parenchyma(cell, columns, rows, false, slab);
  block.cells = make_sph_patch(layout, sph, reference);
  block.width = columns * cell.period;
  block.density = block.cells->density();
  ParticleSystem<2> &system = block.cells->system;
  Particles<2> &particles = system.particles;

  if (surfaces == Surfaces::frozen || slab)
    {
      // The same ties as in the fully periodic grid, those that leave this block turned into what they pull now.
      const CellLayout all = make_parenchyma(cell, columns, rows, true, true);
      std::vector<DeadForce<2>::Entry> forces;
      for (const LamellaTie &tie : all.ties)
        {
          if (tie.shift[0] == 0 && (slab || tie.shift[1] == 0))
            continue;
          const std::uint32_t a = block.cells->particle(tie.a), b = block.cells->particle(tie.b);
          const Vector<2> gap = particles.position(b) - particles.position(a)
                                + all.lattice * Vector<2>(tie.shift[0], tie.shift[1]);
          forces.push_back({a, tie.stiffness * gap});
          forces.push_back({b, -tie.stiffness * gap});
        }
      system.add(std::make_unique<DeadForce<2>>(std::move(forces)));
    }
  block.body_force = &system.add(std::make_unique<BodyForce<2>>(Vector<2>::Zero()));

  // Clamp: the left side's ring nodes (side 3 and corner 0) of the first column.
  const std::uint32_t side = cell.nodes_per_side;
  for (unsigned int row = 0; row < rows; ++row)
    for (std::uint32_t k = 3 * side; k <= 4 * side; ++k)
      particles.inverse_mass[particles.groups[std::size_t(row) * columns].begin + k % (4 * side)] = 0.;

  double nearest = std::numeric_limits<double>::infinity();
  const double middle = 0.5 * rows * cell.period;
  for (const bool collect : {false, true})
    for (unsigned int row = 0; row < rows; ++row)
      for (std::uint32_t k = side; k <= 2 * side; ++k)
        {
          const std::uint32_t node = particles.groups[row * columns + columns - 1].begin + k;
          const double distance = std::abs((row + double(k - side) / side) * cell.period - middle);
          if (!collect)
            nearest = std::min(nearest, distance);
          else if (distance < nearest + 0.01 * layout.spacing)
            block.probe.push_back(node);
        }
  return block;
}
} // namespace turgor
