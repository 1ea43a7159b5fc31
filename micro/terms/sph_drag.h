// The matrix of motion of an SPH fluid without inertia ("NSPH", thesis Eq. 2.30, 2.31 corrected): its viscous
// friction, and for linearly implicit steps of h the stiffness of its pressure, as one product that sweeps
// twice over the neighbours (own_product.h). Three forms, over mu V with w and the rays to the wall of
// sph_viscosity.inc.h, r_ij = x_j - x_i, v_ij = v_j - v_i:
//
//   morris         F_i = sum_j 2 w v_ij                       + sum_q w_q v_iq             2.24 as 2.31
//   monaghan       F_i = (d + 2) [ sum_j 2 w (v_ij.e) e       + sum_q w_q (v_iq.e) e ]     2.25
//   least_squares  F_i = sum_j w [2 beta v_ij + (T_i + T_j) r_ij] + sum_q w_q [beta v_iq + T_i r_iq]
//                  T = theta (G + G^T + tr G) S^-1 - beta G,  G = Y S^-1 sph_viscosity.inc.h
//
// All are symmetric and take energy from every flow but: morris from a translation; the others from a rigid
// motion (a spin costs nothing). Of a particle with few neighbours least_squares keeps its residual in full
// (no central drag in its place): theta fades the stress of D alone.
//
// Stiffness, Gauss-Newton: K = sum_i m (dp/drho)/rho^2 (drho_i)(drho_i)', never negative, with
//   drho_i = (rho_0/gamma_i) D_i,   D_i = -sum_j w v_ij . r_ij + slope_i . v_i,   slope = -(rho/rho_0) dgamma
// A scalar a particle: -h kappa D_i is added to T_i, so an implicit step costs no sweep more. Bodies of given
// velocity count as moving along their own surface there. A solid adds h G (G + G^T) to the stress in T, and
// no theta to that.
//
//   drag.clear(form, n);  drag.body(...);  drag.pair(j, r, w);  drag.ray(r, w, a, b, share);  ...
//   drag.finish();
//
// Balanced, its rays and theta get a factor a body: beside a wall an even stress then pushes at no particle.
//
// Same bits on any number of threads: one thread a body, its pairs in their order.
#pragma once

#include "micro/geometry/tensor.h"
#include "micro/solve/own_product.h"
#include "micro/terms/laid_pattern.h"

#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace turgor {
enum class DragForm { least_squares, morris, monaghan };
constexpr const char *words_of(DragForm) { return "least_squares|morris|monaghan"; }

template <int dim>
class SphDrag final : public OwnProduct {
 public:
  /// scale: mu V, Pa s m^3.
  void clear(DragForm form, double scale);
  /// The next body; what follows is its own until the next one.
  void body();
  void pair(std::uint32_t j, const Vector<dim> &r, double w);  ///< r: m; w: 1/m^2
  /// A point of the wall between nodes a and b, `share` of the way to b. fading: by how much w is less than
  /// 2 N/s dOmega, close to the wall.
  void ray(const Vector<dim> &r, double w, std::uint32_t a, std::uint32_t b, double share,
           double fading = 1.);
  /// The last ray's point is on rigid body number `carrier`; arm: m, from its centre.
  void on_carrier(std::uint32_t carrier, const Vector<dim> &arm);
  /// balanced: an even stress is in balance (sph_drag_balance.cc); least_squares, of a fluid that walls or
  /// periods hold on all sides. drag.finish(threads, true);
  void finish(unsigned int threads, bool balanced = false);
  std::size_t bodies() const { return exact.body.size(); }
  std::size_t pairs() const { return other.size(); }

  /// Of body i: h m (dp/drho) (rho_0/(rho gamma))^2/(mu V), no unit times m^2; slope (1/m); and of a solid,
  /// by the fitted gradients only, h (shear modulus)/mu, kappa then h (K - 2/3 shear modulus)/mu.
  struct Stiffness {
    double kappa = 0., shear = 0.;
    Vector<dim> slope = Vector<dim>::Zero();
  };
  /// One a body; empty: friction alone. fitted: D is minus the trace of G (`divergence`), slope is not used.
  void set_stiffness(const std::vector<Stiffness> &of_bodies, bool fitted = false);

  /// 1/s, tr G of every body at velocities v: exact for affine flow, walls included.
  std::vector<double> divergence(const BodyVector *v);
  /// f += forces (N) of pressures p (Pa), the adjoint of the divergence: they do V sum p_i tr G_i in any
  /// flow,
  ///   F_i = -V sum_j w (p_i S_i^-1 + p_j S_j^-1) r_ij - V p_i S_i^-1 sum_q w_q r_q,
  /// and what walls get of it on their nodes.
  void push(const std::vector<double> &p, double volume, std::array<std::vector<double>, dim> &f,
            std::vector<Vector<dim>> &on_nodes) const;
  /// The same of stresses (Pa, positive in tension): they do -V sum stress_i : G_i in any flow.
  void pull(const std::vector<Tensor2<dim>> &stress, double volume, std::array<std::vector<double>, dim> &f,
            std::vector<Vector<dim>> &on_nodes) const;
  /// 1/s, G of every body at velocities v.
  std::vector<Tensor2<dim>> gradients(const BodyVector *v, unsigned int threads) const;
  /// 1/m; sum w r of body i, that of the wall halved: none where its neighbours stand evenly around it.
  Vector<dim> unevenness(std::size_t i) const;
  /// Least squares gradient (1/m) of a number that each body has, without walls.
  Vector<dim> gradient(const std::vector<double> &values, std::size_t i) const;

  /// What is around every body, to remember (least_squares' weights).
  LaidPattern<dim> pattern() const;

  /// The walls' nodes are `nodes` bodies of given velocity from `first` on; 0: they are at rest.
  void walls(std::uint32_t first, std::uint32_t nodes);

  /// Rigid bodies whose velocities are unknowns too, in rows of their own: travel, and in the next one
  /// `length` (m) times the spin where that is > 0 (dragged_bodies.h). None: their points move as the walls'
  /// nodes.
  struct Carrier {
    std::uint32_t row;
    double length;
  };
  void set_carriers(std::vector<Carrier> all) { carriers = std::move(all); }

  void begin(const FloatRow *p, unsigned int threads) override;
  void begin(const BodyVector *v, unsigned int threads) override;
  void add(const FloatRow *p, std::size_t begin, std::size_t end, FloatRow *product) const override;
  void add(const BodyVector *v, std::size_t begin, std::size_t end, BodyVector *product) const override;
  double power(const BodyVector *v, std::size_t bodies) const override;
  void add_blocks(std::size_t begin, std::size_t end, Block *blocks) const override;
  void connect(const std::function<void(std::uint32_t, std::uint32_t)> &join) const override;

  /// N, of friction on the walls' nodes at the velocities of the last begin(v).
  std::vector<Vector<dim>> on_walls(const BodyVector *v, std::size_t nodes) const;

  std::size_t memory_bytes() const;

 private:
  template <class Row>
  using NumberOf = std::remove_cvref_t<decltype(Row{}[0])>;
  template <class Row>
  struct Body {
    Row pairs{}, wall{}, slope{};  ///< sums of w r; of D
    Row central[dim]{};            ///< monaghan: sum of the walls' w e (x) e
    Row inverse[dim]{};            ///< least_squares: S^-1
    NumberOf<Row> w = 0, wall_w = 0, kappa = 0, theta = 0, shear = 0;
  };
  /// Of T, in 3D with a fourth one of zeros: no row then lies in two cache lines.
  template <class Row>
  struct alignas((dim == 2 ? 2 : 4) * sizeof(Row)) Columns : std::array<Row, dim == 2 ? 2 : 4> {};
  template <class Row>
  struct Copy  ///< in single or double precision
  {
    std::vector<Body<Row>> body;
    std::vector<Row> u;  ///< of a pair: w r, in single precision with w behind; monaghan: and root(w) r/|r|
    std::vector<Row> central;
    std::vector<Columns<Row>> T;
    std::vector<Row> drawn;                  ///< sum of w v_ij, by the first sweep
    std::vector<NumberOf<Row>> tau, weight;  ///< kappa D; of a pair: w
  };
  struct Ray {
    std::uint32_t a, b;
    double share, w;
    DoubleRow r;
    std::uint32_t carrier = none;
    DoubleRow turning{};  ///< m, velocity of the point over the spin of its carrier
  };
  static constexpr std::uint32_t none = 0xffffffff;
  template <class Row, class Vectors>
  Row moments_of(const Copy<Row> &copy, const Vectors *v, std::size_t i, Row *Y) const;
  template <class Row, class Vectors>
  Row drawn_by_neighbours(const Copy<Row> &copy, const Vectors *v, std::size_t i) const;
  template <class Row>
  Row drawn_by_tensors(const Copy<Row> &copy, std::size_t i) const;
  void weigh_rays(std::size_t i);
  void weigh_bodies();
  template <class Row, class Vectors>
  void tensors(Copy<Row> &copy, const Vectors *v, unsigned int threads);
  template <class Row, class Vectors>
  void multiply(const Copy<Row> &copy, const Vectors *v, std::size_t begin, std::size_t end,
                Vectors *product) const;
  template <class By>
  void push_by(const By &by, double volume, std::array<std::vector<double>, dim> &f,
               std::vector<Vector<dim>> &on_nodes) const;
  template <class Row, class Vectors>
  Row velocity_of(const Ray &ray, const Vectors *v) const;
  template <class Row, class Vectors>
  Row pull_of(const Copy<Row> &copy, const Ray &ray, std::size_t i, const Vectors *v) const;
  template <class Row, class Vectors>
  void multiply_carriers(const Copy<Row> &copy, const Vectors *v, std::size_t begin, std::size_t end,
                         Vectors *product) const;
  template <class Row>
  bool walls_move() const {
    return !carriers.empty() || (std::is_same_v<Row, DoubleRow> && given_nodes > 0);
  }

  DragForm form = DragForm::least_squares;
  double scale = 0.;
  std::vector<std::uint32_t> first, first_ray;
  std::vector<std::uint16_t> other;
  std::vector<Ray> rays;
  std::vector<Tensor2<dim>> moments;  ///< S
  std::vector<Vector<dim>> behind;    ///< 1/m, half the sum of w r of the wall without fading
  Copy<DoubleRow> exact;
  Copy<FloatRow> single;
  std::uint32_t first_node = 0, given_nodes = 0;
  std::vector<Carrier> carriers;
  struct Carried {
    std::uint32_t ray, body;
  };
  std::vector<Carried> carried;  ///< rays on carriers, of all bodies
  bool stiff = false, fitted_divergence = false;
};

extern template class SphDrag<2>;
extern template class SphDrag<3>;
}  // namespace turgor
