#include "micro/engine/contact_list.h"

#include "run/parallel.h"

#include <algorithm>

namespace turgor {
template <int dim>
ContactList<dim>::ContactList(const double skin_, const bool keeps_history)
    : skin(skin_), history(keeps_history), list(skin_) {}

template <int dim>
std::size_t ContactList<dim>::add(const Obstacle<dim> &body) {
  bodies.push_back({&body, {}});
  return bodies.size() - 1;
}

template <int dim>
bool ContactList<dim>::covers(const Particles<dim> &particles, const unsigned int threads) const {
  for (const Body &body : bodies)
    if (body.moved < 0. || !(body.shape->moved(body.arm) - body.moved <= 0.5 * skin)) return false;
  return !list.stale(particles, particles.field("radius"), threads);
}

template <int dim>
void ContactList<dim>::find(Body &body, const Particles<dim> &particles, const std::vector<double> &radius,
                            const unsigned int threads) const {
  const double margin = skin + std::max(0., body.shape->slack());
  const Chunks chunks(radius.size(), 512);
  std::vector<std::vector<std::uint32_t>> found(chunks.count());
  std::vector<double> farthest(chunks.count(), 0.);
  for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
    const std::size_t chunk = begin / chunks.size;
    for (std::size_t i = begin; i < end; ++i) {
      const Vector<dim> x = particles.position(i);
      const double within = radius[i] + margin;
      if (body.shape->at(x, within).distance < within) found[chunk].push_back(std::uint32_t(i));
      farthest[chunk] = std::max(farthest[chunk], (x - body.shape->centre).norm() + within);
    }
  });
  body.near.clear();
  for (const auto &part : found) body.near.insert(body.near.end(), part.begin(), part.end());
  body.arm = farthest.empty() ? 0. : *std::max_element(farthest.begin(), farthest.end());
  body.moved = body.shape->moved(body.arm);
}

template <int dim>
void ContactList<dim>::bring_up_to_date(const Particles<dim> &particles, const unsigned int threads) {
  if (covers(particles, threads)) return;
  if (!history) touching.clear();
  const std::vector<double> &radius = particles.field("radius");
  list.build(particles, radius, touching, threads);
  for (Body &body : bodies) find(body, particles, radius, threads);
}

template class ContactList<2>;
template class ContactList<3>;
}  // namespace turgor
