#include "micro/terms/plane_net.h"

#include "micro/geometry/bins.h"
#include "micro/geometry/laguerre_tiling.h"
#include "micro/laws/counter_random.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
Vector<2> PlaneNet::along(const Bond &bond) const {
  return nodes[bond.b] + Vector<2>(bond.shift[0] * periods[0], bond.shift[1] * periods[1]) - nodes[bond.a];
}

double PlaneNet::mean_length() const {
  double sum = 0.;
  for (const Bond &bond : bonds) sum += along(bond).norm();
  return sum / double(bonds.size());
}

namespace {
void check_size(const unsigned int columns, const unsigned int rows) {
  if (columns < 4 || rows < 4 || rows % 2 != 0)
    throw std::invalid_argument(
        "a periodic net needs at least 4 columns and 4 rows, and an even number of "
        "rows");
}
}  // namespace

PlaneNet sixfold_net(const double length, const unsigned int columns, const unsigned int rows) {
  check_size(columns, rows);
  const double height = 0.5 * std::sqrt(3.) * length;
  PlaneNet net;
  net.periods = {columns * length, rows * height};
  const auto number = [&](const int column, const int row) {
    const int n = int(columns), m = int(rows);
    return std::uint32_t((row + m) % m * n + (column + n) % n);
  };
  for (int row = 0; row < int(rows); ++row)
    for (int column = 0; column < int(columns); ++column) {
      net.nodes.push_back({(column + 0.5 * (row % 2)) * length, row * height});
      // to the right, and to both above
      const int left = column - (row % 2 == 0);
      for (const auto &[c, r] : {std::array{column + 1, row}, {left, row + 1}, {left + 1, row + 1}})
        net.bonds.push_back(
            {number(column, row), number(c, r), {c < 0 ? -1 : c >= int(columns), r >= int(rows)}});
    }
  return net;
}

PlaneNet random_net(const double length, const unsigned int columns, const unsigned int rows,
                    const std::uint64_t seed) {
  check_size(columns, rows);
  constexpr unsigned int rounds = 2;
  const Vector<2> periods(columns, 0.5 * std::sqrt(3.) * rows);
  const std::size_t n = std::size_t(columns) * rows;
  std::vector<Vector<2>> seeds;
  for (std::size_t i = 0; i < n; ++i)
    seeds.push_back({periods[0] * random_uniform(seed, 2 * i), periods[1] * random_uniform(seed, 2 * i + 1)});
  const Tiling cells = laguerre_tiling(periods, seeds, std::vector<double>(n, 1.), rounds);
  PlaneNet net;
  net.periods = periods;
  for (std::size_t i = 0; i < n; ++i) net.nodes.push_back(polygon_centroid(cells.outline(i)));
  const auto facing = cells.facing();
  for (std::uint32_t i = 0; i < n; ++i)
    for (const FacingSide &side : facing[i])
      if (side.exists() && i < side.cell) net.bonds.push_back({i, side.cell, side.shift});
  const double scale = length / net.mean_length();
  net.periods *= scale;
  for (Vector<2> &node : net.nodes) node *= scale;
  return net;
}

void centre(PlaneNet &net) {
  std::vector<std::array<int, 2>> moved(net.nodes.size());
  for (std::size_t i = 0; i < net.nodes.size(); ++i)
    for (int d = 0; d < 2; ++d) {
      moved[i][std::size_t(d)] = -int(std::floor(net.nodes[i][d] / net.periods[d]));
      net.nodes[i][d] += (moved[i][std::size_t(d)] - 0.5) * net.periods[d];
    }
  for (PlaneNet::Bond &bond : net.bonds)
    for (std::size_t d = 0; d < 2; ++d) bond.shift[d] += moved[bond.a][d] - moved[bond.b][d];
}

PlaneNet repeated(const PlaneNet &net, const unsigned int along_x, const unsigned int along_y) {
  const std::array<int, 2> count{int(along_x), int(along_y)};
  const std::uint32_t own = std::uint32_t(net.nodes.size());
  PlaneNet all;
  all.periods = {along_x * net.periods[0], along_y * net.periods[1]};
  for (int row = 0; row < count[1]; ++row)
    for (int column = 0; column < count[0]; ++column) {
      for (const Vector<2> &node : net.nodes)
        all.nodes.push_back(node + Vector<2>(column * net.periods[0], row * net.periods[1]));
      for (const PlaneNet::Bond &bond : net.bonds) {
        std::array<int, 2> piece{column + bond.shift[0], row + bond.shift[1]}, shift{};
        for (std::size_t d = 0; d < 2; ++d) {
          shift[d] = int(std::floor(double(piece[d]) / count[d]));
          piece[d] -= shift[d] * count[d];
        }
        all.bonds.push_back({std::uint32_t(row * count[0] + column) * own + bond.a,
                             std::uint32_t(piece[1] * count[0] + piece[0]) * own + bond.b, shift});
      }
    }
  return all;
}

void carve(PlaneNet &net, const std::vector<Vector<2>> &places, const double radius) {
  constexpr std::uint32_t gone = ~std::uint32_t(0);
  std::vector<double> at[2];
  double low[2], high[2];
  for (int d = 0; d < 2; ++d) {
    for (const Vector<2> &place : places) at[d].push_back(place[d]);
    const auto [least, most] = std::minmax_element(at[d].begin(), at[d].end());
    low[d] = *least;
    high[d] = *most;
  }
  const double *const x[2] = {at[0].data(), at[1].data()};
  const Bins<2> by_place(x, std::uint32_t(places.size()), radius, low, high);
  const auto covered = [&](const Vector<2> &node) {
    bool is = false;
    by_place.near(
        node.data(), [&](const std::uint32_t k) { is |= (node - places[k]).norm() <= radius; }, 1);
    return is;
  };
  std::vector<std::uint32_t> number(net.nodes.size(), gone);
  std::vector<Vector<2>> left;
  for (std::size_t i = 0; i < net.nodes.size(); ++i)
    if (!covered(net.nodes[i])) {
      number[i] = std::uint32_t(left.size());
      left.push_back(net.nodes[i]);
    }
  std::vector<PlaneNet::Bond> bonds;
  for (const PlaneNet::Bond &bond : net.bonds)
    if (number[bond.a] != gone && number[bond.b] != gone)
      bonds.push_back({number[bond.a], number[bond.b], bond.shift});
  net.nodes = std::move(left);
  net.bonds = std::move(bonds);
}

void remove_bonds(PlaneNet &net, const double kept, const std::uint64_t seed) {
  std::vector<PlaneNet::Bond> left;
  for (std::size_t k = 0; k < net.bonds.size(); ++k)
    if (random_uniform(mix_bits(seed ^ 0x6b6f6e64ull), k) < kept) left.push_back(net.bonds[k]);
  net.bonds = std::move(left);
}
}  // namespace turgor
