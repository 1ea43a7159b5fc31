#include "micro/terms/sph_sweeps.h"

#include "run/run_context.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace turgor::sph {
template <int dim>
const std::vector<const Sweeps<dim> *> &known_sweeps() {
  static const std::vector<const Sweeps<dim> *> known = [] {
    std::vector<const Sweeps<dim> *> all{&sweeps_portable<dim>()};
#if !defined(TURGOR_PORTABLE)
    all.push_back(&sweeps_avx2<dim>());
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
      all.push_back(&sweeps_avx512<dim>());
#endif
    return all;
  }();
  return known;
}

template <int dim>
const Sweeps<dim> &sweeps() {
  static const Sweeps<dim> &chosen = []() -> const Sweeps<dim> & {
    const char *wish = std::getenv("TURGOR_SIMD");
    if (wish == nullptr || *wish == '\0') return *known_sweeps<dim>().back();
    std::string words;
    for (const Sweeps<dim> *one : known_sweeps<dim>()) {
      if (std::string(one->name) == wish) return *one;
      words += std::string(words.empty() ? "" : ", ") + one->name;
    }
    throw InputError("TURGOR_SIMD=" + std::string(wish) +
                     " in the environment is not among what this program has for this"
                     " processor: " +
                     words + ".");
  }();
  return chosen;
}

template const std::vector<const Sweeps<2> *> &known_sweeps<2>();
template const std::vector<const Sweeps<3> *> &known_sweeps<3>();
template const Sweeps<2> &sweeps<2>();
template const Sweeps<3> &sweeps<3>();
}  // namespace turgor::sph
