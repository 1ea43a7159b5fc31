// A population of centre-based cells with all that moves it: contacts, friction, the over-damped engine,
// surroundings, and the life of the cells between its steps. What the scenes of spheroids and monolayers run.
//
// An interval of length h: life at its start (volumes, divisions, deaths over h), then the engine's steps
// until its end. h follows from a tolerance: an uncompressed cell's radius grows by at most that share within
// h, h = 3 tolerance T/ln 2. Both the coupling and C.3 are first order in h.
//
// Cells are sorted in space (space_order.h) whenever their number has grown by a tenth; whoever writes them
// restores the order of ids.
//
// Checkpoints are taken between intervals; a resumed run has the bits of one that was never stopped.
#pragma once

#include "micro/engine/overdamped.h"
#include "micro/processes/cell_life.h"
#include "micro/engine/system_motion.h"
#include "micro/terms/cell_migration.h"
#include "micro/terms/sphere_contacts.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace turgor {
struct CultureParameters {
  CellLifeParameters life;
  std::string law = "jkr";  ///< contact_law.h
  double adhesion = 1e-4;   ///< W, J/m^2
  PairFriction friction{.normal = 5e10, .tangential = 5e10};
  SolveParameters solve{.tolerance = 1e-5};
  double medium_friction = 5e8;             ///< N s/m^3, of the cell's surface 4 pi R^2
  std::optional<LocalStiffness> stiffness;  ///< none: moduli do not depend on the packing
  CompressionOf compression = CompressionOf::cell;
  double motility = 0.;           ///< D, m^2/s
  MigrationParameters migration;  ///< force 0: none
  bool in_plane = false;          ///< cells move by themselves in x and y alone
  OverdampedParameters motion;
  double growth_tolerance = 2e-3;
  double interval = 0.;  ///< h, s; 0: from the tolerance
};

ContactLaw contact_law(const CultureParameters &parameters);

class CellCulture {
 public:
  CellCulture(const CultureParameters &parameters, Surroundings surroundings, unsigned int threads);

  /// One interval, or what is left of it until `end` (s). With `stop`, which is asked after every step: false
  /// if it said so inside the interval; saved there or not, the next call goes on as if nothing had been.
  bool advance(double end, const std::function<bool()> &stop = {});

  /// Pa, of all cells, at the present positions.
  const std::vector<double> &pressures();

  double time() const { return t; }
  double interval() const { return h; }  ///< s
  void restart_clock() { t = until = 0.; }

  CellPopulation cells;
  CellLife life;
  Surroundings surroundings;
  std::uint64_t steps = 0;

  std::vector<std::string> term_names() const;
  const SphereContacts &contact() const { return contacts; }
  std::uint64_t rejected() const { return stepper.rejected(); }
  double next_step() const { return stepper.next_step(); }
  /// The longest way that any cell has gone within one interval, so far, in mean radii. Beyond 100 the
  /// interval fails: pressures, neighbours and rims of cells would belong to another place.
  double farthest() const { return most; }

  void archive(Archive &a);

 private:
  void begin_interval();
  void set_friction();
  /// After a step; throws std::runtime_error where a cell has gone too far.
  void follow_ways();
  std::string drivers() const;  ///< what drives the cells, entries in brackets; may be none
  /// s, of at most `limit`. Throws std::runtime_error; where it is for the cells' friction it names the
  /// entries.
  double step(double limit);
  double longest_step() const;  ///< s, in which neither polarity nor random forces carry a cell too far
  /// Cells near in space near in memory; now and then, as the population grows.
  void sort();
  bool migrates() const { return parameters.migration.force > 0.; }
  int directions() const { return parameters.in_plane ? 2 : 3; }

  CultureParameters parameters;
  SphereContacts &contacts;
  SystemMotion<3> motion;
  Overdamped<3> stepper;
  double t = 0., h;
  double until = 0.;              ///< s, end of the interval that was begun
  std::uint64_t sorted_size = 0;  ///< cells when they were last sorted
  Particles<3>::Components from;  ///< m, where the cells were when the interval began
  double way = 0.;                ///< m, by no more than which any has moved since
  double most = 0.;               ///< mean radii, of the intervals so far
};
}  // namespace turgor
