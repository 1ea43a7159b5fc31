// The two sweeps of the drag's product, in single and double precision, and what it pulls at walls.
#include "micro/terms/sph_drag_lanes.h"
#include "micro/terms/sph_drag_rows.h"
#include "run/parallel.h"

#include <algorithm>
#include <type_traits>

namespace turgor {
using namespace drag_rows;

template <int dim>
template <class Row, class Vectors>
Row SphDrag<dim>::velocity_of(const Ray &ray, const Vectors *v) const {
  if (ray.carrier != none && !carriers.empty()) {
    const Carrier &body = carriers[ray.carrier];
    Row result = of(v, body.row);
    if (body.length > 0.) result += of(v, body.row + 1)[0] * as<Row>((1. / body.length) * ray.turning);
    return result;
  }
  if constexpr (std::is_same_v<Row, DoubleRow>)
    if (given_nodes > 0)
      return (1. - ray.share) * v[first_node + ray.a].v + ray.share * v[first_node + ray.b].v;
  return Row{};
}

/// Y by columns; sum of w v_ij. Differences first, here and in what follows: what neighbours have in common
/// drops out before anything is rounded.
template <int dim>
template <class Row, class Vectors>
Row SphDrag<dim>::moments_of(const Copy<Row> &copy, const Vectors *v, const std::size_t i, Row *Y) const {
  const std::uint32_t begin = first[i], end = first[i + 1];
  const Row vi = of(v, i);
  if constexpr (std::is_same_v<Row, FloatRow>)
    return drag_lanes::moments<dim>(v, other.data() + begin, copy.u.data() + begin, end - begin, vi, Y);
  Row drawn{};
  for (std::uint32_t k = begin; k < end; ++k) {
    const Row apart = of(v, other[k]) - vi;
    drawn += apart * copy.weight[k];
    for (int a = 0; a < dim; ++a) Y[a] += apart * copy.u[k][a];
  }
  return drawn;
}

/// sum of w v_ij; monaghan: of w (v_ij . e) e.
template <int dim>
template <class Row, class Vectors>
Row SphDrag<dim>::drawn_by_neighbours(const Copy<Row> &copy, const Vectors *v, const std::size_t i) const {
  const std::uint32_t begin = first[i], end = first[i + 1];
  const bool central = form == DragForm::monaghan;
  const Row vi = of(v, i);
  if constexpr (std::is_same_v<Row, FloatRow>) {
    const std::uint16_t *j = other.data() + begin;
    return central ? drag_lanes::drawn_along(v, j, copy.central.data() + begin, end - begin, vi)
                   : drag_lanes::drawn(v, j, copy.weight.data() + begin, end - begin, vi);
  }
  Row sum{};
  for (std::uint32_t k = begin; k < end; ++k) {
    const Row apart = of(v, other[k]) - vi;
    sum += central ? copy.central[k] * dot<dim>(copy.central[k], apart) : apart * copy.weight[k];
  }
  return sum;
}

/// sum of T_j u
template <int dim>
template <class Row>
Row SphDrag<dim>::drawn_by_tensors(const Copy<Row> &copy, const std::size_t i) const {
  const std::uint32_t begin = first[i], end = first[i + 1];
  if constexpr (std::is_same_v<Row, FloatRow>)
    return drag_lanes::by_tensors<dim>(copy.T.data(), other.data() + begin, copy.u.data() + begin,
                                       end - begin);
  Row sum{};
  for (std::uint32_t k = begin; k < end; ++k) sum += times<dim>(copy.T[other[k]].data(), copy.u[k]);
  return sum;
}

/// First sweep: T and tau of every body.
template <int dim>
template <class Row, class Vectors>
void SphDrag<dim>::tensors(Copy<Row> &copy, const Vectors *v, const unsigned int threads) {
  using Number = NumberOf<Row>;
  const bool fits = form == DragForm::least_squares, gradients = fits || fitted_divergence;
  if (!fits && !stiff) return;
  copy.T.resize(bodies());
  copy.drawn.resize(bodies());
  copy.tau.resize(bodies());
  for_chunks(threads, Chunks(bodies(), 256), [&](const std::size_t begin, const std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Body<Row> &me = copy.body[i];
      const Row vi = of(v, i);
      Row Y[dim]{}, *T = copy.T[i].data();
      copy.drawn[i] = moments_of(copy, v, i, Y);
      Number trace = 0;
      for (int a = 0; a < dim; ++a) trace += Y[a][a];
      Number tau = me.kappa * (dot<dim>(me.slope, vi) - trace);
      for (int a = 0; a < dim; ++a) T[a] = Row{};
      if (gradients) {
        for (int a = 0; a < dim; ++a) Y[a] -= vi * me.wall[a];
        if (walls_move<Row>())
          for (std::uint32_t q = first_ray[i]; q < first_ray[i + 1]; ++q)
            for (int a = 0; a < dim; ++a)
              Y[a] += velocity_of<Row>(rays[q], v) * Number(rays[q].w * rays[q].r[a]);
        Row G[dim], s[dim]{};
        trace = 0;
        for (int a = 0; a < dim; ++a) {
          G[a] = times<dim>(Y, me.inverse[a]);
          trace += G[a][a];
        }
        if (fits) {
          for (int a = 0; a < dim; ++a)
            for (int b = 0; b < dim; ++b)
              s[a][b] = me.theta * (a == b ? 2 * G[a][a] + trace : G[a][b] + G[b][a]);
          for (int a = 0; a < dim; ++a) T[a] = times<dim>(s, me.inverse[a]) - Number(beta) * G[a];
        }
        if (me.shear > 0) {
          for (int a = 0; a < dim; ++a)
            for (int b = 0; b < dim; ++b) s[a][b] = me.shear * (G[a][b] + G[b][a]);
          for (int a = 0; a < dim; ++a) T[a] += times<dim>(s, me.inverse[a]);
        }
        if (fitted_divergence) {
          tau = -me.kappa * trace;
          for (int a = 0; a < dim; ++a) T[a] -= tau * me.inverse[a];
        }
      }
      copy.tau[i] = tau;
      if (!fitted_divergence)
        for (int a = 0; a < dim; ++a) T[a][a] -= tau;
    }
  });
}

/// Second sweep: product += A v of bodies [begin, end).
template <int dim>
template <class Row, class Vectors>
void SphDrag<dim>::multiply(const Copy<Row> &copy, const Vectors *v, const std::size_t begin,
                            const std::size_t end, Vectors *product) const {
  using Number = NumberOf<Row>;
  const bool fits = form == DragForm::least_squares, central = form == DragForm::monaghan,
             with_tensors = fits || stiff;
  const Number factor = fits ? Number(2. * beta) : Number(2.);
  for (std::size_t i = begin; i < std::min(end, bodies()); ++i) {
    const Body<Row> &me = copy.body[i];
    const Row vi = of(v, i);
    const Row drawn = with_tensors && !central ? copy.drawn[i] : drawn_by_neighbours(copy, v, i);
    Row pull = central ? Number(dim + 2.) * (Number(2.) * drawn - times<dim>(me.central, vi))
                       : factor * drawn - (fits ? Number(beta) : Number(1.)) * me.wall_w * vi;
    if (with_tensors) {
      const Row *T = copy.T[i].data();
      pull += drawn_by_tensors(copy, i) + times<dim>(T, me.pairs) + times<dim>(T, me.wall);
      if (!fitted_divergence) pull += copy.tau[i] * (me.wall - me.slope);
    }
    if (walls_move<Row>())
      for (std::uint32_t q = first_ray[i]; q < first_ray[i + 1]; ++q) {
        const Row at_wall = velocity_of<Row>(rays[q], v), r = as<Row>(rays[q].r);
        const Number w = Number(rays[q].w);
        pull += central ? Number(dim + 2.) * w * dot<dim>(at_wall, r) / dot<dim>(r, r) * r
                        : Number(fits ? beta : 1.) * w * at_wall;
      }
    add_to(product[i - begin], Number(-scale) * pull);
  }
  multiply_carriers(copy, v, begin, end, product);
}

/// Their rows: what the points on them pull at the particles with.
template <int dim>
template <class Row, class Vectors>
void SphDrag<dim>::multiply_carriers(const Copy<Row> &copy, const Vectors *v, const std::size_t begin,
                                     const std::size_t end, Vectors *product) const {
  for (const Carrier &one : carriers)
    for (const std::uint32_t turns : {0u, 1u}) {
      const std::size_t row = one.row + turns;
      if (row < begin || row >= end || (turns == 1 && one.length == 0.)) continue;
      DoubleRow sum{};
      for (const Carried &on : carried) {
        const Ray &ray = rays[on.ray];
        if (carriers.data() + ray.carrier != &one) continue;
        const DoubleRow pull = as<DoubleRow>(pull_of(copy, ray, on.body, v));
        if (turns == 0)
          sum += pull;
        else
          sum[0] += dot<dim>(pull, ray.turning) / one.length;
      }
      add_to(product[row - begin], as<Row>(scale * sum));
    }
}

template <int dim>
void SphDrag<dim>::begin(const FloatRow *p, const unsigned int threads) {
  tensors(single, p, threads);
}

template <int dim>
void SphDrag<dim>::begin(const BodyVector *v, const unsigned int threads) {
  tensors(exact, v, threads);
}

template <int dim>
void SphDrag<dim>::add(const FloatRow *p, const std::size_t begin_, const std::size_t end,
                       FloatRow *product) const {
  multiply(single, p, begin_, end, product);
}

template <int dim>
void SphDrag<dim>::add(const BodyVector *v, const std::size_t begin_, const std::size_t end,
                       BodyVector *product) const {
  multiply(exact, v, begin_, end, product);
}

/// On body i, over mu V.
template <int dim>
template <class Row, class Vectors>
Row SphDrag<dim>::pull_of(const Copy<Row> &copy, const Ray &ray, const std::size_t i,
                          const Vectors *v) const {
  using Number = NumberOf<Row>;
  const Row u = velocity_of<Row>(ray, v) - of(v, i), r = as<Row>(ray.r);
  const Number w = Number(ray.w);
  Row pull{};
  if (form == DragForm::monaghan)
    pull = Number(dim + 2.) * dot<dim>(u, r) / dot<dim>(r, r) * r;
  else if (form == DragForm::morris)
    pull = u;
  else
    pull = Number(beta) * u;
  if (form == DragForm::least_squares || stiff) pull += times<dim>(copy.T[i].data(), r);
  if (stiff && !fitted_divergence) pull += copy.tau[i] * r;
  return w * pull;
}

template <int dim>
std::vector<Vector<dim>> SphDrag<dim>::on_walls(const BodyVector *v, const std::size_t nodes) const {
  std::vector<Vector<dim>> force(nodes, Vector<dim>::Zero());
  for (std::size_t i = 0; i < bodies(); ++i)
    for (std::uint32_t q = first_ray[i]; q < first_ray[i + 1]; ++q) {
      const DoubleRow pull = pull_of(exact, rays[q], i, v);
      for (int d = 0; d < dim; ++d) {
        force[rays[q].a][d] -= scale * (1. - rays[q].share) * pull[d];
        force[rays[q].b][d] -= scale * rays[q].share * pull[d];
      }
    }
  return force;
}

template <int dim>
double SphDrag<dim>::power(const BodyVector *v, const std::size_t n) const {
  double total = OwnProduct::power(v, n);
  if (given_nodes == 0) return total;
  const std::vector<Vector<dim>> force = on_walls(v, given_nodes);
  for (std::uint32_t k = 0; k < given_nodes; ++k)
    for (int d = 0; d < dim; ++d) total -= force[k][d] * v[first_node + k].v[d];
  return total;
}

template class SphDrag<2>;
template class SphDrag<3>;
}  // namespace turgor
