// What velocities cost by the matrix of motion.
#include "micro/solve/motion_matrix.h"

#include "run/parallel.h"

#include <algorithm>

namespace turgor {
using eight_floats::sum;

// Links and rows that were pushed are asked as they lie there: a matrix that is collected for its power alone
// need not be made ready for products.
template <int dim>
Power MotionMatrix::power(const std::array<std::vector<double>, dim> &velocity, const unsigned int threads_) {
  threads = threads_;
  start<dim>(velocity, velocity);
  const std::size_t n = medium.size();
  const auto listed_by_others = [this](const LinkSource *source) { return source != &pushed; };
  Power result = pushed.power(v.data(), n);
  result += own_rows.power_of(v.data(), n);
  result.lost += sum_chunks(threads, Chunks(n), parts, [&](std::size_t begin, std::size_t last) {
    double total = 0.;
    for (std::size_t i = begin; i < last; ++i) {
      PowerRow row(v, i, n);
      for (const LinkSource *source : sources)
        if (listed_by_others(source)) source->add(i, 1, &row);
      total += medium[i] * sum(v[i].v * v[i].v) + row.result();
    }
    return total;
  });
  bool others = std::any_of(sources.begin(), sources.end(), listed_by_others);
  for (OwnProduct *one : products)
    if (one != &own_rows) {
      others = true;
      one->begin(v.data(), threads);
      result.lost += one->power(v.data(), n);
    }
  if (given_velocity.empty() || !others) return result;
  make_lists();  // what others give has no sums over those of given velocity alone
  const auto on_bodies = [&](const std::vector<BodyVector> &product) {
    double total = 0.;
    for (std::size_t i = 0; i < n; ++i) total += sum(v[i].v * product[i].v);
    return total;
  };
  result.given = result.lost - on_bodies(product_of(v));
  result.pushed = -on_bodies(product_of(given_alone()));
  return result;
}

template Power MotionMatrix::power<2>(const std::array<std::vector<double>, 2> &, unsigned int);
template Power MotionMatrix::power<3>(const std::array<std::vector<double>, 3> &, unsigned int);
}  // namespace turgor
