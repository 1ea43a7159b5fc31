// Cells of the rod model look for hold (thesis 2.3.3): between steps their protrusions contract and let go,
// free ones take hold of nodes, the polarity follows the forces, a cell that is stuck rounds up, and nodes at
// its front are degraded.
//
//   new ones      a free protrusion tries once in `waiting` in the mean: a node drawn at random of those
//                 outside of the cell and within `reach` of an end, A or B of a round cell, the front one of
//                 a polarised cell, which is taken with probability exp(-alpha^2/(2 sigma^2)) (2.40), alpha:
//                 to the polarity
//   polarity      P = sum F/|sum F| of the protrusions (2.42, whose mean of forces has no direction's unit);
//                 a round cell gets it once it has spread for a time
//   stuck         a polarised cell that has come less than `stuck` far in `patience` (T_max) lets all go and
//   is
//                 round again; its own springs round it
//   degradation   dk/dt = -lambda k of nodes that touch it within 45 degrees of P from its middle (2.39)
//
// Whatever is random is a function of seed, rod and step: same bits on any number of threads.
//
//   Protruding protruding(parameters, rods, protrusions, contacts);   cells.after_step = [&](double h) {
//   protruding.after_step(particles, h); };
#pragma once

#include "micro/geometry/bins.h"
#include "micro/terms/protrusions.h"
#include "micro/terms/rod_contacts.h"

#include <numbers>
#include <optional>

namespace turgor {
struct ProtrudingParameters {
  double reach = 12e-6;                     ///< m, l_max
  double waiting = 10.;                     ///< s
  double spread = 0.25 * std::numbers::pi;  ///< sigma
  double spreading = 60.;                   ///< s
  double patience = 600., stuck = 1e-6;     ///< s, m
  double degradation = 0.;                  ///< 1/s, lambda
  std::uint64_t seed = 1;
};

class Protruding {
 public:
  Protruding(const ProtrudingParameters &parameters, std::shared_ptr<RodSet> rods, Protrusions &protrusions,
             const RodContacts &contacts, std::uint32_t nodes);

  /// A step of h (s) has ended with the particles where they are.
  void after_step(Particles<3> &particles, double h);

  const Vector<3> &polarity(const std::size_t rod) const { return cells[rod].polarity; }
  bool polarised(const std::size_t rod) const { return cells[rod].polarised; }
  std::uint64_t rounded_up() const { return roundings; }  ///< how often any has
  std::uint64_t attached() const { return holds; }        ///< how often any protrusion took hold

  void archive(Archive &a);

 private:
  struct Cell {
    Vector<3> polarity = Vector<3>::Zero();
    Vector<3> place = Vector<3>::Zero();   ///< m, where it was when it was last looked after
    double round_since = 0., looked = 0.;  ///< s
    bool polarised = false, placed = false;
    void archive(Archive &a);
  };
  void orient(const Particles<3> &particles, std::size_t rod);
  void round_up(const Particles<3> &particles, std::size_t rod);
  void take_hold(const Particles<3> &particles, std::size_t rod, double h);
  void degrade(Particles<3> &particles, double h) const;
  /// Nodes within reach of a place and outside of the rod that it does not hold, by their numbers.
  std::vector<std::uint32_t> within_reach(const Particles<3> &particles, std::size_t rod,
                                          const Vector<3> &from);

  ProtrudingParameters parameters;
  std::shared_ptr<RodSet> rods;
  Protrusions &protrusions;
  const RodContacts &contacts;
  std::uint32_t nodes;
  std::vector<Cell> cells;
  std::optional<Bins<2>> by_place;  ///< the nodes of this step, once a cell has looked for hold
  double time = 0.;
  std::uint64_t step = 0, roundings = 0, holds = 0;
};
}  // namespace turgor
