#include "micro/terms/rod_contacts.h"

#include "micro/geometry/closest_segments.h"
#include "micro/solve/motion_matrix.h"
#include "micro/solve/step_too_long.h"
#include "run/archive.h"
#include "run/parallel.h"
#include "run/written_anew.h"

#include <algorithm>
#include <atomic>

namespace turgor {
namespace {
constexpr double bluntness = 0.01;  ///< e over R_0 (blunt_line.h)

/// E of two in series, of which one may be rigid.
double modulus_of(const double a, const double b) {
  return std::isinf(a) ? b : std::isinf(b) ? a : in_series(a, b);
}
}  // namespace

RodContacts::RodContacts(std::shared_ptr<RodSet> rods_, const RodContactParameters &parameters_)
    : rods(std::move(rods_)), parameters(parameters_), list(parameters_.skin, is_adhesive(parameters_.law)) {}

void RodContacts::declare(Particles<3> &) {
  const std::size_t n = parameters.nodes + rods->size();
  spheres.resize(n);
  spheres.declare("radius");
  bodies.resize(n);
}

void RodContacts::pack(const Particles<3> &particles, const unsigned int threads) {
  std::vector<double> &around = spheres.field("radius");
  for_chunks(threads, Chunks(bodies.size(), 512), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      Body &body = bodies[k];
      if (is_node(k)) {
        body = {{}, parameters.node_radius, 0.};
        body.line.seen.a = body.line.seen.b = particles.position(k);
      } else {
        const std::size_t rod = k - parameters.nodes;
        body.line = BluntLine(rods->line(particles, rod), bluntness * rods->shape[rod].rest_radius);
        const RodShape::At at = rods->shape[rod].at(body.line.seen.L);
        body.radius = at.radius;
        body.slope = at.slope;
      }
      const RodSet::Line &seen = body.line.seen;
      around[k] = 0.5 * seen.L + body.radius;
      for (int d = 0; d < 3; ++d) spheres.x[d][k] = 0.5 * (seen.a[d] + seen.b[d]);
    }
  });
}

template <class Law>
RodContact RodContacts::touch(const Law &law, const Pair &pair, unsigned char &touches) const {
  const Body &i = bodies[pair.i], &j = bodies[pair.j];
  RodContact c;
  if (is_node(pair.j)) return c;  // of two nodes the first one is the lesser
  const RodSet::Line &own = i.line.seen, &other = j.line.seen;
  const ClosestSegments at = closest_segments(own.a, own.b, other.a, other.b);
  const Vector<3> r = other.a + at.t * (other.b - other.a) - own.a - at.s * (own.b - own.a);
  const double d = r.norm(), delta = i.radius + j.radius - d, R = in_series(i.radius, j.radius),
               E = modulus_of(is_node(pair.i) ? parameters.node_modulus : parameters.modulus,
                              parameters.modulus);
  touches = law.touching(R, E, delta, touches);
  if (!touches) return c;
  if (!(d > 0.))
    throw StepTooLong("the centre lines of two rods cross: smaller steps, stiffer cells, or less force.");
  const SphereContact does = law(R, E, delta);
  c.n = r / d;
  c.s = at.s;
  c.t = at.t;
  c.force = does.force;
  c.overlap = delta;
  c.stiffness = does.stiffness;
  c.area = does.area;
  c.energy = does.energy;
  // U = W R delta times a function of E delta^(3/2)/(W sqrt(R)) in all laws, so R dU/dR = 4/3 U - F delta/3
  const double by_radius = (4. * does.energy - does.force * delta) / (3. * R);
  c.squeeze_i = does.force + by_radius * (R / i.radius) * (R / i.radius);
  c.squeeze_j = does.force + by_radius * (R / j.radius) * (R / j.radius);
  if (is_node(pair.i) && parameters.nucleus_radius > 0.) press_nucleus(i, j, c);
  return c;
}

void RodContacts::press_nucleus(const Body &i, const Body &j, RodContact &c) const {
  const Vector<3> r = 0.5 * (j.line.seen.a + j.line.seen.b) - i.line.seen.a;
  const double d = r.norm(), delta = parameters.nucleus_radius + i.radius - d;
  if (!(delta > 0.)) return;
  if (!(d > 0.))
    throw StepTooLong("a node lies in the middle of a nucleus: smaller steps, stiffer cells, or less force.");
  const SphereContact does =
      HertzContact()(in_series(parameters.nucleus_radius, i.radius),
                     modulus_of(parameters.nucleus_modulus, parameters.node_modulus), delta);
  c.nucleus = does.force / d * r;
  c.nucleus_stiffness = does.stiffness;
  c.energy += does.energy;
}

void RodContacts::prepare(const Particles<3> &particles, const Box<3> &, const unsigned int threads,
                          const bool trial) {
  pack(particles, threads);
  list.bring_up_to_date(spheres, threads);
  const std::vector<Pair> &all = list.pairs().pairs();
  resize_anew(contact, all.size());
  touching_now = list.touching;
  touching_now.resize(all.size(), 0);
  std::atomic<bool> crossed{false};
  std::visit(
      [&](const auto &law) {
        for_chunks(threads, Chunks(all.size(), 256), [&](std::size_t begin, std::size_t end) {
          try {
            for (std::size_t p = begin; p < end; ++p) contact[p] = touch(law, all[p], touching_now[p]);
          } catch (const StepTooLong &) {
            crossed = true;
          }
        });
      },
      parameters.law);
  if (crossed)
    throw StepTooLong("the centre lines of two rods cross: smaller steps, stiffer cells, or less force.");
  if (!trial) accept();
}

void RodContacts::accept() {
  if (!list.touching.empty()) list.touching = touching_now;
}

template <class Visit>
void RodContacts::for_bodies_of(const Particles<3> &particles, const std::size_t group,
                                const Visit &visit) const {
  const Group &g = particles.groups[group];
  for (std::uint32_t i = g.begin; i < std::min(g.end, parameters.nodes); ++i) visit(i, i);
  const auto [begin, end] = rods->of_group(particles, group);
  for (std::size_t rod = begin; rod < end; ++rod) visit(body_of(rod), rods->a(rod));
}

std::array<Vector<3>, 2> RodContacts::push(const RodContact &c, const std::uint32_t body,
                                           const bool first) const {
  const Vector<3> force = (first ? -c.force : c.force) * c.n, deep = (first ? -1. : 1.) * c.nucleus;
  if (is_node(body)) return {force + deep, Vector<3>::Zero()};
  const double share = first ? c.s : c.t;
  const Vector<3> longer = (first ? c.squeeze_i : c.squeeze_j) * bodies[body].longer();
  return {(1. - share) * force + 0.5 * deep + longer, share * force + 0.5 * deep - longer};
}

void RodContacts::add_forces(Particles<3> &particles, const Box<3> &, const std::size_t group) {
  const PairList<3> &pairs_of = list.pairs();
  for_bodies_of(particles, group, [&](const std::uint32_t body, const std::uint32_t at) {
    Vector<3> sum[2] = {Vector<3>::Zero(), Vector<3>::Zero()};
    for (std::uint32_t k = pairs_of.first()[body]; k < pairs_of.first()[body + 1]; ++k) {
      const RodContact &c = contact[pairs_of.own()[k]];
      if (c.area == 0.) continue;
      const auto does = push(c, body, body < pairs_of.other()[k]);
      sum[0] += does[0];
      sum[1] += does[1];
    }
    if (!is_node(body)) {
      const auto on = bodies[body].line.handed_on({sum[0], sum[1]});
      sum[0] = on[0];
      sum[1] = on[1];
    }
    for (std::uint32_t end = 0; end < (is_node(body) ? 1u : 2u); ++end)
      for (int d = 0; d < 3; ++d) particles.f[d][at + end] += sum[end][d];
  });
}

double RodContacts::energy(const Particles<3> &particles, const Box<3> &, const std::size_t group) const {
  const PairList<3> &pairs_of = list.pairs();
  double total = 0.;
  for_bodies_of(particles, group, [&](const std::uint32_t body, std::uint32_t) {
    for (std::uint32_t k = pairs_of.first()[body]; k < pairs_of.first()[body + 1]; ++k)
      total += 0.5 * contact[pairs_of.own()[k]].energy;
  });
  return total;
}

/// Rows of the particles of both bodies: along delta with its change by both radii, across it the two centre
/// lines alone.
void RodContacts::rub(MotionMatrix &matrix, const Pair &pair, const RodContact &c, const double h) const {
  std::array<std::uint32_t, 4> who{};
  std::array<double, 4> weight{};
  std::array<Vector<3>, 4> g;
  std::size_t n = 0;
  const auto add = [&](const std::uint32_t body, const double share, const double sign) {
    if (is_node(body)) {
      who[n] = body;
      weight[n] = sign;
      g[n++] = sign * c.n;
      return;
    }
    const Vector<3> longer = bodies[body].longer();
    for (std::uint32_t end = 0; end < 2; ++end) {
      who[n] = rods->a(body - parameters.nodes) + end;
      weight[n] = sign * (end == 0 ? 1. - share : share);
      g[n] = weight[n] * c.n + (end == 0 ? -1. : 1.) * longer;
      ++n;
    }
  };
  add(pair.i, c.s, 1.);
  add(pair.j, c.t, -1.);
  const auto push_row = [&](const double coefficient) {
    if (!(coefficient > 0.)) return;
    for (std::size_t k = 0; k + 1 < n; ++k) {  // the two ends of a rod are neighbours
      if (is_node(who[k])) continue;
      const BluntLine &line = bodies[parameters.nodes + (who[k] - rods->first) / 2].line;
      const auto on = line.handed_on({g[k], g[k + 1]});
      g[k] = on[0];
      g[++k] = on[1];
    }
    matrix.row<3>(std::span<const std::uint32_t>(who.data(), n), std::span<const Vector<3>>(g.data(), n),
                  coefficient);
  };
  push_row(h * std::max(0., c.stiffness));
  // A rod that is touched along its side resists being tilted towards what touches it: seen from there its
  // line comes nearer by d theta^2/2. A short one turns far by little motion of its ends; one that is much
  // shorter than e is as good as round and soon touched at its end, so that it counts less.
  const auto resist_tilt = [&](const std::uint32_t body, const double share, const Vector<3> &towards,
                               const double sign) {
    if (is_node(body) || !(share > 0. && share < 1.) || bodies[body].line.tilt == 0.) return;
    const RodSet::Line &seen = bodies[body].line.seen;
    const double d = bodies[pair.i].radius + bodies[pair.j].radius - c.overlap, L = seen.L;
    const std::uint32_t end = rods->a(body - parameters.nodes);
    for (std::size_t k = 0; k < n; ++k) {
      g[k] = sign * weight[k] / d * seen.u;
      if (who[k] == end) g[k] -= towards / L;
      if (who[k] == end + 1) g[k] += towards / L;
    }
    push_row(h * std::max(0., c.force) * d * bodies[body].line.tilt);
  };
  resist_tilt(pair.i, c.s, -c.n, 1.);
  resist_tilt(pair.j, c.t, c.n, -1.);
  const auto row_along = [&](const Vector<3> &direction, const double coefficient) {
    for (std::size_t k = 0; k < n; ++k) g[k] = weight[k] * direction;
    push_row(coefficient);
  };
  row_along(c.n, parameters.normal * c.area);
  if (parameters.tangential > 0.) {
    const Vector<3> aside = c.n.unitOrthogonal();
    row_along(aside, parameters.tangential * c.area);
    row_along(c.n.cross(aside), parameters.tangential * c.area);
  }
  if (h == 0. || c.nucleus_stiffness == 0.) return;
  for (std::size_t k = 0; k < n; ++k) weight[k] = k == 0 ? 1. : -0.5;  // a node, and the middle of a rod
  row_along(c.nucleus.normalized(), h * c.nucleus_stiffness);
}

void RodContacts::hold_short_rods(MotionMatrix &matrix, const double h) const {
  if (h == 0.) return;
  std::vector<double> pressed(rods->size(), 0.);  // N, along each rod by what makes it shorter
  const auto add = [&](const std::uint32_t body, const RodContact &c, const bool first) {
    if (is_node(body) || bodies[body].line.bend_along == 0.) return;
    const auto on = push(c, body, first);
    pressed[body - parameters.nodes] += std::max(0., 0.5 * (on[0] - on[1]).dot(bodies[body].line.seen.u));
  };
  for (std::size_t p = 0; p < contact.size(); ++p) {
    if (contact[p].area == 0.) continue;
    add(pairs()[p].i, contact[p], true);
    add(pairs()[p].j, contact[p], false);
  }
  for (std::size_t rod = 0; rod < rods->size(); ++rod) {
    const BluntLine &line = bodies[body_of(rod)].line;
    if (pressed[rod] > 0.)
      matrix.link<3>(rods->a(rod), rods->b(rod), line.seen.u, h * pressed[rod] * line.bend_along,
                     h * pressed[rod] * line.bend_across);
  }
}

void RodContacts::collect(MotionMatrix &matrix, const Particles<3> &, const double h) {
  if (h == 0. && parameters.normal == 0. && parameters.tangential == 0.) return;
  for (std::size_t p = 0; p < contact.size(); ++p)
    if (contact[p].area > 0.) rub(matrix, pairs()[p], contact[p], h);
  hold_short_rods(matrix, h);
}

void RodContacts::archive(Archive &a, Particles<3> &) {
  a.section("rod_contacts");
  std::vector<Pair> held;
  for (std::size_t p = 0; p < list.touching.size(); ++p)
    if (list.touching[p]) held.push_back(pairs()[p]);
  a(held);
  if (a.loading()) list.pairs().restore(std::move(held), bodies.size(), list.touching);
}

std::size_t RodContacts::memory_bytes() const {
  return list.pairs().memory_bytes() + contact.capacity() * sizeof(RodContact) +
         bodies.capacity() * sizeof(Body) + touching_now.capacity() + spheres.size() * 13 * sizeof(double);
}
}  // namespace turgor
