#include "coupling/point_states.h"

#include "run/archive.h"

#include <utility>

namespace turgor {
template <int dim>
void PointStates<dim>::start(const PointShares &shares, const RveState<dim> &state) {
  committed.assign(shares.owners().size(), RveState<dim>());
  trial = committed;
  for (const std::size_t p : shares.mine()) committed[p] = state;
}

template <int dim>
std::vector<std::string> PointStates<dim>::packed(const PointShares &shares,
                                                  const std::vector<std::size_t> &points) const {
  std::vector<std::string> texts(committed.size());
  for (const std::size_t p : points)
    if (shares.owners().at(p) == shares.rank()) {
      RveState<dim> state = committed[p];  // an archive asks for what it could load into
      texts[p] = archived(state);
    }
  return texts;
}

template <int dim>
void PointStates<dim>::unpack(const PointShares &shares, const std::vector<std::string> &texts) {
  for (const std::size_t p : shares.mine()) restore(texts[p], committed[p]);
}

template <int dim>
void PointStates<dim>::move(PointShares &shares, const std::vector<unsigned int> &new_owner) {
  std::vector<std::string> luggage = packed(shares, shares.mine());
  shares.reassign(new_owner, luggage);
  start(shares, RveState<dim>());
  unpack(shares, luggage);
}

template struct PointStates<2>;
template struct PointStates<3>;
}  // namespace turgor
