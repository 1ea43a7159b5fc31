// Friction between spheres that touch (sphere_contacts.h), thesis Eq. 2.4, as links of the matrix of motion
// (micro/solve/motion_matrix.h):
//
//   Gamma_ij = A_ij [ normal e (x) e + tangential (I - e (x) e) ]
//
// A_ij (m^2): contact area, normal and tangential in N s/m^3; e: from one centre to the other.
//
// A linearly implicit step, (Gamma + h K) v = F with K = -dF/dx, has the same form: the contact's stiffness k
// adds h k to the normal friction of the pair, F/d (where it pulls) h to the tangential one. What is left out
// of K, which only the error of a step of first order has: repulsion turned sideways, F/d where F pushes (K
// would not be positive definite).
#pragma once

#include "micro/solve/links.h"
#include "micro/terms/sphere_contacts.h"

#include <algorithm>
#include <cstring>

namespace turgor {
/// The contacts of spheres, gone through in their own list.
class SphereLinks final : public ListedLinks<SphereLinks> {
 public:
  SphereLinks(const SphereContacts &contacts_, const PairFriction &friction_)
      : friction(friction_), contacts(&contacts_) {}

  bool directed() const override { return friction.directed(); }
  void room(const std::size_t begin, const std::size_t end, std::uint32_t *count) const override {
    const auto &first = contacts->list().first();
    for (std::size_t i = begin, last = std::min(end, first.size() - 1); i < last; ++i)
      count[i - begin] += first[i + 1] - first[i];
  }
  template <class Row>
  void links_of(const std::size_t i, Row &row) const {
    constexpr std::size_t ahead = 16;  // contacts on their way
    const PairFriction of_pair = friction;
    const PairContact *contact = contacts->contacts().data();
    const auto &first = contacts->list().first(), &pair = contacts->list().own(),
               &other = contacts->list().other();
    if (i + 1 >= first.size()) return;  // no sphere: a body behind them (engine/moved_bodies.h)
    for (std::uint32_t k = first[i], end = first[i + 1], last = std::uint32_t(pair.size()) - 1; k < end;
         ++k) {
      __builtin_prefetch(contact + pair[std::min<std::size_t>(k + ahead, last)]);
      const PairContact &c = contact[pair[k]];  // all zero where nothing touches
      const PairFriction::Coefficients along_and_across = of_pair(c);
      DoubleRow e;  // the unit vector; what follows it in memory comes last
      std::memcpy(&e, c.e, sizeof e);
      row.link(along_and_across.normal, along_and_across.tangential, e, other[k], c.area > 0.);
    }
  }

 private:
  PairFriction friction;
  const SphereContacts *contacts;
};
}  // namespace turgor
