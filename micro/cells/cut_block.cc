#include "micro/cells/cut_block.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace turgor {
namespace {
/// Rising, each once.
void sort_out(std::vector<std::uint32_t> &nodes) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

/// Those nearest the middle of the heights that `side` spans.
std::vector<std::uint32_t> middle_of(const CellLayout &laid, const std::vector<std::uint32_t> &side) {
  const auto lower = [&](const std::uint32_t a, const std::uint32_t b) {
    return laid.nodes[a][1] < laid.nodes[b][1];
  };
  const auto [lowest, highest] = std::minmax_element(side.begin(), side.end(), lower);
  const double middle = 0.5 * (laid.nodes[*lowest][1] + laid.nodes[*highest][1]);
  const auto distance = [&](const std::uint32_t node) { return std::abs(laid.nodes[node][1] - middle); };
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::uint32_t node : side) nearest = std::min(nearest, distance(node));
  std::vector<std::uint32_t> found;
  for (const std::uint32_t node : side)
    if (distance(node) < nearest + 0.01 * laid.spacing) found.push_back(node);
  return found;
}
/// Each with its share of the height, as the reference has it; the block repeats itself upwards.
std::vector<CutBlock::SideNode> shares_of(const CellLayout &reference, std::vector<std::uint32_t> nodes) {
  const auto y = [&](const std::size_t k) { return reference.nodes[nodes[k]][1]; };
  std::stable_sort(nodes.begin(), nodes.end(), [&](const std::uint32_t a, const std::uint32_t b) {
    return reference.nodes[a][1] < reference.nodes[b][1];
  });
  const double height = reference.lattice(1, 1);
  std::vector<CutBlock::SideNode> side;
  const std::size_t n = nodes.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double below = k > 0 ? y(k - 1) : y(n - 1) - height, above = k + 1 < n ? y(k + 1) : y(0) + height;
    side.push_back({nodes[k], 0.5 * (above - below)});
  }
  return side;
}
}  // namespace

std::vector<CutBlock::Pull> CutBlock::carrying(const Vector<2> &traction) const {
  std::vector<Pull> all;
  for (const SideNode &one : right)
    all.push_back({one.node, one.height * layout.parameters.depth * traction});
  return all;
}

std::vector<CutBlock::Pull> CutBlock::pulls(const std::function<Vector<2>(std::uint32_t)> &place) const {
  std::vector<Pull> all;
  if (surfaces == Surfaces::free || surfaces == Surfaces::osmosis) return all;
  for (const LamellaTie &tie : cut) {
    const LamellaSpring spring{tie.stiffness};
    const Vector<2> force =
        spring.force_on_a(LamellaSpring::gap(place(tie.a), place(tie.b), tie.shift, layout.lattice));
    all.push_back({tie.a, force});
    all.push_back({tie.b, -force});
  }
  return all;
}

CutBlock cut_out(const CellLayout &laid, const CellLayout &reference, const Surfaces surfaces) {
  if (!reference.periodic[0] || !reference.periodic[1] || laid.nodes.size() != reference.nodes.size())
    throw std::invalid_argument(
        "A block is cut out of tissue that is periodic both ways, as laid and as it is at F = I.");
  const bool slab = surfaces == Surfaces::slab;
  CutBlock block;
  block.surfaces = surfaces;
  block.layout = reference;
  block.layout.periodic = {false, slab};
  block.layout.ties.clear();
  block.width = reference.lattice.col(0).norm();
  block.density = (reference.total_fluid_mass() + reference.total_wall_mass()) /
                  (reference.lattice.determinant() * reference.parameters.depth);
  std::vector<std::uint32_t> right;
  for (const LamellaTie &tie : reference.ties) {
    if (tie.shift[0] == 0 && (slab || tie.shift[1] == 0)) {
      block.layout.ties.push_back(tie);
      continue;
    }
    block.cut.push_back(tie);
    if (tie.shift[0] !=
        0)  // the image that is displaced along the period belongs to what follows at the right
    {
      block.clamped.push_back(tie.shift[0] > 0 ? tie.b : tie.a);
      right.push_back(tie.shift[0] > 0 ? tie.a : tie.b);
    }
  }
  if (right.empty())
    throw std::invalid_argument(
        "A block whose cells are tied to nothing at the right side has no side to be clamped at.");
  sort_out(block.clamped);
  sort_out(right);
  block.probe = middle_of(laid, right);
  block.right = shares_of(reference, right);
  return block;
}
}  // namespace turgor
