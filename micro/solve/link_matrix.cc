#include "micro/solve/link_matrix.h"

#include "run/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace turgor {
using namespace eight_floats;

namespace {
using Bits = std::int32_t __attribute__((vector_size(32)));

/// Bits set in both, and in one of them alone.
inline EightFloats both(const EightFloats a, const EightFloats b) { return EightFloats(Bits(a) & Bits(b)); }
inline EightFloats differ(const EightFloats a, const EightFloats b) { return EightFloats(Bits(a) ^ Bits(b)); }
}  // namespace

double LinkMatrix::assemble(const std::vector<const LinkSource *> &sources, const std::vector<double> &medium,
                            const std::vector<Block> *blocks, const Forces &forces,
                            const std::vector<BodyVector> &v, std::vector<Eight> &r,
                            const unsigned int threads) {
  const std::size_t n = medium.size(), groups = (n + width - 1) / width;
  // room for all listed links; only those that touch are filled in
  first.resize(groups + 1);
  first[0] = 0;
  for_chunks(threads, Chunks(groups, 512), [&](std::size_t begin, std::size_t last) {
    for (std::size_t g = begin; g < last; ++g) {
      std::uint32_t count[width] = {};
      for (const LinkSource *source : sources) source->room(g * width, std::min(n, (g + 1) * width), count);
      first[g + 1] = *std::max_element(count, count + width);
    }
  });
  for (std::size_t g = 0; g < groups; ++g) first[g + 1] += first[g];
  directed = blocks != nullptr || std::any_of(sources.begin(), sources.end(),
                                              [](const LinkSource *source) { return source->directed(); });
  links.resize(first[groups]);
  lines.resize(directed ? first[groups] : 0);
  end.resize(groups);
  own.resize(groups);
  inverse.resize(directed ? groups : 0);
  inverse_same.resize(directed ? 0 : groups);
  r.resize(groups);
  const Sum all{sources, medium, blocks, forces, v};
  return sum_chunks(threads, Chunks(groups, 64), parts, [&](std::size_t begin, std::size_t last) {
    std::vector<FloatRow> work;
    DoubleRow total{};
    for (std::size_t g = begin; g < last; ++g)
      total += directed ? rows_of<true>(g, all, r, work) : rows_of<false>(g, all, r, work);
    return sum(total);
  });
}

/// work: of one thread, lines of eight bodies, link by link: e and w.
template <bool with_lines>
DoubleRow LinkMatrix::rows_of(const std::size_t g, const Sum &all, std::vector<Eight> &r,
                              std::vector<FloatRow> &work) {
  std::uint32_t count[width] = {}, most = 0;
  double isotropic[width];
  FloatRow rest[width] = {};
  DoubleRow total{};
  if (with_lines && work.size() < width * (first[g + 1] - first[g] + 1))
    work.resize(2 * width * (first[g + 1] - first[g] + 1));
  const std::size_t bodies = std::min(width, all.medium.size() - g * width);
  const auto row_of = [&](const std::size_t lane) {
    const std::size_t i = g * width + std::min(lane, bodies - 1);
    return LinkRow<with_lines>(ExactRow(all.forces, all.medium, all.v, i), all.medium[i],
                               links.data() + first[g], work.data(), lane);
  };
  LinkRow<with_lines> rows[width] = {row_of(0), row_of(1), row_of(2), row_of(3),
                                     row_of(4), row_of(5), row_of(6), row_of(7)};
  for (const LinkSource *source : all.sources) source->add(g * width, bodies, rows);
  for (std::size_t lane = 0; lane < width; ++lane) {
    const std::size_t i = g * width + lane;
    own[g][lane] = 0.f;
    isotropic[lane] = 1.;
    if (lane >= bodies)  // nobody: no residual
      continue;
    const LinkRow<with_lines> &row = rows[lane];
    count[lane] = std::uint32_t(row.end() - links.data()) - first[g];
    most = std::max(most, count[lane]);
    own[g][lane] = float(all.medium[i]);
    isotropic[lane] = row.isotropic();
    rest[lane] = floats(row.result());
    total += row.result() * row.result();
  }
  r[g] = columns([&](const int lane) { return rest[lane]; });
  end[g] = first[g] + most;
  for (std::size_t lane = 0; lane < width; ++lane)
    for (std::uint32_t k = count[lane]; k < most; ++k) {
      links[first[g] + k].tangential[lane] = 0.f;
      links[first[g] + k].other[lane] = std::uint32_t(g * width + lane);
      if constexpr (with_lines) work[k * width + lane] = FloatRow{};
    }
  if constexpr (with_lines)
    finish_lines(g, work.data(), isotropic, all);
  else
    for (std::size_t lane = 0; lane < width; ++lane) inverse_same[g][lane] = float(1. / isotropic[lane]);
  return total;
}

/// Directions of eight g from e and w, and the inverse diagonal blocks.
void LinkMatrix::finish_lines(const std::size_t g, const FloatRow *work, const double (&isotropic)[width],
                              const Sum &all) {
  for (std::uint32_t k = first[g]; k < end[g]; ++k, work += width) {
    EightFloats w;
    const Eight e = columns([&](const int lane) { return work[lane]; }, w);
    const EightFloats sign = both(w, -EightFloats{}), size = differ(w, sign);
    EightFloats root;
    for (std::size_t lane = 0; lane < width; ++lane) root[lane] = std::sqrt(size[lane]);
    lines[k] = {root * e.x, root * e.y, root * e.z};
    links[k].tangential = differ(links[k].tangential, sign);
  }
  const Blocks low = blocks_of<false>(g, isotropic, all), high = blocks_of<true>(g, isotropic, all);
  inverse[g] = {halves(low.xx, high.xx), halves(low.xy, high.xy), halves(low.xz, high.xz),
                halves(low.yy, high.yy), halves(low.yz, high.yz), halves(low.zz, high.zz)};
}

/// Sums in double, of the products that the matrix itself has.
template <bool high>
LinkMatrix::Blocks LinkMatrix::blocks_of(const std::size_t g, const double (&isotropic)[width],
                                         const Sum &all) const {
  FourDoubles xx{}, xy{}, xz{}, yy{}, yz{}, zz{}, t;
  std::memcpy(&t, isotropic + 4 * high, sizeof t);
  for (std::uint32_t k = first[g]; k < end[g]; ++k) {
    const EightFloats sign = both(links[k].tangential, -EightFloats{});
    const Eight &l = lines[k];
    const FourDoubles x = half<high>(l.x), y = half<high>(l.y), z = half<high>(l.z),
                      sx = half<high>(differ(l.x, sign)), sy = half<high>(differ(l.y, sign));
    xx += sx * x;
    xy += sx * y;
    xz += sx * z;
    yy += sy * y;
    yz += sy * z;
    zz += half<high>(differ(l.z, sign)) * z;
  }
  xx += t;
  yy += t;
  zz += t;
  for (std::size_t lane = 0, i = g * width + 4 * high;
       all.blocks != nullptr && lane < 4 && i < all.blocks->size(); ++lane, ++i) {
    const Block &block = (*all.blocks)[i];
    xx[lane] += block.xx;
    xy[lane] += block.xy;
    xz[lane] += block.xz;
    yy[lane] += block.yy;
    yz[lane] += block.yz;
    zz[lane] += block.zz;
  }
  const FourDoubles a = yy * zz - yz * yz, b = xz * yz - xy * zz, c = xy * yz - xz * yy,
                    id = 1. / (xx * a + xy * b + xz * c);
  return {
      a * id, b * id, c * id, (xx * zz - xz * xz) * id, (xy * xz - xx * yz) * id, (xx * yy - xy * xy) * id};
}

template <bool with_lines>
double LinkMatrix::product_of(const std::size_t begin, const std::size_t last, const std::vector<FloatRow> &p,
                              std::vector<Eight> &Ap) const {
  const EightFloats signs = -EightFloats{};  // the bit of the sign alone
  FourDoubles total{};
  for (std::size_t g = begin; g < last; ++g) {
    const FloatRow *at = &p[g * width];
    const Eight me = columns([&](const int k) { return at[k]; });
    Eight sum{own[g] * me.x, own[g] * me.y, own[g] * me.z};
    for (std::uint32_t k = first[g]; k < end[g]; ++k) {
      const EightLinks &l = links[k];
      const Eight you = columns([&](const int lane) { return p[l.other[lane]]; });
      const EightFloats ux = me.x - you.x, uy = me.y - you.y, uz = me.z - you.z;
      if constexpr (with_lines) {
        const Eight &e = lines[k];
        const EightFloats sign = both(l.tangential, signs), t = differ(l.tangential, sign),
                          along = differ(ux * e.x + uy * e.y + uz * e.z, sign);
        sum.x += t * ux + along * e.x;
        sum.y += t * uy + along * e.y;
        sum.z += t * uz + along * e.z;
      } else {
        sum.x += l.tangential * ux;
        sum.y += l.tangential * uy;
        sum.z += l.tangential * uz;
      }
    }
    Ap[g] = sum;
    total += wide(dot(me, sum));
  }
  return sum(total);
}

double LinkMatrix::product(const std::size_t begin, const std::size_t last, const std::vector<FloatRow> &p,
                           std::vector<Eight> &Ap) const {
  return directed ? product_of<true>(begin, last, p, Ap) : product_of<false>(begin, last, p, Ap);
}

std::size_t LinkMatrix::memory_bytes() const {
  return sizeof(EightLinks) * links.capacity() + sizeof(Eight) * lines.capacity() +
         4 * (first.capacity() + end.capacity()) +
         sizeof(EightFloats) * (own.capacity() + inverse_same.capacity()) +
         sizeof(Symmetric) * inverse.capacity();
}
}  // namespace turgor
