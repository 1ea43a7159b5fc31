// The stretches of a ring within reach of each fluid particle.
#include "micro/geometry/near_points.h"
#include "micro/terms/sph_lists.h"

#include <bit>
#include <cmath>

namespace turgor {
void WallArcs::clear(const std::uint32_t particles) {
  arcs.clear();
  first_arc.assign(particles + 1, 0);
  chunks = 0;
}

void WallArcs::build(const ListOrigin<2> &origin, const std::uint32_t nw, const double reach,
                     const std::vector<unsigned char> *gone) {
  const std::uint32_t n = std::uint32_t(origin.size()) - nw;
  const double *wx = origin[0], *wy = origin[1], *x = wx + nw, *y = wy + nw;
  arcs.clear();
  first_arc.assign(1, 0);
  chunks = 0;
  std::vector<double> mx(nw + near_block), my(nw + near_block), limit(nw + near_block, -1.);
  for (std::uint32_t k = 0; k < nw; ++k) {
    const std::uint32_t b = k + 1 < nw ? k + 1 : 0;
    mx[k] = 0.5 * (wx[k] + wx[b]);
    my[k] = 0.5 * (wy[k] + wy[b]);
    const double r = reach + 0.5 * std::hypot(wx[b] - wx[k], wy[b] - wy[k]);
    limit[k] = gone != nullptr && (*gone)[k] != 0 ? -1. : r * r;
  }
  const auto add_arc = [&](const std::uint32_t first, const std::uint32_t length) {
    arcs.push_back({std::uint16_t(first), std::uint16_t(length)});
    chunks += (length + sph::list_padding - 1) / sph::list_padding;
  };
  struct Stretch {
    std::uint32_t first, end;
  };
  std::vector<Stretch> near;  // of the ring cut open before its first face
  for (std::uint32_t i = 0; i < n; ++i) {
    const double at[2] = {x[i], y[i]};
    near.clear();
    for (std::uint32_t k = 0; k < nw; k += near_block) {
      unsigned int bits = near_bits<2>({mx.data(), my.data()}, k, at,
                                       [&](const std::uint32_t j) { return four_numbers(&limit[j]); });
      while (bits != 0) {
        const auto skipped = std::uint32_t(std::countr_zero(bits)), first = k + skipped,
                   end = first + std::uint32_t(std::countr_one(bits >> skipped));
        bits &= ~0u << (end - k);
        if (!near.empty() && near.back().end == first)
          near.back().end = end;
        else
          near.push_back({first, end});
      }
    }
    // In order from the first gap on: what lies before that gap goes with the end of the ring, or comes last.
    const bool cut = !near.empty() && near[0].first == 0, whole = cut && near[0].end == nw,
               joined = cut && !whole && near.back().end == nw;
    for (std::size_t s = cut && !whole ? 1 : 0; s < near.size(); ++s)
      add_arc(near[s].first,
              near[s].end - near[s].first + (joined && s + 1 == near.size() ? near[0].end : 0));
    if (cut && !whole && !joined) add_arc(0, near[0].end);
    first_arc.push_back(std::uint32_t(arcs.size()));
  }
}
}  // namespace turgor
