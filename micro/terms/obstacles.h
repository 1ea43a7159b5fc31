// Particles of any scene against bodies of any shape: every law (surface_laws.h) with every obstacle (obstacle.h), in one loop. The forces
// on particles are -dE/dx; the reaction goes to the body, group by group.
//
//   system.add(std::make_unique<Obstacles<2>>("plates", SurfacePenalty{k}, floor, lid))     floor, lid: std::unique_ptr<Plane<2>>
//   ...[0].velocity[1] = 0.1;   ...[0].pressing()                                           m/s, N
//
// Who touches is asked (for_touches), not left over from the forces: friction, stress and implicit steps of spheres ask it. A body whose
// shape answers to what presses (an elastic capsule) settles in prepare(), before the forces, or at the end of a step if it has a friction of
// its own. Fields read by SphereOnSurface: radius (m), modulus (Pa), reference_volume (m^3, if any).
#pragma once

#include "micro/engine/term.h"
#include "micro/geometry/obstacle.h"
#include "micro/terms/surface_laws.h"

#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace turgor
{
template <int dim>
class Obstacles final : public Term<dim>
{
public:
  using Contact = typename Obstacle<dim>::Contact;

  /// Bodies in the order in which they act.
  template <class... Body>
  Obstacles(std::string name_, SurfaceLaw law_, std::unique_ptr<Body>... body)
    : own_name(std::move(name_))
    , law(std::move(law_))
  {
    (bodies.push_back(std::move(body)), ...);
  }

  std::string name() const override { return own_name; }
  void declare(Particles<dim> &particles) override;
  void prepare(const Particles<dim> &particles, const Box<dim> &box, unsigned int threads, bool trial) override;
  void add_forces(Particles<dim> &particles, const Box<dim> &box, std::size_t group) override;
  /// Links to bodies of given velocity: friction by the area of the contact, with h (s) the slope of the force along the normal too.
  void collect(MotionMatrix &matrix, const Particles<dim> &particles, double h) override;
  void advance(const Particles<dim> &particles, double dt) override;
  double energy(const Particles<dim> &particles, const Box<dim> &box, std::size_t group) const override;
  void add_virials(const Particles<dim> &particles, std::vector<Tensor2<dim>> &virial) const override;
  bool fast() const override { return true; }
  Rates rates(const Particles<dim> &particles) const override;
  void archive(Archive &a, Particles<dim> &particles) override;

  std::size_t size() const { return bodies.size(); }
  Obstacle<dim> &operator[](const std::size_t k) { return *bodies[k]; }
  const Obstacle<dim> &operator[](const std::size_t k) const { return *bodies[k]; }

  /// visit(particle, contact with the body, what the law makes of it[, the body, the particle's place]), body by body, particles in their order.
  template <class Visit>
  void for_touches(const Particles<dim> &particles, const Visit &visit) const
  {
    std::visit(
      [&](const auto &one) {
        const auto view = one.on(particles);
        for (const auto &body : bodies)
          for (const Group &g : particles.groups)
            for_group(view, particles, *body, g, [&](const std::size_t i, const Vector<dim> &x, const Contact &c) {
              if constexpr (std::is_invocable_v<Visit, std::size_t, const Contact &, const SphereContact &, const Obstacle<dim> &, const Vector<dim> &>)
                visit(i, c, view(i, c.distance, c.curvature), *body, x);
              else
                visit(i, c, view(i, c.distance, c.curvature));
            });
      },
      law);
  }

  double friction() const; ///< N s/m^3, of what touches, by the area of its contact
  /// gamma (N s/m) += the friction of each particle with the bodies, where forces were last asked.
  void add_friction(const Particles<dim> &particles, std::vector<double> &gamma) const;

  /// Of what cells live on: m, of a place below the surface of the nearest body that lets it through; infinite where there is none.
  double depth_of(const Vector<dim> &x) const;

  /// J, of one more cell at x (m) with radius and uncompressed radius (m) and modulus (Pa), to a few per cent; infinite where it cannot be.
  double energy_of(const Vector<dim> &x, double radius, double reference, double modulus) const;

  double deepest() const; ///< m, of the particle farthest behind a surface; of the last evaluation
  double work() const;    ///< J, done on the particles by all bodies since the start, by the trapezoidal rule, the last step included

private:
  /// visit(i, x, contact) for all particles of a group that feel the body.
  template <class View, class Visit>
  static void for_group(const View &view, const Particles<dim> &particles, const Obstacle<dim> &body, const Group &g, const Visit &visit)
  {
    const auto [begin, end] = view.holds_for(g);
    for (std::uint32_t i = begin; i < end; ++i)
      {
        const Vector<dim> x = particles.position(i);
        const double reach = view.reach(i);
        const Contact c = body.at(x, reach);
        if (c.distance < reach)
          visit(i, x, c);
      }
  }
  /// The bodies whose shape answers, into balance with what presses on them; dt (s): 0 at once.
  void settle(const Particles<dim> &particles, double dt);

  std::string own_name;
  SurfaceLaw law;
  std::vector<std::unique_ptr<Obstacle<dim>>> bodies;
  std::vector<std::size_t> number; ///< of this term with each body
  double done = 0.; ///< J, all but the half of the last step that its force is still to come for
};

extern template class Obstacles<2>;
extern template class Obstacles<3>;
} // namespace turgor
