// What is around a population of cells and acts on it: terms of the population's system like all others
// (bodies that cells press against, the pressure of a dextran solution), and what processes ask of them.
//
//   Surroundings around;
//   around.walls = &around.add(std::make_unique<Obstacles<3>>("capsule", SphereOnSurface{material},
//     std::make_unique<ElasticCapsule>(capsule)));
//   around.join(cells, contacts);
#pragma once

#include "micro/engine/particle_system.h"
#include "micro/terms/obstacles.h"
#include "micro/terms/sphere_contacts.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace turgor {
struct Surroundings {
  Obstacles<3> *walls = nullptr;  ///< among the terms, if there are any

  /// At time t (s): the cells have grown and divided, the steps of an interval are about to begin (who is at
  /// the edge, what force holds the pressure).
  std::function<void(const Particles<3> &, double t)> update = [](const Particles<3> &, double) {};

  /// Columns that they add to the scene's series, and their values now, after the forces: {name, unit} and
  /// value.
  struct Value {
    std::string name, unit;
    double value = 0.;
  };
  std::function<std::vector<Value>(const Particles<3> &)> values = [](const Particles<3> &) {
    return std::vector<Value>();
  };

  /// Entries that drive the cells through it, as "Body/Load"; none where nothing does.
  std::string drivers;
  template <class T>
  T &add(std::unique_ptr<T> term) {
    T &reference = *term;
    terms.push_back(std::move(term));
    return reference;
  }

  /// The terms become those of a system, in the order in which they were added, its walls entries of the
  /// cells' list of contacts. References to them stay good.
  void join(ParticleSystem<3> &system, const SphereContacts &contacts) {
    for (auto &term : terms) system.add(std::move(term));
    terms.clear();
    if (walls) walls->listed_in(contacts.contact_list());
  }

  /// m, of a place below the surface of the nearest wall that lets through what cells live on.
  double depth_of(const Vector<3> &x) const { return walls ? walls->depth_of(x) : HUGE_VAL; }

  /// J, of one more cell at x (m); see Obstacles. What a division chooses its place by.
  double energy_of(const Vector<3> &x, const double radius, const double reference,
                   const double modulus) const {
    return walls ? walls->energy_of(x, radius, reference, modulus) : 0.;
  }

 private:
  std::vector<std::unique_ptr<Term<3>>> terms;  ///< until a system has them
};
}  // namespace turgor
