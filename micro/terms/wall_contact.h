// A cell against a wall, plane or spherical: Hertz (thesis Eq. 2.5, 2.6) with the wall's own radius and
// modulus, no adhesion.
//
//   F = 4/3 E sqrt(R) delta^(3/2),  delta = R_i - w,  w: distance of the cell's centre from the wall
//   1/R = 1/R_i + curvature (plane 0; convex wall 1/R_w; the inside of a sphere -1/R_w),  1/E = 1/E_i + 1/E_w
//
// With a local stiffness (local_stiffness.h) the wall counts as a mirror image of the cell: E_i -> E_i g(d),
// d = 1 - w/R_ref,i, of this contact alone, so that F is a function of w and conservative. The energy is the
// integral of F over the overlap.
//
// In: m, Pa. E_i and E_w carry their 1 - nu^2. Out: N, N/m, m^2.
#pragma once

#include "micro/engine/particles.h"
#include "micro/laws/local_stiffness.h"
#include "micro/laws/overlap_energy.h"
#include "micro/laws/sphere_contact.h"

#include <numbers>
#include <optional>

namespace turgor {
struct WallMaterial {
  double modulus = HUGE_VAL;                     ///< Pa, E/(1 - nu^2) of the wall; infinite: rigid
  double friction = 0.;                          ///< N s/m^3, with cells in contact
  std::optional<LocalStiffness> stiffness = {};  ///< of the cells; none: their own modulus

  /// R: radius of the cell, R_ref: uncompressed, E: its modulus, curvature: 1/m, w: m. delta > 0.
  SphereContact operator()(const double R, const double R_ref, const double E, const double curvature,
                           const double w) const {
    LocalStiffness::Value g;
    if (stiffness) g = (*stiffness)(1. - w / R_ref);
    const double cell = E * g.factor, share = std::isfinite(modulus) ? modulus / (cell + modulus) : 1.;
    const double R_eff = 1. / (1. / R + curvature);
    SphereContact c = HertzContact()(R_eff, cell * share, R - w);
    c.stiffness += c.force / g.factor * share * g.slope / R_ref;  // dE/dw of the pair: E_i' share^2
    return c;
  }

  /// J; with a local stiffness by Gauss' rule over pieces of the overlap.
  double energy(const double R, const double R_ref, const double E, const double curvature,
                const double w) const {
    if (!stiffness) return (*this)(R, R_ref, E, curvature, w).energy;
    const auto force = [&](const double overlap) {
      return (*this)(R, R_ref, E, curvature, R - overlap).force;
    };
    constexpr int pieces = 24;
    double sum = 0., from = 0.;
    for (const double d : stiffness->kinks())
      if (const double to = d * R_ref - (R_ref - R); to > 0. && to < R - w) {
        sum += overlap_energy(from, to, pieces, force);
        from = to;
      }
    return sum + overlap_energy(from, R - w, pieces, force);
  }

  /// The same to a few per cent and soon, for any w: 0 where it does not touch, infinite where its centre
  /// would be behind the wall.
  double energy_about(const double R, const double R_ref, const double E, const double curvature,
                      const double w) const {
    if (!(w > 0.)) return HUGE_VAL;
    return w < R ? overlap_energy(
                       0., R - w, 6,
                       [&](double overlap) { return (*this)(R, R_ref, E, curvature, R - overlap).force; })
                 : 0.;
  }
};

/// R_ref of a cell: of the field "reference_volume" (m^3) where cells carry one, else its radius.
class ReferenceRadius {
 public:
  template <int dim>
  explicit ReferenceRadius(const Particles<dim> &particles)
      : values(particles.field(particles.has("reference_volume") ? "reference_volume" : "radius").data()),
        of_volume(particles.has("reference_volume")) {}
  double operator()(const std::size_t i) const {
    return of_volume ? std::cbrt(values[i] * (0.75 / std::numbers::pi)) : values[i];
  }

 private:
  const double *values;
  bool of_volume;
};
}  // namespace turgor
