#include "micro/terms/cell_friction.h"

#include "run/parallel.h"
#include "run/number_text.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace turgor
{
using namespace eight_floats;

Friction::Friction(const FrictionParameters &parameters_)
  : parameters(parameters_)
  , pair{parameters_.normal, parameters_.tangential, 0.}
{}

bool Friction::none() const
{
  return pair.normal == 0. && pair.tangential == 0. && pair.step == 0.;
}

double Friction::exact_residual(const Particles<3> &particles, const SphereContacts &contacts, const unsigned int threads)
{
  const PairList<3> &list = contacts.list();
  const std::vector<PairContact> &contact = contacts.contacts();
  return sum_chunks(threads, Chunks(own.size()), parts, [&](std::size_t begin, std::size_t last) {
    DoubleRow total{};
    for (std::size_t i = begin; i < last; ++i)
      {
        ExactRow row(particles, own, v, i);
        for (std::uint32_t k = list.first()[i]; k < list.first()[i + 1]; ++k)
          {
            const PairContact &c = contact[list.own()[k]]; // all zero where nothing touches
            row.add(pair(c), ExactRow::direction(c), v[list.other()[k]].v);
          }
        const DoubleRow rest = row.result();
        Eight &eight = r[i / FrictionMatrix::width];
        const std::size_t lane = i % FrictionMatrix::width;
        eight.x[lane] = float(rest[0]);
        eight.y[lane] = float(rest[1]);
        eight.z[lane] = float(rest[2]);
        total += rest * rest;
      }
    return sum(total);
  });
}

/// Conjugate gradients in single precision for A d = r, until |r|^2 <= target; v += d. All numbers are those of r/|r|: squares of small
/// forces would leave the range of single precision.
void Friction::correct(const double target, const double start, const unsigned int threads, const double allowed)
{
  const std::size_t n = own.size();
  const Chunks chunks(matrix.eights(), 64);
  p.resize(FrictionMatrix::width * chunks.n);
  Ap.resize(chunks.n);
  correction.resize(chunks.n);
  const double size = std::sqrt(start);
  const float scale = float(1. / size);
  double residual = 1.;
  double rz = sum_chunks(threads, chunks, parts, [&](std::size_t begin, std::size_t last) {
    DoubleRow total{};
    for (std::size_t g = begin; g < last; ++g)
      {
        const Eight rest{scale * r[g].x, scale * r[g].y, scale * r[g].z}, z = matrix.preconditioned(g, rest);
        r[g] = rest;
        to_rows(z, &p[FrictionMatrix::width * g]);
        correction[g] = {};
        total += wide(dot(rest, z));
      }
    return sum(total);
  });
  std::vector<double> squares(chunks.count());
  while (!(residual * start <= target))
    {
      if (!std::isfinite(residual * start))
        throw NotSolved("the forces on the cells are no numbers any more: stiffer cells (Cell/Bulk modulus, Cell/Modulus), or less that drives them.");
      if (last_iterations >= parameters.max_iterations)
        throw NotSolved("the friction matrix was not solved within " + number_text(parameters.max_iterations)
                        + " iterations (residual " + number_text(std::sqrt(residual * start / allowed) * parameters.tolerance)
                        + " of the forces, allowed " + number_text(parameters.tolerance)
                        + "): more friction with the medium, or a larger tolerance.");
      const double pAp = sum_chunks(threads, chunks, parts, [&](std::size_t begin, std::size_t last) {
        return matrix.product(begin, last, p, Ap);
      });
      const float alpha = float(rz / pAp);
      const double rz_next = sum_chunks(threads, chunks, parts, [&](std::size_t begin, std::size_t last) {
        DoubleRow total{}, square{};
        for (std::size_t g = begin; g < last; ++g)
          {
            const Eight rest{r[g].x - alpha * Ap[g].x, r[g].y - alpha * Ap[g].y, r[g].z - alpha * Ap[g].z},
              z = matrix.preconditioned(g, rest);
            r[g] = rest;
            Ap[g] = z;
            total += wide(dot(rest, z));
            square += wide(dot(rest, rest));
          }
        squares[begin / chunks.size] = sum(square);
        return sum(total);
      });
      residual = 0.;
      for (const double square : squares)
        residual += square;
      const float beta = float(rz_next / rz);
      rz = rz_next;
      ++last_iterations;
      for_chunks(threads, chunks, [&](std::size_t begin, std::size_t last) {
        for (std::size_t g = begin; g < last; ++g)
          {
            FloatRow *rows = &p[FrictionMatrix::width * g];
            const Eight q = columns([&](const int k) { return rows[k]; });
            Eight &d = correction[g];
            d = {d.x + alpha * q.x, d.y + alpha * q.y, d.z + alpha * q.z};
            to_rows({Ap[g].x + beta * q.x, Ap[g].y + beta * q.y, Ap[g].z + beta * q.z}, rows);
          }
      });
    }
  for_chunks(threads, Chunks(n), [&](std::size_t begin, std::size_t last) {
    for (std::size_t i = begin; i < last; ++i)
      {
        const Eight &d = correction[i / FrictionMatrix::width];
        const std::size_t lane = i % FrictionMatrix::width;
        v[i].v += size * DoubleRow{d.x[lane], d.y[lane], d.z[lane], 0.};
      }
  });
}

double Friction::start(const Particles<3> &particles, const unsigned int threads)
{
  v.resize(own.size());
  return sum_chunks(threads, Chunks(own.size()), parts, [&](std::size_t begin, std::size_t last) {
    double total = 0.;
    for (std::size_t i = begin; i < last; ++i)
      {
        v[i].v = DoubleRow{particles.v[0][i], particles.v[1][i], particles.v[2][i], 0.};
        for (int d = 0; d < 3; ++d)
          total += particles.f[d][i] * particles.f[d][i];
      }
    return total;
  });
}

void Friction::solve(Particles<3> &particles, const SphereContacts &contacts, const double forces, double residual,
                     const unsigned int threads)
{
  last_iterations = 0;
  if (forces == 0.) // nothing moves; no residual is small against no force
    {
      for (auto &values : particles.v)
        std::fill(values.begin(), values.end(), 0.);
      return;
    }
  const double allowed = parameters.tolerance * parameters.tolerance * forces;
  // A correction is worth six digits at most: single precision has no more.
  for (; !(residual <= allowed); residual = exact_residual(particles, contacts, threads))
    correct(std::max(0.25 * allowed, 2.5e-13 * residual), residual, threads, allowed);
  all_iterations += last_iterations;
  for_chunks(threads, Chunks(own.size()), [&](std::size_t begin, std::size_t last) {
    for (std::size_t i = begin; i < last; ++i)
      for (int d = 0; d < 3; ++d)
        particles.v[d][i] = v[i].v[d];
  });
}

void Friction::velocities(Particles<3> &particles, const SphereContacts &contacts, const std::vector<double> &gamma,
                          const double implicit_step, const unsigned int threads)
{
  pair.step = implicit_step;
  own = gamma;
  if (none())
    return without_pairs(particles, threads);
  const double forces = start(particles, threads);
  const double residual = matrix.assemble(contacts, own, pair, particles, v, r, threads);
  solve(particles, contacts, forces, residual, threads);
}

void Friction::velocities_again(Particles<3> &particles, const SphereContacts &contacts, const unsigned int threads)
{
  if (none())
    return without_pairs(particles, threads);
  const double forces = start(particles, threads);
  solve(particles, contacts, forces, exact_residual(particles, contacts, threads), threads);
}

void Friction::without_pairs(Particles<3> &particles, const unsigned int threads)
{
  last_iterations = 0;
  for_chunks(threads, Chunks(own.size()), [&](std::size_t begin, std::size_t last) {
    for (int d = 0; d < 3; ++d)
      for (std::size_t i = begin; i < last; ++i)
        particles.v[d][i] = particles.f[d][i] / own[i];
  });
}

std::size_t Friction::memory_bytes() const
{
  return matrix.memory_bytes() + sizeof(double) * own.capacity() + sizeof(CellVector) * v.capacity() + sizeof(FloatRow) * p.capacity()
         + sizeof(Eight) * (r.capacity() + Ap.capacity() + correction.capacity());
}
} // namespace turgor
