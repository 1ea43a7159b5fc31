#include "micro/solve/row_blocks.h"

#include "run/parallel.h"

#include <algorithm>

namespace turgor {
using namespace eight_floats;

namespace {
/// A 3 x 3 block by its rows.
struct Square {
  DoubleRow row[3] = {};

  void add(const DoubleRow a, const DoubleRow b) {
    for (int d = 0; d < 3; ++d) row[d] += a[d] * b;
  }
};

/// The blocks of one body, in the order in which its neighbours are met.
class BodyBlocks {
 public:
  void begin(const std::uint32_t body) {
    me = body;
    common = {};
    neighbours.clear();
    blocks.clear();
  }

  void add(const RowList &list, const std::uint32_t r, const DoubleRow g) {
    common.add(g, list.common[r].v);
    for (std::uint32_t k = list.first[r]; k < list.first[r + 1]; ++k)
      if (list.body[k] != me) of(list.body[k]).add(g, list.entries[k].v);
  }

  /// As PushedLinks gives them: -tangential I - (normal - tangential) e e'.
  void link(const double normal, const double tangential, const DoubleRow e, const std::uint32_t other,
            bool) {
    Square &block = of(other);
    block.add((tangential - normal) * e, e);
    for (int d = 0; d < 3; ++d) block.row[d][d] -= tangential;
  }

  std::uint32_t me = 0;
  Square common;
  std::vector<std::uint32_t> neighbours;
  std::vector<Square> blocks;

 private:
  /// seen[body]: its place among the neighbours, if it is among them; what is left from other bodies tells
  /// itself apart by that.
  Square &of(const std::uint32_t body) {
    if (body >= seen.size()) seen.resize(body + std::size_t(1), 0);
    std::uint32_t k = seen[body];
    if (k >= neighbours.size() || neighbours[k] != body) {
      k = seen[body] = std::uint32_t(neighbours.size());
      neighbours.push_back(body);
      blocks.emplace_back();
    }
    return blocks[k];
  }

  std::vector<std::uint32_t> seen;
};
}  // namespace

std::size_t RowList::memory_bytes() const {
  return 4 * (first.capacity() + body.capacity() + first_of.capacity() + row_of.capacity()) +
         sizeof(BodyVector) * (entries.capacity() + common.capacity() + of_body.capacity());
}

void RowBlocks::build(const RowList &list, const PushedLinks *links, const std::size_t bodies,
                      const unsigned int threads) {
  const Chunks chunks((bodies + width - 1) / width, together);
  parts.resize(chunks.count());
  for_chunks(threads, chunks, [&](const std::size_t from, const std::size_t to) {
    thread_local BodyBlocks all[width];
    thread_local std::vector<EightBlocks> built;
    built.clear();
    Part &part = parts[from / together];
    part.first.assign(1, 0);
    for (std::size_t e = from; e < to; ++e) {
      std::size_t most = 0;
      for (std::size_t lane = 0; lane < width; ++lane) {
        const std::size_t i = width * e + lane;
        BodyBlocks &one = all[lane];
        one.begin(std::uint32_t(i));
        if (i >= bodies) continue;
        for (std::uint32_t k = list.first_of[i]; k < list.first_of[i + 1]; ++k)
          if (list.is_short(list.row_of[k])) one.add(list, list.row_of[k], list.of_body[k].v);
        if (links != nullptr) links->links_of(i, one);
        most = std::max(most, one.blocks.size());
      }
      for (std::size_t k = 0; k <= most; ++k) {
        EightBlocks &eight = built.emplace_back();
        for (int d = 0; d < 3; ++d)
          eight.row[d] = columns([&](const int lane) {
            const BodyBlocks &one = all[lane];
            return k == 0                   ? floats(one.common.row[d])
                   : k <= one.blocks.size() ? floats(one.blocks[k - 1].row[d])
                                            : FloatRow{};
          });
        for (std::size_t lane = 0; lane < width; ++lane)
          eight.to[lane] = k > 0 && k <= all[lane].blocks.size() ? all[lane].neighbours[k - 1] : all[lane].me;
      }
      part.first.push_back(std::uint32_t(built.size()));
    }
    part.blocks.assign(built.begin(), built.end());
  });
}

void RowBlocks::add(const FloatRow *p, const std::size_t begin, const std::size_t end,
                    FloatRow *product) const {
  for (std::size_t i = begin; i < end; i += width) {
    const std::size_t e = i / width;
    const Part &part = parts[e / together];
    const EightBlocks *one = part.blocks.data() + part.first[e % together], *const last =
                                                                                part.blocks.data() +
                                                                                part.first[e % together + 1];
    // bodies that fill up the last eight have rows of p as well
    const Eight me = columns([&](const int lane) { return p[i + std::size_t(lane)]; });
    Eight sum{one->row[0].x * me.x + one->row[0].y * me.y + one->row[0].z * me.z,
              one->row[1].x * me.x + one->row[1].y * me.y + one->row[1].z * me.z,
              one->row[2].x * me.x + one->row[2].y * me.y + one->row[2].z * me.z};
    for (++one; one < last; ++one) {
      const Eight you = columns([&](const int lane) { return p[one->to[lane]]; });
      const EightFloats x = you.x - me.x, y = you.y - me.y, z = you.z - me.z;
      sum.x += one->row[0].x * x + one->row[0].y * y + one->row[0].z * z;
      sum.y += one->row[1].x * x + one->row[1].y * y + one->row[1].z * z;
      sum.z += one->row[2].x * x + one->row[2].y * y + one->row[2].z * z;
    }
    FloatRow rows[width];
    to_rows(sum, rows);
    for (std::size_t lane = 0; lane < std::min(width, end - i); ++lane)
      product[i - begin + lane] += rows[lane];
  }
}

std::size_t RowBlocks::memory_bytes() const {
  std::size_t total = sizeof(Part) * parts.capacity();
  for (const Part &part : parts)
    total += 4 * part.first.capacity() + sizeof(EightBlocks) * part.blocks.capacity();
  return total;
}
}  // namespace turgor
