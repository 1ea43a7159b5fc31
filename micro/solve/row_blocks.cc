#include "micro/solve/row_blocks.h"

#include "run/parallel.h"

#include <algorithm>

namespace turgor {
using namespace eight_floats;

namespace {
/// A 3 x 3 block by its columns, while it is summed.
struct Columns {
  DoubleRow column[3] = {};

  /// += a b'
  void add(const DoubleRow a, const DoubleRow b) {
    for (int d = 0; d < 3; ++d) column[d] += b[d] * a;
  }
  void add(const Columns &other) {
    for (int d = 0; d < 3; ++d) column[d] += other.column[d];
  }
};

/// Links of one body, as PushedLinks gives them: tangential I + (normal - tangential) e e' on the diagonal,
/// less it elsewhere.
struct LinkSums {
  Columns *sums;
  const std::uint16_t *place;

  void link(const double normal, const double tangential, const DoubleRow e, std::uint32_t, bool) {
    Columns block;
    block.add((normal - tangential) * e, e);
    for (int d = 0; d < 3; ++d) block.column[d][d] += tangential;
    Columns &other = sums[*place++];
    for (int d = 0; d < 3; ++d) {
      sums[0].column[d] += block.column[d];
      other.column[d] -= block.column[d];
    }
  }
};

/// The neighbours of one body after another, in the order in which they are met; itself first.
class Neighbours {
 public:
  explicit Neighbours(std::vector<std::uint32_t> &all_) : all(all_) {}
  void begin(const std::uint32_t body) {
    first = all.size();
    place_of(body);
  }
  /// seen[body]: its place, if it is among them; what is left of other bodies' tells itself apart by that.
  std::uint16_t place_of(const std::uint32_t body) {
    if (body >= seen.size()) seen.resize(body + std::size_t(1), 0);
    if (first + seen[body] >= all.size() || all[first + seen[body]] != body) {
      seen[body] = std::uint16_t(all.size() - first);
      all.push_back(body);
    }
    return seen[body];
  }

 private:
  std::vector<std::uint32_t> &all;
  std::size_t first = 0;
  std::vector<std::uint16_t> seen;
};

struct LinkPlaces {
  Neighbours &neighbours;
  std::vector<std::uint16_t> &place;
  void link(double, double, DoubleRow, const std::uint32_t other, bool) {
    place.push_back(neighbours.place_of(other));
  }
};

inline DoubleRow column_of(const double *square, const int d) {
  DoubleRow result;  // its fourth number is the next column's first
  std::memcpy(&result, square + 3 * d, sizeof result);
  return result;
}
/// Its fourth number goes to where the next column begins, which is set after it.
inline void set_column(double *square, const int d, const DoubleRow column) {
  std::memcpy(square + 3 * d, &column, sizeof column);
}
}  // namespace

void RowList::end_row() {
  const std::uint32_t begin = first.back(), end = std::uint32_t(body.size());
  first.push_back(end);
  const std::size_t r = rows() - 1;
  if (r == 0 || length(r) != length(r - 1) ||
      !std::equal(body.begin() + begin, body.end(), body.begin() + first[r - 1]))
    group.push_back(std::uint32_t(r));
}

void RowBlocks::build(const RowList &list, const PushedLinks *links, const std::size_t bodies_,
                      const unsigned int threads) {
  if (!joins_as_before(list, links, bodies_)) find_neighbours(list, links, threads);
  const Chunks chunks(bodies, width * together);
  for_chunks(threads, chunks, [&](const std::size_t begin, const std::size_t end) {
    fill(parts[begin / chunks.size], begin, end, list, links);
  });
}

bool RowBlocks::joins_as_before(const RowList &list, const PushedLinks *links, const std::size_t bodies_) {
  std::vector<std::uint32_t> now;
  now.reserve(joined.size());
  for (std::size_t k = 0; k < list.group.size(); ++k) {
    const std::uint32_t r = list.group[k];
    now.push_back(std::uint32_t(list.length(r)));
    now.push_back(std::uint32_t(list.rows_of(k)));
    if (list.is_short(r))
      now.insert(now.end(), list.body.begin() + list.first[r], list.body.begin() + list.first[r + 1]);
  }
  if (links != nullptr) links->append_ends(now);
  const bool same = bodies == bodies_ && now == joined;
  bodies = bodies_;
  joined.swap(now);
  return same;
}

void RowBlocks::find_neighbours(const RowList &list, const PushedLinks *links, const unsigned int threads) {
  std::vector<std::uint32_t> first_use(bodies + 1, 0);  // of a body, all parts together
  const auto for_entries = [&](const auto &visit) {
    for (std::size_t k = 0; k < list.group.size(); ++k)
      if (const std::uint32_t r = list.group[k]; list.is_short(r))
        for (std::uint32_t e = list.first[r]; e < list.first[r + 1]; ++e)
          if (list.body[e] < bodies) visit(list.body[e], k, e);
  };
  for_entries([&](const std::uint32_t i, std::size_t, std::uint32_t) { ++first_use[i + 1]; });
  for (std::size_t i = 0; i < bodies; ++i) first_use[i + 1] += first_use[i];
  std::vector<Use> uses(first_use[bodies]);
  std::vector<std::uint32_t> next(first_use.begin(), first_use.end());
  for_entries([&](const std::uint32_t i, const std::size_t k, const std::uint32_t e) {
    const std::uint32_t r = list.group[k];
    uses[next[i]++] = {list.first[r], std::uint16_t(e - list.first[r]), std::uint16_t(list.length(r)),
                       std::uint32_t(list.rows_of(k))};
  });
  const Chunks chunks(bodies, width * together);
  parts.clear();
  parts.resize(chunks.count());
  for_chunks(threads, chunks, [&](const std::size_t begin, const std::size_t end) {
    Part &part = parts[begin / chunks.size];
    Neighbours neighbours(part.body);
    LinkPlaces linked{neighbours, part.place};
    std::size_t most = 0;
    part.first_eight.assign(1, 0);
    part.uses.assign(uses.begin() + first_use[begin], uses.begin() + first_use[end]);
    for (std::size_t i = begin; i < end; ++i) {
      part.first.push_back(std::uint32_t(part.body.size()));
      part.first_use.push_back(first_use[i] - first_use[begin]);
      part.first_place.push_back(std::uint32_t(part.place.size()));
      neighbours.begin(std::uint32_t(i));
      for (std::uint32_t u = first_use[i]; u < first_use[i + 1]; ++u)
        for (std::uint32_t k = 0; k < uses[u].count; ++k)
          part.place.push_back(neighbours.place_of(list.body[uses[u].from + k]));
      if (links != nullptr) links->links_of(i, linked);
      most = std::max(most, part.body.size() - part.first.back());
      if (i + 1 == end || (i + 1) % width == 0) {
        part.first_eight.push_back(part.first_eight.back() + std::uint32_t(most));
        most = 0;
      }
    }
    part.first.push_back(std::uint32_t(part.body.size()));
    part.first_use.push_back(std::uint32_t(part.uses.size()));
    part.body.shrink_to_fit();
    part.place.shrink_to_fit();
    part.exact.resize(part.body.size() + 1);
    part.eights.resize(part.first_eight.back());
  });
}

void RowBlocks::fill(Part &part, const std::size_t begin, const std::size_t end, const RowList &list,
                     const PushedLinks *links) const {
  std::vector<Columns> sums;
  for (std::size_t i = 0; i < end - begin; ++i) {
    const std::uint32_t first = part.first[i], count = part.first[i + 1] - first;
    sums.assign(count, {});
    const std::uint16_t *place = part.place.data() + part.first_place[i];
    for (std::uint32_t u = part.first_use[i]; u < part.first_use[i + 1]; ++u) {
      const Use &use = part.uses[u];
      const BodyVector *const g = list.g.data() + use.from;
      for (std::uint32_t k = 0; k < use.count; ++k) {
        Columns sum = sums[*place];
        for (const BodyVector *row = g; row < g + use.rows * use.count; row += use.count)
          sum.add(row[use.own].v, row[k].v);
        sums[*place++] = sum;
      }
    }
    LinkSums linked{sums.data(), place};
    if (links != nullptr) links->links_of(begin + i, linked);
    for (std::uint32_t k = 1; k < count; ++k) sums[0].add(sums[k]);
    for (std::uint32_t k = 0; k < count; ++k)
      for (int d = 0; d < 3; ++d) set_column(part.exact[first + k].number.data(), d, sums[k].column[d]);
  }
  for (std::size_t e = 0; e + 1 < part.first_eight.size(); ++e)
    for (std::uint32_t k = 0; k < part.first_eight[e + 1] - part.first_eight[e]; ++k) {
      EightSquares &eight = part.eights[part.first_eight[e] + k];
      FloatRow column[3][width] = {};
      for (std::size_t lane = 0; lane < width; ++lane) {
        const std::size_t i = width * e + lane;
        const bool there = i < end - begin && k < part.first[i + 1] - part.first[i];
        eight.to[lane] = there ? part.body[part.first[i] + k] : std::uint32_t(begin + i);
        for (int d = 0; there && d < 3; ++d)
          column[d][lane] = floats(column_of(part.exact[part.first[i] + k].number.data(), d));
      }
      for (int d = 0; d < 3; ++d) eight.column[d] = columns([&](const int lane) { return column[d][lane]; });
    }
}

void RowBlocks::add(const FloatRow *p, const std::size_t begin, const std::size_t end,
                    FloatRow *product) const {
  for (std::size_t i = begin; i < end; i += width) {
    const std::size_t e = i / width;
    const Part &part = parts[e / together];
    const EightSquares *one = part.eights.data() + part.first_eight[e % together],
                       *const last = part.eights.data() + part.first_eight[e % together + 1];
    // bodies that fill up the last eight have rows of p as well
    const Eight me = columns([&](const int lane) { return p[i + std::size_t(lane)]; });
    Eight sum;
    const auto times = [&](const Eight(&c)[3], const EightFloats x, const EightFloats y,
                           const EightFloats z) {
      sum.x += c[0].x * x + c[1].x * y + c[2].x * z;
      sum.y += c[0].y * x + c[1].y * y + c[2].y * z;
      sum.z += c[0].z * x + c[1].z * y + c[2].z * z;
    };
    times(one->column, me.x, me.y, me.z);
    for (++one; one < last; ++one) {
      const Eight you = columns([&](const int lane) { return p[one->to[lane]]; });
      times(one->column, you.x - me.x, you.y - me.y, you.z - me.z);
    }
    add_rows(sum, std::min(width, end - i), product + (i - begin));
  }
}

void RowBlocks::add(const BodyVector *v, const std::size_t begin, const std::size_t end,
                    BodyVector *product) const {
  constexpr std::size_t size = width * together;
  for (std::size_t i = begin; i < end; ++i) {
    const Part &part = parts[i / size];
    const std::uint32_t first = part.first[i % size], last = part.first[i % size + 1];
    const DoubleRow me = v[i].v;
    DoubleRow sum{};
    for (std::uint32_t k = first; k < last; ++k) {
      const double *square = part.exact[k].number.data();
      const DoubleRow u = k == first ? me : v[part.body[k]].v - me;
      for (int d = 0; d < 3; ++d) sum += u[d] * column_of(square, d);
    }
    product[i - begin].v += DoubleRow{sum[0], sum[1], sum[2], 0.};
  }
}

void RowBlocks::add_diagonal(const std::size_t begin, const std::size_t end, Block *to) const {
  constexpr std::size_t size = width * together;
  for (std::size_t i = begin; i < end; ++i) {
    const Part &part = parts[i / size];
    Block &block = to[i - begin];
    for (std::uint32_t k = part.first[i % size]; k < part.first[i % size + 1]; ++k) {
      const auto &m = part.exact[k].number;
      const double sign = k == part.first[i % size] ? 1. : -1.;
      block.xx += sign * m[0];
      block.xy += sign * m[3];
      block.xz += sign * m[6];
      block.yy += sign * m[4];
      block.yz += sign * m[7];
      block.zz += sign * m[8];
    }
  }
}

std::size_t RowBlocks::memory_bytes() const {
  std::size_t total = sizeof(Part) * parts.capacity() + 4 * joined.capacity();
  for (const Part &part : parts)
    total += 4 * (part.first.capacity() + part.body.capacity() + part.first_eight.capacity() +
                  part.first_use.capacity() + part.first_place.capacity()) +
             sizeof(Square) * part.exact.capacity() + sizeof(EightSquares) * part.eights.capacity() +
             sizeof(Use) * part.uses.capacity() + 2 * part.place.capacity();
  return total;
}
}  // namespace turgor
