#include "micro/solve/motion_matrix.h"

#include "run/parallel.h"

#include <algorithm>

namespace turgor {
using namespace eight_floats;

namespace {
template <int dim>
DoubleRow row_of(const Vector<dim> &a) {
  DoubleRow result{};
  for (int d = 0; d < dim; ++d) result[d] = a[d];
  return result;
}
}  // namespace

MotionMatrix::MotionMatrix(const SolveParameters &parameters_) : parameters(parameters_) {}

void MotionMatrix::clear(const std::size_t n) {
  medium.assign(n, 0.);
  clear_parts();
}

void MotionMatrix::clear(const std::vector<double> &of_medium) {
  medium = of_medium;
  clear_parts();
}

void MotionMatrix::clear_parts() {
  pushed.clear();
  own_rows.clear();
  sources.clear();
  products.clear();
  given_velocity.clear();
  listed = false;
  find_clusters = {};
  level.clear();
}

template <int dim>
std::uint32_t MotionMatrix::given(const Vector<dim> &velocity) {
  given_velocity.push_back({row_of<dim>(velocity)});
  // behind the bodies that fill up the last eight
  return std::uint32_t((medium.size() + LinkMatrix::width - 1) / LinkMatrix::width * LinkMatrix::width +
                       given_velocity.size() - 1);
}

template <int dim>
void MotionMatrix::link(const std::uint32_t i, const std::uint32_t j, const Vector<dim> &e,
                        const double normal, const double tangential) {
  pushed.push(i, j, row_of<dim>(e), normal, tangential);
}

template <int dim>
void MotionMatrix::row(const std::span<const std::uint32_t> bodies, const std::span<const Vector<dim>> g,
                       const double c) {
  own_rows.push<dim>(bodies, g, c);
}

template <int dim>
void MotionMatrix::whole(const std::uint32_t first, const std::span<const Vector<dim>> g, const double c) {
  std::vector<std::uint32_t> bodies(g.size());
  for (std::size_t k = 0; k < g.size(); ++k) bodies[k] = first + std::uint32_t(k);
  own_rows.push<dim>(bodies, g, c);
}

void MotionMatrix::add(const LinkSource &links) { sources.push_back(&links); }
void MotionMatrix::add(OwnProduct &product) { products.push_back(&product); }

template <int dim>
void MotionMatrix::correct_clusters(const std::array<std::vector<double>, dim> &x) {
  find_clusters = [this, &x] {
    clusters.find<dim>(
        medium.size(),
        [this](const std::function<void(std::uint32_t, std::uint32_t)> &join) {
          LinkedBodies linked;
          for (const LinkSource *source : sources)
            for (std::uint32_t i = 0; i < medium.size(); ++i) {
              linked.others.clear();
              source->add(i, 1, &linked);
              for (const std::uint32_t j : linked.others) join(i, j);
            }
          for (const OwnProduct *product : products) product->connect(join);
        },
        x);
  };
}

void MotionMatrix::make_lists() {
  if (listed) return;
  listed = true;
  alone = sources;
  const bool with_rows = !own_rows.empty(), with_links = !pushed.empty();
  if (with_links) {
    pushed.sort(medium.size());
    sources.push_back(&pushed);
    if (!with_rows) alone.push_back(&pushed);
  }
  if (with_rows) {
    own_rows.sort(medium.size(), with_links ? &pushed : nullptr, threads);
    products.push_back(&own_rows);
  }
}

Forces MotionMatrix::forces_of_links(const Forces &forces, const std::vector<BodyVector> &velocity) {
  if (products.empty()) return forces;
  less.assign(medium.size(), {});
  for (OwnProduct *one : products) one->begin(velocity.data(), threads);
  for_chunks(threads, Chunks(medium.size()), [&](std::size_t begin, std::size_t last) {
    for (const OwnProduct *one : products) one->add(velocity.data(), begin, last, less.data() + begin);
    for (std::size_t i = begin; i < last; ++i) less[i].v = forces(i) - less[i].v;
  });
  return {{}, less.data()};
}

double MotionMatrix::assemble() {
  blocks.assign(products.empty() ? 0 : medium.size(), {});
  if (!products.empty())
    for_chunks(threads, Chunks(medium.size()), [&](std::size_t begin, std::size_t last) {
      for (const OwnProduct *one : products) one->add_blocks(begin, last, blocks.data() + begin);
    });
  return matrix.assemble(alone, medium, products.empty() ? nullptr : &blocks, forces_of_links(F, v), v, r,
                         threads);
}

template <class Store>
double MotionMatrix::residual_of(const Forces &forces, const std::vector<BodyVector> &velocity,
                                 const Store &store) {
  const Forces left = forces_of_links(forces, velocity);
  return sum_chunks(threads, Chunks(medium.size()), parts, [&](std::size_t begin, std::size_t last) {
    DoubleRow total{};
    for (std::size_t i = begin; i < last; ++i) {
      ExactRow row(left, medium, velocity, i);
      for (const LinkSource *source : alone) source->add(i, 1, &row);
      const DoubleRow one = row.result();
      store(i, one);
      total += one * one;
    }
    return sum(total);
  });
}

double MotionMatrix::exact_residual() {
  return residual_of(F, v, [&](const std::size_t i, const DoubleRow one) { set_residual(i, one); });
}

void MotionMatrix::set_residual(const std::size_t i, const DoubleRow one) {
  Eight &eight = r[i / LinkMatrix::width];
  const std::size_t lane = i % LinkMatrix::width;
  eight.x[lane] = float(one[0]);
  eight.y[lane] = float(one[1]);
  eight.z[lane] = float(one[2]);
}

std::vector<BodyVector> MotionMatrix::product_of(const std::vector<BodyVector> &velocity) {
  const std::vector<BodyVector> no_forces(medium.size());
  std::vector<BodyVector> product(medium.size());
  residual_of({{}, no_forces.data()}, velocity,
              [&](const std::size_t i, const DoubleRow one) { product[i].v = -one; });
  return product;
}

void MotionMatrix::measure_clusters() {
  find_clusters();
  clusters.measure([&](const std::vector<BodyVector> &velocity,
                       std::vector<BodyVector> &product) { product = product_of(velocity); },
                   v.size());
}

/// The square of the residual after it.
double MotionMatrix::correct_as_rigid() {
  exact_rest.resize(medium.size());
  residual_of(F, v, [&](const std::size_t i, const DoubleRow one) { exact_rest[i].v = one; });
  clusters.correct(exact_rest, v);
  return sum_chunks(threads, Chunks(medium.size()), parts, [&](std::size_t begin, std::size_t last) {
    DoubleRow total{};
    for (std::size_t i = begin; i < last; ++i) {
      set_residual(i, exact_rest[i].v);
      total += exact_rest[i].v * exact_rest[i].v;
    }
    return sum(total);
  });
}

std::vector<BodyVector> MotionMatrix::given_alone() const {
  std::vector<BodyVector> at_rest(v.size());
  std::copy(given_velocity.begin(), given_velocity.end(),
            at_rest.end() - std::ptrdiff_t(given_velocity.size()));
  return at_rest;
}

/// The square of what the tolerance is relative to: of the forces, and of what bodies of given velocity do to
/// others at rest.
double MotionMatrix::scale_of_forces(const double forces) {
  if (given_velocity.empty()) return forces;
  return std::max(forces, residual_of(F, given_alone(), [](std::size_t, DoubleRow) {}));
}

std::size_t MotionMatrix::memory_bytes() const {
  return matrix.memory_bytes() + own_rows.memory_bytes() + clusters.memory_bytes() + level.memory_bytes() +
         sizeof(double) * medium.capacity() + sizeof(Block) * blocks.capacity() +
         sizeof(BodyVector) * (v.capacity() + less.capacity() + exact_rest.capacity()) +
         sizeof(FloatRow) * p.capacity() +
         sizeof(Eight) * (r.capacity() + Ap.capacity() + correction.capacity());
}

template std::uint32_t MotionMatrix::given<2>(const Vector<2> &);
template void MotionMatrix::link<2>(std::uint32_t, std::uint32_t, const Vector<2> &, double, double);
template void MotionMatrix::row<2>(std::span<const std::uint32_t>, std::span<const Vector<2>>, double);
template void MotionMatrix::whole<2>(std::uint32_t, std::span<const Vector<2>>, double);
template void MotionMatrix::correct_clusters<2>(const std::array<std::vector<double>, 2> &);
template std::uint32_t MotionMatrix::given<3>(const Vector<3> &);
template void MotionMatrix::link<3>(std::uint32_t, std::uint32_t, const Vector<3> &, double, double);
template void MotionMatrix::row<3>(std::span<const std::uint32_t>, std::span<const Vector<3>>, double);
template void MotionMatrix::whole<3>(std::uint32_t, std::span<const Vector<3>>, double);
template void MotionMatrix::correct_clusters<3>(const std::array<std::vector<double>, 3> &);
}  // namespace turgor
