#include "micro/solve/links.h"

namespace turgor {
void PushedLinks::clear() {
  links.clear();
  any_directed = false;
}

void PushedLinks::push(const std::uint32_t i, const std::uint32_t j, const DoubleRow e, const double normal,
                       const double tangential) {
  links.push_back({e, normal, tangential, i, j});
  any_directed = any_directed || normal != tangential;
}

void PushedLinks::sort(const std::size_t bodies) {
  first.assign(bodies + 1, 0);
  const auto for_ends = [&](const auto &body) {
    for (std::uint32_t k = 0; k < links.size(); ++k)
      for (const std::uint32_t i : {links[k].i, links[k].j})
        if (i < bodies) body(i, k);
  };
  for_ends([&](const std::uint32_t i, std::uint32_t) { ++first[i + 1]; });
  for (std::size_t i = 0; i < bodies; ++i) first[i + 1] += first[i];
  of_body.resize(first[bodies]);
  std::vector<std::uint32_t> next = first;
  for_ends([&](const std::uint32_t i, const std::uint32_t k) { of_body[next[i]++] = k; });
}

Power PushedLinks::power(const BodyVector *v, const std::size_t bodies) const {
  Power total;
  for (const Pushed &link : links) {
    const DoubleRow vi = v[link.i].v, vj = v[link.j].v, u = vi - vj, along = link.e * u;  // u[3] = 0
    const DoubleRow drag =
        link.tangential * u + (link.normal - link.tangential) * ((along[0] + along[1]) + along[2]) * link.e;
    const auto power_of = [&](const DoubleRow w) {
      return (w[0] * drag[0] + w[1] * drag[1]) + w[2] * drag[2];
    };
    total.lost += power_of(u);
    if (link.i < bodies && link.j < bodies) continue;
    const double by_i = link.i < bodies ? 0. : power_of(vi), by_j = link.j < bodies ? 0. : -power_of(vj);
    total.given += by_i + by_j;
    if (link.i < bodies || link.j < bodies) {
      const DoubleRow moving = link.i < bodies ? vj : vi, still = link.i < bodies ? vi : vj;
      const DoubleRow by = link.e * moving;
      const DoubleRow push =
          link.tangential * moving + (link.normal - link.tangential) * ((by[0] + by[1]) + by[2]) * link.e;
      total.pushed += (still[0] * push[0] + still[1] * push[1]) + still[2] * push[2];
    }
  }
  return total;
}

void PushedLinks::room(const std::size_t begin, const std::size_t end, std::uint32_t *count) const {
  for (std::size_t i = begin; i < end; ++i) count[i - begin] += first[i + 1] - first[i];
}
}  // namespace turgor
