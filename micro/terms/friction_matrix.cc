#include "micro/terms/friction_matrix.h"

#include "micro/engine/parallel.h"

#include <cmath>

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

void FrictionMatrix::assemble(const SphereContacts &contacts, const std::vector<double> &gamma, const PairFriction &friction,
                              const unsigned int threads)
{
  const PairList<3> &list = contacts.list();
  const std::vector<PairContact> &contact = contacts.contacts();
  const std::size_t n = gamma.size(), groups = (n + width - 1) / width;
  const auto &of = list.first();
  // room for all listed pairs; only those that touch are filled in
  first.resize(groups + 1);
  first[0] = 0;
  for (std::size_t g = 0; g < groups; ++g)
    {
      std::uint32_t most = 0;
      for (std::size_t i = g * width; i < std::min(n, (g + 1) * width); ++i)
        most = std::max(most, of[i + 1] - of[i]);
      first[g + 1] = first[g] + most;
    }
  directed = friction.directed();
  links.resize(first[groups]);
  lines.resize(directed ? first[groups] : 0);
  end.resize(groups);
  own.resize(groups);
  inverse.resize(groups);
  for_chunks(threads, Chunks(groups, 64), [&](std::size_t begin, std::size_t last) {
    for (std::size_t g = begin; g < last; ++g)
      {
        std::uint32_t count[width] = {}, most = 0;
        Symmetric &blocks = inverse[g];
        blocks = Symmetric{};
        own[g] = EightFloats{};
        for (std::size_t lane = 0; lane < std::min(width, n - g * width); ++lane)
          {
            const std::size_t i = g * width + lane;
            std::uint32_t to = first[g];
            double isotropic = gamma[i], m[6] = {0., 0., 0., 0., 0., 0.};
            for (std::uint32_t k = of[i]; k < of[i + 1]; ++k)
              {
                const PairContact &c = contact[list.own()[k]]; // all zero where nothing touches
                const auto [normal, tangential] = friction(c);
                const double w = normal - tangential;
                links[to].tangential[lane] = float(std::copysign(tangential, w));
                links[to].other[lane] = list.other()[k];
                if (directed)
                  {
                    const double root = std::sqrt(std::abs(w));
                    lines[to].x[lane] = float(root * c.e[0]);
                    lines[to].y[lane] = float(root * c.e[1]);
                    lines[to].z[lane] = float(root * c.e[2]);
                  }
                to += c.area > 0.; // the next one takes the place of one that does not touch
                isotropic += tangential;
                m[0] += w * c.e[0] * c.e[0];
                m[1] += w * c.e[0] * c.e[1];
                m[2] += w * c.e[0] * c.e[2];
                m[3] += w * c.e[1] * c.e[1];
                m[4] += w * c.e[1] * c.e[2];
                m[5] += w * c.e[2] * c.e[2];
              }
            count[lane] = to - first[g];
            most = std::max(most, count[lane]);
            m[0] += isotropic;
            m[3] += isotropic;
            m[5] += isotropic;
            const double a = m[3] * m[5] - m[4] * m[4], b = m[2] * m[4] - m[1] * m[5], c = m[1] * m[4] - m[2] * m[3];
            const double id = 1. / (m[0] * a + m[1] * b + m[2] * c);
            own[g][lane] = float(gamma[i]);
            blocks.xx[lane] = float(a * id);
            blocks.xy[lane] = float(b * id);
            blocks.xz[lane] = float(c * id);
            blocks.yy[lane] = float((m[0] * m[5] - m[2] * m[2]) * id);
            blocks.yz[lane] = float((m[1] * m[2] - m[0] * m[4]) * id);
            blocks.zz[lane] = float((m[0] * m[3] - m[1] * m[1]) * id);
          }
        end[g] = first[g] + most;
        for (std::size_t lane = 0; lane < width; ++lane)
          for (std::uint32_t k = first[g] + count[lane]; k < end[g]; ++k)
            {
              links[k].tangential[lane] = 0.f;
              links[k].other[lane] = std::uint32_t(g * width + lane);
              if (directed)
                lines[k].x[lane] = lines[k].y[lane] = lines[k].z[lane] = 0.f;
            }
      }
  });
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
  return sizeof(Links) * links.capacity() + sizeof(Eight) * lines.capacity() + 4 * (first.capacity() + end.capacity()) + sizeof(EightFloats) * own.capacity()
         + sizeof(Symmetric) * inverse.capacity();
}
} // namespace turgor
