#include "micro/cells/air_spaces.h"

#include "micro/cells/ring_geometry.h"

#include <limits>
#include <stdexcept>

namespace turgor {
namespace {
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

struct Partner {
  std::uint32_t node;
  std::array<int, 2> shift;
};

std::array<int, 2> sum(const std::array<int, 2> &a, const std::array<int, 2> &b) {
  return {{a[0] + b[0], a[1] + b[1]}};
}

/// Per node, who is tied to it, and moved by which periods.
std::vector<std::vector<Partner>> partners(const CellLayout &layout) {
  std::vector<std::vector<Partner>> all(layout.nodes.size());
  for (const LamellaTie &tie : layout.ties) {
    all[tie.a].push_back({tie.b, tie.shift});
    all[tie.b].push_back({tie.a, {{-tie.shift[0], -tie.shift[1]}}});
  }
  return all;
}

/// Stretches without ties of two bonds or more, as they are in the cell itself.
std::vector<AirFace> faces_of(const CellLayout &layout, const std::vector<std::vector<Partner>> &tied) {
  std::vector<AirFace> faces;
  for (std::size_t c = 0; c < layout.cells(); ++c) {
    const WallRing &ring = layout.rings[c];
    std::vector<std::uint32_t> held;
    for (std::uint32_t k = 0; k < ring.count; ++k)
      if (!tied[ring.first + k].empty()) held.push_back(k);
    if (held.empty())
      throw std::invalid_argument(
          "A cell of this tissue would be tied to no other: its walls are all shorter than two "
          "Structure/Gap. Use a smaller one.");
    for (std::size_t i = 0; i < held.size(); ++i) {
      const std::uint32_t next = i + 1 < held.size() ? held[i + 1] : held[0] + ring.count;
      if (next - held[i] > 1) faces.push_back({std::uint32_t(c), ring.first + held[i], next - held[i]});
    }
  }
  return faces;
}

std::uint32_t end_of(const CellLayout &layout, const AirFace &face) {
  const WallRing &ring = layout.rings[face.ring];
  return ring.first + (face.first - ring.first + face.bonds) % ring.count;
}
}  // namespace

std::vector<AirSpace> find_air_spaces(const CellLayout &layout) {
  const auto tied = partners(layout);
  const std::vector<AirFace> faces = faces_of(layout, tied);
  std::vector<std::uint32_t> begins(layout.nodes.size(), none);  // the face that begins at a node
  for (std::uint32_t f = 0; f < faces.size(); ++f) begins[faces[f].first] = f;
  std::vector<unsigned char> seen(faces.size(), 0);
  std::vector<AirSpace> all;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    if (seen[f]) continue;
    AirSpace space;
    std::array<int, 2> shift{};
    std::uint32_t at = f;
    do {
      seen[at] = 1;
      space.push_back(faces[at]);
      space.back().shift = shift;
      const std::uint32_t end = end_of(layout, faces[at]);
      std::uint32_t next = none;
      for (const Partner &partner : tied[end])
        if (begins[partner.node] != none && next == none) {
          next = begins[partner.node];
          shift = sum(shift, partner.shift);
        }
      if (next == none || (seen[next] && next != f))
        throw std::invalid_argument("The air spaces of this tissue do not close.");
      at = next;
    } while (at != f);
    if (shift != std::array<int, 2>{})
      throw std::invalid_argument(
          "The air spaces of this tissue would join to channels without end, and nothing would hold its "
          "cells together across them. Use a smaller Structure/Gap.");
    all.push_back(std::move(space));
  }
  return all;
}

double air_area(const CellLayout &layout, const AirSpace &space, const std::vector<double> &x,
                const Tensor2<2> &H) {
  const auto place = [&](const AirFace &face, const std::size_t node) -> Vector<2> {
    return at(x, node) + H.col(0) * double(face.shift[0]) + H.col(1) * double(face.shift[1]);
  };
  const Vector<2> origin = place(space[0], space[0].first);
  double twice = 0.;
  Vector<2> last = Vector<2>::Zero();
  for (const AirFace &face : space) {
    std::size_t node = face.first;
    for (std::uint32_t k = 0; k <= face.bonds; ++k, node = layout.rings[face.ring].after(node)) {
      const Vector<2> here = place(face, node) - origin;
      twice += last[1] * here[0] - last[0] * here[1];  // the way round is clockwise
      last = here;
    }
  }
  return 0.5 * twice;
}

double air_rim(const CellLayout &layout, const AirSpace &space, const std::vector<double> &x) {
  double length = 0.;
  for (const AirFace &face : space) {
    std::size_t node = face.first;
    for (std::uint32_t k = 0; k < face.bonds; ++k) {
      const std::size_t next = layout.rings[face.ring].after(node);
      length += (at(x, next) - at(x, node)).norm();
      node = next;
    }
  }
  return 0.5 * length;
}
}  // namespace turgor
