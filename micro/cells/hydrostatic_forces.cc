// HydrostaticNetwork, its forces: what is measured of edges, hinges and volumes, then dE/dx, virial and
// second derivatives.
#include "micro/cells/hydrostatic_network.h"
#include "micro/cells/ring_geometry.h"
#include "micro/laws/lamella_tie.h"
#include "micro/laws/wall_bending.h"

#include <cmath>

namespace turgor {
namespace {
/// 1/|e| (1/m) and the gradient of the direction angle (1/m) of many edges e (m).
void directions(const std::size_t count, const double *__restrict ex, const double *__restrict ey,
                double *__restrict inverse_length, double *__restrict gx, double *__restrict gy) {
  for (std::size_t i = 0; i < count; ++i) {
    inverse_length[i] = 1. / std::sqrt(ex[i] * ex[i] + ey[i] * ey[i]);
    const double s = inverse_length[i] * inverse_length[i];
    gx[i] = -s * ey[i];
    gy[i] = s * ex[i];
  }
}

/// Sum of r (x) f, J: four numbers that stay in registers.
struct OuterSum {
  double xx, xy, yx, yy;
  explicit OuterSum(const Tensor2<2> &start)
      : xx(start(0, 0)), xy(start(0, 1)), yx(start(1, 0)), yy(start(1, 1)) {}
  void add(const double ax, const double ay, const double bx, const double by) {
    xx += ax * bx;
    xy += ax * by;
    yx += ay * bx;
    yy += ay * by;
  }
  Tensor2<2> sum() const {
    Tensor2<2> result;
    result << xx, xy, yx, yy;
    return result;
  }
};
}  // namespace

void HydrostaticNetwork::measure(const std::vector<double> &x, NetworkEvaluation &out,
                                 const WallHistory *history) const {
  const std::size_t n = geometry.nodes.size();
  for (std::vector<double> *v : {&out.ex, &out.ey, &out.stretch, &out.angle}) v->resize(n);
  out.volume.resize(geometry.rings.size());
  for (const WallRing &ring : geometry.rings) {
    const std::size_t last = ring.first + ring.count - 1;
    for (std::size_t i = ring.first; i < last; ++i) {
      out.ex[i] = x[2 * i + 2] - x[2 * i];
      out.ey[i] = x[2 * i + 3] - x[2 * i + 1];
    }
    out.ex[last] = x[2 * ring.first] - x[2 * last];
    out.ey[last] = x[2 * ring.first + 1] - x[2 * last + 1];
  }
  for (std::size_t i = 0; i < n; ++i)
    out.stretch[i] = std::sqrt(out.ex[i] * out.ex[i] + out.ey[i] * out.ey[i]) * inverse_rest[i];

  out.hinge.clear();
  if (cracked(history)) {
    out.hinge = geometry.hinge;
    for (const WallRing &ring : geometry.rings)
      for (std::size_t k = 0; k < ring.count; ++k)
        if (history->broken[ring.first + k])
          for (const std::size_t node : {std::size_t(ring.first + k), ring.after(ring.first + k)})
            out.hinge[node] = limits.broken_share * geometry.hinge[node];
  }
  for (std::size_t c = 0; c < geometry.rings.size(); ++c) {
    const WallRing &ring = geometry.rings[c];
    const std::size_t first = ring.first, count = ring.count;
    for (std::size_t k = 0; k < count && bending; ++k) {
      const std::size_t i = first + k, before = first + (k == 0 ? count - 1 : k - 1);
      out.angle[i] = WallBending::angle({out.ex[before], out.ey[before]}, {out.ex[i], out.ey[i]}) -
                     geometry.rest_angle[i];
    }
    out.volume[c] = depth() * polygon_area(x, ring);
  }
}

void HydrostaticNetwork::stretch_edges(NetworkEvaluation &out, const WallHistory *history) const {
  const std::size_t n = geometry.nodes.size();
  for (std::vector<double> *v : {&out.inverse_length, &out.tension, &out.slope, &out.gx, &out.gy})
    v->resize(n);
  if (history)
    for (std::size_t i = 0; i < n; ++i)
      out.tension[i] = history->force(wall, elastic, limits.broken_share, i, out.stretch[i], out.slope[i]);
  else
    wall.forces(n, out.stretch.data(), out.tension.data(), out.slope.data());
  for (std::size_t i = 0; i < n; ++i) out.slope[i] *= inverse_rest[i];
  directions(n, out.ex.data(), out.ey.data(), out.inverse_length.data(), out.gx.data(), out.gy.data());
}

void HydrostaticNetwork::pull(const std::size_t cell, const bool with_hessian, NetworkEvaluation &out) const {
  const WallRing &ring = geometry.rings[cell];
  const std::size_t first = ring.first, count = ring.count;
  const std::vector<double> &hinge = hinges(out);
  OuterSum of_wall(out.virial.wall), of_bending(out.virial.bending);
  for (std::size_t i = first; i < first + count; ++i) out.moment[i] = bending ? hinge[i] * out.angle[i] : 0.;
  // t_i = F e/|e| + (M_i - M_(i+1)) dphi/de: the hinge at node i adds +M to the angle of edge i, -M to edge i
  // - 1
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = first + k, after = first + (k + 1 == count ? 0 : k + 1);
    const double ux = out.ex[i] * out.inverse_length[i], uy = out.ey[i] * out.inverse_length[i];
    const double M = out.moment[i] - out.moment[after];
    const double wx = out.tension[i] * ux, wy = out.tension[i] * uy, bx = M * out.gx[i], by = M * out.gy[i];
    out.tx[i] = wx + bx;
    out.ty[i] = wy + by;
    of_wall.add(wx, wy, out.ex[i], out.ey[i]);
    of_bending.add(bx, by, out.ex[i], out.ey[i]);
    if (with_hessian) {
      const double transverse = out.tension[i] * out.inverse_length[i], along = out.slope[i] - transverse;
      const double pp = hinge[i] + hinge[after];
      // second derivative of the direction angle: symmetric, traceless, from u and 1/|e|^2
      const double s = M * out.inverse_length[i] * out.inverse_length[i];
      const double hxx = 2. * s * ux * uy, hxy = s * (uy * uy - ux * ux);
      out.Sxx[i] = along * ux * ux + transverse + pp * out.gx[i] * out.gx[i] + hxx;
      out.Sxy[i] = along * ux * uy + pp * out.gx[i] * out.gy[i] + hxy;
      out.Syy[i] = along * uy * uy + transverse + pp * out.gy[i] * out.gy[i] - hxx;
    }
  }
  const double push = 0.5 * out.pressure[cell] * depth();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = first + k, before = first + (k == 0 ? count - 1 : k - 1);
    out.gradient[2 * i] += out.tx[before] - out.tx[i] - push * (out.ey[before] + out.ey[i]);
    out.gradient[2 * i + 1] += out.ty[before] - out.ty[i] + push * (out.ex[before] + out.ex[i]);
  }
  out.virial.wall = of_wall.sum();
  out.virial.bending = of_bending.sum();
}

void HydrostaticNetwork::add_ties(const std::vector<double> &x, const Tensor2<2> &H,
                                  NetworkEvaluation &out) const {
  OuterSum virial(Tensor2<2>::Zero());
  for (const LamellaTie &tie : geometry.ties) {
    const Vector<2> d = LamellaSpring::gap(at(x, tie.a), at(x, tie.b), tie.shift, H);
    const double k_tie = tie.stiffness;
    out.gradient[2 * tie.a] -= k_tie * d[0];
    out.gradient[2 * tie.a + 1] -= k_tie * d[1];
    out.gradient[2 * tie.b] += k_tie * d[0];
    out.gradient[2 * tie.b + 1] += k_tie * d[1];
    virial.add(k_tie * d[0], k_tie * d[1], d[0], d[1]);
  }
  out.virial.tie = virial.sum();
}

void HydrostaticNetwork::evaluate(const std::vector<double> &x, const Tensor2<2> &H, const NetworkOrder order,
                                  NetworkEvaluation &out, const WallHistory *history) const {
  if (history && history->empty()) history = nullptr;
  measure(x, out, history);
  if (order == NetworkOrder::energy) {
    out.energy = energy(x, H, out, history);
    return;
  }
  const std::size_t n = geometry.nodes.size();
  const bool with_hessian = order == NetworkOrder::hessian;
  for (std::vector<double> *v : {&out.moment, &out.tx, &out.ty}) v->resize(n);
  if (with_hessian)
    for (std::vector<double> *v : {&out.Sxx, &out.Sxy, &out.Syy}) v->resize(n);
  for (std::vector<double> *v : {&out.pressure, &out.stiffness}) v->resize(geometry.rings.size());
  out.gradient.assign(x.size(), 0.);
  out.virial = {};
  stretch_edges(out, history);
  for (std::size_t c = 0; c < geometry.rings.size(); ++c) {
    const CellPressure content = cell_pressure(c, out.volume[c], history, false);
    out.pressure[c] = content.pressure;
    out.stiffness[c] = content.stiffness;
    out.virial.fluid.diagonal().array() -= out.pressure[c] * out.volume[c];
    pull(c, with_hessian, out);
    if (!body.isZero()) body_energy(x, polygon_area(x, geometry.rings[c]), c, &out.gradient);
  }
  add_ties(x, H, out);
  out.touches.clear();
  if (contact_on && !air.empty()) {
    air.find(x, H, with_hessian, out.touches);
    air.add_forces(out.touches, out.gradient, out.virial.contact);
    out.virial.touching = !out.touches.empty();
  }
  if (!gas.empty()) {
    gas.find(x, H, out.pushes);
    gas.add_forces(out.pushes, out.gradient, out.virial.contact);
    out.virial.touching = true;
  }
  if (!body.isZero())
    for (std::size_t i = 0; i < n; ++i)
      for (int c = 0; c < 2; ++c) out.gradient[2 * i + c] -= geometry.node_mass[i] * body[c];
  for (std::size_t i = 0; i < dead.size(); ++i) out.gradient[i] -= dead[i];
}
}  // namespace turgor
