#include "micro/terms/cell_friction.h"

#include "micro/engine/parallel.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace turgor
{
Friction::Friction(const FrictionParameters &parameters_)
  : parameters(parameters_)
{}

void Friction::assemble(const SphereContacts &contacts, const std::vector<double> &gamma, const double implicit_step,
                        const unsigned int threads)
{
  const PairList<3> &list = contacts.list();
  const std::vector<PairContact> &contact = contacts.contacts();
  const std::size_t n = gamma.size();
  first.assign(n + 1, 0);
  for_chunks(threads, Chunks(n), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (std::uint32_t k = list.first()[i]; k < list.first()[i + 1]; ++k)
        first[i + 1] += contact[list.own()[k]].area > 0.;
  });
  for (std::size_t i = 0; i < n; ++i)
    first[i + 1] += first[i];
  links.resize(first[n]);
  inverse.resize(n);
  own = gamma;
  for_chunks(threads, Chunks(n), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      {
        std::uint32_t at = first[i];
        double isotropic = gamma[i], m[6] = {0., 0., 0., 0., 0., 0.};
        for (std::uint32_t k = list.first()[i]; k < list.first()[i + 1]; ++k)
          {
            const PairContact &c = contact[list.own()[k]];
            if (!(c.area > 0.))
              continue;
            double normal = parameters.normal * c.area, tangential = parameters.tangential * c.area;
            if (implicit_step > 0.)
              { // only what keeps the matrix positive definite; repulsion turned sideways is left explicit
                normal += implicit_step * std::max(0., c.stiffness);
                tangential += implicit_step * std::max(0., -c.force / c.distance);
              }
            links[at++] = {{c.e[0], c.e[1], c.e[2]}, tangential, normal - tangential, list.other()[k]};
            isotropic += tangential;
            const double w = normal - tangential;
            m[0] += w * c.e[0] * c.e[0];
            m[1] += w * c.e[0] * c.e[1];
            m[2] += w * c.e[0] * c.e[2];
            m[3] += w * c.e[1] * c.e[1];
            m[4] += w * c.e[1] * c.e[2];
            m[5] += w * c.e[2] * c.e[2];
          }
        m[0] += isotropic;
        m[3] += isotropic;
        m[5] += isotropic;
        const double a = m[3] * m[5] - m[4] * m[4], b = m[2] * m[4] - m[1] * m[5], c = m[1] * m[4] - m[2] * m[3];
        const double id = 1. / (m[0] * a + m[1] * b + m[2] * c);
        inverse[i] = {{a * id, b * id, c * id, (m[0] * m[5] - m[2] * m[2]) * id, (m[1] * m[2] - m[0] * m[4]) * id,
                       (m[0] * m[3] - m[1] * m[1]) * id}};
      }
  });
}

void Friction::multiply(const SphereContacts &, const std::vector<std::array<double, 3>> &x,
                        std::vector<std::array<double, 3>> &y, const unsigned int threads) const
{
  for_chunks(threads, Chunks(x.size()), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      {
        const std::array<double, 3> &xi = x[i];
        double sum[3] = {own[i] * xi[0], own[i] * xi[1], own[i] * xi[2]};
        for (std::uint32_t k = first[i]; k < first[i + 1]; ++k)
          {
            const Link &l = links[k];
            const std::array<double, 3> &xj = x[l.other];
            const double u[3] = {xi[0] - xj[0], xi[1] - xj[1], xi[2] - xj[2]};
            const double along = l.difference * (u[0] * l.e[0] + u[1] * l.e[1] + u[2] * l.e[2]);
            for (int d = 0; d < 3; ++d)
              sum[d] += l.tangential * u[d] + along * l.e[d];
          }
        y[i] = {sum[0], sum[1], sum[2]};
      }
  });
}

void Friction::velocities(Particles<3> &particles, const SphereContacts &contacts, const std::vector<double> &gamma,
                          const double implicit_step, const unsigned int threads)
{
  const std::size_t n = gamma.size();
  const Chunks chunks(n);
  last_iterations = 0;
  if (parameters.normal == 0. && parameters.tangential == 0. && implicit_step == 0.)
    {
      for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
        for (int d = 0; d < 3; ++d)
          for (std::size_t i = begin; i < end; ++i)
            particles.v[d][i] = particles.f[d][i] / gamma[i];
      });
      return;
    }
  assemble(contacts, gamma, implicit_step, threads);
  for (auto *array : {&v, &r, &z, &s, &As})
    array->resize(n);
  const auto dot = [&](const std::vector<std::array<double, 3>> &a, const std::vector<std::array<double, 3>> &b) {
    return sum_chunks(threads, chunks, parts, [&](std::size_t begin, std::size_t end) {
      double total = 0.;
      for (std::size_t i = begin; i < end; ++i)
        total += a[i][0] * b[i][0] + a[i][1] * b[i][1] + a[i][2] * b[i][2];
      return total;
    });
  };
  const auto precondition = [&] {
    for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        {
          const double *m = inverse[i].m;
          const auto &q = r[i];
          z[i] = {m[0] * q[0] + m[1] * q[1] + m[2] * q[2], m[1] * q[0] + m[3] * q[1] + m[4] * q[2],
                  m[2] * q[0] + m[4] * q[1] + m[5] * q[2]};
        }
    });
  };
  for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (int d = 0; d < 3; ++d)
        {
          v[i][d] = particles.v[d][i];
          r[i][d] = particles.f[d][i];
        }
  });
  const double allowed = parameters.tolerance * parameters.tolerance * dot(r, r);
  multiply(contacts, v, As, threads);
  for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (int d = 0; d < 3; ++d)
        r[i][d] -= As[i][d];
  });
  double residual = dot(r, r);
  if (residual > allowed)
    {
      precondition();
      s = z;
      double rz = dot(r, z);
      while (residual > allowed)
        {
          if (last_iterations >= parameters.max_iterations || !std::isfinite(residual))
            throw std::runtime_error("the friction matrix was not solved within "
                                     + std::to_string(parameters.max_iterations) + " iterations (residual "
                                     + std::to_string(std::sqrt(residual / allowed) * parameters.tolerance)
                                     + " of the forces, allowed " + std::to_string(parameters.tolerance)
                                     + "): more friction with the medium, or a larger tolerance.");
          multiply(contacts, s, As, threads);
          const double alpha = rz / dot(s, As);
          for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
              for (int d = 0; d < 3; ++d)
                {
                  v[i][d] += alpha * s[i][d];
                  r[i][d] -= alpha * As[i][d];
                }
          });
          precondition();
          const double rz_next = dot(r, z), beta = rz_next / rz;
          rz = rz_next;
          residual = dot(r, r);
          for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
              for (int d = 0; d < 3; ++d)
                s[i][d] = z[i][d] + beta * s[i][d];
          });
          ++last_iterations;
        }
    }
  all_iterations += last_iterations;
  for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (int d = 0; d < 3; ++d)
        particles.v[d][i] = v[i][d];
  });
}
} // namespace turgor
