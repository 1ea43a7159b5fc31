// How the matrix of motion is solved: conjugate gradients in single precision, refined against the exact
// residual.
#include "micro/solve/motion_matrix.h"

#include "micro/solve/step_too_long.h"
#include "run/number_text.h"
#include "run/parallel.h"

#include <algorithm>
#include <cmath>

namespace turgor {
using namespace eight_floats;

/// Ap of the eights [begin, last); p.Ap of them.
double MotionMatrix::product(const std::size_t begin, const std::size_t last) {
  double total = matrix.product(begin, last, p, Ap);
  if (products.empty()) return total;
  constexpr std::size_t width = LinkMatrix::width;
  std::vector<FloatRow> own(width * (last - begin));
  for (const OwnProduct *one : products)
    one->add(p.data(), width * begin, std::min(medium.size(), width * last), own.data());
  FourDoubles dots{};
  for (std::size_t g = begin; g < last; ++g) {
    const Eight me = columns([&](const int k) { return p[width * g + std::size_t(k)]; }),
                more = columns([&](const int k) { return own[width * (g - begin) + std::size_t(k)]; });
    Ap[g] = {Ap[g].x + more.x, Ap[g].y + more.y, Ap[g].z + more.z};
    dots += wide(dot(me, more));
  }
  return total + sum(dots);
}

template <int dim>
double MotionMatrix::start(const std::array<std::vector<double>, dim> &f,
                           const std::array<std::vector<double>, dim> &velocity) {
  const std::size_t n = medium.size(),
                    given_at = (n + LinkMatrix::width - 1) / LinkMatrix::width * LinkMatrix::width;
  F = {};
  for (int d = 0; d < dim; ++d) F.component[d] = f[d].data();
  v.resize(given_at + given_velocity.size());
  std::copy(given_velocity.begin(), given_velocity.end(), v.begin() + std::ptrdiff_t(given_at));
  return sum_chunks(threads, Chunks(n), parts, [&](std::size_t begin, std::size_t last) {
    double total = 0.;
    for (std::size_t i = begin; i < last; ++i) {
      DoubleRow at{};
      for (int d = 0; d < dim; ++d) {
        at[d] = velocity[d][i];
        total += f[d][i] * f[d][i];
      }
      v[i].v = at;
    }
    return total;
  });
}

/// r becomes scale r, p where the search begins; r'z.
double MotionMatrix::first_direction(const float scale) {
  const Chunks chunks(matrix.eights(), 64);
  double rz = sum_chunks(threads, chunks, parts, [&](std::size_t begin, std::size_t last) {
    DoubleRow total{};
    for (std::size_t g = begin; g < last; ++g) {
      const Eight rest{scale * r[g].x, scale * r[g].y, scale * r[g].z}, z = matrix.preconditioned(g, rest);
      r[g] = rest;
      to_rows(z, &p[LinkMatrix::width * g]);
      correction[g] = {};
      total += wide(dot(rest, z));
    }
    return sum(total);
  });
  if (level.wanted()) {
    rz += level.ask(r);
    for_chunks(threads, chunks, [&](std::size_t begin, std::size_t last) {
      for (std::size_t g = begin; g < last; ++g)
        add_rows(level.motion()[g], LinkMatrix::width, &p[LinkMatrix::width * g]);
    });
  }
  return rz;
}

/// Conjugate gradients in single precision for A d = r, until |r|^2 <= target; v += d. All numbers are those
/// of r/|r|: squares of small forces would leave the range of single precision.
void MotionMatrix::correct(const double target, const double start, const double allowed) {
  const std::size_t n = medium.size();
  const Chunks chunks(matrix.eights(), 64);
  p.resize(LinkMatrix::width * chunks.n + given_velocity.size());
  std::fill(p.end() - std::ptrdiff_t(given_velocity.size()), p.end(), FloatRow{});  // which stay as they are
  Ap.resize(chunks.n);
  correction.resize(chunks.n);
  const double size = std::sqrt(start);
  const float scale = float(1. / size);
  double residual = 1.;
  double rz = first_direction(scale);
  squares.resize(chunks.count());
  while (!(residual * start <= target)) {
    if (!std::isfinite(residual * start))
      throw NoNumbers("the forces on the bodies or what ties them together are no numbers any more.");
    if (last_iterations >= parameters.max_iterations) {
      // Less than what is aimed at may be enough: the exact residual decides.
      if (residual * start <= allowed) break;
      throw NotSolved(
          "the friction matrix was not solved within " + number_text(parameters.max_iterations) +
          " iterations: " + number_text(std::sqrt(residual * start / allowed) * parameters.tolerance, 3) +
          " of the forces are left over, allowed are " + number_text(parameters.tolerance) + ".");
    }
    for (OwnProduct *one : products) one->begin(p.data(), threads);
    const double pAp = sum_chunks(threads, chunks, parts,
                                  [&](std::size_t begin, std::size_t last) { return product(begin, last); });
    const float alpha = float(rz / pAp);
    double rz_next = sum_chunks(threads, chunks, parts, [&](std::size_t begin, std::size_t last) {
      DoubleRow total{}, square{};
      for (std::size_t g = begin; g < last; ++g) {
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
    if (level.wanted()) rz_next += level.ask(r);
    residual = 0.;
    for (const double square : squares) residual += square;
    const float beta = float(rz_next / rz);
    rz = rz_next;
    ++last_iterations;
    for_chunks(threads, chunks, [&](std::size_t begin, std::size_t last) {
      for (std::size_t g = begin; g < last; ++g) {
        FloatRow *rows = &p[LinkMatrix::width * g];
        const Eight q = columns([&](const int k) { return rows[k]; });
        Eight &d = correction[g];
        d = {d.x + alpha * q.x, d.y + alpha * q.y, d.z + alpha * q.z};
        Eight z = Ap[g];
        if (level.wanted()) {
          const Eight &more = level.motion()[g];
          z = {z.x + more.x, z.y + more.y, z.z + more.z};
        }
        to_rows({z.x + beta * q.x, z.y + beta * q.y, z.z + beta * q.z}, rows);
      }
    });
  }
  for_chunks(threads, Chunks(n), [&](std::size_t begin, std::size_t last) {
    for (std::size_t i = begin; i < last; ++i) {
      const Eight &d = correction[i / LinkMatrix::width];
      const std::size_t lane = i % LinkMatrix::width;
      v[i].v += size * DoubleRow{d.x[lane], d.y[lane], d.z[lane], 0.};
    }
  });
}

template <int dim>
void MotionMatrix::finish(const double forces, double residual,
                          std::array<std::vector<double>, dim> &velocity) {
  last_iterations = 0;
  if (forces == 0.)  // nothing moves; no residual is small against no force
  {
    for (auto &values : velocity) std::fill(values.begin(), values.end(), 0.);
    return;
  }
  // N: below it numbers leave the range of single precision, and nothing is left to be solved.
  constexpr double nothing = 1e-36;
  const double allowed = std::max(parameters.tolerance * parameters.tolerance * forces, nothing * nothing);
  if (find_clusters) residual = correct_as_rigid();
  // A correction is worth six digits at most: single precision has no more.
  for (; !(residual <= allowed); residual = find_clusters ? correct_as_rigid() : exact_residual())
    correct(std::max(0.25 * allowed, 2.5e-13 * residual), residual, allowed);
  for_chunks(threads, Chunks(medium.size()), [&](std::size_t begin, std::size_t last) {
    for (std::size_t i = begin; i < last; ++i)
      for (int d = 0; d < dim; ++d) velocity[d][i] = v[i].v[d];
  });
}

template <int dim>
void MotionMatrix::solve(const std::array<std::vector<double>, dim> &f,
                         std::array<std::vector<double>, dim> &velocity, const unsigned int threads_) {
  threads = threads_;
  make_lists();
  if (none()) return medium_alone<dim>(f, velocity);
  const double forces = start<dim>(f, velocity), residual = assemble();
  if (find_clusters) measure_clusters();
  if (level.wanted() && !level.sum(medium, pushed, own_rows.rows())) level.clear();
  finish<dim>(scale_of_forces(forces), residual, velocity);
}

template <int dim>
void MotionMatrix::again(const std::array<std::vector<double>, dim> &f,
                         std::array<std::vector<double>, dim> &velocity, const unsigned int threads_) {
  threads = threads_;
  if (none()) return medium_alone<dim>(f, velocity);
  const double forces = start<dim>(f, velocity);
  finish<dim>(scale_of_forces(forces), exact_residual(), velocity);
}

template <int dim>
void MotionMatrix::medium_alone(const std::array<std::vector<double>, dim> &f,
                                std::array<std::vector<double>, dim> &velocity) {
  last_iterations = 0;
  for_chunks(threads, Chunks(medium.size()), [&](std::size_t begin, std::size_t last) {
    for (int d = 0; d < dim; ++d)
      for (std::size_t i = begin; i < last; ++i) velocity[d][i] = f[d][i] / medium[i];
  });
}

template double MotionMatrix::start<2>(const std::array<std::vector<double>, 2> &,
                                       const std::array<std::vector<double>, 2> &);
template double MotionMatrix::start<3>(const std::array<std::vector<double>, 3> &,
                                       const std::array<std::vector<double>, 3> &);
template void MotionMatrix::solve<2>(const std::array<std::vector<double>, 2> &,
                                     std::array<std::vector<double>, 2> &, unsigned int);
template void MotionMatrix::again<2>(const std::array<std::vector<double>, 2> &,
                                     std::array<std::vector<double>, 2> &, unsigned int);
template void MotionMatrix::solve<3>(const std::array<std::vector<double>, 3> &,
                                     std::array<std::vector<double>, 3> &, unsigned int);
template void MotionMatrix::again<3>(const std::array<std::vector<double>, 3> &,
                                     std::array<std::vector<double>, 3> &, unsigned int);
}  // namespace turgor
