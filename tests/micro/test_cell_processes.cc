// The laws of a cell's life against their closed forms: volume under pressure, growth and its inhibition, the
// cycle, death, division, variability.
#include "micro/cells/cell_stress.h"
#include "micro/processes/cell_life.h"
#include "micro/geometry/plane.h"
#include "micro/terms/elastic_capsule.h"

#include <boost/test/unit_test.hpp>

#include <Eigen/Geometry>

using namespace turgor;

namespace {
const auto digits = [](const double relative) { return boost::test_tools::tolerance(relative); };
constexpr double hour = 3600.;

CellLifeParameters plain() {
  CellLifeParameters p;
  p.variability.spread = 0.;
  p.growth.inhibition = Inhibition::none;
  return p;
}

struct Press final : Term<3>  // a given pressure on all cells from all sides
{
  const CellLife &life;
  const CellPopulation &cells;
  double p = 0.;
  Press(const CellLife &l, const CellPopulation &c) : life(l), cells(c) {}
  std::string name() const override { return "press"; }
  void declare(Particles<3> &) override {}
  void add_forces(Particles<3> &, const Box<3> &, std::size_t) override {}
  double energy(const Particles<3> &, const Box<3> &, std::size_t) const override { return 0.; }
  void add_virials(const Particles<3> &, std::vector<Tensor2<3>> &virial) const override {
    for (std::size_t i = 0; i < virial.size(); ++i)
      virial[i] -= p * life.volume(cells, i) * Tensor2<3>::Identity();
  }
};
}  // namespace

BOOST_AUTO_TEST_SUITE(cell_processes)

// C.1, C.2: dp = K d eps with K = K_0 or K_0 V_ref/V, by integration.
BOOST_AUTO_TEST_CASE(strain_at_rest_integrates_the_bulk_modulus) {
  for (const bool hardening : {false, true}) {
    const CellVolumeLaw law{hardening};
    const double K = 5e3, end = 0.8;
    const int n = 2000;
    double p = 0.;
    for (int k = 0; k < n; ++k) p += law.modulus((k + 0.5) * end / n, K) * end / n;  // midpoint rule
    BOOST_TEST(law.strain_at_rest(p, K) == end, digits(1e-7));
  }
  // thesis C.2.3: at 5 kPa K(V) = 10 kPa, at 10 kPa 15 kPa (K_0 = 5 kPa)
  const CellVolumeLaw law{true};
  BOOST_TEST(law.modulus(law.strain_at_rest(5e3, 5e3), 5e3) == 10e3, digits(1e-12));
  BOOST_TEST(law.modulus(law.strain_at_rest(10e3, 5e3), 5e3) == 15e3, digits(1e-12));
  BOOST_TEST(law.strain_at_rest(-100., 5e3) == -0.02, digits(1e-14));
}

// C.3 under constant pressure: eps = eps_rest (1 - exp(-t/T)), whatever the interval.
BOOST_AUTO_TEST_CASE(volume_follows_pressure_with_the_relaxation_time) {
  const double T = 2. * hour, rest = 0.3;
  for (const int n : {1, 7, 100}) {
    double eps = 0.;
    for (int k = 0; k < n; ++k) eps = relaxed_strain(eps, rest, T / n, T);
    BOOST_TEST(eps == rest * (1. - std::exp(-1.)), digits(1e-12));
  }
  BOOST_TEST(relaxed_strain(0.1, rest, 1., 0.) == rest);
  // pressure rising linearly: first order in the interval
  const auto after = [&](const int n) {
    double eps = 0.;
    for (int k = 0; k < n; ++k) eps = relaxed_strain(eps, double(k) / n, T / n, T);
    return eps;
  };
  const double exact = std::exp(-1.);  // ramp s/T: eps = t/T - 1 + exp(-t/T) at t = T
  BOOST_TEST((after(50) - exact) / (after(100) - exact) == 2., digits(0.02));
}

BOOST_AUTO_TEST_CASE(inhibition_is_half_at_the_threshold) {
  for (const double n : {1., 2., 4.}) {
    const GrowthLaw hill{.inhibition = Inhibition::hill, .threshold = 0.35, .exponent = n};
    BOOST_TEST(hill.factor(0.35) == 0.5, digits(1e-14));
    BOOST_TEST(hill.factor(0.7) == 1. / (1. + std::pow(2., n)), digits(1e-14));
    BOOST_TEST(hill.factor(0.) == 1.);
    BOOST_TEST(hill.factor(-0.1) == 1.);
  }
  const GrowthLaw linear{.inhibition = Inhibition::linear, .threshold = 0.35};
  BOOST_TEST(linear.factor(0.35) == 0.5, digits(1e-14));
  BOOST_TEST(linear.factor(0.7) == 0., digits(1e-14));
  BOOST_TEST(linear.factor(0.9) == 0.);
  const GrowthLaw sharp{.inhibition = Inhibition::hill, .threshold = 0.35, .exponent = 1e4};
  BOOST_TEST(sharp.factor(0.349) == 1., digits(1e-10));
  BOOST_TEST(sharp.factor(0.351) < 1e-10);
}

BOOST_AUTO_TEST_CASE(both_rates_double_the_volume_in_the_cycle_time) {
  for (const bool exponential : {false, true}) {
    const GrowthLaw growth{.exponential = exponential, .inhibition = Inhibition::none};
    const CellCycle cycle;
    const double T = 17. * hour, V_0 = 2.;
    double phase = 0., V = V_0;
    BOOST_TEST(cycle.advance(growth, V_0, T, 1., cycle.mitosis, phase, V) < 0.);
    BOOST_TEST(V == V_0);  // no growth during mitosis
    for (int k = 0; k < 9; ++k)
      BOOST_TEST(cycle.advance(growth, V_0, T, 1., (T - cycle.mitosis) / 10., phase, V) < 0.);
    // the tenth, and a minute more, which is handed on
    BOOST_TEST(cycle.advance(growth, V_0, T, 1., (T - cycle.mitosis) / 10. + 60., phase, V) == 60.,
               digits(1e-9));
    BOOST_TEST(V == 2. * V_0, digits(1e-12));
    BOOST_TEST(phase == 1., digits(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(sizer_waits_for_the_volume_and_timer_does_not) {
  const GrowthLaw growth;
  const double T = 17. * hour, V_0 = 1., f = 0.5;
  const auto divides_after = [&](const bool timer, double &V) {
    CellCycle cycle;
    cycle.timer = timer;
    double phase = 0.;
    V = V_0;
    return 4. * T - cycle.advance(growth, V_0, T, f, 4. * T, phase, V);
  };
  double V = 0.;
  const double m = 1.5 * hour;
  BOOST_TEST(divides_after(false, V) == m + (T - m) / f, digits(1e-12));
  BOOST_TEST(V == 2. * V_0, digits(1e-12));
  BOOST_TEST(divides_after(true, V) == T, digits(1e-12));
  BOOST_TEST(V == (1. + f) * V_0, digits(1e-12));
}

BOOST_AUTO_TEST_CASE(only_before_the_restriction_point_cells_go_to_rest) {
  CellCycle cycle;
  BOOST_TEST(cycle.rests(false, 0.2, 0.29));
  BOOST_TEST(!cycle.rests(false, 0.2, 0.31));
  BOOST_TEST(!cycle.rests(false, 0.3, 0.1));  // committed
  BOOST_TEST(!cycle.rests(true, 0.2, 0.31));  // wakes
  cycle.reversible = false;
  BOOST_TEST(cycle.rests(true, 0.2, 0.31));
}

BOOST_AUTO_TEST_CASE(a_dead_cell_shrinks_to_its_solid_part) {
  CellDeath death;
  death.rim = Rim::necrotic;
  BOOST_TEST(death.dies(21e-6, 1600., 1500.));
  BOOST_TEST(!death.dies(19e-6, 1600., 1500.));  // in the rim
  BOOST_TEST(!death.dies(21e-6, 1400., 1500.));
  // C.1.3: C.3 with T_lys in the strain to the solid part, from log(phi) + 0.1 to 0.3, however many steps it
  // takes
  const double T = 5. * 24. * hour, at_rest = 0.3, whole = std::log(death.solid_fraction) + 0.1;
  double V_ref = 1., eps = 0.1;
  for (int k = 1; k <= 40; ++k) {
    V_ref = death.drained(V_ref, 1., T, 0.2 * T);
    eps = relaxed_strain(eps, at_rest, 0.2 * T, T);
    BOOST_TEST(compressed_volume(V_ref, eps) ==
                   death.solid_fraction * std::exp(-(at_rest + (whole - at_rest) * std::exp(-0.2 * k))),
               digits(1e-12));
    BOOST_TEST(death.ended(V_ref, 1., eps, at_rest) ==
               ((at_rest - whole) * std::exp(-0.2 * k) < CellDeath::nearly));
  }
  // 2.12: linear, down to phi after (1 - phi) T
  death.linear = true;
  double V_linear = death.drained(3., 3., T, 0.5 * T);
  BOOST_TEST(V_linear == 1.5, digits(1e-14));
  BOOST_TEST(!death.ended(V_linear, 3., 0., 0.));
  V_linear = death.drained(V_linear, 3., T, 0.3 * T + 1.);
  BOOST_TEST(V_linear == 0.6, digits(1e-14));
  BOOST_TEST(death.ended(V_linear, 3., 0., 0.));
}

// Two packed cells at rest under their pressure die: death itself changes no force, and the contact's d_ij
// follows the drained cell.
BOOST_AUTO_TEST_CASE(death_does_not_soften_the_contact) {
  CellLifeParameters parameters = plain();
  parameters.death = {
      .rim = Rim::necrotic, .rim_thickness = -1., .necrosis_pressure = 1000.};  // every cell is deep enough
  CellLife life(parameters);
  CellPopulation cells;
  life.declare(cells.particles);
  const double R_ref = parameters.birth_radius, eps = 0.2, d = 0.13;
  for (const double x : {0., 2. * R_ref * (1. - d)}) life.add(cells, Vector<3>(x, 0., 0.), 0.);
  for (int i = 0; i < 2; ++i) {
    cells.particles.cells.column("strain")[i] = eps;
    cells.particles.field("radius")[i] = sphere_radius(life.volume(cells, i));
  }
  const LocalStiffness law = LocalStiffness::repaired_C9();
  SphereContacts contacts(HertzContact(), 1e-6, law), soft(HertzContact(), 1e-6);
  Press &press = cells.add(std::make_unique<Press>(life, cells));
  const auto force = [&](SphereContacts &c) {
    for (auto &f : cells.particles.f) std::fill(f.begin(), f.end(), 0.);
    c.add_forces(cells.particles, 1);
    return cells.particles.f[0][1];
  };
  const double before = force(contacts), p = 5e3 * std::expm1(eps);
  BOOST_TEST(before / force(soft) == law(d).factor, digits(1e-12));
  // p, less what the pair presses itself
  press.p = p - life.measure_pressures(cells, contacts, 1)[0];
  const auto pass = [&](const double dt) {
    life.advance(cells, contacts, {}, dt, 0, 1, [](const auto &) {});
  };
  pass(60.);
  BOOST_CHECK(!cells.state().alive(0) && !cells.state().alive(1));
  BOOST_TEST(force(contacts) == before, digits(1e-9));
  // drained for T_lys/10 at the same pressure: V_ref = phi exp(-log(phi) exp(-0.1)) of that at death
  pass(0.1 * parameters.death.lysis_time);
  const double share = std::pow(0.2, 1. - std::exp(-0.1)), shrunk = R_ref * std::cbrt(share);
  BOOST_TEST(cells.particles.field("radius")[0] == shrunk * std::exp(-eps / 3.), digits(1e-9));
  BOOST_TEST(force(contacts) / force(soft) == law(1. - (1. - d) * R_ref / shrunk).factor, digits(1e-9));
}

BOOST_AUTO_TEST_CASE(variability_is_a_clamped_gaussian_of_the_id) {
  const CellVariability vary{.spread = 0.1, .clamp = 4., .seed = 7};
  const int n = 200000;
  double sum = 0., square = 0., cross = 0., low = 1., high = 1.;
  for (int id = 0; id < n; ++id) {
    const double a = vary(1., std::uint64_t(id), Varied::cycle_time) - 1.,
                 b = vary(1., std::uint64_t(id), Varied::modulus) - 1.;
    sum += a;
    square += a * a;
    cross += a * b;
    low = std::min(low, 1. + a);
    high = std::max(high, 1. + a);
  }
  // standard errors: mean 0.1/sqrt(n) = 2.2e-4, variance 0.01 sqrt(2/n) = 3.2e-5, covariance 0.01/sqrt(n)
  // = 2.2e-5; four of them
  BOOST_CHECK_SMALL(sum / n, 9e-4);
  BOOST_CHECK_SMALL(square / n - 0.01, 1.3e-4);
  BOOST_CHECK_SMALL(cross / n, 9e-5);
  BOOST_TEST(low >= 0.6);
  BOOST_TEST(high <= 1.4);
  BOOST_TEST(vary(17., 3, Varied::cycle_time) == vary(17., 3, Varied::cycle_time));
  BOOST_TEST((CellVariability{.spread = 1., .clamp = 0.5, .seed = 1}(2., 11, Varied::modulus) <= 3.));
}

// A cell squeezed by two others along x: stress along x only, pressure a third of it.
BOOST_AUTO_TEST_CASE(stress_of_a_squeezed_cell_by_hand) {
  CellPopulation cells;
  for (const double x : {-1.5, 0., 1.5})
    cells.add(Vector<3>(x, 0., 0.), 1.,
              2.);  // R = 1/2, E = 1, delta = 1/2: F = 4/3 sqrt(1/2) (1/2)^(3/2) = 1/3
  SphereContacts contacts(HertzContact(), 0.1);
  contacts.add_forces(cells.particles, 1);
  std::vector<Tensor2<3>> virial;
  cell_virials(cells.particles, contacts, 1, virial);
  BOOST_TEST(virial[1](0, 0) == -2. / 3. * 0.75, digits(1e-13));  // two contacts, 3/4 from the centre
  BOOST_TEST(virial[1](1, 1) == 0.);
  BOOST_TEST(-virial[1].trace() / 6. == 0.5 / 6., digits(1e-13));  // pressure of a cell of volume 2
  // the least compressed direction is across
  CellDivision division;
  BOOST_CHECK_SMALL(division.choose(1, virial[1])[0], 1e-14);
  division.direction = DivisionDirection::given;
  division.axis = Vector<3>(0., 0., 2.);
  BOOST_TEST(division.choose(1, virial[1])[2] == 1.);
  division.direction = DivisionDirection::random_in_plane;
  BOOST_TEST(division.choose(5, virial[1])[2] == 0.);
  BOOST_TEST(division.choose(5, virial[1]).norm() == 1., digits(1e-14));
}

BOOST_AUTO_TEST_CASE(random_directions_are_uniform) {
  CellDivision division;
  division.direction = DivisionDirection::random;
  const int n = 20000;
  Vector<3> mean = Vector<3>::Zero();
  Tensor2<3> second = Tensor2<3>::Zero();
  for (int id = 0; id < n; ++id) {
    const Vector<3> e = division.choose(std::uint64_t(id), Tensor2<3>::Zero());
    BOOST_REQUIRE(std::abs(e.norm() - 1.) < 1e-14);
    mean += e / n;
    second += e * e.transpose() / n;
  }
  // standard errors: 1/sqrt(3 n) = 4e-3; sqrt(4/45/n) = 2e-3; four of them
  BOOST_CHECK_SMALL(mean.cwiseAbs().maxCoeff(), 0.016);
  BOOST_CHECK_SMALL((second - Tensor2<3>::Identity() / 3.).cwiseAbs().maxCoeff(), 0.0085);
}

PairList<3> near(const CellPopulation &cells) {
  PairList<3> list(CellDivision::reach(1.));
  std::vector<unsigned char> no_marks;
  list.build(cells.particles, cells.particles.field("radius"), no_marks);
  return list;
}

// A pair alone lies least in energy where it touches without force: Hertz 2 R_d, extended Hertz where F = 0.
BOOST_AUTO_TEST_CASE(newborn_pairs_lie_where_their_energy_is_least) {
  CellPopulation cells;
  cells.add(Vector<3>::Zero(), 1., 100.);
  const double R = std::cbrt(0.5), W = 1.;
  CellDivision division;
  SphereContacts hertz(HertzContact(), 0.1);
  hertz.add_forces(cells.particles, 1);
  BOOST_TEST(division.half_distance(cells, hertz, near(cells), {}, 0, Vector<3>::UnitX(), R) == R,
             digits(2e-3));
  SphereContacts sticky(ExtendedHertzContact{W}, 0.1);
  sticky.add_forces(cells.particles, 1);
  // 4/3 E sqrt(R/2) delta^(3/2) = pi W R/2, E = 50
  const double delta =
      std::pow(std::numbers::pi * W * 0.5 * R / (4. / 3. * 50. * std::sqrt(0.5 * R)), 2. / 3.);
  BOOST_TEST(
      division.half_distance(cells, sticky, near(cells), {}, 0, Vector<3>::UnitX(), R) == R - 0.5 * delta,
      digits(2e-3));
  division.least_energy = false;
  BOOST_TEST(division.half_distance(cells, sticky, near(cells), {}, 0, Vector<3>::UnitX(), R) == 1. - R,
             digits(1e-14));
  // held between two neighbours along its line it comes to lie closer
  division.least_energy = true;
  cells.add(Vector<3>(1.9, 0., 0.), 1., 100.);
  cells.add(Vector<3>(-1.9, 0., 0.), 1., 100.);
  hertz.add_forces(cells.particles, 1);
  const double held = division.half_distance(cells, hertz, near(cells), {}, 0, Vector<3>::UnitX(), R);
  BOOST_TEST(held < 0.8 * R);
  // a neighbour that the mother does not touch, but daughters of free distance would
  CellPopulation apart;
  apart.add(Vector<3>::Zero(), 1., 100.);
  apart.add(Vector<3>(2.3, 0., 0.), 1., 100.);
  hertz.add_forces(apart.particles, 1);
  BOOST_TEST(hertz.contacts().empty());
  BOOST_TEST(division.half_distance(apart, hertz, near(apart), {}, 0, Vector<3>::UnitX(), R) < 0.99 * R);
  hertz.add_forces(cells.particles, 1);
  const double across = division.half_distance(cells, hertz, near(cells), {}, 0, Vector<3>::UnitY(), R);
  BOOST_TEST(across > held);
}

// A mother that touches a wall: across it the pair lies as without a wall, towards it closer together, never
// behind it.
BOOST_AUTO_TEST_CASE(newborn_pairs_see_the_wall) {
  CellPopulation cells;
  cells.add(Vector<3>::Zero(), 1., 100.);
  SphereContacts hertz(HertzContact(), 0.1);
  hertz.add_forces(cells.particles, 1);
  const auto floor_at = [](const double z) {
    Surroundings walls;
    walls.walls = &walls.add(std::make_unique<Obstacles<3>>(
        "floor", SphereOnSurface{}, std::make_unique<Plane<3>>(Vector<3>(0., 0., z), Vector<3>(0., 0., 1.))));
    return walls;
  };
  Surroundings walls = floor_at(-0.9);
  const double R = std::cbrt(0.5);
  CellDivision division;
  const double free = division.half_distance(cells, hertz, near(cells), {}, 0, Vector<3>::UnitZ(), R);
  BOOST_TEST(division.half_distance(cells, hertz, near(cells), walls, 0, Vector<3>::UnitX(), R) == free,
             digits(1e-12));
  // least of 8/15 E R^(1/2) delta^(5/2): pair E = 50, R/2, delta = 2 R - 2 s; wall E = 100, R, delta = R -
  // 0.9 + s: equal forces
  const double s = division.half_distance(cells, hertz, near(cells), walls, 0, Vector<3>::UnitZ(), R);
  const double pair = 2. * HertzContact()(0.5 * R, 50., 2. * (R - s)).force,
               wall = HertzContact()(R, 100., R - 0.9 + s).force;
  BOOST_TEST(s < 0.9 * free);
  BOOST_TEST(pair == wall, digits(0.02));

  // so near that only the least distance leaves both before the wall: that one
  const double nearest = 1. - R;
  walls = floor_at(-nearest - 0.01);
  BOOST_TEST(division.half_distance(cells, hertz, near(cells), walls, 0, Vector<3>::UnitZ(), R) <
             nearest + 0.01);

  CapsuleParameters thin;
  thin.radius = 10.;
  walls = {};
  walls.walls = &walls.add(
      std::make_unique<Obstacles<3>>("capsule", SphereOnSurface{}, std::make_unique<ElasticCapsule>(thin)));
  cells.particles.x[0][0] = 9.4;  // a daughter touching her sister would have her centre outside
  BOOST_TEST(9.4 + division.half_distance(cells, hertz, near(cells), walls, 0, Vector<3>::UnitX(), R) < 10.);
}

// One cell without neighbours: it divides at T, its volume is kept, both daughters are new and as old as what
// was left.
BOOST_AUTO_TEST_CASE(a_lonely_cell_doubles_every_cycle) {
  CellLifeParameters p = plain();
  CellLife life(p);
  CellPopulation cells;
  life.declare(cells.particles);
  life.add(cells, Vector<3>::Zero(), 0.);
  SphereContacts contacts(HertzContact(), 1e-6);
  std::size_t gathers = 0;
  const double dt = 17. * hour / 90.5;  // no divisor of the cycle
  double t = 0.;
  while (t < 17. * hour - 0.6 * dt) {
    contacts.add_forces(cells.particles, 1);
    life.advance(cells, contacts, {}, dt, 0, 1, [&](const Rearrangement &places) {
      contacts.gather(places);
      ++gathers;
    });
    t += dt;
  }
  BOOST_TEST(cells.size() == 1u);
  contacts.add_forces(cells.particles, 1);
  life.advance(cells, contacts, {}, dt, 0, 1, [&](const Rearrangement &places) {
    contacts.gather(places);
    ++gathers;
  });
  t += dt;
  BOOST_TEST(cells.size() == 2u);
  BOOST_TEST(gathers == 1u);
  BOOST_TEST(cells.id()[0] == 1u);
  BOOST_TEST(cells.id()[1] == 2u);
  for (int i = 0; i < 2; ++i) {
    BOOST_TEST(cells.particles.cells.column("phase")[i] * 17. * hour == t - 17. * hour, digits(1e-9));
    BOOST_TEST(cells.particles.field("reference_volume")[i] == life.birth_volume(), digits(1e-9));
  }
  BOOST_TEST((cells.particles.position(0) + cells.particles.position(1)).norm() < 1e-20);
}

// A single cell under a pressure that rises linearly, with its own relaxation: eps_rest = p/K, so C.3 gives
// eps = (a/K) [t - T_rel (1 - exp(-t/T_rel))]. First order in the interval; with hardening at rest log(1 +
// p/K).
BOOST_AUTO_TEST_CASE(a_compressed_cell_follows_its_closed_form) {
  const double K = 5e3, T_rel = 2. * hour, end = 4. * hour, most = 10e3;
  const auto strain_after = [&](const bool hardening, const bool ramp, const int n) {
    CellLifeParameters parameters = plain();
    parameters.volume.hardening = hardening;
    parameters.growth = {.inhibition = Inhibition::hill};
    parameters.cycle.quiescence_below = 1.;  // rests from the start on: V_ref is constant
    parameters.cycle.restriction = 1.;
    CellLife life(parameters);
    CellPopulation cells;
    life.declare(cells.particles);
    life.add(cells, Vector<3>::Zero(), 0.);
    SphereContacts contacts(HertzContact(), 1e-6);
    Press &press = cells.add(std::make_unique<Press>(life, cells));
    for (int k = 0; k < n; ++k) {
      press.p = ramp ? most * k / n : most;
      contacts.add_forces(cells.particles, 1);
      life.advance(cells, contacts, {}, end / n, 0, 1, [](const auto &) {});
    }
    BOOST_TEST(cells.particles.field("radius")[0] ==
                   parameters.birth_radius * std::exp(-cells.particles.cells.column("strain")[0] / 3.),
               digits(1e-12));
    return cells.particles.cells.column("strain")[0];
  };
  // constant pressure: exact, with and without hardening
  BOOST_TEST(strain_after(false, false, 10) == most / K * (1. - std::exp(-end / T_rel)), digits(1e-12));
  BOOST_TEST(strain_after(true, false, 10) == std::log(3.) * (1. - std::exp(-end / T_rel)), digits(1e-12));
  const double exact = most / K * (1. - T_rel / end * (1. - std::exp(-end / T_rel)));
  const double e1 = strain_after(false, true, 40) - exact, e2 = strain_after(false, true, 80) - exact;
  BOOST_CHECK_SMALL(e2, 0.02);
  BOOST_TEST(e1 / e2 == 2., digits(0.02));  // first order
}

BOOST_AUTO_TEST_SUITE_END()
