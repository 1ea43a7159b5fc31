// Rods: their shape and its multiplier, nearest points of segments, contacts by hand, slopes of the energy,
// momentum and its moment, a squeezed rod's closed form, bits on threads and after a checkpoint.
#include "micro/engine/overdamped.h"
#include "micro/engine/system_motion.h"
#include "micro/geometry/closest_segments.h"
#include "micro/laws/counter_random.h"
#include "micro/solve/bisection.h"
#include "micro/terms/rod_contacts.h"
#include "run/archive.h"
#include "slope_of_energy.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using namespace turgor::test;
namespace tt = boost::test_tools;

namespace {
constexpr double R_0 = 6e-6;

/// Rods and nodes in a heap: places and directions at random, of all lengths.
struct Heap {
  ParticleSystem<3> system;
  std::shared_ptr<RodSet> rods = std::make_shared<RodSet>();
  RodContacts *contacts = nullptr;

  Heap(RodContactParameters parameters, const std::size_t count, const double side) {
    Particles<3> &p = system.particles;
    parameters.nodes = parameters.node_radius > 0. ? 8 : 0;
    p.resize(parameters.nodes);
    if (parameters.nodes > 0) p.groups.push_back({0, parameters.nodes, parameters.nodes});
    const auto any = [&](const std::uint64_t k) {
      return Vector<3>(random_uniform(1, 3 * k), random_uniform(1, 3 * k + 1), random_uniform(1, 3 * k + 2));
    };
    for (std::uint32_t i = 0; i < parameters.nodes; ++i)
      for (int d = 0; d < 3; ++d) p.x[d][i] = side * any(1000000 + i)[d];
    std::vector<Vector<3>> a, b;
    for (std::size_t k = 0; k < count; ++k) {
      a.push_back(side * any(2 * k));
      b.push_back(a.back() + 12e-6 * random_uniform(2, k) * (any(2 * k + 1) - Vector<3>::Constant(0.5)));
      rods->shape.push_back({R_0 * (0.9 + 0.2 * random_uniform(3, k)), 1e-3});
    }
    rods->inner_friction = 0.2;
    rods->add(p, a, b);
    system.add(std::make_unique<RodBodies>(rods));
    contacts = &system.add(std::make_unique<RodContacts>(rods, parameters));
  }

  /// Net force and torque over the largest force (and times R_0).
  double imbalance() {
    system.compute_forces();
    const Particles<3> &p = system.particles;
    Vector<3> sum = Vector<3>::Zero(), torque = Vector<3>::Zero();
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vector<3> f(p.f[0][i], p.f[1][i], p.f[2][i]);
      sum += f;
      torque += p.position(i).cross(f) / R_0;
    }
    return std::max(sum.norm(), torque.norm()) / largest_component(p);
  }
};

RodContactParameters soft(const ContactLaw &law) {
  return {.law = law,
          .skin = 1e-6,
          .modulus = 600.,
          .nucleus_radius = 3e-6,
          .nucleus_modulus = 6000.,
          .node_radius = 1e-6,
          .normal = 1e9,
          .tangential = 5e8};
}

/// Implicit steps of a heap whose nodes are held by much friction.
void step(Heap &heap, const int steps) {
  SystemMotion<3> motion(heap.system, {.tolerance = 1e-6});
  motion.medium.assign(heap.system.particles.size(), 0.01);
  motion.own_length = R_0;
  Overdamped<3> stepper({.method = OverdampedMethod::implicit, .tolerance = 1e-2, .first_step = 0.1}, motion,
                        heap.system.threads);
  for (int k = 0; k < steps; ++k) stepper.step(heap.system.particles, 10.);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(rods)

BOOST_AUTO_TEST_CASE(a_rod_keeps_its_volume_and_its_multiplier_is_that_of_the_two_equations) {
  const RodShape shape{R_0, 2e-3};
  BOOST_TEST(shape.radius(0.) == R_0);
  for (const double L : {0., 1e-9, 1e-6, 5e-6, 2e-5, 1e-3}) {
    const RodShape::At at = shape.at(L);
    BOOST_TEST(RodShape::volume(at.radius, L) == shape.volume(), tt::tolerance(1e-14));
    const double h = 1e-5 * (L + R_0), from = std::max(L - h, 0.), to = L + h;
    if (L > 2. * h) {
      BOOST_TEST((shape.radius(to) - shape.radius(from)) / (to - from) == at.slope, tt::tolerance(1e-6));
      BOOST_TEST((shape.energy(to) - shape.energy(from)) / (to - from) == at.pull, tt::tolerance(1e-6));
    }
    // both equations with q from dV/dt = 0, any forces
    const double mu = 3., a = std::numbers::pi * at.radius * at.radius,
                 s = 2. * std::numbers::pi * at.radius * (2. * at.radius + L), F_z = 1e-9, F_r = -4e-9,
                 along = F_z - shape.stiffness * L, across = F_r - shape.stiffness * (at.radius - R_0),
                 q = -(a * along + s * across) / (a * a + s * s);
    const double longer = (along + q * a) / mu;
    BOOST_TEST(longer == (F_z + at.slope * F_r - at.pull) / (mu * (1. + at.slope * at.slope)),
               tt::tolerance(1e-9));
    BOOST_TEST((across + q * s) / mu == at.slope * longer, tt::tolerance(1e-9));
  }
  BOOST_TEST(shape.at(0.).pull_over_length == shape.stiffness * (1. + 1. / 16.), tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(nearest_points_of_segments_are_the_nearest) {
  const auto any = [](const std::uint64_t k) {
    return Vector<3>(random_uniform(5, 3 * k), random_uniform(5, 3 * k + 1), random_uniform(5, 3 * k + 2));
  };
  for (std::uint64_t k = 0; k < 400; ++k) {
    const Vector<3> a = any(4 * k), b = k % 5 == 0 ? a : any(4 * k + 1), p = any(4 * k + 2),
                    q = k % 7 == 0   ? p
                        : k % 3 == 0 ? Vector<3>(p + 0.7 * (b - a))
                                     : any(4 * k + 3);
    const ClosestSegments c = closest_segments(a, b, p, q);
    const auto apart = [&](const double s, const double t) {
      return (a + s * (b - a) - p - t * (q - p)).norm();
    };
    double least = HUGE_VAL;
    for (int i = 0; i <= 50; ++i)
      for (int j = 0; j <= 50; ++j) least = std::min(least, apart(i / 50., j / 50.));
    BOOST_TEST(apart(c.s, c.t) <= least + 1e-12);
  }
  const ClosestSegments side_by_side =
      closest_segments({0., 0., 0.}, {4., 0., 0.}, {2., 1., 0.}, {6., 1., 0.});  // share from 2 to 4
  BOOST_TEST(side_by_side.s == 0.75);
  BOOST_TEST(side_by_side.t == 0.25);
}

BOOST_AUTO_TEST_CASE(two_rods_and_a_node_by_hand) {
  Heap heap({.law = HertzContact(), .modulus = 600.}, 2, 0.);
  Particles<3> &p = heap.system.particles;
  for (RodShape &shape : heap.rods->shape) shape = {R_0, 1e-3};
  // crossing at right angles, 4 um long each, the one above the other
  // contacts see them a little shorter (blunt_line.h)
  const double L = 4e-6, e = 0.01 * R_0, seen = L * L / std::hypot(L, e), R = RodShape{R_0}.radius(seen),
               d = 2. * R - 1e-6;
  p.x = {std::vector<double>{-1e-6, 3e-6, 0., 0.}, {0., 0., -2e-6, 2e-6}, {0., 0., d, d}};
  heap.system.compute_forces();
  const SphereContact hertz = HertzContact()(0.5 * R, 300., 1e-6);
  const RodShape::At at = heap.rods->shape[0].at(seen);
  // the pair pushes each rod where it is nearest: a quarter from A of the first, the middle of the second
  BOOST_TEST(p.f[2][0] == -0.75 * hertz.force, tt::tolerance(1e-12));
  BOOST_TEST(p.f[2][1] == -0.25 * hertz.force, tt::tolerance(1e-12));
  BOOST_TEST(p.f[2][2] == 0.5 * hertz.force, tt::tolerance(1e-12));
  // and makes it longer: by F, and by a quarter of dU/dR_ij = U/(2 R_ij) on each radius
  const double squeeze = hertz.force + 0.25 * hertz.energy / R,
               longer = L * (L * L + 2. * e * e) / std::pow(L * L + e * e, 1.5);
  BOOST_TEST(p.f[0][1] == -heap.rods->shape[0].at(L).pull - squeeze * at.slope * longer,
             tt::tolerance(1e-12));
  BOOST_TEST(p.f[0][0] == -p.f[0][1], tt::tolerance(1e-12));
  BOOST_TEST(heap.system.potential_energy() == hertz.energy + 2. * heap.rods->shape[0].energy(L),
             tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(forces_are_slopes_of_energies_and_keep_momentum_and_its_moment) {
  for (const ContactLaw &law : {ContactLaw(HertzContact()), ContactLaw(JkrContact{1e-5})}) {
    Heap heap(soft(law), 12, 20e-6);
    Particles<3> &p = heap.system.particles;
    const RodSet::Line line = heap.rods->line(p, 0);  // a node within the nucleus of the first rod
    for (int d = 0; d < 3; ++d) p.x[d][0] = 0.5 * (line.a[d] + line.b[d]) + (d == 0 ? 2.5e-6 : 1e-6);
    heap.system.compute_forces();
    int touch = 0, deep = 0;
    for (const RodContact &c : heap.contacts->contacts()) {
      touch += c.area > 0.;
      deep += c.nucleus_stiffness > 0.;
    }
    BOOST_TEST(touch > 20);
    BOOST_TEST(deep > 0);
    BOOST_TEST(slope_error(heap.system, 1e-9, 1) < 1e-6);
    BOOST_TEST(heap.imbalance() < 1e-12);
  }
}

/// Where contacts see a line that is much shorter than the rod's (blunt_line.h): L from nothing to five e.
BOOST_AUTO_TEST_CASE(short_rods_forces_are_slopes_and_go_to_nothing_with_their_length) {
  Heap heap(soft(HertzContact()), 12, 20e-6);
  Particles<3> &p = heap.system.particles;
  const double e = 0.01 * R_0;
  for (std::size_t rod = 0; rod < 12; ++rod) {
    const RodSet::Line line = heap.rods->line(p, rod);
    const double L = 0.5 * e * double(rod);
    for (int d = 0; d < 3; ++d) p.x[d][heap.rods->b(rod)] = line.a[d] + L * line.u[d];
  }
  BOOST_TEST(slope_error(heap.system, 1e-10, 1) < 1e-6);
  BOOST_TEST(heap.imbalance() < 1e-12);

  // pressed round by two nodes at its ends, a rod is pulled together by a force that falls with L: no tip at
  // 0
  Heap pressed(soft(HertzContact()), 1, 1e-3);
  Particles<3> &q = pressed.system.particles;
  const auto together = [&](const double L) {
    for (std::uint32_t i = 0; i < 8; ++i)
      for (int d = 0; d < 3; ++d) q.x[d][i] = d > 0 ? 0. : i < 2 ? (i == 0 ? -6e-6 : 6e-6) : 1e-3 * i;
    for (std::size_t end = 0; end < 2; ++end)
      for (int d = 0; d < 3; ++d) q.x[d][8 + end] = d > 0 ? 0. : (end == 0 ? -0.5 : 0.5) * L;
    pressed.system.compute_forces();
    return q.f[0][8];
  };
  BOOST_TEST(together(0.) == 0.);
  BOOST_TEST(together(2e-3 * e) > 0.);
  BOOST_TEST(together(2e-3 * e) == 2. * together(1e-3 * e), tt::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(friction_is_in_the_one_matrix_and_keeps_momentum) {
  Heap heap(soft(HertzContact()), 12, 30e-6);
  SystemMotion<3> motion(heap.system, {.tolerance = 1e-10});
  Particles<3> &p = heap.system.particles;
  motion.medium.assign(p.size(), 0.01);
  for (const double h : {0., 1.}) {
    motion.forces(p, false);
    for (auto &v : p.v) std::fill(v.begin(), v.end(), 0.);
    motion.velocities(p, h);
    Vector<3> sum = Vector<3>::Zero(), drag = Vector<3>::Zero();
    for (std::size_t i = 0; i < p.size(); ++i)
      for (int d = 0; d < 3; ++d) {
        sum[d] += 0.01 * p.v[d][i];
        drag[d] += 0.01 * std::abs(p.v[d][i]);
      }
    BOOST_TEST(sum.norm() < 1e-8 * drag.norm());
    BOOST_TEST(motion.dissipation(p) > 0.);
  }
  // a common velocity costs what the medium takes
  for (auto &v : p.v) std::fill(v.begin(), v.end(), 1e-6);
  motion.forces(p, false);
  BOOST_TEST(motion.dissipation(p) == 0.01 * 3e-12 * double(p.size()), tt::tolerance(1e-9));
}

/// Nothing but the medium is turned: a rod alone in a rigid motion rubs nowhere else.
BOOST_AUTO_TEST_CASE(a_rods_own_friction_is_objective) {
  Heap heap({.law = HertzContact(), .modulus = 600.}, 1, 0.);
  Particles<3> &p = heap.system.particles;
  p.x = {std::vector<double>{0., 3e-6}, {0., 2e-6}, {0., -1e-6}};
  const Vector<3> spin(0.3, -0.2, 0.5);
  for (std::size_t i = 0; i < 2; ++i) {
    const Vector<3> v = spin.cross(p.position(i));
    for (int d = 0; d < 3; ++d) p.v[d][i] = v[d];
  }
  SystemMotion<3> motion(heap.system, {.tolerance = 1e-10});
  motion.medium.assign(2, 1e-12);
  motion.forces(p, false);
  BOOST_TEST(motion.dissipation(p) < 1e-11 * heap.rods->inner_friction * 3e-6 * 3e-6);
}

/// A rod between two held nodes, each pressing on the middle of its side: 0 = dE/dL + 2 squeeze R'.
BOOST_AUTO_TEST_CASE(a_rod_between_two_nodes_gets_as_long_as_its_closed_form) {
  const double gap = 5e-6, node = 2e-6;
  RodContactParameters parameters{.law = HertzContact(), .modulus = 3000., .node_radius = node};
  Heap heap(parameters, 1, 1e-3);  // eight nodes, six of them far away
  Particles<3> &p = heap.system.particles;
  heap.rods->shape[0] = {R_0, 1e-3};
  for (std::uint32_t i = 0; i < 8; ++i) p.x[0][i] = 1e-3 * (1. + i);
  for (std::uint32_t i = 0; i < 2; ++i) {
    p.x[0][i] = p.x[2][i] = 0.;
    p.x[1][i] = (i == 0 ? -1. : 1.) * (0.5 * gap + node);
  }
  for (int d = 0; d < 3; ++d) p.x[d][8] = p.x[d][9] = 0.;
  p.x[0][8] = -1e-6;
  p.x[0][9] = 1e-6;
  SystemMotion<3> motion(heap.system, {.tolerance = 1e-9});
  motion.medium.assign(p.size(), 1e12);
  motion.medium[8] = motion.medium[9] = 0.01;
  motion.own_length = R_0;
  Overdamped<3> stepper({.method = OverdampedMethod::implicit, .tolerance = 1e-2, .first_step = 0.1}, motion,
                        1);
  for (int k = 0; k < 400; ++k) stepper.step(p, 100.);
  const auto force_along = [&](const double L) {
    const double e = 0.01 * heap.rods->shape[0].rest_radius, q = std::hypot(L, e),  // blunt_line.h
        seen_over_L = L * (L * L + 2. * e * e) / (q * q * q);
    const RodShape::At at = heap.rods->shape[0].at(L * L / q);
    const double R = in_series(at.radius, node), delta = at.radius - 0.5 * gap,
                 pull = heap.rods->shape[0].at(L).pull;
    if (delta <= 0.) return -pull;
    const SphereContact c = HertzContact()(R, 3000., delta);
    return -pull -
           2. * seen_over_L * at.slope * (c.force + 0.5 * c.energy / R * (R / at.radius) * (R / at.radius));
  };
  const double L = bisect(
      1e-8, 40e-6, [&](const double length) { return force_along(length) > 0.; }, "length of the rod", 60);
  BOOST_TEST(L > 3e-6);
  BOOST_TEST(p.x[0][9] - p.x[0][8] == L, tt::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(threads_and_a_checkpoint_do_not_change_a_bit) {
  for (const ContactLaw &law : {ContactLaw(HertzContact()), ContactLaw(JkrContact{1e-5})}) {
    Heap one(soft(law), 300, 90e-6);
    step(one, 12);
    for (const unsigned int threads : {2u, 3u}) {
      Heap other(soft(law), 300, 90e-6);
      other.system.threads = threads;
      step(other, 12);
      BOOST_TEST((other.system.particles.x == one.system.particles.x));
    }
    Archive saved;
    one.system.archive(saved);
    const std::string bytes = saved.finish();
    Heap again(soft(law), 300, 90e-6);
    Archive from(bytes);
    again.system.archive(from);
    step(one, 5);
    step(again, 5);
    BOOST_TEST((again.system.particles.x == one.system.particles.x));
  }
}

BOOST_AUTO_TEST_SUITE_END()
