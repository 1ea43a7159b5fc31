// HydrostaticNetwork, what an affine motion of all its nodes does: forces and curvature of the energy.
#include "micro/cells/hydrostatic_network.h"
#include "micro/cells/ring_geometry.h"
#include "micro/laws/lamella_tie.h"

#include <array>

namespace turgor {
void HydrostaticNetwork::affine_response(const std::vector<double> &x, const Tensor2<2> &H,
                                         const NetworkEvaluation &e, const std::array<Tensor2<2>, 4> &L,
                                         std::array<std::vector<double>, 4> &forces,
                                         Tensor4<2> &curvature) const {
  curvature.setZero();
  const double z0 = depth();
  const std::vector<double> &hinge = hinges(e);
  using Rows = Eigen::Matrix<double, 2, 4>;  // column k: what motion L[k] does to a vector
  const auto moved = [&](const Vector<2> &v) {
    Rows r;
    for (int k = 0; k < 4; ++k) r.col(k) = L[k] * v;
    return r;
  };
  const auto add = [&](const std::size_t node, const Rows &f) {
    for (int k = 0; k < 4; ++k) {
      forces[k][2 * node] += f(0, k);
      forces[k][2 * node + 1] += f(1, k);
    }
  };
  for (int k = 0; k < 4; ++k) forces[k].assign(x.size(), 0.);

  for (std::size_t c = 0; c < geometry.rings.size(); ++c) {
    const WallRing &ring = geometry.rings[c];
    const std::size_t first = ring.first, count = ring.count;
    const double area = e.volume[c] / z0;
    Eigen::Matrix<double, 1, 4> d_volume;  // affine: trace(L) V
    for (int k = 0; k < 4; ++k) d_volume(k) = L[k].trace() * e.volume[c];
    curvature += e.stiffness[c] * d_volume.transpose() * d_volume;
    // bilinear second derivative of the area under affine motions: A (tr tr - trace of product)
    for (int k = 0; k < 4; ++k)
      for (int l = 0; l < 4; ++l)
        curvature(k, l) -= e.pressure[c] * z0 * area * (L[k].trace() * L[l].trace() - (L[k] * L[l]).trace());
    const Eigen::Matrix<double, 1, 4> pressure_rise = e.stiffness[c] * d_volume;

    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = first + k, before = first + (k == 0 ? count - 1 : k - 1),
                        after = first + (k + 1 == count ? 0 : k + 1);
      const Rows de = moved({e.ex[i], e.ey[i]});
      // change of t_i: S_i de_i + C_(i-1)^T de_(i-1) + C_i de_(i+1), C_i = -B/l g_i g_(i+1)^T
      Tensor2<2> S;
      S << e.Sxx[i], e.Sxy[i], e.Sxy[i], e.Syy[i];
      const Vector<2> g(e.gx[i], e.gy[i]), g_before(e.gx[before], e.gy[before]),
          g_after(e.gx[after], e.gy[after]);
      const Eigen::Matrix<double, 1, 4> turn_before =
                                            g_before.transpose() * moved({e.ex[before], e.ey[before]}),
                                        turn_after = g_after.transpose() * moved({e.ex[after], e.ey[after]});
      // neighbours alike: one product
      const Rows dt = e.hinge.empty() && hinge[i] == hinge[after]
                          ? Rows(S * de - hinge[i] * g * (turn_before + turn_after))
                          : Rows(S * de - g * (hinge[i] * turn_before + hinge[after] * turn_after));
      curvature += de.transpose() * dt;
      add(i, -dt);
      add(after, dt);

      // fluid: -p z0 d(dA/dx_i) + (d2E/dV2 dV) z0 dA/dx_i; dA/dx_i = half the turned neighbour edge sum
      const Rows ds = moved({e.ex[before] + e.ex[i], e.ey[before] + e.ey[i]});
      const Vector<2> dA(0.5 * (e.ey[before] + e.ey[i]), -0.5 * (e.ex[before] + e.ex[i]));
      Rows turned;
      turned.row(0) = 0.5 * ds.row(1);
      turned.row(1) = -0.5 * ds.row(0);
      add(i, -e.pressure[c] * z0 * turned + z0 * dA * pressure_rise);
    }
  }
  for (const LamellaTie &tie : geometry.ties) {
    const Rows dd = moved(LamellaSpring::gap(at(x, tie.a), at(x, tie.b), tie.shift, H));
    curvature += tie.stiffness * dd.transpose() * dd;
    add(tie.a, -tie.stiffness * dd);
    add(tie.b, tie.stiffness * dd);
  }
  air.add_affine(e.touches, L, forces, curvature);
  gas.add_affine(e.pushes, L, forces, curvature);
}
}  // namespace turgor
