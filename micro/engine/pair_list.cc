#include "micro/engine/pair_list.h"

#include "micro/geometry/near_points.h"
#include "run/parallel.h"
#include "run/written_anew.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
bool before(const Pair &a, const Pair &b) { return a.i != b.i ? a.i < b.i : a.j < b.j; }
}  // namespace

template <int dim>
PairList<dim>::PairList(const double skin_) : skin(skin_) {}

template <int dim>
bool PairList<dim>::stale(const Particles<dim> &particles, const std::vector<double> &radius,
                          const unsigned int threads) const {
  if (built_radius.size() != radius.size()) return true;
  const double allowed = 0.5 * skin;
  std::atomic<bool> result{false};
  for_chunks(threads, Chunks(radius.size(), 4096), [&](std::size_t begin, std::size_t end) {
    bool good = true;
    for (std::size_t i = begin; i < end; ++i) {
      const double left = allowed - std::max(0., radius[i] - built_radius[i]);
      double moved = 0.;
      for (int d = 0; d < dim; ++d) {
        const double step = particles.x[d][i] - built_at[d][i];
        moved += step * step;
      }
      good = good & (left > 0.) & (moved < left * left);
    }
    if (!good) result = true;
  });
  return result;
}

template <int dim>
void PairList<dim>::build(const Particles<dim> &particles, const std::vector<double> &radius,
                          std::vector<unsigned char> &touching, const unsigned int threads) {
  const std::uint32_t n = std::uint32_t(radius.size());
  std::array<const double *, dim> x;
  for (int d = 0; d < dim; ++d) {
    x[d] = particles.x[d].data();
    built_at[d] = particles.x[d];
  }
  built_radius = radius;
  ++build_count;

  const std::vector<Pair> list_before = touching.empty() ? std::vector<Pair>() : list;
  const std::vector<std::uint32_t> first_before =
      touching.empty() ? std::vector<std::uint32_t>(1, 0) : first_pair;
  const std::vector<unsigned char> touched = std::move(touching);

  search.find(x, radius, skin, threads);
  // Each sphere's own: first the pairs in which it is the second one, then those in which it is the first.
  // How many it has of either comes first, then the second ones j at the places of their first ones.
  std::vector<std::uint32_t> next(n, 0);
  first_pair.assign(n + 1, 0);
  search.for_each([&](const std::uint32_t i, const std::uint32_t j) {
    ++first_pair[std::min(i, j) + 1];
    ++next[std::max(i, j)];
  });
  first_of.resize(n + 1);
  first_of[0] = 0;
  std::vector<std::uint32_t> place(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    place[i] = first_of[i] + next[i];
    first_of[i + 1] = place[i] + first_pair[i + 1];
    first_pair[i + 1] += first_pair[i];
    next[i] = first_of[i];
  }
  resize_anew(pair_of, first_of[n]);
  resize_anew(other_of, first_of[n]);
  search.for_each([&](const std::uint32_t i, const std::uint32_t j) {
    other_of[place[std::min(i, j)]++] = std::max(i, j);
  });

  // The order of pairs is that of i, then j, whatever the order in which they were found.
  resize_anew(list, first_pair[n]);
  touching.assign(first_pair[n], 0);
  for_chunks(threads, Chunks(n, 256), [&](std::size_t begin, std::size_t end) {
    for (std::uint32_t i = std::uint32_t(begin); i < end; ++i) {
      std::uint32_t p = first_pair[i];
      const std::uint32_t last = first_pair[i + 1], own = first_of[i + 1] - (last - p);
      std::uint32_t *j = other_of.data() + own, *number = pair_of.data() + own;
      sort_few(j, last - p);
      for (; p < last; ++p, ++j) {
        list[p] = {i, *j};
        *number++ = p;
        if (i + 1 < first_before.size()) {
          const auto from = list_before.begin() + first_before[i],
                     to = list_before.begin() + first_before[i + 1];
          const auto was =
              std::lower_bound(from, to, *j, [](const Pair &pair, std::uint32_t k) { return pair.j < k; });
          touching[p] = was != to && was->j == *j && touched[std::size_t(was - list_before.begin())];
        }
      }
    }
  });

  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t p = first_pair[i]; p < first_pair[i + 1]; ++p) {
      const std::uint32_t others = next[list[p].j]++;
      pair_of[others] = p;
      other_of[others] = i;
    }
}

template <int dim>
void PairList<dim>::gather(const Rearrangement &places, std::vector<unsigned char> &touching) {
  const std::vector<std::uint32_t> &source = places.source;
  if (std::find(touching.begin(), touching.end(), 1) == touching.end())
    return restore({}, source.size(), touching);
  // copies[first_copy[i] .. first_copy[i + 1]): the new places of the sphere that was i
  const std::size_t n_before = first_pair.size() - 1;
  std::vector<std::uint32_t> first_copy(n_before + 1, 0), copies(source.size());
  for (const std::uint32_t i : source)
    if (i != Rearrangement::fresh) ++first_copy[i + 1];
  for (std::size_t i = 0; i < n_before; ++i) first_copy[i + 1] += first_copy[i];
  std::vector<std::uint32_t> next = first_copy;
  for (std::uint32_t k = 0; k < source.size(); ++k)
    if (source[k] != Rearrangement::fresh) copies[next[source[k]]++] = k;
  std::vector<Pair> held;
  for (std::size_t p = 0; p < touching.size(); ++p)
    if (touching[p])
      for (std::uint32_t a = first_copy[list[p].i]; a < first_copy[list[p].i + 1]; ++a)
        for (std::uint32_t b = first_copy[list[p].j]; b < first_copy[list[p].j + 1]; ++b)
          held.push_back({std::min(copies[a], copies[b]), std::max(copies[a], copies[b])});
  std::sort(held.begin(), held.end(), before);
  restore(std::move(held), source.size(), touching);
}

template <int dim>
void PairList<dim>::restore(std::vector<Pair> touching_pairs, const std::size_t n,
                            std::vector<unsigned char> &touching) {
  list = std::move(touching_pairs);
  touching.assign(list.size(), 1);
  first_pair.assign(n + 1, 0);
  for (std::size_t p = 0; p < list.size(); ++p) {
    if (!(list[p].i < list[p].j && list[p].j < n && (p == 0 || before(list[p - 1], list[p]))))
      throw std::runtime_error("the checkpoint's contacts do not belong to this scene");
    ++first_pair[list[p].i + 1];
  }
  for (std::size_t i = 0; i < n; ++i) first_pair[i + 1] += first_pair[i];
  built_radius.clear();
}

template <int dim>
std::size_t PairList<dim>::memory_bytes() const {
  return list.capacity() * sizeof(Pair) +
         4 * (first_of.capacity() + pair_of.capacity() + other_of.capacity() + first_pair.capacity()) +
         8 * (dim * built_at[0].capacity() + built_radius.capacity());
}

template class PairList<2>;
template class PairList<3>;
}  // namespace turgor
