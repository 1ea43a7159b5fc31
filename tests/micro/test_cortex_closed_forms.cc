// Deformable cells against closed forms: pressure of nets and of active tension, relaxation, flow, stress;
// shapes, and what is no closed surface.
#include "cortex_cell.h"
#include "micro/engine/overdamped.h"
#include "micro/engine/system_motion.h"

#include <boost/test/unit_test.hpp>

#include <numbers>

using namespace turgor;
using namespace turgor::test;
using Cell = test::CortexCell;

BOOST_AUTO_TEST_SUITE(cortex_closed_forms)

// A net under isotropic tension T = sqrt(3) k (lambda - 1) (area modulus sqrt(3)/2 k, area strain 2 (lambda -
// 1)) holds a pressure of 2 T/R.
BOOST_AUTO_TEST_CASE(a_net_of_springs_holds_the_pressure_of_laplace) {
  for (const auto &[nu, apart] : {std::pair(4u, 0.02), std::pair(8u, 0.005)}) {
    Cell cell(sphere_shape(nu, R));
    const double k = 4e-4, lambda = 1.001;
    cell.system.add(linear_edges(cell.surfaces));
    for (auto &x : cell.p.x)
      for (double &value : x) value *= lambda;
    cell.system.compute_forces();
    double virial = 0.;  // -sum F.x = 3 p V
    for (std::size_t i = 0; i < cell.p.size(); ++i) virial -= cell.force(i).dot(cell.p.position(i));
    const double p = virial / (3. * cell.surfaces->volume(cell.p, 0));
    BOOST_TEST(p == 2. * std::sqrt(3.) * k * (lambda - 1.) / R, boost::test_tools::tolerance(apart));
  }
}

BOOST_AUTO_TEST_CASE(active_tension_and_content_come_to_rest_at_laplaces_pressure) {
  for (const auto &[nu, apart] : {std::pair(4u, 0.02), std::pair(8u, 0.005)}) {
    Cell cell(sphere_shape(nu, R));
    const double tau = 3e-4;
    cell.system.add(tension(cell.surfaces));
    auto &inside = cell.system.add(content(cell.surfaces));
    cell.p.declare("radius");
    std::fill(cell.p.field("radius").begin(), cell.p.field("radius").end(), R);
    SystemMotion<3> motion(cell.system, {.tolerance = 1e-6});
    motion.medium.assign(cell.p.size(), 6. * std::numbers::pi * 1e-3 * R / double(cell.p.size()));
    Overdamped<3> stepper({.method = OverdampedMethod::implicit, .tolerance = 0.01, .first_step = 1e-5},
                          motion, 1);
    for (double t = 0.; t < 0.01;) t += stepper.step(cell.p, 0.01);
    const double V = cell.surfaces->volume(cell.p, 0), radius = std::cbrt(V * 3. / (4. * std::numbers::pi));
    BOOST_TEST(inside.pressure(cell.p, 0) == 2. * tau / radius, boost::test_tools::tolerance(apart));
  }
}

// All edges of a sphere that was blown up recover alike: length - rest goes with exp(-t k/gamma), and what is
// dissipated is what was stored.
BOOST_AUTO_TEST_CASE(a_sphere_of_kelvin_and_voigt_relaxes_in_friction_over_stiffness) {
  double before = 0.;
  for (const double h : {0.02, 0.01}) {
    Cell cell;
    auto &edges = cell.system.add(linear_edges(cell.surfaces));  // gamma/k = 0.25 s
    for (auto &x : cell.p.x)
      for (double &value : x) value *= 1.05;
    cell.p.declare("radius");
    std::fill(cell.p.field("radius").begin(), cell.p.field("radius").end(), R);
    SystemMotion<3> motion(cell.system, {.tolerance = 1e-10});
    motion.medium.assign(cell.p.size(), 1e-10);
    Overdamped<3> stepper(
        {.method = OverdampedMethod::implicit, .tolerance = 10., .first_step = h, .longest_step = h}, motion,
        1);
    cell.system.compute_forces();
    const double stored = cell.system.potential_energy();
    double t = 0., heat = 0.;
    while (t < 0.25 - 1e-9) {
      const double step = stepper.step(cell.p, 0.25 - t);
      t += step;
      heat += step * edges.dissipation(cell.p, 0);
    }
    cell.system.compute_forces();
    const double grown =
        std::cbrt(cell.surfaces->volume(cell.p, 0) / cell.surfaces->cells.column("rest_volume")[0]) - 1.;
    const double error = std::abs(grown / (0.05 * std::exp(-1.)) - 1.),
                 lost = std::abs(1. - heat / (stored - cell.system.potential_energy()));
    BOOST_TEST(error < 4. * h / 0.25);
    BOOST_TEST(lost < 4. * h / 0.25);
    if (before > 0.) BOOST_TEST(before / error == 2., boost::test_tools::tolerance(0.15));  // first order
    before = error;
  }
}

BOOST_AUTO_TEST_CASE(an_edge_with_friction_in_series_forgets_its_tension) {
  Cell cell;
  auto &edges = cell.system.add(linear_edges(cell.surfaces));
  for (auto &x : cell.p.x)
    for (double &value : x) value *= 1.1;
  const double tension = edges.tension(cell.p, 5), stored = edges.energy(cell.p, {}, 0);
  double heat = 0.;
  for (int step = 0; step < 10; ++step)  // k/gamma = 4/s, 0.5 s
    heat += edges.flow(cell.p, 1e-4, 0.05);
  BOOST_TEST(edges.tension(cell.p, 5) == tension * std::exp(-2.), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(heat == stored * (1. - std::exp(-4.)), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(stored - edges.energy(cell.p, {}, 0) == heat, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(in_plane_stress_is_that_of_the_net) {
  Cell cell(sphere_shape(16, R));
  auto &edges = cell.system.add(linear_edges(cell.surfaces));
  for (const double lambda : {1.01, 0.99}) {
    const auto x = cell.p.x;
    for (auto &values : cell.p.x)
      for (double &value : values) value *= lambda;
    const std::vector<double> stress = in_plane_stress(*cell.surfaces, edges, cell.p);
    double mean = 0.;
    for (const double s : stress) mean += s / double(stress.size());
    BOOST_TEST(mean == std::sqrt(3.) * 4e-4 * (lambda - 1.) / lambda,
               boost::test_tools::tolerance(0.001));  // its sign, too
    cell.p.x = x;
  }
}

BOOST_AUTO_TEST_CASE(shapes_have_their_volumes) {
  for (const unsigned int nu : {4u, 8u, 16u}) {
    const Cell ball(sphere_shape(nu, R)), disc(red_cell_shape(nu, 7.82e-6));
    BOOST_TEST(ball.p.size() == 10 * nu * nu + 2);
    BOOST_TEST(ball.surfaces->volume(ball.p, 0) == 4. / 3. * std::numbers::pi * R * R * R,
               boost::test_tools::tolerance(1e-12));
    BOOST_TEST(disc.surfaces->volume(disc.p, 0) == 94.0984e-18, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(disc.surfaces->area(disc.p, 0) == 134.5e-12,
               boost::test_tools::tolerance(nu == 4 ? 0.06 : 0.015));
    const std::vector<double> &length = disc.surfaces->edge_table.column("rest_length");
    const auto [shortest, longest] = std::minmax_element(length.begin(), length.end());
    BOOST_TEST(*longest < 2.5 * *shortest);
    BOOST_TEST(std::abs(*std::max_element(disc.p.x[0].begin(), disc.p.x[0].end()) - 3.91e-6) < 0.2e-6);
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_closed_surface_is_refused_with_a_sentence) {
  const DeformableShape good = sphere_shape(2, R);
  const auto refused = [](const TriangleMesh &mesh, const std::vector<Vector<3>> &nodes,
                          const std::string &why) {
    CellSurfaces surfaces;
    Particles<3> particles;
    BOOST_CHECK_EXCEPTION(surfaces.add(particles, mesh, nodes), std::invalid_argument,
                          [&](const std::invalid_argument &error) {
                            return std::string(error.what()).find(why) != std::string::npos;
                          });
  };
  TriangleMesh open = good.mesh, turned = good.mesh, inside_out = good.mesh;
  open.faces.pop_back();
  refused(open, good.nodes, "not closed");
  std::swap(turned.faces[3][0], turned.faces[3][1]);
  refused(turned, good.nodes, "oriented");
  for (auto &face : inside_out.faces) std::swap(face[0], face[1]);
  refused(inside_out, good.nodes, "counter-clockwise seen from outside");
  std::vector<Vector<3>> nodes = good.nodes;
  nodes[good.mesh.faces[0][1]] = nodes[good.mesh.faces[0][0]];
  refused(good.mesh, nodes, "has no area");
  nodes = good.nodes;
  nodes.push_back(Vector<3>::Zero());
  refused(good.mesh, nodes, "name 42 nodes, but there are 43");
  // two balls that share one node
  TriangleMesh both = good.mesh;
  const std::uint16_t n = std::uint16_t(good.nodes.size());
  nodes = good.nodes;
  for (std::size_t i = 1; i < good.nodes.size(); ++i) nodes.push_back(2. * good.nodes[0] - good.nodes[i]);
  for (const auto &face : good.mesh.faces)
    both.faces.push_back({face[1] == 0 ? std::uint16_t(0) : std::uint16_t(n + face[1] - 1),
                          face[0] == 0 ? std::uint16_t(0) : std::uint16_t(n + face[0] - 1),
                          face[2] == 0 ? std::uint16_t(0) : std::uint16_t(n + face[2] - 1)});
  refused(both, nodes, "meet at node 0 alone");
}
BOOST_AUTO_TEST_SUITE_END()
