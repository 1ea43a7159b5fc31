// The life of all cells of a population over an interval between steps of the engine: pressure, volume, growth, rest, division,
// death (thesis 5.3.1, C.1-C.3; each law in its own file: cell_volume.h, cell_growth.h, cell_cycle.h, cell_death.h,
// cell_division.h, cell_variability.h).
//
// At the start of the interval dt, for every cell: p from its virial stress; eps relaxes towards the strain at rest under p;
// f(eps); a dead cell goes on with its lysis; a living one dies, rests or advances in its cycle. Then volumes and radii are those
// of the end, and cells divide or are taken away. First order in dt.
//
// Of a sphere: reference_volume (m^3). Of a cell: strain (no unit), phase (no unit), cycle_time (s), bulk_modulus (Pa), with necrosis
// volume_at_death (m^3).
#pragma once

#include "micro/cells/cell_population.h"
#include "micro/cells/surroundings.h"
#include "micro/laws/cell_cycle.h"
#include "micro/laws/cell_death.h"
#include "micro/processes/cell_division.h"
#include "micro/laws/cell_variability.h"
#include "micro/laws/cell_volume.h"

#include <functional>
#include <memory>
#include <vector>

namespace turgor
{
struct CellLifeParameters
{
  double birth_radius = 6e-6;       ///< m, uncompressed
  double cycle_time = 17. * 3600.;  ///< mean T, s
  double modulus = 450.;            ///< mean Young's E of the contacts, Pa
  double poisson = 0.4;
  double bulk_modulus = 5e3;        ///< mean K_0, Pa
  double relaxation = 2. * 3600.;   ///< T_rel, s
  CellVolumeLaw volume;
  GrowthLaw growth;
  CellCycle cycle;
  CellDeath death;
  CellDivision division;
  CellVariability variability;
};

class CellLife
{
public:
  explicit CellLife(const CellLifeParameters &parameters);

  void declare(Particles<3> &particles) const;

  /// A cell with its fields at a phase of its cycle, uncompressed.
  void add(CellPopulation &cells, const Vector<3> &x, double phase) const;

  /// The life over dt (s). Contacts are those of the present positions (add_forces). gather_others(places): all that keeps
  /// something per cell beside the population; called where cells divide or go.
  void advance(CellPopulation &cells, const SphereContacts &contacts,
               const Surroundings &surroundings, double dt, unsigned int threads,
               const std::function<void(const Rearrangement &)> &gather_others);

  /// Pa, of each cell, from contacts at the present positions.
  const std::vector<double> &measure_pressures(const CellPopulation &cells, const SphereContacts &contacts, unsigned int threads);

  void set_rim_thickness(const double thickness) { parameters.death.rim_thickness = thickness; } ///< m

  double birth_volume() const { return V_0; } ///< m^3
  double volume(const CellPopulation &cells, std::size_t i) const;

  std::uint64_t divisions = 0, deaths = 0, removed = 0;
  double grown = 0., drained = 0.; ///< m^3 of uncompressed volume, so far: made by growth; lost by lysis, remains taken away included

private:
  void draw(CellPopulation &cells, std::size_t i) const; ///< what depends on the id
  /// Of each cell: whether it is deeper than the viable rim.
  std::vector<unsigned char> below_rim(const Particles<3> &p, const Surroundings &surroundings) const;

  CellLifeParameters parameters;
  double V_0;
  std::vector<Tensor2<3>> virial;
  std::vector<double> pressure;
};
} // namespace turgor
