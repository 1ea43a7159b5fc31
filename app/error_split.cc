#include "app/error_split.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace turgor {
namespace {
/// "12.3 %", with the sign where asked for.
std::string percent(const double share, const char *format = "%.3g %%") {
  char text[40];
  std::snprintf(text, sizeof(text), format, 100. * share);
  return text;
}

std::string value_of(const Counterpart::Entries &entries, const std::string &name) {
  for (const auto &[entry, value] : entries)
    if (entry == name) return value;
  return "";
}

/// Why the rest is so large. `left`: what the parts that are measured leave of the total; `number` its part.
std::string reason(const Counterpart &cells, const double left, const double number) {
  const std::string here = value_of(cells.entries, "Columns");
  if (cells.half.empty())
    return "It holds what the number of cells does, which has no line of its own: " + here + " by " +
           value_of(cells.entries, "Rows") + " cells cannot be halved.";
  const std::string sizes = value_of(cells.half, "Columns") + " to " + here;
  std::string text = "The number's part is a line in 1/n through two sizes, ";
  if (number * left < 0.)
    text += "and from " + sizes +
            " cells all cells move away from FE2 instead of towards it: at such sizes they pass through a "
            "largest or smallest value, and the line leads the wrong way.";
  else if (std::abs(number) > std::abs(left))
    text += "and from " + sizes +
            " cells all cells come closer to FE2 faster than with 1/n, so that the line leads beyond it.";
  else
    text += "and from " + sizes +
            " cells all cells come closer to FE2 more slowly than with 1/n, so that the line ends before it.";
  return text + (cells.moves || cells.struck ? " The particles' own error is in the rest, too." : "");
}

std::string remark(const Counterpart &cells, const double total, const double left, const double number,
                   const double rest) {
  if (std::abs(rest) <= unexplained * std::abs(total)) return "";
  const std::string size = total == 0. ? "there is a rest and no error"
                                       : "the rest is " + percent(std::abs(rest / total)) +
                                             " of the error, more than " + percent(unexplained);
  return size + ": the split does not explain this error. " + reason(cells, left, number) +
         " The error of FE2 and the parts above the number's are measured, and hold.";
}
}  // namespace

ErrorSplit error_split(const Counterpart &cells, const std::map<std::string, Compared> &runs) {
  const Compared &fe = runs.at(as_it_is), &whole = runs.at(all_cells);
  ErrorSplit split;
  SplitLine total{"error of FE2", {}, fe.cpu}, rest{"  rest", {}, {}}, number{"  number of cells", {}, {}};
  for (const auto &[name, value] : whole.values)
    rest.share[name] = total.share[name] = fe.values.at(name) / value - 1.;
  split.lines.push_back(total);
  for (const auto &[part, entries] : cells.refinements) {
    const Compared &refined = runs.at(refined_label + part);
    SplitLine line{"  " + part, {}, refined.cpu};
    for (auto &[name, share] : rest.share) {
      line.share[name] = fe.values.at(name) / refined.values.at(name) - 1.;
      share = (1. + share) / (1. + line.share[name]) - 1.;
    }
    split.lines.push_back(line);
  }
  const std::map<std::string, double> left = rest.share;
  if (!cells.half.empty()) {
    const Compared &fewer = runs.at(fewer_cells);
    // lengths and times are half as large there; tip_over_width is a number
    const double scale = cells.moves ? 2. : 1.;
    number.cpu = fewer.cpu;
    for (auto &[name, share] : rest.share) {
      const double here = whole.values.at(name), limit = 2. * here - scale * fewer.values.at(name);
      number.share[name] = limit / here - 1.;
      share = (1. + share) / (1. + number.share[name]) - 1.;
    }
    split.lines.push_back(number);
  }
  split.lines.push_back(rest);
  for (const auto &[name, share] : rest.share)
    if (const std::string text = remark(cells, total.share.at(name), left.at(name),
                                        cells.half.empty() ? 0. : number.share.at(name), share);
        !text.empty())
      split.remarks[name] = text;
  split.lines.push_back({"all cells", {}, whole.cpu});
  if (cells.has_sides) {
    SplitLine line{"surface (not in the error)", {}, runs.at(free_sides).cpu};
    for (const auto &[name, value] : whole.values)
      line.share[name] = runs.at(free_sides).values.at(name) / value - 1.;
    split.lines.push_back(line);
  }
  return split;
}

std::string cost_in_words(const ErrorSplit &split) {
  const auto cells = std::find_if(split.lines.begin(), split.lines.end(),
                                  [](const SplitLine &line) { return line.what == all_cells; });
  if (cells == split.lines.end() || !cells->cpu || !split.lines[0].cpu) return "";
  const double fine = *cells->cpu, coarse = *split.lines[0].cpu;
  if (!(fine > 0.) || !(coarse > 0.)) return "";
  char text[160];
  const bool fast = fine >= coarse;
  std::snprintf(text, sizeof(text),
                "FE2 takes %.3g s of CPU time, all cells %.3g s: FE2 %s %.3g times as %s.", coarse, fine,
                fast ? "is" : "takes", fast ? fine / coarse : coarse / fine, fast ? "fast" : "long");
  return text;
}
}  // namespace turgor
