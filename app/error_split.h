// Where the error of finite elements and RVEs comes from, out of the runs of `turgor compare`.
//
//   total    FE2 over all cells - 1: the same tissue, its sides as the interior (counterpart.h)
//   part     FE2 over FE2 with one thing refined - 1: mesh, RVE size, time step, skipping
//   number   of cells: what all cells come to when there are ever more, over what they are, - 1; by
//            2 f(n) - f(n/2), as what ends and clamp do goes with 1/n
//   rest     what is left of the total when every part is taken out: what does not go
//            with 1/n (sides of a block at such sizes), the particles' own error
//   surface  all cells with free sides over the same with sides as the interior - 1; in no FE2, so in no
//            error
//
// The parts multiply: 1 + total = (1 + part) ... (1 + number) (1 + rest). All but the number's part and the
// rest are measured. The number's part is a line through two sizes, and where such a line does not lead to
// the limit, the rest is as wrong as it is: a rest larger than `unexplained` of the total is remarked upon.
#pragma once

#include "app/counterpart.h"

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace turgor {
/// A rest of more than this share of the total, and the split does not explain the error.
constexpr double unexplained = 0.5;

/// Labels of the runs.
constexpr const char *as_it_is = "FE2", *all_cells = "all cells", *free_sides = "all cells, free sides",
                     *fewer_cells = "half as many cells", *refined_label = "FE2, refined: ";

/// What a run came to.
struct Compared {
  std::map<std::string, double> values;  ///< of the measures that are one number, in SI units
  double cpu = 0.;                       ///< s
  double history = NAN;                  ///< rms error of the probe's course over that of all cells

  struct Failed {
    std::optional<double> first = {};  ///< way of the tool over the size at rest; none: no cell has failed
    double share = 0.;                 ///< of all cells, at the end
  };
  std::optional<Failed> failed = {};  ///< where walls may break
};

struct SplitLine {
  std::string what;
  std::map<std::string, double> share;  ///< by measure
  std::optional<double> cpu;            ///< s; none for the rest
};

struct ErrorSplit {
  std::vector<SplitLine> lines;                ///< total, parts, number, rest, all cells, surface
  std::map<std::string, std::string> remarks;  ///< by measure: why the split does not explain its error
};

/// `runs` by label: all that `cells` asks for.
ErrorSplit error_split(const Counterpart &cells, const std::map<std::string, Compared> &runs);

/// "FE2 takes 0.9 s of CPU time, all cells 404 s: FE2 is 449 times as fast."; empty where a run has no time.
std::string cost_in_words(const ErrorSplit &split);
}  // namespace turgor
