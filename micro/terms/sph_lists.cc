#include "micro/terms/sph_lists.h"

#include <algorithm>
#include <cmath>

namespace turgor
{
void SphLists::build(const ListOrigin<2> &origin, const std::uint32_t nw, const double reach)
{
  const std::uint32_t n = std::uint32_t(origin.size()) - nw;
  const double *wx = origin[0], *wy = origin[1], *x = wx + nw, *y = wy + nw;
  const double reach2 = reach * reach;
  neighbours.clear();
  arcs.clear();
  first_neighbour.assign(1, 0);
  first_arc.assign(1, 0);
  chunks = 0;
  if (!origin.finite())
    { // no neighbours: the scene sees the positions themselves and says that it diverged
      first_neighbour.assign(n + 1, 0);
      first_arc.assign(n + 1, 0);
      return;
    }

  // Bins of the reach over the bounding box.
  double lo[2] = {x[0], y[0]}, hi[2] = {x[0], y[0]};
  for (std::uint32_t i = 1; i < n; ++i)
    {
      lo[0] = std::min(lo[0], x[i]);
      hi[0] = std::max(hi[0], x[i]);
      lo[1] = std::min(lo[1], y[i]);
      hi[1] = std::max(hi[1], y[i]);
    }
  const double width = reach / 2.;
  int bins[2];
  for (int d = 0; d < 2; ++d)
    bins[d] = std::clamp(int((hi[d] - lo[d]) / width) + 1, 1, 256);
  const std::size_t bin_count = std::size_t(bins[0]) * std::size_t(bins[1]);
  std::vector<std::uint32_t> start(bin_count + 1, 0), bin_of(n);
  std::vector<std::uint16_t> order(n);
  const auto bin_index = [&](double value, int d) {
    return std::clamp(int((value - lo[d]) / width), 0, bins[d] - 1);
  };
  for (std::uint32_t i = 0; i < n; ++i)
    {
      bin_of[i] = bin_index(y[i], 1) * bins[0] + bin_index(x[i], 0);
      ++start[bin_of[i] + 1];
    }
  for (std::size_t b = 1; b < start.size(); ++b)
    start[b] += start[b - 1];
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (std::uint32_t i = 0; i < n; ++i)
    order[next[bin_of[i]]++] = std::uint16_t(i);

  for (std::uint32_t i = 0; i < n; ++i)
    {
      const int bx = bin_index(x[i], 0), by = bin_index(y[i], 1);
      for (int cy = std::max(by - 2, 0); cy <= std::min(by + 2, bins[1] - 1); ++cy)
        {
          const std::uint32_t from = start[cy * bins[0] + std::max(bx - 2, 0)];
          const std::uint32_t to = start[cy * bins[0] + std::min(bx + 2, bins[0] - 1) + 1];
          for (std::uint32_t k = from; k < to; ++k)
            {
              const std::uint32_t j = order[k];
              const double dx = x[j] - x[i], dy = y[j] - y[i];
              if (j != i && dx * dx + dy * dy < reach2)
                neighbours.push_back(std::uint16_t(j));
            }
        }
      while (neighbours.size() % sph::list_padding != 0)
        neighbours.push_back(std::uint16_t(n));
      first_neighbour.push_back(std::uint32_t(neighbours.size()));
    }

  std::vector<double> mx(nw), my(nw), limit(nw);
  for (std::uint32_t k = 0; k < nw; ++k)
    {
      const std::uint32_t b = k + 1 < nw ? k + 1 : 0;
      mx[k] = 0.5 * (wx[k] + wx[b]);
      my[k] = 0.5 * (wy[k] + wy[b]);
      const double r = reach + 0.5 * std::hypot(wx[b] - wx[k], wy[b] - wy[k]);
      limit[k] = r * r;
    }
  std::vector<unsigned char> near(nw);
  for (std::uint32_t i = 0; i < n; ++i)
    {
      unsigned int count = 0;
      for (std::uint32_t k = 0; k < nw; ++k)
        {
          const double dx = mx[k] - x[i], dy = my[k] - y[i];
          near[k] = dx * dx + dy * dy < limit[k];
          count += near[k];
        }
      const auto add_arc = [&](std::uint32_t first, std::uint32_t length) {
        arcs.push_back({std::uint16_t(first), std::uint16_t(length)});
        chunks += (length + sph::list_padding - 1) / sph::list_padding;
      };
      if (count == nw)
        add_arc(0, nw);
      else if (count > 0)
        {
          std::uint32_t gap = 0; // a face out of reach, to start from
          while (near[gap])
            ++gap;
          for (std::uint32_t s = 0; s < nw;)
            {
              const std::uint32_t k = (gap + s) % nw;
              if (!near[k])
                {
                  ++s;
                  continue;
                }
              std::uint32_t length = 0;
              while (s < nw && near[(gap + s) % nw])
                {
                  ++s;
                  ++length;
                }
              add_arc(k, length);
            }
        }
      first_arc.push_back(std::uint32_t(arcs.size()));
    }
}
} // namespace turgor
