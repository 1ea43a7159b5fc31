// Particles of any scene against bodies of any shape: every law (surface_laws.h) with every obstacle
// (obstacle.h), in one loop. The forces on particles are -dE/dx; the reaction goes to the body, group by
// group.
//
//   system.add(std::make_unique<Obstacles<2>>("plates", SurfacePenalty{k}, floor, lid))     floor, lid:
//     std::unique_ptr<Plane<2>>
//   ...[0].velocity[1] = 0.1;   ...[0].pressing()                                           m/s, N
//
// Spheres share one list of contacts with their pairs (contact_list.h): those next to a body are in it, and
// no others are asked.
//
//   walls.listed_in(contacts.contact_list());          contacts: SphereContacts
//
// Who touches is asked (for_touches), not left over from the forces: friction, stress and implicit steps of
// spheres ask it. A body whose shape answers to what presses (an elastic capsule) settles in prepare(),
// before the forces, or at the end of a step if it has a friction of its own. Fields read by SphereOnSurface:
// radius (m), modulus (Pa), reference_volume (m^3, if any).
#pragma once

#include "micro/engine/contact_list.h"
#include "micro/engine/term.h"
#include "micro/geometry/obstacle.h"
#include "micro/terms/dragged_bodies.h"
#include "micro/terms/surface_laws.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace turgor {
template <int dim>
class Obstacles final : public Term<dim> {
 public:
  using Contact = typename Obstacle<dim>::Contact;

  /// Bodies in the order in which they act.
  template <class... Body>
  Obstacles(std::string name_, SurfaceLaw law_, std::unique_ptr<Body>... body)
      : own_name(std::move(name_)), law(std::move(law_)) {
    (bodies.push_back(std::move(body)), ...);
  }

  std::string name() const override { return own_name; }
  void declare(Particles<dim> &particles) override;
  void prepare(const Particles<dim> &particles, const Box<dim> &box, unsigned int threads,
               bool trial) override;
  void add_forces(Particles<dim> &particles, const Box<dim> &box, std::size_t group) override {
    add_forces_of(particles, box, group, group + 1);
  }
  void add_forces_of(Particles<dim> &particles, const Box<dim> &box, std::size_t begin,
                     std::size_t end) override;
  /// Links to bodies of given velocity, rows with those that forces move: friction by the area of the
  /// contact, with h (s) the slope of the force along the normal too.
  void collect(MotionMatrix &matrix, const Particles<dim> &particles, double h) override;
  MovedBodies<dim> *moved_bodies() override { return dragged.choose(bodies) ? &dragged : nullptr; }
  void advance(const Particles<dim> &particles, double dt) override;
  double energy(const Particles<dim> &particles, const Box<dim> &box, std::size_t group) const override;
  void add_virials(const Particles<dim> &particles, std::vector<Tensor2<dim>> &virial) const override;
  bool fast() const override { return true; }
  Rates rates(const Particles<dim> &particles) const override;
  void archive(Archive &a, Particles<dim> &particles) override;

  /// The bodies become entries of a list of contacts: only spheres that it has next to them are looked at
  /// from now on.
  void listed_in(std::shared_ptr<ContactList<dim>> list);

  std::size_t size() const { return bodies.size(); }
  Obstacle<dim> &operator[](const std::size_t k) { return *bodies[k]; }
  const Obstacle<dim> &operator[](const std::size_t k) const { return *bodies[k]; }

  struct Touch {
    std::size_t particle;
    const Vector<dim> &x;    ///< m, of the particle
    const Contact &contact;  ///< with the body
    SphereContact does;      ///< what the law makes of it
    const Obstacle<dim> &body;
    Vector<dim> force;  ///< N, on the particle
  };
  /// visit(touch), body by body, particles in their order.
  template <class Visit>
  void for_touches(const Particles<dim> &particles, const Visit &visit) const {
    const bool listed = list && list->covers(particles);
    std::visit(
        [&](const auto &one) {
          const auto view = one.on(particles);
          for (std::size_t k = 0; k < bodies.size(); ++k)
            for_groups(view, particles, k, 0, particles.groups.size(), listed,
                       [&](std::size_t, const std::size_t i, const Vector<dim> &x, const Contact &c) {
                         const SphereContact does = view(i, c.distance, c.curvature);
                         Vector<dim> force = does.force * c.normal;
                         if (c.bend.squaredNorm() > 0.)
                           force -= view.by_curvature(i, c.distance, c.curvature) * c.bend;
                         visit(Touch{i, x, c, does, *bodies[k], force});
                       });
        },
        law);
  }

  double friction() const;  ///< N s/m^3, of what touches, by the area of its contact
  /// gamma (N s/m) += the friction of each particle with the bodies, where forces were last asked.
  void add_friction(const Particles<dim> &particles, std::vector<double> &gamma) const override;

  /// Of what cells live on: m, of a place below the surface of the nearest body that lets it through;
  /// infinite where there is none.
  double depth_of(const Vector<dim> &x) const;

  /// J, of one more cell at x (m) with radius and uncompressed radius (m) and modulus (Pa), to a few per
  /// cent; infinite where it cannot be.
  double energy_of(const Vector<dim> &x, double radius, double reference, double modulus) const;

  double deepest() const;  ///< m, of the particle farthest behind a surface; of the last evaluation
  double work() const;  ///< J, done on the particles by all bodies since the start, by the trapezoidal rule,
                        ///< the last step included

 private:
  /// look(group, i) for the particles of the groups [begin, end) that may feel body k. listed: for those
  /// alone that are next to it in the list.
  template <class View, class Look>
  void for_candidates(const View &view, const Particles<dim> &particles, const std::size_t k,
                      const std::size_t begin, const std::size_t end, const bool listed,
                      const Look &look) const {
    const std::vector<std::uint32_t> none, &near = listed ? list->next_to(entry[k]) : none;
    auto next =
        begin < end ? std::lower_bound(near.begin(), near.end(), particles.groups[begin].begin) : near.end();
    for (std::size_t group = begin; group < end && (!listed || next != near.end()); ++group) {
      const auto [first, last] = view.holds_for(particles.groups[group]);
      if (!listed)
        for (std::uint32_t i = first; i < last; ++i) look(group, i);
      for (; next != near.end() && *next < particles.groups[group].end; ++next)
        if (*next >= first && *next < last) look(group, *next);
    }
  }
  /// visit(group, i, x, contact) for those that do feel it.
  template <class View, class Visit>
  void for_groups(const View &view, const Particles<dim> &particles, const std::size_t k,
                  const std::size_t begin, const std::size_t end, const bool listed,
                  const Visit &visit) const {
    for_candidates(view, particles, k, begin, end, listed,
                   [&](const std::size_t group, const std::uint32_t i) {
                     const Vector<dim> x = particles.position(i);
                     const double reach = view.reach(i);
                     const Contact c = bodies[k]->at(x, reach);
                     if (c.distance < reach) visit(group, i, x, c);
                   });
  }
  /// The bodies whose shape answers, into balance with what presses on them; dt (s): 0 at once.
  void settle(const Particles<dim> &particles, double dt, bool listed);

  std::string own_name;
  SurfaceLaw law;
  std::vector<std::unique_ptr<Obstacle<dim>>> bodies;
  DraggedBodies<dim> dragged;
  std::vector<std::size_t> number;         ///< of this term with each body
  std::shared_ptr<ContactList<dim>> list;  ///< none: all particles are asked
  std::vector<std::size_t> entry;          ///< of each body in it
  double done = 0.;  ///< J, all but the half of the last step that its force is still to come for
};

extern template class Obstacles<2>;
extern template class Obstacles<3>;
}  // namespace turgor
