#include "micro/terms/sph_drag_rows.h"
#include "run/parallel.h"

#include <algorithm>
#include <cmath>

namespace turgor {
using namespace drag_rows;

template <int dim>
void SphDrag<dim>::clear(const DragForm form_, const double scale_) {
  form = form_;
  scale = scale_;
  stiff = false;
  given_nodes = 0;
  exact.body.clear();
  exact.u.clear();
  exact.central.clear();
  exact.weight.clear();
  other.clear();
  rays.clear();
  carriers.clear();
  carried.clear();
  first.assign(1, 0);
  first_ray.assign(1, 0);
  moments.clear();
  behind.clear();
}

template <int dim>
void SphDrag<dim>::body() {
  exact.body.emplace_back();
  moments.push_back(Tensor2<dim>::Zero());
  behind.push_back(Vector<dim>::Zero());
  first.push_back(std::uint32_t(other.size()));
  first_ray.push_back(std::uint32_t(rays.size()));
}

template <int dim>
void SphDrag<dim>::pair(const std::uint32_t j, const Vector<dim> &r, const double w) {
  Body<DoubleRow> &me = exact.body.back();
  const DoubleRow u = row_of<dim>(w * r);
  other.push_back(std::uint16_t(j));
  exact.u.push_back(u);
  exact.weight.push_back(w);
  me.pairs += u;
  me.w += w;
  if (form == DragForm::monaghan) exact.central.push_back(row_of<dim>(std::sqrt(w) * r.normalized()));
  moments.back() += w * r * r.transpose();
  first.back() = std::uint32_t(other.size());
}

template <int dim>
void SphDrag<dim>::ray(const Vector<dim> &r, const double w, const std::uint32_t a, const std::uint32_t b,
                       const double share, const double fading) {
  Body<DoubleRow> &me = exact.body.back();
  rays.push_back({.a = a, .b = b, .share = share, .w = w, .r = row_of<dim>(r)});
  me.wall += row_of<dim>(w * r);
  me.wall_w += w;
  behind.back() += 0.5 * w / fading * r;
  const Vector<dim> e = r.normalized();
  for (int k = 0; k < dim; ++k) me.central[k] += row_of<dim>(w * e[k] * e);
  first_ray.back() = std::uint32_t(rays.size());
}

template <int dim>
void SphDrag<dim>::on_carrier(const std::uint32_t carrier, const Vector<dim> &arm) {
  Ray &ray = rays.back();
  ray.carrier = carrier;
  ray.turning[0] = -arm[1];
  ray.turning[1] = arm[0];
  carried.push_back({std::uint32_t(rays.size() - 1), std::uint32_t(bodies() - 1)});
}

template <int dim>
void SphDrag<dim>::finish(const unsigned int threads, const bool balanced) {
  const bool weighs = balanced && form == DragForm::least_squares;
  for_chunks(threads, Chunks(bodies()), [&](const std::size_t begin, const std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (weighs) weigh_rays(i);
      for (std::uint32_t q = first_ray[i]; q < first_ray[i + 1]; ++q) {
        Vector<dim> r;
        for (int d = 0; d < dim; ++d) r[d] = rays[q].r[d];
        moments[i] += rays[q].w * r * r.transpose();
      }
      const Eigen::SelfAdjointEigenSolver<Tensor2<dim>> spectrum(moments[i]);
      const Vector<dim> inverse = spectrum.eigenvalues().cwiseMax(least_moment).cwiseInverse();
      const Tensor2<dim> S =
          spectrum.eigenvectors() * inverse.asDiagonal() * spectrum.eigenvectors().transpose();
      for (int a = 0; a < dim; ++a) exact.body[i].inverse[a] = row_of<dim>(S.col(a));
      const double share = std::clamp(spectrum.eigenvalues()[0] / sound_moment, 0., 1.);
      exact.body[i].theta = share * share;
    }
  });
  if (weighs) weigh_bodies();
  single.u.resize(exact.u.size());
  single.central.resize(exact.central.size());
  single.weight.resize(exact.weight.size());
  for_chunks(threads, Chunks(exact.u.size(), 8192), [&](const std::size_t begin, const std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      DoubleRow u = exact.u[k];
      u[3] = exact.weight[k];
      single.u[k] = narrow(u);
      single.weight[k] = float(exact.weight[k]);
      if (!exact.central.empty()) single.central[k] = narrow(exact.central[k]);
    }
  });
  set_stiffness({});
}

template <int dim>
void SphDrag<dim>::set_stiffness(const std::vector<Stiffness> &of_bodies, const bool fitted) {
  stiff = !of_bodies.empty();
  fitted_divergence = stiff && fitted;
  single.body.resize(bodies());
  for (std::size_t i = 0; i < bodies(); ++i) {
    Body<DoubleRow> &from = exact.body[i];
    from.kappa = stiff ? of_bodies[i].kappa : 0.;
    from.shear = fitted_divergence ? of_bodies[i].shear : 0.;
    from.slope = stiff ? row_of<dim>(of_bodies[i].slope) : DoubleRow{};
    Body<FloatRow> &to = single.body[i];
    to.pairs = narrow(from.pairs);
    to.wall = narrow(from.wall);
    to.slope = narrow(from.slope);
    for (int a = 0; a < dim; ++a) {
      to.central[a] = narrow(from.central[a]);
      to.inverse[a] = narrow(from.inverse[a]);
    }
    to.w = float(from.w);
    to.wall_w = float(from.wall_w);
    to.kappa = float(from.kappa);
    to.theta = float(from.theta);
    to.shear = float(from.shear);
  }
}

template <int dim>
void SphDrag<dim>::walls(const std::uint32_t first_, const std::uint32_t nodes) {
  first_node = first_;
  given_nodes = nodes;
}

/// Without what a body's own velocity does by its stress (least_squares): they precondition only.
template <int dim>
void SphDrag<dim>::add_blocks(const std::size_t begin_, const std::size_t end, Block *blocks) const {
  for (const Carrier &one : carriers)
    for (const std::uint32_t turns : {0u, 1u}) {
      const std::size_t row = one.row + turns;
      if (row < begin_ || row >= end || (turns == 1 && one.length == 0.)) continue;
      double sum = 0.;
      for (const Carried &on : carried)
        if (const Ray &ray = rays[on.ray]; carriers.data() + ray.carrier == &one)
          sum += scale * (form == DragForm::least_squares ? beta : 1.) * ray.w *
                 (turns == 0 ? 1. : dot<dim>(ray.turning, ray.turning) / (one.length * one.length));
      blocks[row - begin_].xx += sum;
      blocks[row - begin_].yy += sum;  // of a spin: no motion there, but an inverse
      blocks[row - begin_].zz += sum;
    }
  for (std::size_t i = begin_; i < std::min(end, bodies()); ++i) {
    const Body<DoubleRow> &me = exact.body[i];
    Tensor2<dim> A = Tensor2<dim>::Zero();
    const auto outer = [&](const DoubleRow a, const double c) {
      for (int k = 0; k < dim; ++k)
        for (int l = 0; l < dim; ++l) A(k, l) += c * a[k] * a[l];
    };
    if (form == DragForm::monaghan) {
      for (int k = 0; k < dim; ++k)
        for (int l = 0; l < dim; ++l) A(k, l) += (dim + 2.) * me.central[k][l];
      for (std::uint32_t k = first[i]; k < first[i + 1]; ++k) outer(exact.central[k], 2. * (dim + 2.));
    } else
      A.diagonal().array() += (form == DragForm::morris ? 1. : beta) * (2. * me.w + me.wall_w);
    if (stiff) {
      for (std::uint32_t k = first[i]; k < first[i + 1]; ++k) {
        const Body<DoubleRow> &you = exact.body[other[k]];
        outer(fitted_divergence ? times<dim>(you.inverse, exact.u[k]) : exact.u[k], you.kappa);
      }
      outer(fitted_divergence ? times<dim>(me.inverse, me.pairs + me.wall) : me.pairs + me.slope, me.kappa);
    }
    A *= scale;
    Block &to = blocks[i - begin_];
    to.xx += A(0, 0);
    to.xy += A(0, 1);
    to.yy += A(1, 1);
    if constexpr (dim == 3) {
      to.xz += A(0, 2);
      to.yz += A(1, 2);
      to.zz += A(2, 2);
    } else
      to.zz += A.trace();  // no motion there, but an inverse
  }
}

template <int dim>
void SphDrag<dim>::connect(const std::function<void(std::uint32_t, std::uint32_t)> &join) const {
  for (std::uint32_t i = 0; i < bodies(); ++i)
    for (std::uint32_t k = first[i]; k < first[i + 1]; ++k) join(i, other[k]);
  if (carriers.empty()) return;
  for (const Carried &on : carried) join(on.body, carriers[rays[on.ray].carrier].row);
}

template <int dim>
std::size_t SphDrag<dim>::memory_bytes() const {
  const auto of_copy = [](const auto &copy) {
    return copy.body.capacity() * sizeof(copy.body[0]) +
           (copy.u.capacity() + copy.central.capacity()) * sizeof(copy.u[0]) +
           copy.T.capacity() * sizeof(copy.T[0]) + copy.drawn.capacity() * sizeof(copy.drawn[0]) +
           (copy.tau.capacity() + copy.weight.capacity()) * sizeof(copy.tau[0]);
  };
  return of_copy(exact) + of_copy(single) + 4 * (first.capacity() + first_ray.capacity()) +
         2 * other.capacity() + rays.capacity() * sizeof(Ray) + moments.capacity() * sizeof(Tensor2<dim>);
}

template class SphDrag<2>;
template class SphDrag<3>;
}  // namespace turgor
