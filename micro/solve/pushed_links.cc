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

void PushedLinks::room(const std::size_t begin, const std::size_t end, std::uint32_t *count) const {
  for (std::size_t i = begin; i < end; ++i) count[i - begin] += first[i + 1] - first[i];
}
}  // namespace turgor
