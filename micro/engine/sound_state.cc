#include "micro/engine/sound_state.h"

#include "run/number_text.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace turgor {
std::function<std::string(std::size_t)> in_columns(const unsigned int columns) {
  return [columns](const std::size_t c) {
    return "cell (" + number_text(c % columns) + ", " + number_text(c / columns) + ")";
  };
}

template <int dim>
std::string unsound(const Particles<dim> &p, const SoundBounds &bounds) {
  for (std::size_t c = 0; c < p.groups.size(); ++c)
    for (std::uint32_t i = p.groups[c].begin; i < p.groups[c].end; ++i) {
      double far = 0., square = 0., sum = 0.;  // sum: no number where one of them is not
      for (int d = 0; d < dim; ++d) {
        far = std::max(far, std::abs(p.x[d][i]));
        square += p.v[d][i] * p.v[d][i];
        sum += p.x[d][i] + p.v[d][i] + p.f[d][i];
      }
      const double fast = std::sqrt(square);
      if (std::isfinite(sum) && far < bounds.reach && fast < bounds.fastest) continue;
      std::ostringstream sentence;
      sentence << "a " << (i < p.groups[c].fluid ? "wall node" : "fluid particle");
      if (bounds.cell) sentence << " of " << bounds.cell(c);
      if (!std::isfinite(sum))
        sentence << " has a position, velocity or force that is no number any more";
      else if (!(far < bounds.reach)) {
        sentence << " has left the scene, to (";
        for (int d = 0; d < dim; ++d) sentence << (d > 0 ? ", " : "") << p.x[d][i];
        sentence << ") m";
      } else
        sentence << " moves at " << fast << " m/s, more than the " << bounds.fastest
                 << " m/s up to which it would mean something";
      return sentence.str();
    }
  return "";
}

template std::string unsound<2>(const Particles<2> &, const SoundBounds &);
template std::string unsound<3>(const Particles<3> &, const SoundBounds &);
}  // namespace turgor
