// What velocities cost by the matrix of motion.
#include "micro/solve/motion_matrix.h"

#include "run/parallel.h"

namespace turgor {
using eight_floats::sum;

template <int dim>
MotionMatrix::Power MotionMatrix::power(const std::array<std::vector<double>, dim> &velocity,
                                        const unsigned int threads_) {
  threads = threads_;
  make_lists();
  start<dim>(velocity, velocity);
  const std::size_t n = medium.size();
  Power result;
  result.lost = sum_chunks(threads, Chunks(n), parts, [&](std::size_t begin, std::size_t last) {
    double total = 0.;
    for (std::size_t i = begin; i < last; ++i) {
      PowerRow row(v, i, n);
      for (const LinkSource *source : sources) source->add(i, 1, &row);
      total += medium[i] * sum(v[i].v * v[i].v) + row.result();
    }
    return total;
  });
  for (OwnProduct *one : products) {
    one->begin(v.data(), threads);
    result.lost += one->power(v.data(), n);
  }
  if (given_velocity.empty()) return result;
  const auto on_bodies = [&](const std::vector<BodyVector> &product) {
    double total = 0.;
    for (std::size_t i = 0; i < n; ++i) total += sum(v[i].v * product[i].v);
    return total;
  };
  result.given = result.lost - on_bodies(product_of(v));
  result.pushed = -on_bodies(product_of(given_alone()));
  return result;
}

template MotionMatrix::Power MotionMatrix::power<2>(const std::array<std::vector<double>, 2> &, unsigned int);
template MotionMatrix::Power MotionMatrix::power<3>(const std::array<std::vector<double>, 3> &, unsigned int);
}  // namespace turgor
