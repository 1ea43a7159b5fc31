// The fibre network: nets, springs and anchors by hand, slopes of the energy, stress, moduli against closed
// forms, the scene's bits after a stop and on threads.
#include "micro/laws/counter_random.h"
#include "micro/scenes/matrix/network_shear.h"
#include "run_of_scene.h"
#include "slope_of_energy.h"

#include <set>

using namespace turgor;
using namespace turgor::test;
namespace tt = boost::test_tools;

namespace {
void shake(Particles<3> &p, const double by) {
  for (int d = 0; d < 3; ++d)
    for (std::size_t i = 0; i < p.size(); ++i)
      p.x[d][i] += by * (2. * random_uniform(7, 3 * i + std::uint64_t(d)) - 1.);
}
const NetworkParameters anchored{.pore = 2e-6,
                                 .stiffness = 1e-3,
                                 .columns = 6,
                                 .rows = 6,
                                 .kept = 0.8,
                                 .height = 3e-6,
                                 .depth = 2e-6,
                                 .seed = 3};
const char *const small =
    "set Pore sizes = 2.4e-6\nset Stiffnesses = 1e-3\nset Seeds = 2\nset Side = 4.1e-5\nset Steps = 2\nset "
    "Frames = 0\nset Largest strain = 0.1\n";
}  // namespace

BOOST_AUTO_TEST_SUITE(fibre_network)

BOOST_AUTO_TEST_CASE(nets_have_six_bonds_a_node_and_the_mean_length_they_are_asked_for) {
  for (const PlaneNet &net : {sixfold_net(2e-6, 6, 8), random_net(2e-6, 12, 14, 5)}) {
    BOOST_TEST(net.bonds.size() == 3 * net.nodes.size());
    BOOST_TEST(net.mean_length() == 2e-6, tt::tolerance(1e-12));
    std::set<std::pair<std::uint32_t, std::uint32_t>> joined;
    for (const PlaneNet::Bond &bond : net.bonds) {
      BOOST_TEST(net.along(bond).norm() < 2. * 2e-6);
      BOOST_TEST(joined.insert(std::minmax(bond.a, bond.b)).second);
    }
  }
  for (const PlaneNet::Bond &bond : sixfold_net(2e-6, 4, 4).bonds)
    BOOST_TEST(sixfold_net(2e-6, 4, 4).along(bond).norm() == 2e-6, tt::tolerance(1e-12));
  PlaneNet net = random_net(2e-6, 30, 30, 1);
  remove_bonds(net, 0.7, 1);
  BOOST_TEST(std::abs(double(net.bonds.size()) / 2700. - 0.7) < 0.03);
  BOOST_CHECK_THROW(sixfold_net(1., 5, 5), std::invalid_argument);
  BOOST_CHECK_THROW(random_net(1., 3, 4, 1), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_stretched_fibre_and_anchors_by_hand) {
  ParticleSystem<3> system;
  const auto network = std::make_shared<FibreNetwork>(
      system.particles, system.box, PlaneNet{{10., 10.}, {{1., 1.}, {9., 1.}}, {{0, 1, {-1, 0}}}});
  system.add(std::make_unique<FibreSprings>(network, 3.));
  Particles<3> &p = system.particles;
  p.field("stiffness")[1] = 1.;  // degraded to a third: the fibre has (3 + 1)/2
  p.x[0][1] = 8.5;               // across the period the fibre is 2.5 long, 2 at rest
  system.compute_forces();
  BOOST_TEST(p.f[0][0] == -1., tt::tolerance(1e-14));
  BOOST_TEST(p.f[0][1] == 1., tt::tolerance(1e-14));
  BOOST_TEST(system.potential_energy() == 0.25, tt::tolerance(1e-14));
  BOOST_TEST(system.virial()(0, 0) == 2.5, tt::tolerance(1e-14));

  // a stiffer right half: nodes at x > 0 and their fibres to anchors there
  ParticleSystem<3> halves;
  const auto two = std::make_shared<FibreNetwork>(
      halves.particles, halves.box, PlaneNet{{10., 10.}, {{-1., 1.}, {1., 1.}}, {{0, 1, {0, 0}}}});
  halves.add(std::make_unique<FibreSprings>(two, FibreStiffness(3., 30.)));
  BOOST_TEST(halves.particles.field("stiffness")[0] == 3.);
  BOOST_TEST(halves.particles.field("stiffness")[1] == 30.);
  halves.particles.x[0][1] = 1.5;
  halves.compute_forces();
  BOOST_TEST(halves.particles.f[0][0] == 0.5 * 16.5, tt::tolerance(1e-14));

  // six fibres to anchors, each at 3-4-5 to the plane: in it 6 k c^2/2 with c = 3/5, out of it 6 k s^2
  ParticleSystem<3> one;
  const auto tied =
      std::make_shared<FibreNetwork>(one.particles, one.box, PlaneNet{{10., 10.}, {{1., 1.}}, {}});
  tied->add_anchors(one.particles, 4., 3., 1);
  one.add(std::make_unique<FibreSprings>(tied, 2.));
  one.particles.x[0][0] += 1e-6;
  one.particles.x[2][0] += 1e-6;
  one.compute_forces();
  BOOST_TEST(one.particles.f[0][0] == -1e-6 * 2. * 3. * 0.36, tt::tolerance(1e-5));
  BOOST_TEST(one.particles.f[2][0] == -1e-6 * 2. * 6. * 0.64, tt::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(forces_and_stress_are_slopes_of_the_energy_and_bonds_keep_momentum) {
  NetworkSample sample(anchored, 1);
  shake(sample.system.particles, 0.3e-6);
  BOOST_TEST(slope_error(sample.system, 1e-9, 1) < 1e-8);
  // dU/dF at the same fractional places, against the stress
  const double h = 1e-4;
  for (int k = 0; k < 4; ++k) {
    Tensor2<2> up = Tensor2<2>::Identity();
    up(k / 2, k % 2) += h;
    Tensor2<2> down = Tensor2<2>::Identity();
    down(k / 2, k % 2) -= h;
    const Particles<3> at = sample.system.particles;
    sample.deform(up);
    sample.system.compute_forces();
    const double above = sample.energy();
    sample.deform(down * up.inverse());
    sample.system.compute_forces();
    const double below = sample.energy();
    sample.deform(down.inverse());
    sample.system.particles = at;
    sample.system.compute_forces();
    BOOST_TEST((above - below) / (2. * h * sample.volume()) == sample.stress()(k / 2, k % 2),
               tt::tolerance(1e-5));
  }
  NetworkParameters free = anchored;
  free.height = 0.;
  NetworkSample loose(free, 1);
  shake(loose.system.particles, 0.3e-6);
  loose.system.compute_forces();
  for (int d = 0; d < 3; ++d) {
    double sum = 0.;
    for (const double f : loose.system.particles.f[d]) sum += f;
    BOOST_TEST(std::abs(sum) < 1e-13 * largest_component(loose.system.particles));
  }
}

BOOST_AUTO_TEST_CASE(a_sixfold_lattice_has_its_closed_form_and_others_their_exact_linear_response) {
  NetworkParameters p{.nodes = NetworkNodes::sixfold,
                      .pore = 2e-6,
                      .stiffness = 3e-3,
                      .columns = 6,
                      .rows = 6,
                      .depth = 4e-6};
  NetworkSample lattice(p, 1);
  const NetworkModuli m = lattice.moduli(1e-5, 1e-9);
  BOOST_TEST(m.shear() == std::sqrt(3.) / 4. * 3e-3 / 4e-6, tt::tolerance(1e-7));
  BOOST_TEST(m.young() == 2. / std::sqrt(3.) * 3e-3 / 4e-6, tt::tolerance(1e-7));
  BOOST_TEST(m.poisson() == 1. / 3., tt::tolerance(1e-7));
  BOOST_TEST(lattice.affine().shear() == m.shear(), tt::tolerance(1e-7));

  NetworkSample random(anchored, 1);
  const NetworkModuli computed = random.moduli(1e-5, 1e-9), exact = random.relaxed(),
                      affine = random.affine();
  BOOST_TEST((computed.C - exact.C).norm() < 1e-6 * affine.C.norm());
  BOOST_TEST(computed.shear() < affine.shear());
  BOOST_TEST(effective_medium(0.5) == 0.);
  BOOST_TEST(effective_medium(0.75) == 0.25, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_stopped_run_goes_on_with_the_same_bits_and_threads_do_not_matter) {
  const Outcome whole = run<NetworkShear>(small, 1, 0, "shear");
  BOOST_TEST(std::abs(whole.results.at("energy_balance")) < 0.05);
  BOOST_TEST(whole.results.at("reference_error") < 1e-6);
  for (const unsigned long stop : {1ul, 3ul}) {
    const Outcome resumed = run<NetworkShear>(small, 1, stop, "shear");
    BOOST_TEST((resumed.rows == whole.rows));
    BOOST_TEST((resumed.results == whole.results));
  }
  for (const unsigned int threads : {2u, 3u}) {
    const Outcome shared = run<NetworkShear>(small, threads, 0, "shear");
    BOOST_TEST((shared.rows == whole.rows));
    BOOST_TEST((shared.results == whole.results));
  }
}

BOOST_AUTO_TEST_SUITE_END()
