// The triangulated wall: the mesh of a sphere, forces as differences of the energy, what a net of springs is
// as a sheet.
#include "micro/geometry/geodesic_sphere.h"
#include "micro/laws/counter_random.h"
#include "micro/engine/particle_system.h"
#include "micro/terms/net_wall.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>

using namespace turgor;

namespace {
const NetWallParameters wall{100., 1e-6, 1300.};
constexpr double radius = 30e-6;

/// A disturbed sphere of stretch lambda.
std::unique_ptr<ParticleSystem<3>> sphere_of(const unsigned int nu, const NetWallParameters &parameters,
                                             const double lambda, const double disturbance, NetWall *&term,
                                             std::shared_ptr<const WallDamage> damage = nullptr) {
  GeodesicSphere unit = make_geodesic_sphere(nu);
  auto system = std::make_unique<ParticleSystem<3>>();
  std::vector<Vector<3>> rest;
  for (const Vector<3> &x : unit.positions) rest.push_back(radius * x);
  const auto mesh = std::make_shared<const TriangleMesh>(unit.mesh);
  Particles<3> &p = system->particles;
  p.resize(mesh->nodes);
  p.groups.push_back({0, mesh->nodes, mesh->nodes});
  auto net = std::make_unique<NetWall>(mesh, NetShape(*mesh, rest), parameters);
  net->set_damage(damage);
  for (std::size_t i = 0; i < mesh->nodes; ++i) {
    p.inverse_mass[i] = 1. / net->node_mass(i);
    for (int d = 0; d < 3; ++d)
      p.x[d][i] = lambda * rest[i][d] + disturbance * (random_uniform(1, 3 * i + d) - 0.5);
  }
  term = &system->add(std::move(net));
  return system;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(net_wall)

BOOST_AUTO_TEST_CASE(sphere_is_closed_outward_and_even) {
  for (const unsigned int nu : {1u, 2u, 6u, 14u}) {
    const GeodesicSphere sphere = make_geodesic_sphere(nu);
    BOOST_TEST(sphere.positions.size() == 10 * nu * nu + 2);
    BOOST_TEST(sphere.mesh.nodes == 10 * nu * nu + 2);
    BOOST_TEST(sphere.mesh.faces.size() == 20 * nu * nu);
    BOOST_TEST(sphere.mesh.edges.size() == 30 * nu * nu);
    double shortest = 10., longest = 0.;
    for (const auto &edge : sphere.mesh.edges) {
      const double l = (sphere.positions[edge.a] - sphere.positions[edge.b]).norm();
      shortest = std::min(shortest, l);
      longest = std::max(longest, l);
    }
    BOOST_TEST_MESSAGE("nu = " << nu << ": longest over shortest edge " << longest / shortest);
    BOOST_TEST(longest / shortest < 1.4);  // 1 is impossible with fivefold nodes
    double mean = 0., square = 0.;
    for (const auto &edge : sphere.mesh.edges) {
      const double l = (sphere.positions[edge.a] - sphere.positions[edge.b]).norm();
      mean += l / double(sphere.mesh.edges.size());
      square += l * l / double(sphere.mesh.edges.size());
    }
    const double spread = std::sqrt(std::max(0., square / (mean * mean) - 1.));
    BOOST_TEST_MESSAGE("standard deviation of the edges " << spread);
    BOOST_TEST(spread < 0.07);
    bool outward = true;
    for (const auto &f : sphere.mesh.faces)
      outward = outward && (sphere.positions[f[1]] - sphere.positions[f[0]])
                                   .cross(sphere.positions[f[2]] - sphere.positions[f[0]])
                                   .dot(sphere.positions[f[0]]) > 0.;
    BOOST_TEST(outward);
    for (const double w : NetShape(sphere.mesh, sphere.positions).width) BOOST_TEST(w > 0.);
  }
  TriangleMesh open;
  open.faces = {{0, 1, 2}};
  BOOST_CHECK_THROW(open.complete(), std::invalid_argument);
  BOOST_CHECK_THROW(make_geodesic_sphere(0), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(force_is_minus_the_energys_gradient) {
  auto damage = std::make_shared<WallDamage>(1, 270, 180);
  for (const bool broken : {false, true}) {
    NetWall *term = nullptr;
    NetWallParameters thick = wall;
    thick.thickness = 10e-6;  // so that hinges count as much as springs
    if (broken) {
      damage->cells[0].bond_broken[7] = 1;
      damage->cells[0].face_gone[20] = 1;
    }
    auto system = sphere_of(3, thick, 1.05, 4e-6, term, broken ? damage : nullptr);
    Particles<3> &p = system->particles;
    system->compute_forces();
    const auto force = p.f;
    double largest = 0.;
    for (int d = 0; d < 3; ++d)
      for (const double f : force[d]) largest = std::max(largest, std::abs(f));
    const double h = 1e-10;
    for (std::size_t i = 0; i < p.size(); i += 5)
      for (int d = 0; d < 3; ++d) {
        const double x = p.x[d][i];
        p.x[d][i] = x + h;
        const double up = term->energy(p, system->box, 0);
        p.x[d][i] = x - h;
        const double down = term->energy(p, system->box, 0);
        p.x[d][i] = x;
        // central differences: h^2/l^2 = 1e-10 and round-off 1e-16 E/(h f) = 1e-8
        BOOST_TEST(std::abs(force[d][i] + (up - down) / (2. * h)) < 1e-7 * largest);
      }
  }
}

BOOST_AUTO_TEST_CASE(momentum_and_angular_momentum_are_kept) {
  NetWall *term = nullptr;
  auto system = sphere_of(4, wall, 1.02, 3e-6, term);
  system->compute_forces();
  const Particles<3> &p = system->particles;
  Vector<3> sum = Vector<3>::Zero(), torque = Vector<3>::Zero();
  double size = 0.;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector<3> f(p.f[0][i], p.f[1][i], p.f[2][i]);
    sum += f;
    torque += p.position(i).cross(f);
    size += f.norm();
  }
  BOOST_TEST(sum.norm() < 1e-14 * size);
  BOOST_TEST(torque.norm() < 1e-13 * size * radius);  // hinges divide by small areas
}

BOOST_AUTO_TEST_CASE(a_sphere_is_stress_free_at_rest_and_its_tension_is_the_membranes) {
  NetWall *term = nullptr;
  auto rest = sphere_of(6, wall, 1., 0., term);
  rest->compute_forces();
  for (int d = 0; d < 3; ++d)
    for (const double f : rest->particles.f[d]) BOOST_TEST(std::abs(f) < 1e-12 * wall.stiffness * radius);
  // E of the whole sphere: area times G t0 (lambda^2 + lambda^-4/2 - 3/2), the incompressible neo-Hookean
  // sheet
  for (const double lambda : {1.01, 1.2, 0.9}) {
    NetWallParameters no_bending = wall;
    no_bending.bending = false;
    auto blown = sphere_of(6, no_bending, lambda, 0., term);
    const GeodesicSphere unit = make_geodesic_sphere(6);
    double area = 0.;
    for (const double share : NetShape(unit.mesh, unit.positions).area_share) area += share * radius * radius;
    const double exact = area * wall.stiffness * (lambda * lambda + 0.5 * std::pow(lambda, -4.) - 1.5);
    BOOST_TEST(term->energy(blown->particles, blown->box, 0) == exact, boost::test_tools::tolerance(1e-10));
  }
}

BOOST_AUTO_TEST_CASE(the_net_itself_pulled_uniaxially) {
  // The energy of a fine sphere's own edges under a small strain within the tangent planes is what an
  // isotropic sheet of K = 3 G t0, mu = 3/2 G t0 has (equibiaxially E t = 3 G t0, uniaxially 4 G t0, a
  // sixfold net): a sphere made an ellipsoid by x (1 + e), y, z (1 - e/2). Directly: strain energy per area
  // 1/2 K tr^2 + mu |dev|^2 integrated over the sphere, e_ab = P D P.
  NetWallParameters no_bending = wall;
  no_bending.bending = false;
  NetWall *term = nullptr;
  double error[2];
  for (const int fine : {0, 1}) {
    auto system = sphere_of(fine ? 16 : 8, no_bending, 1., 0., term);
    Particles<3> &p = system->particles;
    const double e = 1e-5, stretch[3] = {1. + e, 1. - 0.5 * e, 1. - 0.5 * e};
    for (int d = 0; d < 3; ++d)
      for (double &x : p.x[d]) x *= stretch[d];
    // With u = cos^2 of the angle to x: meridional strain e (1 - u) - e u'..., all in closed form below
    double exact = 0.;
    const int n = 4000;
    for (int k = 0; k < n; ++k) {
      const double u = -1. + (k + 0.5) * 2. / n;  // cos of the polar angle, equal areas
      const double along = e * (1. - u * u) - 0.5 * e * u * u, around = -0.5 * e;
      const double trace = along + around, dev = 0.5 * (along - around);
      exact += (0.5 * 3. * trace * trace + 1.5 * 2. * dev * dev) * 2. / n;
    }
    exact *= 2. * std::numbers::pi * radius * radius * wall.stiffness;
    error[fine] = term->energy(p, system->box, 0) / exact - 1.;
  }
  BOOST_TEST_MESSAGE("ellipsoid, nu = 8, 16: " << error[0] << " " << error[1]);
  BOOST_TEST(std::abs(error[1]) < 0.01);
  BOOST_TEST(std::abs(error[0] / error[1]) > 3.);  // second order in the edge length
}

BOOST_AUTO_TEST_CASE(the_stated_step_is_stable_and_not_far_from_the_limit) {
  // Largest eigenvalue of M^-1 K by power iteration over differences of the force
  NetWall *term = nullptr;
  auto system = sphere_of(6, wall, 1.01, 0., term);
  Particles<3> &p = system->particles;
  const auto x = p.x;
  std::array<std::vector<double>, 3> v;
  for (int d = 0; d < 3; ++d)
    for (std::size_t i = 0; i < p.size(); ++i) v[d].push_back(random_uniform(3, 3 * i + d) - 0.5);
  system->compute_forces();
  const auto f0 = p.f;
  double largest = 0.;
  for (int it = 0; it < 300; ++it) {
    double norm = 0.;
    for (int d = 0; d < 3; ++d)
      for (const double c : v[d]) norm += c * c;
    norm = std::sqrt(norm);
    const double h = 1e-9;
    for (int d = 0; d < 3; ++d)
      for (std::size_t i = 0; i < p.size(); ++i) p.x[d][i] = x[d][i] + h * v[d][i] / norm;
    system->compute_forces();
    largest = 0.;
    for (int d = 0; d < 3; ++d)
      for (std::size_t i = 0; i < p.size(); ++i) {
        const double next = -(p.f[d][i] - f0[d][i]) / h * p.inverse_mass[i];
        largest += next * v[d][i] / norm;
        v[d][i] = next;
      }
  }
  p.x = x;
  const double bound = term->rates(p).wall.frequency_squared;
  BOOST_TEST_MESSAGE("bound over largest squared frequency: " << bound / largest);
  BOOST_TEST(bound > largest);
  BOOST_TEST(bound < 2. * largest);  // step within 1/sqrt 2 of the limit
}

// The lightest cell decides the step; a copy somewhere else changes no bit of it.
BOOST_AUTO_TEST_CASE(every_cell_counts_for_the_step) {
  NetWall *net = nullptr;
  const auto one = sphere_of(4, wall, 1.02, 0., net);
  const double alone = net->rates(one->particles).wall.frequency_squared;
  Particles<3> two = one->particles;
  const std::uint32_t n = std::uint32_t(two.size());
  two.resize(2 * n);
  two.groups = {{0, n, n}, {n, 2 * n, 2 * n}};
  for (std::uint32_t i = 0; i < n; ++i) {
    for (int d = 0; d < 3; ++d) two.x[d][n + i] = two.x[d][i] + 1.7 * radius;
    two.inverse_mass[n + i] = two.inverse_mass[i];
  }
  BOOST_TEST(net->rates(two).wall.frequency_squared == alone);
  for (std::uint32_t i = 0; i < n; ++i) two.inverse_mass[n + i] *= 3.;
  BOOST_TEST(net->rates(two).wall.frequency_squared == 3. * alone, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_SUITE_END()
