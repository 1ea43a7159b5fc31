#include "micro/terms/cell_friction.h"

#include "micro/engine/parallel.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace turgor
{
namespace
{
using Lanes = double __attribute__((vector_size(32)));
using Floats = float __attribute__((vector_size(16)));
using Index = std::int64_t __attribute__((vector_size(32)));

/// Four floats as doubles.
inline Lanes wide(const float *four)
{
  return __builtin_convertvector(*reinterpret_cast<const Floats *>(four), Lanes);
}

inline double sum(const Lanes a) { return (a[0] + a[1]) + (a[2] + a[3]); }

/// (sum of x, sum of y, sum of z, 0)
inline Lanes sums(const Lanes x, const Lanes y, const Lanes z)
{
  const Lanes none{};
  const Lanes xy = __builtin_shuffle(x, y, Index{0, 4, 2, 6}) + __builtin_shuffle(x, y, Index{1, 5, 3, 7});
  const Lanes z0 = __builtin_shuffle(z, none, Index{0, 4, 2, 6}) + __builtin_shuffle(z, none, Index{1, 5, 3, 7});
  return __builtin_shuffle(xy, z0, Index{0, 1, 4, 5}) + __builtin_shuffle(xy, z0, Index{2, 3, 6, 7});
}
} // namespace

Friction::Friction(const FrictionParameters &parameters_)
  : parameters(parameters_)
{}

bool Friction::none(const double implicit_step) const
{
  return parameters.normal == 0. && parameters.tangential == 0. && implicit_step == 0.;
}

Friction::Coefficients Friction::coefficients(const PairContact &c, const double implicit_step) const
{
  Coefficients result{parameters.normal * c.area, parameters.tangential * c.area};
  if (implicit_step > 0.)
    { // only what keeps the matrix positive definite; repulsion turned sideways is left explicit
      result.normal += implicit_step * std::max(0., c.stiffness);
      result.tangential += implicit_step * std::max(0., -c.force / c.distance);
    }
  return result;
}

void Friction::assemble(const SphereContacts &contacts, const unsigned int threads)
{
  const PairList<3> &list = contacts.list();
  const std::vector<PairContact> &contact = contacts.contacts();
  const std::size_t n = own.size();
  // room for all listed pairs; only those that touch are filled in
  first.resize(n + 1);
  first[0] = 0;
  for (std::size_t i = 0; i < n; ++i)
    first[i + 1] = first[i] + (list.first()[i + 1] - list.first()[i] + 3) / 4;
  links.resize(first[n]);
  end.resize(n);
  inverse.resize(n);
  for_chunks(threads, Chunks(n), [&](std::size_t begin, std::size_t last) {
    for (std::size_t i = begin; i < last; ++i)
      {
        std::uint32_t at = first[i], lane = 0;
        double isotropic = own[i], m[6] = {0., 0., 0., 0., 0., 0.};
        for (std::uint32_t k = list.first()[i]; k < list.first()[i + 1]; ++k)
          {
            const PairContact &c = contact[list.own()[k]];
            if (!(c.area > 0.))
              continue;
            const auto [normal, tangential] = coefficients(c, step);
            const double w = normal - tangential;
            Links &four = links[at];
            for (int d = 0; d < 3; ++d)
              four.e[d][lane] = float(c.e[d]);
            four.tangential[lane] = float(tangential);
            four.difference[lane] = float(w);
            four.other[lane] = list.other()[k];
            if (++lane == 4)
              {
                ++at;
                lane = 0;
              }
            isotropic += tangential;
            m[0] += w * c.e[0] * c.e[0];
            m[1] += w * c.e[0] * c.e[1];
            m[2] += w * c.e[0] * c.e[2];
            m[3] += w * c.e[1] * c.e[1];
            m[4] += w * c.e[1] * c.e[2];
            m[5] += w * c.e[2] * c.e[2];
          }
        if (lane > 0)
          {
            Links &four = links[at++];
            for (; lane < 4; ++lane)
              {
                four.e[0][lane] = four.e[1][lane] = four.e[2][lane] = 0.f;
                four.tangential[lane] = four.difference[lane] = 0.f;
                four.other[lane] = std::uint32_t(i);
              }
          }
        end[i] = at;
        m[0] += isotropic;
        m[3] += isotropic;
        m[5] += isotropic;
        const double a = m[3] * m[5] - m[4] * m[4], b = m[2] * m[4] - m[1] * m[5], c = m[1] * m[4] - m[2] * m[3];
        const double id = 1. / (m[0] * a + m[1] * b + m[2] * c);
        const float xx = float(a * id), xy = float(b * id), xz = float(c * id), yy = float((m[0] * m[5] - m[2] * m[2]) * id),
                    yz = float((m[1] * m[2] - m[0] * m[4]) * id), zz = float((m[0] * m[3] - m[1] * m[1]) * id);
        inverse[i] = {{{xx, xy, xz, 0.f}, {xy, yy, yz, 0.f}, {xz, yz, zz, 0.f}}};
      }
  });
}

Lanes Friction::product(const std::size_t i, const std::vector<Row> &x) const
{
  const Lanes xi = x[i].v;
  Lanes sx{}, sy{}, sz{};
  for (std::uint32_t k = first[i]; k < end[i]; ++k)
    {
      const Links &l = links[k];
      const Lanes a = xi - x[l.other[0]].v, b = xi - x[l.other[1]].v, c = xi - x[l.other[2]].v, d = xi - x[l.other[3]].v;
      const Lanes ab = __builtin_shuffle(a, b, Index{0, 4, 2, 6}), cd = __builtin_shuffle(c, d, Index{0, 4, 2, 6});
      const Lanes ab1 = __builtin_shuffle(a, b, Index{1, 5, 3, 7}), cd1 = __builtin_shuffle(c, d, Index{1, 5, 3, 7});
      const Lanes ux = __builtin_shuffle(ab, cd, Index{0, 1, 4, 5}), uy = __builtin_shuffle(ab1, cd1, Index{0, 1, 4, 5}),
                  uz = __builtin_shuffle(ab, cd, Index{2, 3, 6, 7});
      const Lanes ex = wide(l.e[0]), ey = wide(l.e[1]), ez = wide(l.e[2]), t = wide(l.tangential);
      const Lanes along = wide(l.difference) * (ux * ex + uy * ey + uz * ez);
      sx += t * ux + along * ex;
      sy += t * uy + along * ey;
      sz += t * uz + along * ez;
    }
  return own[i] * xi + sums(sx, sy, sz);
}

Lanes Friction::preconditioned(const std::size_t i) const
{
  const Lanes q = r[i].v;
  return wide(inverse[i].column[0]) * q[0] + wide(inverse[i].column[1]) * q[1] + wide(inverse[i].column[2]) * q[2];
}

double Friction::exact_residual(const Particles<3> &particles, const SphereContacts &contacts, const unsigned int threads)
{
  const PairList<3> &list = contacts.list();
  const std::vector<PairContact> &contact = contacts.contacts();
  return sum_chunks(threads, Chunks(own.size()), parts, [&](std::size_t begin, std::size_t last) {
    Lanes total{};
    for (std::size_t i = begin; i < last; ++i)
      {
        const Lanes vi = v[i].v;
        Lanes rest = Lanes{particles.f[0][i], particles.f[1][i], particles.f[2][i], 0.} - own[i] * vi;
        for (std::uint32_t k = list.first()[i]; k < list.first()[i + 1]; ++k)
          {
            const PairContact &c = contact[list.own()[k]];
            if (!(c.area > 0.))
              continue;
            const auto [normal, tangential] = coefficients(c, step);
            const Lanes e{c.e[0], c.e[1], c.e[2], 0.}, u = vi - v[list.other()[k]].v;
            rest -= tangential * u + (normal - tangential) * sum(e * u) * e;
          }
        r[i].v = rest;
        total += rest * rest;
      }
    return sum(total);
  });
}

/// Conjugate gradients with the single-precision matrix for A d = r, until |r|^2 <= target; v += d.
void Friction::correct(const double target, double residual, const unsigned int threads, const double allowed)
{
  const std::size_t n = own.size();
  const Chunks chunks(n);
  for (auto *array : {&s, &As, &correction})
    array->resize(n);
  double rz = sum_chunks(threads, chunks, parts, [&](std::size_t begin, std::size_t last) {
    Lanes total{};
    for (std::size_t i = begin; i < last; ++i)
      {
        s[i].v = preconditioned(i);
        correction[i].v = Lanes{};
        total += r[i].v * s[i].v;
      }
    return sum(total);
  });
  std::vector<double> squares(chunks.count());
  while (residual > target)
    {
      if (last_iterations >= parameters.max_iterations || !std::isfinite(residual))
        throw std::runtime_error("the friction matrix was not solved within " + std::to_string(parameters.max_iterations)
                                 + " iterations (residual " + std::to_string(std::sqrt(residual / allowed) * parameters.tolerance)
                                 + " of the forces, allowed " + std::to_string(parameters.tolerance)
                                 + "): more friction with the medium, or a larger tolerance.");
      const double sAs = sum_chunks(threads, chunks, parts, [&](std::size_t begin, std::size_t last) {
        Lanes total{};
        for (std::size_t i = begin; i < last; ++i)
          {
            As[i].v = product(i, s);
            total += s[i].v * As[i].v;
          }
        return sum(total);
      });
      const double alpha = rz / sAs;
      const double rz_next = sum_chunks(threads, chunks, parts, [&](std::size_t begin, std::size_t last) {
        Lanes total{}, square{};
        for (std::size_t i = begin; i < last; ++i)
          {
            correction[i].v += alpha * s[i].v;
            r[i].v -= alpha * As[i].v;
            As[i].v = preconditioned(i);
            total += r[i].v * As[i].v;
            square += r[i].v * r[i].v;
          }
        squares[begin / chunks.size] = sum(square);
        return sum(total);
      });
      residual = 0.;
      for (const double square : squares)
        residual += square;
      const double beta = rz_next / rz;
      rz = rz_next;
      ++last_iterations;
      if (residual > target)
        for_chunks(threads, chunks, [&](std::size_t begin, std::size_t last) {
          for (std::size_t i = begin; i < last; ++i)
            s[i].v = As[i].v + beta * s[i].v;
        });
    }
  for_chunks(threads, chunks, [&](std::size_t begin, std::size_t last) {
    for (std::size_t i = begin; i < last; ++i)
      v[i].v += correction[i].v;
  });
}

void Friction::solve(Particles<3> &particles, const SphereContacts &contacts, const unsigned int threads)
{
  const std::size_t n = own.size();
  const Chunks chunks(n);
  last_iterations = 0;
  v.resize(n);
  r.resize(n);
  const double forces = sum_chunks(threads, chunks, parts, [&](std::size_t begin, std::size_t last) {
    double total = 0.;
    for (std::size_t i = begin; i < last; ++i)
      {
        v[i].v = Lanes{particles.v[0][i], particles.v[1][i], particles.v[2][i], 0.};
        for (int d = 0; d < 3; ++d)
          total += particles.f[d][i] * particles.f[d][i];
      }
    return total;
  });
  if (forces == 0.) // nothing moves; no residual is small against no force
    {
      for (auto &values : particles.v)
        std::fill(values.begin(), values.end(), 0.);
      return;
    }
  const double allowed = parameters.tolerance * parameters.tolerance * forces;
  // A correction is worth six digits at most: single precision has no more.
  for (double residual = exact_residual(particles, contacts, threads); residual > allowed;
       residual = exact_residual(particles, contacts, threads))
    correct(std::max(0.25 * allowed, 1e-12 * residual), residual, threads, allowed);
  all_iterations += last_iterations;
  for_chunks(threads, chunks, [&](std::size_t begin, std::size_t last) {
    for (std::size_t i = begin; i < last; ++i)
      for (int d = 0; d < 3; ++d)
        particles.v[d][i] = v[i].v[d];
  });
}

void Friction::velocities(Particles<3> &particles, const SphereContacts &contacts, const std::vector<double> &gamma,
                          const double implicit_step, const unsigned int threads)
{
  step = implicit_step;
  own = gamma;
  if (!none(step))
    assemble(contacts, threads);
  velocities_again(particles, contacts, threads);
}

void Friction::velocities_again(Particles<3> &particles, const SphereContacts &contacts, const unsigned int threads)
{
  if (!none(step))
    return solve(particles, contacts, threads);
  last_iterations = 0;
  for_chunks(threads, Chunks(own.size()), [&](std::size_t begin, std::size_t last) {
    for (int d = 0; d < 3; ++d)
      for (std::size_t i = begin; i < last; ++i)
        particles.v[d][i] = particles.f[d][i] / own[i];
  });
}

std::size_t Friction::memory_bytes() const
{
  return sizeof(Links) * links.capacity() + 4 * (first.capacity() + end.capacity()) + sizeof(double) * own.capacity()
         + sizeof(Block) * inverse.capacity()
         + sizeof(Row) * (v.capacity() + r.capacity() + s.capacity() + As.capacity() + correction.capacity());
}
} // namespace turgor
