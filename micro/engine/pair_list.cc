#include "micro/engine/pair_list.h"

#include <algorithm>
#include <cmath>

namespace turgor
{
template <int dim>
PairList<dim>::PairList(const double skin_)
  : skin(skin_)
{}

template <int dim>
bool PairList<dim>::stale(const Particles<dim> &particles, const std::vector<double> &radius) const
{
  if (built_radius.size() != radius.size())
    return true;
  const double allowed = 0.5 * skin;
  for (std::size_t i = 0; i < radius.size(); ++i)
    {
      const double left = allowed - std::max(0., radius[i] - built_radius[i]);
      double moved = 0.;
      for (int d = 0; d < dim; ++d)
        {
          const double step = particles.x[d][i] - built_at[d][i];
          moved += step * step;
        }
      if (!(left > 0. && moved < left * left))
        return true;
    }
  return false;
}

template <int dim>
void PairList<dim>::build(const Particles<dim> &particles, const std::vector<double> &radius,
                          std::vector<unsigned char> &touching)
{
  const std::uint32_t n = std::uint32_t(radius.size());
  std::array<const double *, dim> x;
  for (int d = 0; d < dim; ++d)
    {
      x[d] = particles.x[d].data();
      built_at[d] = particles.x[d];
    }
  const bool same_spheres = built_radius.size() == n;
  built_radius = radius;
  ++build_count;

  const std::vector<Pair> before = std::move(list);
  const std::vector<std::uint32_t> first_before = std::move(first_pair);
  std::vector<unsigned char> touched = std::move(touching);
  list.clear();
  touching.clear();
  first_pair.assign(1, 0);
  std::vector<std::uint32_t> count(n + 1, 0);

  const double widest = n > 0 ? *std::max_element(radius.begin(), radius.end()) : 0.;
  double low[dim], high[dim];
  for (int d = 0; d < dim; ++d)
    {
      const auto [least, most] = std::minmax_element(x[d], x[d] + n);
      low[d] = n > 0 ? *least : 0.;
      high[d] = n > 0 ? *most : 0.;
    }
  const Bins<dim> bins(x.data(), n, 0.5 * (2. * widest + skin), low, high, 256.);
  std::vector<std::uint32_t> near;
  for (std::uint32_t i = 0; i < n; ++i)
    {
      std::array<double, dim> at;
      for (int d = 0; d < dim; ++d)
        at[d] = x[d][i];
      near.clear();
      bins.near(at.data(), [&](const std::uint32_t j) {
        if (j <= i)
          return;
        double r2 = 0.;
        for (int d = 0; d < dim; ++d)
          r2 += (x[d][j] - at[d]) * (x[d][j] - at[d]);
        const double reach = radius[i] + radius[j] + skin;
        if (r2 < reach * reach)
          near.push_back(j);
      });
      std::sort(near.begin(), near.end());
      for (const std::uint32_t j : near)
        {
          list.push_back({i, j});
          unsigned char was = 0;
          if (same_spheres && i + 1 < first_before.size() && !touched.empty())
            {
              const auto begin = before.begin() + first_before[i], end = before.begin() + first_before[i + 1];
              const auto found = std::lower_bound(begin, end, j, [](const Pair &p, std::uint32_t k) { return p.j < k; });
              was = found != end && found->j == j && touched[std::size_t(found - before.begin())];
            }
          touching.push_back(was);
          ++count[i + 1];
          ++count[j + 1];
        }
      first_pair.push_back(std::uint32_t(list.size()));
    }
  for (std::uint32_t i = 0; i < n; ++i)
    count[i + 1] += count[i];
  first_of = count;
  pair_of.resize(2 * list.size());
  other_of.resize(2 * list.size());
  for (std::uint32_t p = 0; p < list.size(); ++p)
    for (const auto &[own_sphere, other_sphere] : {std::pair(list[p].i, list[p].j), std::pair(list[p].j, list[p].i)})
      {
        const std::uint32_t slot = count[own_sphere]++;
        pair_of[slot] = p;
        other_of[slot] = other_sphere;
      }
}

template <int dim>
std::size_t PairList<dim>::memory_bytes() const
{
  return list.capacity() * sizeof(Pair)
         + 4 * (first_of.capacity() + pair_of.capacity() + other_of.capacity() + first_pair.capacity())
         + 8 * (dim * built_at[0].capacity() + built_radius.capacity());
}

template class PairList<2>;
template class PairList<3>;
} // namespace turgor
