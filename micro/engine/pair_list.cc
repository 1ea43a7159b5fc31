#include "micro/engine/pair_list.h"

#include "micro/geometry/bins.h"
#include "micro/geometry/near_points.h"
#include "run/parallel.h"

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

  const Chunks chunks(n, 256);
  find(x, radius, chunks, threads);
  for (std::uint32_t i = 0; i < n; ++i) first_pair[i + 1] += first_pair[i];
  list.resize(first_pair[n]);
  touching.assign(first_pair[n], 0);
  for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
    const std::uint32_t *j = found[begin / chunks.size].data();
    for (std::uint32_t i = std::uint32_t(begin); i < end; ++i)
      for (std::uint32_t p = first_pair[i]; p < first_pair[i + 1]; ++p, ++j) {
        list[p] = {i, *j};
        if (i + 1 < first_before.size()) {
          const auto from = list_before.begin() + first_before[i],
                     to = list_before.begin() + first_before[i + 1];
          const auto was =
              std::lower_bound(from, to, *j, [](const Pair &pair, std::uint32_t k) { return pair.j < k; });
          touching[p] = was != to && was->j == *j && touched[std::size_t(was - list_before.begin())];
        }
      }
  });

  // Each sphere's own: first the pairs in which it is the second one, then those in which it is the first.
  std::vector<std::uint32_t> next(n, 0);
  for (const Pair &pair : list) ++next[pair.j];
  first_of.resize(n + 1);
  first_of[0] = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    first_of[i + 1] = first_of[i] + next[i] + (first_pair[i + 1] - first_pair[i]);
    next[i] = first_of[i];
  }
  pair_of.resize(2 * list.size());
  other_of.resize(2 * list.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    std::uint32_t own = first_of[i + 1] - (first_pair[i + 1] - first_pair[i]);
    for (std::uint32_t p = first_pair[i]; p < first_pair[i + 1]; ++p, ++own) {
      const std::uint32_t j = list[p].j, others = next[j]++;
      pair_of[own] = pair_of[others] = p;
      other_of[own] = j;
      other_of[others] = i;
    }
  }
}

/// For each chunk of spheres i the second ones j > i of their pairs, and how many pairs each has.
template <int dim>
void PairList<dim>::find(const std::array<const double *, dim> &x, const std::vector<double> &radius,
                         const Chunks &chunks, const unsigned int threads) {
  const std::uint32_t n = std::uint32_t(radius.size());
  const double widest = n > 0 ? *std::max_element(radius.begin(), radius.end()) : 0.;
  double low[dim], high[dim];
  for (int d = 0; d < dim; ++d) {
    low[d] = high[d] = n > 0 ? x[d][0] : 0.;
    for (std::uint32_t i = 0; i < n; ++i) {
      low[d] = std::min(low[d], x[d][i]);
      high[d] = std::max(high[d], x[d][i]);
    }
  }
  const Bins<dim> bins(x.data(), n, 2. * widest + skin, low, high, 256.);
  std::vector<std::uint32_t> order = bins.sorted();
  order.resize(n + near_block, 0);
  std::vector<double> sorted[dim], sorted_radius(n + near_block);
  std::array<const double *, dim> sorted_x;
  for (int d = 0; d < dim; ++d) {
    sorted[d].resize(n + near_block);
    sorted_x[d] = sorted[d].data();
  }
  for_chunks(threads, Chunks(n, 4096), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      for (int d = 0; d < dim; ++d) sorted[d][k] = x[d][order[k]];
      sorted_radius[k] = radius[order[k]];
    }
  });
  if (found.size() < chunks.count()) found.resize(chunks.count());
  first_pair.resize(n + 1);
  first_pair[0] = 0;
  for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> &all = found[begin / chunks.size];
    const std::uint32_t *const number = order.data();
    const double *const radius_of = sorted_radius.data();
    typename Bins<dim>::Runs near_by;
    std::size_t size = 0;
    for (std::uint32_t i = std::uint32_t(begin); i < end; ++i) {
      std::array<double, dim> at;
      for (int d = 0; d < dim; ++d) at[d] = x[d][i];
      const std::size_t before_i = size;
      const double reach_i = radius[i] + skin;
      const auto limit = [=](const std::uint32_t k) {
        const FourNumbers reach = reach_i + four_numbers(radius_of + k);
        return reach * reach;
      };
      const std::uint32_t runs = bins.near_runs(at.data(), reach_i + widest, near_by);
      const std::size_t room = size + near_by.numbers + near_block;
      if (all.size() < room) all.resize(room + room / 2);
      std::uint32_t *to = all.data() + size;
      for (std::uint32_t r = 0; r < runs; ++r)
        for (std::uint32_t k = near_by.run[r].first; k < near_by.run[r].last; k += near_block) {
          const unsigned int later = greater_bits(number + k, i) & first_bits(near_by.run[r].last - k);
          to += keep_numbers(number + k, near_bits<dim>(sorted_x, k, at.data(), limit) & later, to);
        }
      size = std::size_t(to - all.data());
      sort_few(all.data() + before_i, size - before_i);
      first_pair[i + 1] = std::uint32_t(size - before_i);
    }
  });
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
