// The choice between the laws of two spheres (sphere_contact.h), by name. A law more is a file with a
// structure like those and its name here: entries, checks, scenes and tables follow.
//
//   prm.add_parameter("Law", name, "... " + contact_law_text(), Selection(contact_law_names()));
//   SphereContacts contacts(make_contact_law(name, W), skin);
#pragma once

#include "micro/laws/sphere_contact.h"

#include <string>
#include <variant>

namespace turgor {
using ContactLaw = std::variant<HertzContact, ExtendedHertzContact, JkrContact>;

std::string contact_law_names();  ///< as the entry takes them: "hertz|..."
std::string contact_law_text();   ///< "hertz: without adhesion, Eq. 2.5; ..."

/// W: energy of adhesion, J/m^2, of the laws that have one. The name must be one of those above.
ContactLaw make_contact_law(const std::string &name, double W);

/// What is wrong with the law's adhesion for spheres of a modulus (Pa) and radius (m, the entry so named), as
/// a sentence; empty: nothing.
std::string wrong_adhesion(const ContactLaw &law, double modulus, double radius,
                           const std::string &radius_entry);

inline std::string name_of(const ContactLaw &law) {
  return std::visit([](const auto &one) { return std::string(one.name); }, law);
}

template <class Law>
constexpr bool has_adhesion = requires(Law law) {
  law.W;
};

inline bool is_adhesive(const ContactLaw &law) {
  return std::visit([]<class Law>(const Law &) { return has_adhesion<Law>; }, law);
}

/// m, >= 0: how far apart spheres that touched hold on to each other. R, E: as in sphere_contact.h.
inline double hold_of(const ContactLaw &law, const double R, const double E) {
  return std::visit(
      [&]<class Law>(const Law &one) {
        if constexpr (Law::has_history)
          return -one.release(R, E);
        else
          return 0.;
      },
      law);
}
}  // namespace turgor
