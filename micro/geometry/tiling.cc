#include "micro/geometry/tiling.h"

#include "run/number_text.h"

#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace turgor {
namespace {
double cross(const Vector<2> &a, const Vector<2> &b) { return a[0] * b[1] - a[1] * b[0]; }

std::array<int, 2> minus(const std::array<int, 2> &a, const std::array<int, 2> &b) {
  return {{a[0] - b[0], a[1] - b[1]}};
}
std::array<int, 2> plus(const std::array<int, 2> &a, const std::array<int, 2> &b) {
  return {{a[0] + b[0], a[1] + b[1]}};
}

using Key = std::array<std::int64_t, 4>;
Key key_of(const TilingCorner &from, const TilingCorner &to) {
  return {from.vertex, to.vertex, to.shift[0] - from.shift[0], to.shift[1] - from.shift[1]};
}

[[noreturn]] void refuse(const std::string &what) {
  throw std::invalid_argument("These cells are no tiling: " + what + ".");
}

std::string cell_name(const std::size_t cell) { return "cell " + number_text(double(cell + 1)); }

/// floor(a / b) and what is left.
std::pair<int, int> floored(const int a, const int b) {
  const int rest = (a % b + b) % b;
  return {(a - rest) / b, rest};
}

/// Second period less as many first ones as bring it nearest to a right angle; every corner stays where it
/// is.
void make_upright(Tiling &tiling) {
  const Vector<2> first = tiling.lattice.col(0);
  const int k = int(std::ceil(tiling.lattice.col(1).dot(first) / first.squaredNorm() - 0.5 - 1e-9));
  tiling.lattice.col(1) -= double(k) * first;
  for (auto &cell : tiling.cells)
    for (TilingCorner &corner : cell) corner.shift[0] += k * corner.shift[1];
}
}  // namespace

double polygon_area(const std::vector<Vector<2>> &outline) {
  double twice =
      0.;  // relative to the first corner: round-off does not grow with the distance from the origin
  for (std::size_t k = 1; k + 1 < outline.size(); ++k)
    twice += cross(outline[k] - outline[0], outline[k + 1] - outline[0]);
  return 0.5 * twice;
}

Vector<2> polygon_centroid(const std::vector<Vector<2>> &outline) {
  Vector<2> moment = Vector<2>::Zero();
  double twice = 0.;
  for (std::size_t k = 1; k + 1 < outline.size(); ++k) {
    const Vector<2> a = outline[k] - outline[0], b = outline[k + 1] - outline[0];
    moment += cross(a, b) * (a + b) / 3.;
    twice += cross(a, b);
  }
  return outline[0] + moment / twice;
}

Vector<2> Tiling::place(const TilingCorner &corner) const {
  return vertices[corner.vertex] + lattice * Vector<2>(corner.shift[0], corner.shift[1]);
}

std::vector<Vector<2>> Tiling::outline(const std::size_t cell) const {
  std::vector<Vector<2>> result;
  for (const TilingCorner &corner : cells[cell]) result.push_back(place(corner));
  return result;
}

double Tiling::area(const std::size_t cell) const { return polygon_area(outline(cell)); }

double Tiling::total_area() const {
  double sum = 0.;
  for (std::size_t c = 0; c < cells.size(); ++c) sum += area(c);
  return sum;
}

double Tiling::side_length(const std::size_t cell, const std::size_t side) const {
  return (place(cells[cell][(side + 1) % cells[cell].size()]) - place(cells[cell][side])).norm();
}

std::vector<std::vector<FacingSide>> Tiling::facing() const {
  std::map<Key, std::pair<std::uint32_t, std::uint32_t>> sides;
  for (std::uint32_t c = 0; c < cells.size(); ++c)
    for (std::uint32_t k = 0; k < cells[c].size(); ++k)
      if (!sides.emplace(key_of(cells[c][k], cells[c][(k + 1) % cells[c].size()]), std::pair{c, k}).second)
        refuse("two cells, one of them " + cell_name(c) + ", lie on the same side of a wall");
  std::vector<std::vector<FacingSide>> result(cells.size());
  for (std::uint32_t c = 0; c < cells.size(); ++c)
    for (std::uint32_t k = 0; k < cells[c].size(); ++k) {
      const TilingCorner &from = cells[c][k], &to = cells[c][(k + 1) % cells[c].size()];
      FacingSide other;
      if (const auto found = sides.find(key_of(to, from)); found != sides.end()) {
        other.cell = found->second.first;
        other.side = found->second.second;
        other.shift =
            minus(to.shift, cells[other.cell][other.side].shift);  // both begin, or end, at that vertex
      }
      result[c].push_back(other);
    }
  return result;
}

void Tiling::check() const {
  if (cells.empty()) refuse("there are none");
  if (periodic && !(lattice.determinant() > 0.))
    refuse("the periods have to span a positive area, counter-clockwise");
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].size() < 3)
      refuse(cell_name(c) + " has " + number_text(double(cells[c].size())) + " corners, 3 are the least");
    for (std::size_t k = 0; k < cells[c].size(); ++k) {
      const TilingCorner &corner = cells[c][k];
      if (corner.vertex >= vertices.size() || !place(corner).allFinite())
        refuse("a corner of " + cell_name(c) + " is nowhere");
      if (corner == cells[c][(k + 1) % cells[c].size()]) refuse(cell_name(c) + " has the same corner twice");
      if (!periodic && corner.shift != std::array<int, 2>{{0, 0}})
        refuse(cell_name(c) + " reaches across a period, but the piece is bounded");
    }
    if (!(area(c) > 0.))
      refuse(cell_name(c) + " does not run counter-clockwise around an area (" + number_text(area(c)) +
             " m^2)");
  }
  bool border = !periodic;
  for (const auto &sides : facing())
    for (const FacingSide &side : sides) border = border || !side.exists();
  const double whole = lattice.determinant();
  if (!border && !(std::abs(total_area() - whole) <= 1e-9 * whole))
    refuse("their areas sum to " + number_text(total_area()) + " m^2, but a period has " +
           number_text(whole) + " m^2");
}

Tiling replicated(const Tiling &tiling, const unsigned int columns, const unsigned int rows) {
  if (!tiling.periodic || columns < 1 || rows < 1)
    throw std::invalid_argument(
        "Only a periodic tiling has copies side by side, at least one in each direction.");
  Tiling result;
  const int n = int(columns), m = int(rows);
  result.lattice.col(0) = double(n) * tiling.lattice.col(0);
  result.lattice.col(1) = double(m) * tiling.lattice.col(1);
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i)
      for (const Vector<2> &vertex : tiling.vertices)
        result.vertices.push_back(vertex + tiling.lattice * Vector<2>(i, j));
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i)
      for (const auto &cell : tiling.cells) {
        result.cells.emplace_back();
        for (const TilingCorner &corner : cell) {
          const auto [across, column] = floored(i + corner.shift[0], n);
          const auto [up, row] = floored(j + corner.shift[1], m);
          result.cells.back().push_back(
              {std::uint32_t((row * n + column) * int(tiling.vertices.size())) + corner.vertex,
               {{across, up}}});
        }
      }
  make_upright(result);
  return result;
}

Tiling replicated_upright(const Tiling &tiling, const unsigned int columns, const unsigned int rows) {
  const auto upright = [](const Tiling &t) {
    return std::abs(t.lattice.col(0).dot(t.lattice.col(1))) < 1e-9 * t.lattice.determinant();
  };
  if (upright(tiling)) return replicated(tiling, columns, rows);
  const Tiling pair = replicated(tiling, 1, 2);
  if (rows % 2 != 0 || tiling.cells.size() != 1 || !upright(pair))
    throw std::invalid_argument("rows that are moved by half a cell make an upright block two by two");
  const Tiling pairs = replicated(pair, columns, rows / 2);
  Tiling result = pairs;
  for (unsigned int row = 0; row < rows; ++row)
    for (unsigned int column = 0; column < columns; ++column)
      result.cells[row * columns + column] = pairs.cells[2 * (row / 2 * columns + column) + row % 2];
  return result;
}

Tiling rotated(Tiling tiling, const double angle) {
  Tensor2<2> turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  tiling.lattice = (turn * tiling.lattice).eval();
  for (Vector<2> &vertex : tiling.vertices) vertex = (turn * vertex).eval();
  return tiling;
}

Tiling without_short_sides(const Tiling &tiling, const double shortest) {
  // Vertex v is its leader's image: place of v = place of leader + H shift + an offset that the middle makes
  // zero.
  std::vector<TilingCorner> leader(tiling.vertices.size());
  std::vector<std::vector<std::uint32_t>> members(tiling.vertices.size());
  for (std::uint32_t v = 0; v < leader.size(); ++v) {
    leader[v].vertex = v;
    members[v] = {v};
  }
  for (std::size_t c = 0; c < tiling.cells.size(); ++c)
    for (std::size_t k = 0; k < tiling.cells[c].size(); ++k) {
      if (!(tiling.side_length(c, k) < shortest)) continue;
      const TilingCorner &from = tiling.cells[c][k], &to = tiling.cells[c][(k + 1) % tiling.cells[c].size()];
      const TilingCorner a = leader[from.vertex], b = leader[to.vertex];
      if (a.vertex == b.vertex) continue;
      // from.shift + a.shift belongs to leader a, to.shift + b.shift to leader b: the same place from now on
      const std::array<int, 2> apart = minus(plus(from.shift, a.shift), plus(to.shift, b.shift));
      for (const std::uint32_t v : members[b.vertex]) {
        leader[v] = {a.vertex, plus(leader[v].shift, apart)};
        members[a.vertex].push_back(v);
      }
      members[b.vertex].clear();
    }
  Tiling result = tiling;
  std::vector<std::uint32_t> number(leader.size(), 0);
  result.vertices.clear();
  for (std::uint32_t v = 0; v < leader.size(); ++v)
    if (!members[v].empty()) {
      Vector<2> middle = Vector<2>::Zero();
      for (const std::uint32_t m : members[v])
        middle += tiling.vertices[m] - tiling.lattice * Vector<2>(leader[m].shift[0], leader[m].shift[1]);
      number[v] = std::uint32_t(result.vertices.size());
      result.vertices.push_back(middle / double(members[v].size()));
    }
  for (std::size_t c = 0; c < result.cells.size(); ++c) {
    std::vector<TilingCorner> kept;
    for (const TilingCorner &corner : result.cells[c]) {
      const TilingCorner &to = leader[corner.vertex];
      const TilingCorner next{number[to.vertex], plus(corner.shift, to.shift)};
      if (kept.empty() || !(kept.back() == next)) kept.push_back(next);
    }
    while (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
    if (kept.size() < 3)
      refuse(cell_name(c) + " is smaller than the distance at which vertices are merged (" +
             number_text(shortest) + " m)");
    result.cells[c] = std::move(kept);
  }
  return result;
}
}  // namespace turgor
