// Who may touch whom in a population of spheres: pairs of spheres (pair_list.h), and spheres next to bodies
// of any shape (micro/geometry/obstacle.h). Both are found at the same time with the same skin, and are good
// for as long: while no sphere has moved and grown by half a skin together, and no body's surface has come
// nearer by the other half.
//
//   auto list = std::make_shared<ContactList<3>>(0.2 * R);  const std::size_t k = list->add(body);
//   list->bring_up_to_date(particles, threads);             pairs().pairs(), next_to(k)
//
// A body whose shape answers to what presses on it is looked for from as far as it may come back by itself
// (Obstacle::slack): what is next to it does not change when it settles. SphereContacts and Obstacles share
// one list; either brings it up to date. Field read: radius (m).
#pragma once

#include "micro/engine/pair_list.h"
#include "micro/geometry/obstacle.h"

namespace turgor {
template <int dim>
class ContactList {
 public:
  /// m. keeps_history: which pairs touch is remembered from one list to the next.
  ContactList(double skin, bool keeps_history);

  /// A body, which has to live as long as the list: its number. The list is out of date then.
  std::size_t add(const Obstacle<dim> &body);

  /// Whether nothing can touch that is not in it.
  bool covers(const Particles<dim> &particles, unsigned int threads = 1) const;

  void bring_up_to_date(const Particles<dim> &particles, unsigned int threads);

  PairList<dim> &pairs() { return list; }
  const PairList<dim> &pairs() const { return list; }
  std::vector<unsigned char> touching;  ///< of pairs(): the history

  /// The spheres that may touch a body, in their order.
  const std::vector<std::uint32_t> &next_to(const std::size_t body) const { return bodies[body].near; }

 private:
  struct Body {
    const Obstacle<dim> *shape;
    std::vector<std::uint32_t> near;
    double arm = 0.;     ///< m, from its centre to the farthest sphere at most
    double moved = -1.;  ///< m, Obstacle::moved(arm) when the list was built; negative: it is in no list yet
  };
  void find(Body &body, const Particles<dim> &particles, const std::vector<double> &radius,
            unsigned int threads) const;

  double skin;
  bool history;
  PairList<dim> list;
  std::vector<Body> bodies;
};

extern template class ContactList<2>;
extern template class ContactList<3>;
}  // namespace turgor
