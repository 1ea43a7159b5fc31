// What is around a population of cells and acts on it: a wall, a capsule, the pressure of a dextran solution. A scene of
// spheroids has a list of them (spheroid_scene.h); each is one file in micro/terms or micro/processes.
//
// In a step (Overdamped's outer forces): add_forces. After a step: advance, for bodies of its own (the capsule's radius).
// Between steps, at the times of the processes: add_virial (the stress that cells feel from it), then, when cells have
// grown and divided, update (who is at the edge, what force holds the pressure).
#pragma once

#include "micro/cells/cell_population.h"
#include "micro/geometry/tensor.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace turgor
{
class Archive;

class Surroundings
{
public:
  virtual ~Surroundings() = default;

  /// Of the entry in active_terms.
  virtual std::string name() const = 0;

  /// particles.f += forces (N); from one thread, also at trial positions.
  virtual void add_forces(Particles<3> &particles) = 0;

  /// gamma += friction of cells with it, N s/m.
  virtual void add_friction(const Particles<3> &, std::vector<double> & /*gamma*/) const {}

  /// stiffness += slope of its force on a cell over the way towards it (N/m), for implicit steps.
  virtual void add_stiffness(const Particles<3> &, std::vector<double> & /*stiffness*/) const {}

  /// A step of dt (s) has been taken; particles are where it ended.
  virtual void advance(const Particles<3> &, double /*dt*/) {}

  /// At time t (s): the cells have grown and divided, the steps of an interval are about to begin.
  virtual void update(const CellPopulation &, double /*t*/) {}

  /// m, of a place below its surface, from which the viable rim counts; infinite where it has none.
  virtual double depth_of(const Vector<3> & /*x*/) const { return HUGE_VAL; }

  /// virial[i] += sum of f (x) r over its contacts with cell i (N m): f on the cell, r from its centre to the contact.
  virtual void add_virial(const Particles<3> &, std::vector<Tensor2<3>> & /*virial*/) const {}

  /// The cells have other places.
  virtual void gather(const Rearrangement &) {}

  /// J, of one more cell at x (m) with radius and uncompressed radius (m) and modulus (Pa), all else being what it was at the last
  /// add_forces; infinite where it cannot be. What a division chooses its place by.
  virtual double energy_of(const Vector<3> & /*x*/, double /*radius*/, double /*reference*/, double /*modulus*/) const { return 0.; }

  /// Columns it adds to the scene's series, and their values now: {name, unit} and value.
  struct Value
  {
    std::string name, unit;
    double value = 0.;
  };
  virtual std::vector<Value> values(const CellPopulation &) const { return {}; }

  virtual void archive(Archive &) {}
};
} // namespace turgor
