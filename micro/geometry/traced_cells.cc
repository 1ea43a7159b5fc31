#include "micro/geometry/traced_cells.h"

#include "run/number_text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace turgor {
namespace {
using Corner = std::pair<int, int>;  // of pixels: (x, y) is the lower left one of pixel (x, y)

constexpr int step_x[4] = {1, 0, -1, 0}, step_y[4] = {0, 1, 0, -1};  // right, up, left, down

/// Labels of one fault, each with what else is to be said of it; told together, so that an image is mended at
/// once.
class Faults {
 public:
  Faults(std::string one_, std::string many_, std::string advice_)
      : one(std::move(one_)), many(std::move(many_)), advice(std::move(advice_)) {}

  void add(const std::uint32_t label, const std::string &where = "") {
    if (++count <= named) labels += (count > 1 ? ", " : "") + number_text(label) + where;
  }

  /// Empty without any; else sentences, the last with its full stop.
  std::string text() const {
    if (count == 0) return "";
    const std::string more = count > named ? " and " + number_text(count - named) + " more" : "";
    return (count == 1 ? "The cell with the label " + labels + " " + one
                       : "The cells with the labels " + labels + more + " " + many) +
           advice + ".";
  }

 private:
  static constexpr std::size_t named = 10;
  std::string one, many, advice, labels;
  std::size_t count = 0;
};

/// The pixel to the left, or right, of the edge that leaves a corner in a direction.
std::uint32_t beside(const LabelImage &image, const Corner &c, const int direction, const bool left) {
  const int d = left ? direction : (direction + 3) % 4;  // quadrant counted from right-up, counter-clockwise
  return image.around(c.first - (d == 1 || d == 2), c.second - (d == 2 || d == 3));
}

/// Whether three edges between labels or more end there.
bool is_junction(const LabelImage &image, const Corner &c) {
  int lines = 0;
  for (int d = 0; d < 4; ++d) lines += beside(image, c, d, true) != beside(image, c, d, false);
  return lines > 2;
}

/// Once around the label, it on the left, from its first pixel on.
std::vector<Corner> walk_around(const LabelImage &image, const Corner &start, const std::uint32_t label) {
  std::vector<Corner> loop;
  Corner at = start;
  int direction = 0;
  do {
    loop.push_back(at);
    at = {at.first + step_x[direction], at.second + step_y[direction]};
    // left first: pixels that touch at a corner alone are not together
    for (const int turn : {1, 0, 3})
      if (const int next = (direction + turn) % 4;
          beside(image, at, next, true) == label && beside(image, at, next, false) != label) {
        direction = next;
        break;
      }
  } while (!(at == start && direction == 0));
  return loop;
}

double distance_to_line(const Corner &p, const Corner &a, const Corner &b) {
  const double x = b.first - a.first, y = b.second - a.second, u = p.first - a.first, v = p.second - a.second,
               length = std::hypot(x, y);
  return length > 0. ? std::abs(x * v - y * u) / length : std::hypot(u, v);
}

/// Douglas and Peucker: corners of `line` between its ends that are kept.
void keep(const std::vector<Corner> &line, const std::size_t from, const std::size_t to,
          const double tolerance, std::vector<bool> &kept) {
  double most = tolerance;
  std::size_t worst = from;
  for (std::size_t k = from + 1; k < to; ++k)
    if (const double d = distance_to_line(line[k], line[from], line[to]); d > most) {
      most = d;
      worst = k;
    }
  if (worst == from) return;
  kept[worst] = true;
  keep(line, from, worst, tolerance, kept);
  keep(line, worst, to, tolerance, kept);
}

/// A line between two junctions, straightened; the same corners from either end.
std::vector<Corner> straightened(std::vector<Corner> line, const double tolerance) {
  const bool backwards = std::lexicographical_compare(line.rbegin(), line.rend(), line.begin(), line.end());
  if (backwards) std::reverse(line.begin(), line.end());
  std::vector<bool> kept(line.size(), false);
  kept.front() = kept.back() = true;
  keep(line, 0, line.size() - 1, tolerance, kept);
  std::vector<Corner> result;
  for (std::size_t k = 0; k < line.size(); ++k)
    if (kept[k]) result.push_back(line[k]);
  if (backwards) std::reverse(result.begin(), result.end());
  return result;
}

bool touches_space(const LabelImage &image, const Corner &c) {
  for (int d = 0; d < 4; ++d)
    if (beside(image, c, d, true) == 0) return true;
  return false;
}

/// Where a loop is cut: its junctions; of one that meets hardly any other also places of its free side, far
/// from each other.
std::vector<std::size_t> cuts_of(const LabelImage &image, const std::vector<Corner> &loop) {
  std::vector<std::size_t> cuts;
  for (std::size_t k = 0; k < loop.size(); ++k)
    if (is_junction(image, loop[k])) cuts.push_back(k);
  while (cuts.size() < 3) {
    std::size_t best = 0;
    double most = -1.;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      if (!touches_space(image, loop[k])) continue;
      double least = 1e300;
      for (const std::size_t c : cuts)
        least = std::min(least, std::hypot(loop[k].first - loop[c].first, loop[k].second - loop[c].second));
      if (least > most && least > 0.) {
        most = least;
        best = k;
      }
    }
    cuts.push_back(best);
    std::sort(cuts.begin(), cuts.end());
  }
  return cuts;
}

/// Pixels of a label that hang together through their sides.
struct Pieces {
  std::vector<int> of;              // per pixel
  std::vector<std::size_t> first;   // pixel of a piece, the lowest
  std::vector<std::size_t> pixels;  // how many
  std::vector<bool> at_border;
};

Pieces pieces_of(const LabelImage &image) {
  Pieces pieces;
  pieces.of.assign(image.labels.size(), -1);
  std::vector<std::size_t> todo;
  for (std::size_t start = 0; start < image.labels.size(); ++start) {
    if (pieces.of[start] >= 0) continue;
    const int piece = int(pieces.first.size());
    pieces.first.push_back(start);
    pieces.pixels.push_back(0);
    pieces.at_border.push_back(false);
    pieces.of[start] = piece;
    todo = {start};
    while (!todo.empty()) {
      const std::size_t i = todo.back();
      todo.pop_back();
      ++pieces.pixels[piece];
      const int x = int(i % std::size_t(image.width)), y = int(i / std::size_t(image.width));
      if (x == 0 || y == 0 || x == image.width - 1 || y == image.height - 1) pieces.at_border[piece] = true;
      for (int d = 0; d < 4; ++d) {
        const int u = x + step_x[d], v = y + step_y[d];
        if (u < 0 || v < 0 || u >= image.width || v >= image.height) continue;
        const std::size_t j = std::size_t(v) * image.width + u;
        if (pieces.of[j] < 0 && image.labels[j] == image.labels[i]) {
          pieces.of[j] = piece;
          todo.push_back(j);
        }
      }
    }
  }
  return pieces;
}

/// Corners of the cell whose lowest pixel this is, as vertices of the tiling.
std::vector<TilingCorner> trace(const LabelImage &image, const std::vector<Corner> &loop, const double pixel,
                                const double tolerance, std::map<Corner, std::uint32_t> &vertices,
                                Tiling &tiling) {
  std::vector<TilingCorner> cell;
  const std::vector<std::size_t> cuts = cuts_of(image, loop);
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    const std::size_t to = cuts[(k + 1) % cuts.size()];
    std::vector<Corner> line = {loop[cuts[k]]};
    for (std::size_t i = cuts[k]; i != to;) {
      i = (i + 1) % loop.size();
      line.push_back(loop[i]);
    }
    const std::vector<Corner> straight = straightened(line, tolerance);
    for (std::size_t i = 0; i + 1 < straight.size(); ++i) {
      const auto [found, is_new] = vertices.emplace(straight[i], std::uint32_t(tiling.vertices.size()));
      if (is_new) tiling.vertices.push_back(pixel * Vector<2>(straight[i].first, straight[i].second));
      cell.push_back({found->second, {{0, 0}}});
    }
  }
  return cell;
}

/// In pixels.
double area_within(const std::vector<Corner> &loop) {
  double twice = 0.;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Corner &a = loop[k], &b = loop[(k + 1) % loop.size()];
    twice += double(a.first) * b.second - double(a.second) * b.first;
  }
  return 0.5 * twice;
}
}  // namespace

Tiling trace_cells(const LabelImage &image, const double pixel, const double tolerance) {
  const Pieces pieces = pieces_of(image);
  std::set<std::uint32_t> labels, torn;
  std::map<Corner, std::uint32_t> vertices;
  Tiling tiling;
  tiling.periodic = false;
  Faults apart("lies in two pieces or more", "lie in two pieces or more",
               " (one of them at the pixel in brackets, from the lower left)"),
      cut("touches the border of the image, so that its outline is not known",
          "touch the border of the image, so that their outlines are not known",
          ": leave such cells out (label 0)"),
      holed("has a hole or another cell in it", "have holes or other cells in them", "");
  for (std::size_t piece = 0; piece < pieces.first.size(); ++piece) {
    const std::size_t start = pieces.first[piece];
    const std::uint32_t label = image.labels[start];
    const int x = int(start % std::size_t(image.width)), y = int(start / std::size_t(image.width));
    if (label == 0) continue;
    if (!labels.insert(label).second) {
      if (torn.insert(label).second) apart.add(label, " (" + number_text(x) + ", " + number_text(y) + ")");
      continue;
    }
    if (pieces.at_border[piece]) {
      cut.add(label);
      continue;
    }
    const std::vector<Corner> loop = walk_around(image, {x, y}, label);
    if (std::lround(area_within(loop)) != long(pieces.pixels[piece])) {
      holed.add(label);
      continue;
    }
    tiling.cells.push_back(trace(image, loop, pixel, tolerance, vertices, tiling));
  }
  std::string wrong;
  for (const Faults *faults : {&apart, &cut, &holed})
    if (const std::string text = faults->text(); !text.empty()) wrong += (wrong.empty() ? "" : " ") + text;
  if (!wrong.empty()) throw std::invalid_argument(wrong);
  if (tiling.cells.empty())
    throw std::invalid_argument("The image has no cells: all of its pixels have the label 0.");
  tiling.check();
  return tiling;
}
}  // namespace turgor
