// What a particle feels of a surface (obstacle.h) at a signed distance w, by kind of particle:
//
//   SurfacePenalty   wall nodes (and fluid that has left its cell):  E = k w^2/2 for w < 0, no friction
//   SphereOnSurface  the sphere of a cell without wall nodes (wall_contact.h: Hertz, the wall's own modulus,
//                    a local stiffness), up to w = 0: its centre on the surface, where the law ends
//
// A law holds for a part of a group (holds_for) and is asked through a view that is bound to the particles'
// fields once (SurfaceLaw::on): reach (m): it is felt for w < reach; (i, w, curvature) -> force along the
// normal (N), slope of the force (N/m), area (m^2); by_curvature (J m): slope of the energy. A third law is a
// structure of this form and its name in SurfaceLaw.
#pragma once

#include "micro/terms/wall_contact.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace turgor {
struct SurfacePenalty {
  double stiffness = 0.;  ///< k, N/m
  bool holds_fluid = false;

  struct View {
    const SurfacePenalty &law;
    std::pair<std::uint32_t, std::uint32_t> holds_for(const Group &g) const {
      return {g.begin, law.holds_fluid ? g.end : g.fluid};
    }
    double reach(std::size_t) const { return 0.; }
    SphereContact operator()(std::size_t, const double w, double) const {
      return {-law.stiffness * w, law.stiffness, 0., 0.5 * law.stiffness * w * w};
    }
    double energy(std::size_t, const double w, double) const { return 0.5 * law.stiffness * w * w; }
    double by_curvature(std::size_t, double, double) const { return 0.; }
    bool ends_at(double) const { return false; }
    double modulus(std::size_t) const { return 0.; }
    double modulus_of_wall() const { return HUGE_VAL; }
  };
  template <int dim>
  View on(const Particles<dim> &) const {
    return {*this};
  }
};

struct SphereOnSurface {
  WallMaterial material;

  struct View {
    const WallMaterial &material;
    const double *radius, *modulus_of;
    ReferenceRadius reference;
    std::pair<std::uint32_t, std::uint32_t> holds_for(const Group &g) const {
      return {g.fluid, g.wall_count() > 0 ? g.fluid : g.end};
    }
    double reach(const std::size_t i) const { return radius[i]; }
    SphereContact operator()(const std::size_t i, const double w, const double curvature) const {
      return material(radius[i], reference(i), modulus_of[i], bounded(i, curvature), w);
    }
    double energy(const std::size_t i, const double w, const double curvature) const {
      return material.energy(radius[i], reference(i), modulus_of[i], bounded(i, curvature), w);
    }
    /// Of the energy: it goes with sqrt(R), 1/R = 1/R_i + curvature.
    double by_curvature(const std::size_t i, const double w, const double curvature) const {
      const double c = bounded(i, curvature);
      return c == curvature ? -0.5 * energy(i, w, c) / (1. / radius[i] + c) : 0.;
    }
    /// A hollow that the sphere does not fit into is one that it just fits into.
    double bounded(const std::size_t i, const double curvature) const {
      return std::max(curvature, -0.95 / radius[i]);
    }
    bool ends_at(const double w) const { return !(w > 0.); }
    double modulus(const std::size_t i) const  ///< Pa, of its contacts, as packed under some kPa
    {
      return modulus_of[i] * (material.stiffness ? (*material.stiffness)(0.2).factor : 1.);
    }
    double modulus_of_wall() const { return material.modulus; }
  };
  template <int dim>
  View on(const Particles<dim> &p) const {
    return {material, p.field("radius").data(), p.field("modulus").data(), ReferenceRadius(p)};
  }
};

using SurfaceLaw = std::variant<SurfacePenalty, SphereOnSurface>;
}  // namespace turgor
