#include "micro/cells/cell_layout.h"

#include "run/number_text.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace turgor {
namespace {
/// Compensated: equal masses give count times mass, whatever their number.
double sum(const std::vector<double> &mass, const std::size_t begin, const std::size_t end) {
  double total = 0., lost = 0.;
  for (std::size_t i = begin; i < end; ++i) {
    const double next = total + mass[i];
    lost += std::abs(total) >= std::abs(mass[i]) ? (total - next) + mass[i] : (mass[i] - next) + total;
    total = next;
  }
  return total + lost;
}

void require(const bool good, const std::string &what) {
  if (!good) throw std::invalid_argument("This layout of cells is impossible: " + what + ".");
}

void require_all(const std::vector<double> &values, const std::size_t count, const bool zero_too,
                 const std::string &what) {
  require(values.size() == count, what + " needs " + number_text(double(count)) + " values, it has " +
                                      number_text(double(values.size())));
  for (const double v : values)
    require(
        std::isfinite(v) && (v > 0. || (zero_too && v == 0.)),
        what + " is " + number_text(v) + ", but has to be " + (zero_too ? "zero or positive" : "positive"));
}
}  // namespace

double CellLayout::wall_mass(const std::size_t cell) const {
  return sum(node_mass, rings[cell].first, rings[cell].end());
}

double CellLayout::total_wall_mass() const { return sum(node_mass, 0, node_mass.size()); }

double CellLayout::total_fluid_mass() const { return sum(fluid_mass, 0, fluid_mass.size()); }

std::vector<double> CellLayout::positions() const {
  std::vector<double> x;
  x.reserve(2 * nodes.size());
  for (const Vector<2> &node : nodes) x.insert(x.end(), {node[0], node[1]});
  return x;
}

void CellLayout::set_positions(const std::vector<double> &x) {
  require(x.size() == 2 * nodes.size(), "there are two coordinates for every node");
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = {x[2 * i], x[2 * i + 1]};
}

void CellLayout::check() const {
  require(!rings.empty(), "it has no cells");
  std::size_t first = 0;
  for (const WallRing &ring : rings) {
    require(ring.first == first, "rings follow each other without holes");
    require(ring.count >= 3, "a ring of " + number_text(int(ring.count)) + " nodes, but 3 are the least");
    first = ring.end();
  }
  require(first == nodes.size(), "every node belongs to a ring");
  require_all(rest_length, nodes.size(), false, "the bonds' rest length");
  require_all(hinge, nodes.size(), true, "the hinges' stiffness");
  require_all(node_mass, nodes.size(), false, "the nodes' mass");
  require_all(fluid_mass, rings.size(), false, "the cells' fluid mass");
  require(rest_angle.size() == nodes.size(), "every hinge has a rest angle");
  require(spacing > 0. && spring_stiffness > 0., "its spacing and spring stiffness have to be positive");
  for (const LamellaTie &tie : ties) {
    require(tie.a < nodes.size() && tie.b < nodes.size() && tie.a != tie.b, "a tie joins two of its nodes");
    require(tie.stiffness > 0. && std::isfinite(tie.stiffness), "a tie's stiffness has to be positive");
    for (int d = 0; d < 2; ++d)
      require(periodic[d] || tie.shift[d] == 0, "a tie across a side that is not periodic");
  }
}
}  // namespace turgor
