// The stretches of a ring within reach of each fluid particle.
#include "micro/terms/sph_lists.h"

#include <cmath>

namespace turgor
{
void WallArcs::clear(const std::uint32_t particles)
{
  arcs.clear();
  first_arc.assign(particles + 1, 0);
  chunks = 0;
}

void WallArcs::build(const ListOrigin<2> &origin, const std::uint32_t nw, const double reach,
                     const std::vector<unsigned char> *gone)
{
  const std::uint32_t n = std::uint32_t(origin.size()) - nw;
  const double *wx = origin[0], *wy = origin[1], *x = wx + nw, *y = wy + nw;
  arcs.clear();
  first_arc.assign(1, 0);
  chunks = 0;
  std::vector<double> mx(nw), my(nw), limit(nw);
  for (std::uint32_t k = 0; k < nw; ++k)
    {
      const std::uint32_t b = k + 1 < nw ? k + 1 : 0;
      mx[k] = 0.5 * (wx[k] + wx[b]);
      my[k] = 0.5 * (wy[k] + wy[b]);
      const double r = reach + 0.5 * std::hypot(wx[b] - wx[k], wy[b] - wy[k]);
      limit[k] = gone != nullptr && (*gone)[k] != 0 ? -1. : r * r;
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
