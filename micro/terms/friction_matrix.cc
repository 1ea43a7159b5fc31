#include "micro/terms/friction_matrix.h"

#include "run/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace turgor
{
using namespace eight_floats;

namespace
{
using Bits = std::int32_t __attribute__((vector_size(32)));

/// Bits set in both, and in one of them alone.
inline EightFloats both(const EightFloats a, const EightFloats b) { return EightFloats(Bits(a) & Bits(b)); }
inline EightFloats differ(const EightFloats a, const EightFloats b) { return EightFloats(Bits(a) ^ Bits(b)); }
} // namespace

double FrictionMatrix::assemble(const SphereContacts &contacts, const std::vector<double> &gamma, const PairFriction &friction,
                                const Particles<3> &particles, const std::vector<CellVector> &v, std::vector<Eight> &r,
                                const unsigned int threads)
{
  const std::size_t n = gamma.size(), groups = (n + width - 1) / width;
  const auto &of = contacts.list().first();
  // room for all listed pairs; only those that touch are filled in
  first.resize(groups + 1);
  first[0] = 0;
  for_chunks(threads, Chunks(groups, 512), [&](std::size_t begin, std::size_t last) {
    for (std::size_t g = begin; g < last; ++g)
      {
        first[g + 1] = 0;
        for (std::size_t i = g * width; i < std::min(n, (g + 1) * width); ++i)
          first[g + 1] = std::max(first[g + 1], of[i + 1] - of[i]);
      }
  });
  for (std::size_t g = 0; g < groups; ++g)
    first[g + 1] += first[g];
  directed = friction.directed();
  links.resize(first[groups]);
  lines.resize(directed ? first[groups] : 0);
  end.resize(groups);
  own.resize(groups);
  inverse.resize(directed ? groups : 0);
  inverse_same.resize(directed ? 0 : groups);
  r.resize(groups);
  return sum_chunks(threads, Chunks(groups, 64), parts, [&](std::size_t begin, std::size_t last) {
    Work work;
    DoubleRow total{};
    for (std::size_t g = begin; g < last; ++g)
      total += directed ? rows_of<true>(g, contacts, gamma, friction, particles, v, r, work) :
                          rows_of<false>(g, contacts, gamma, friction, particles, v, r, work);
    return sum(total);
  });
}

template <bool with_lines>
DoubleRow FrictionMatrix::rows_of(const std::size_t g, const SphereContacts &contacts, const std::vector<double> &gamma,
                                  const PairFriction &friction, const Particles<3> &particles, const std::vector<CellVector> &v,
                                  std::vector<Eight> &r, Work &work)
{
  constexpr std::size_t ahead = 16; // contacts on their way
  const PairContact *contact = contacts.contacts().data();
  const auto &of = contacts.list().first(), &pair = contacts.list().own(), &other = contacts.list().other();
  std::uint32_t count[width] = {}, most = 0;
  double isotropic[width];
  FloatRow rest[width] = {};
  DoubleRow total{};
  if (with_lines && work.lines.size() < width * (first[g + 1] - first[g]))
    work.lines.resize(2 * width * (first[g + 1] - first[g]));
  for (std::size_t lane = 0; lane < width; ++lane)
    {
      const std::size_t i = g * width + lane;
      own[g][lane] = 0.f;
      isotropic[lane] = 1.;
      if (i >= gamma.size()) // nobody: no residual
        continue;
      Links *to = links.data() + first[g];
      [[maybe_unused]] FloatRow *line = with_lines ? work.lines.data() + lane : nullptr;
      ExactRow row(particles, gamma, v, i);
      double all = gamma[i];
      for (std::uint32_t k = of[i]; k < of[i + 1]; ++k)
        {
          __builtin_prefetch(contact + pair[std::min<std::size_t>(k + ahead, pair.size() - 1)]);
          const PairContact &c = contact[pair[k]]; // all zero where nothing touches
          const PairFriction::Coefficients along_and_across = friction(c);
          DoubleRow e = ExactRow::direction(c);
          row.add(along_and_across, e, v[other[k]].v);
          all += along_and_across.tangential;
          to->tangential[lane] = float(along_and_across.tangential);
          to->other[lane] = other[k];
          if constexpr (with_lines)
            {
              e[3] = along_and_across.normal - along_and_across.tangential;
              *line = floats(e);
            }
          const bool touches = c.area > 0.; // the next one takes the place of one that does not touch
          to += touches;
          if constexpr (with_lines)
            line += touches * width;
        }
      count[lane] = std::uint32_t(to - links.data()) - first[g];
      most = std::max(most, count[lane]);
      own[g][lane] = float(gamma[i]);
      isotropic[lane] = all;
      rest[lane] = floats(row.result());
      total += row.result() * row.result();
    }
  r[g] = columns([&](const int lane) { return rest[lane]; });
  end[g] = first[g] + most;
  for (std::size_t lane = 0; lane < width; ++lane)
    for (std::uint32_t k = count[lane]; k < most; ++k)
      {
        links[first[g] + k].tangential[lane] = 0.f;
        links[first[g] + k].other[lane] = std::uint32_t(g * width + lane);
        if constexpr (with_lines)
          work.lines[k * width + lane] = FloatRow{};
      }
  if constexpr (with_lines)
    finish_lines(g, work.lines.data(), isotropic);
  else
    for (std::size_t lane = 0; lane < width; ++lane)
      inverse_same[g][lane] = float(1. / isotropic[lane]);
  return total;
}

/// Directions of eight g from e and w, and the inverse diagonal blocks.
void FrictionMatrix::finish_lines(const std::size_t g, const FloatRow *work, const double (&isotropic)[width])
{
  for (std::uint32_t k = first[g]; k < end[g]; ++k, work += width)
    {
      EightFloats w;
      const Eight e = columns([&](const int lane) { return work[lane]; }, w);
      const EightFloats sign = both(w, -EightFloats{}), size = differ(w, sign);
      EightFloats root;
      for (std::size_t lane = 0; lane < width; ++lane)
        root[lane] = std::sqrt(size[lane]);
      lines[k] = {root * e.x, root * e.y, root * e.z};
      links[k].tangential = differ(links[k].tangential, sign);
    }
  const Blocks low = blocks_of<false>(g, isotropic), high = blocks_of<true>(g, isotropic);
  inverse[g] = {halves(low.xx, high.xx), halves(low.xy, high.xy), halves(low.xz, high.xz),
                halves(low.yy, high.yy), halves(low.yz, high.yz), halves(low.zz, high.zz)};
}

/// Sums in double, of the products that the matrix itself has.
template <bool high>
FrictionMatrix::Blocks FrictionMatrix::blocks_of(const std::size_t g, const double (&isotropic)[width]) const
{
  FourDoubles xx{}, xy{}, xz{}, yy{}, yz{}, zz{}, t;
  std::memcpy(&t, isotropic + 4 * high, sizeof t);
  for (std::uint32_t k = first[g]; k < end[g]; ++k)
    {
      const EightFloats sign = both(links[k].tangential, -EightFloats{});
      const Eight &l = lines[k];
      const FourDoubles x = half<high>(l.x), y = half<high>(l.y), z = half<high>(l.z), sx = half<high>(differ(l.x, sign)),
                        sy = half<high>(differ(l.y, sign));
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
  const FourDoubles a = yy * zz - yz * yz, b = xz * yz - xy * zz, c = xy * yz - xz * yy, id = 1. / (xx * a + xy * b + xz * c);
  return {a * id, b * id, c * id, (xx * zz - xz * xz) * id, (xy * xz - xx * yz) * id, (xx * yy - xy * xy) * id};
}

template <bool with_lines>
double FrictionMatrix::product_of(const std::size_t begin, const std::size_t last, const std::vector<FloatRow> &p,
                                  std::vector<Eight> &Ap) const
{
  const EightFloats signs = -EightFloats{}; // the bit of the sign alone
  FourDoubles total{};
  for (std::size_t g = begin; g < last; ++g)
    {
      const FloatRow *at = &p[g * width];
      const Eight me = columns([&](const int k) { return at[k]; });
      Eight sum{own[g] * me.x, own[g] * me.y, own[g] * me.z};
      for (std::uint32_t k = first[g]; k < end[g]; ++k)
        {
          const Links &l = links[k];
          const Eight you = columns([&](const int lane) { return p[l.other[lane]]; });
          const EightFloats ux = me.x - you.x, uy = me.y - you.y, uz = me.z - you.z;
          if constexpr (with_lines)
            {
              const Eight &e = lines[k];
              const EightFloats sign = both(l.tangential, signs), t = differ(l.tangential, sign),
                                along = differ(ux * e.x + uy * e.y + uz * e.z, sign);
              sum.x += t * ux + along * e.x;
              sum.y += t * uy + along * e.y;
              sum.z += t * uz + along * e.z;
            }
          else
            {
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

double FrictionMatrix::product(const std::size_t begin, const std::size_t last, const std::vector<FloatRow> &p,
                               std::vector<Eight> &Ap) const
{
  return directed ? product_of<true>(begin, last, p, Ap) : product_of<false>(begin, last, p, Ap);
}

std::size_t FrictionMatrix::memory_bytes() const
{
  return sizeof(Links) * links.capacity() + sizeof(Eight) * lines.capacity() + 4 * (first.capacity() + end.capacity())
         + sizeof(EightFloats) * (own.capacity() + inverse_same.capacity()) + sizeof(Symmetric) * inverse.capacity();
}
} // namespace turgor
