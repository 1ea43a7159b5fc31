// Contact between cells, and lamella that breaks: by hand, F = -dE/dx, momentum, lists.
#include "micro/laws/counter_random.h"
#include "micro/engine/particle_system.h"
#include "micro/terms/cell_contact.h"
#include "micro/terms/lamella_ties.h"
#include "run/archive.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <memory>
#include <tuple>

using namespace turgor;

namespace {
// Squares of side 4 with n nodes a side, counter-clockwise, lower left corner at `corners`; fluid particles
// behind the wall.
void add_square(Particles<2> &p, const double x0, const double y0, const unsigned int n,
                const unsigned int fluid = 0) {
  const std::uint32_t begin = std::uint32_t(p.size()), ring = 4 * n;
  p.resize(begin + ring + fluid);
  p.groups.push_back({begin, begin + ring, begin + ring + fluid});
  const double s = 4. / n;
  for (std::uint32_t k = 0; k < n; ++k) {
    const double corner[4][2] = {{k * s, 0.}, {4., k * s}, {4. - k * s, 4.}, {0., 4. - k * s}};
    for (int side = 0; side < 4; ++side) {
      p.x[0][begin + side * n + k] = x0 + corner[side][0];
      p.x[1][begin + side * n + k] = y0 + corner[side][1];
    }
  }
  for (std::uint32_t k = 0; k < fluid; ++k) {
    p.x[0][begin + ring + k] = x0 + 2.;
    p.x[1][begin + ring + k] = y0 + 2.;
  }
  std::fill(p.inverse_mass.begin() + begin, p.inverse_mass.end(), 1.);
}

/// Stiffness 10, spacing 1; inset h, range rho.
CellContactParameters law(const double inset, const double range, const double skin = 0.2) {
  CellContactParameters parameters;
  parameters.stiffness = 10.;
  parameters.surface = {inset, 0.25};
  parameters.range = range;
  parameters.fluid_range = 0.4;
  parameters.skin = skin;
  parameters.spacing = parameters.node_mass = 1.;
  return parameters;
}

/// No two points equally near: where that changes, the force jumps.
void disturb(Particles<2> &p, const double by) {
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int d = 0; d < 2; ++d) p.x[d][i] += by * (2. * random_uniform(3, 2 * i + d) - 1.);
}

/// isolated: nothing turns the system, which a periodic box does.
void require_conservative(ParticleSystem<2> &system, const bool isolated = true) {
  Particles<2> &p = system.particles;
  system.compute_forces();
  const Particles<2>::Components f = p.f;
  const auto energy = [&] {
    system.compute_forces();
    return system.potential_energy();
  };
  double fx = 0., fy = 0., moment = 0., scale = 0.;
  for (std::size_t i = 0; i < p.size(); ++i) {
    fx += f[0][i];
    fy += f[1][i];
    moment += p.x[0][i] * f[1][i] - p.x[1][i] * f[0][i];
    scale = std::max(scale, std::hypot(f[0][i], f[1][i]));
  }
  BOOST_REQUIRE(scale > 0.);
  BOOST_TEST(std::hypot(fx, fy) < 1e-14 * double(p.size()) * scale);
  if (isolated) BOOST_TEST(std::abs(moment) < 1e-14 * double(p.size()) * scale * 10.);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int d = 0; d < 2; ++d) {
      const double h = 1e-6, x = p.x[d][i];
      p.x[d][i] = x + h;
      const double up = energy();
      p.x[d][i] = x - h;
      const double down = energy();
      p.x[d][i] = x;
      // Order h^2/l^2, and round-off of the energy over the step
      BOOST_TEST(std::abs((up - down) / (2. * h) + f[d][i]) < 1e-8 * scale, "particle " << i);
    }
}
}  // namespace

BOOST_AUTO_TEST_SUITE(cell_contact)

BOOST_AUTO_TEST_CASE(corner_at_a_wall_by_hand) {
  // No inset. A corner node stands 0.1 before the foreign wall, above the middle of a bond: k (0.2 - 0.1) on
  // it, half of that on each end. All else is farther away.
  ParticleSystem<2> system;
  add_square(system.particles, 0., 0., 4);
  add_square(system.particles, 4.1, 1.5, 4);
  Particles<2> &p = system.particles;
  for (std::uint32_t k = 17; k < 32; ++k)  // second cell: pointed to the left at its lower left corner
    p.x[0][k] += 0.5;
  const auto &contact = system.add(std::make_unique<CellContact>(law(0., 0.2)));
  system.compute_forces();
  BOOST_TEST(p.f[0][16] == 1., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(p.f[1][16]) < 1e-14);
  for (const int k : {5, 6})  // (4, 1) and (4, 2)
    BOOST_TEST(p.f[0][k] == -0.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(system.potential_energy() == 0.05, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(contact.deepest() == 0.1, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(contact.crossed_bonds() == 0u);
}

BOOST_AUTO_TEST_CASE(soft_contact_by_hand) {
  // The same corner: k/rho (0.2 - 0.1)^2 and k/(3 rho) (0.2 - 0.1)^3.
  ParticleSystem<2> system;
  add_square(system.particles, 0., 0., 4);
  add_square(system.particles, 4.1, 1.5, 4);
  Particles<2> &p = system.particles;
  for (std::uint32_t k = 17; k < 32; ++k) p.x[0][k] += 0.5;
  CellContactParameters soft = law(0., 0.2);
  soft.soft = true;
  system.add(std::make_unique<CellContact>(soft));
  system.compute_forces();
  BOOST_TEST(p.f[0][16] == 0.5, boost::test_tools::tolerance(1e-12));
  for (const int k : {5, 6}) BOOST_TEST(p.f[0][k] == -0.25, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(system.potential_energy() == 10. / 0.6 * 1e-3, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(walls_that_lie_on_each_other_feel_nothing_and_pushed_together_resist) {
  for (const double overlap : {0., 0.3}) {
    ParticleSystem<2> system;
    Particles<2> &p = system.particles;
    add_square(p, 0., 0., 4);
    add_square(p, 4. - overlap, 0., 4);
    const auto &contact = system.add(std::make_unique<CellContact>(law(0.25, 0.33)));
    system.compute_forces();
    double on_second = 0., most = 0.;
    for (std::uint32_t k = 0; k < 32; ++k) {
      on_second += k < 16 ? 0. : p.f[0][k];
      most = std::max(most, std::hypot(p.f[0][k], p.f[1][k]));
    }
    if (overlap == 0.)
      BOOST_TEST(most == 0.);
    else {
      BOOST_TEST(on_second > 1.);
      BOOST_TEST(contact.crossed_bonds() == 0u);  // inner faces
      disturb(p, 0.02);
      require_conservative(system);
    }
  }
}

BOOST_AUTO_TEST_CASE(contact_is_conservative) {
  // Three cells that overlap a little, disturbed: nodes in walls, walls on nodes, a corner in a dent; some
  // bonds torn.
  for (const auto &[torn, soft] : {std::pair{false, false}, {true, false}, {false, true}}) {
    ParticleSystem<2> system;
    Particles<2> &p = system.particles;
    add_square(p, 0., 0., 5);
    add_square(p, 3.9, 0.3, 5);
    add_square(p, 1.7, 3.85, 5);
    disturb(p, 0.12);
    const auto damage = std::make_shared<WallDamage>(3, 20, 20);
    if (torn)
      for (const int bond : {6, 7, 13}) {
        damage->cells[0].bond_broken[bond] = 1;
        ++damage->cells[0].broken;
      }
    CellContactParameters parameters = law(0.15, 0.6);
    parameters.soft = soft;
    system.add(std::make_unique<CellContact>(parameters, damage));
    require_conservative(system);
  }
}

BOOST_AUTO_TEST_CASE(a_wall_does_not_pass_through_itself) {
  // A square pressed flat: its lower and upper faces, 0.5 - 2 x 0.1 apart, repel each other, the same up as
  // down.
  ParticleSystem<2> system;
  Particles<2> &p = system.particles;
  add_square(p, 0., 0., 4);
  for (std::size_t i = 0; i < p.size(); ++i) p.x[1][i] *= 0.125;
  system.add(std::make_unique<CellContact>(law(0.1, 0.4)));
  system.compute_forces();
  double up = 0., down = 0.;
  for (std::uint32_t i = 0; i < 16; ++i) (p.f[1][i] > 0. ? up : down) += p.f[1][i];
  BOOST_TEST(up > 1.);
  BOOST_TEST(std::abs(up + down) < 1e-12);
  BOOST_TEST(p.f[1][10] > 0.);  // on the upper side
  disturb(p, 0.02);
  require_conservative(system);
}

BOOST_AUTO_TEST_CASE(a_torn_wall_lets_through_and_holds_from_both_sides) {
  // The right wall of the first cell has lost its bond from (4, 1) to (4, 2). The second cell's pointed
  // corner stands in the gap (nothing), behind the lower flap and before it (away from it, on either side).
  for (const auto &[x, y, sign] :
       {std::tuple{4., 1.5, 0.}, std::tuple{3.9, 0.5, -1.}, std::tuple{4.1, 0.5, 1.}}) {
    ParticleSystem<2> system;
    Particles<2> &p = system.particles;
    add_square(p, 0., 0., 4);
    add_square(p, 10., 10., 4);
    p.x[0][16] = x;
    p.x[1][16] = y;
    const auto damage = std::make_shared<WallDamage>(2, 16, 16);
    damage->cells[0].bond_broken[5] = 1;
    damage->cells[0].broken = 1;
    damage->cells[1].bond_broken[0] = damage->cells[1].bond_broken[15] = 1;  // the corner alone
    damage->cells[1].broken = 2;
    system.add(std::make_unique<CellContact>(law(0., 0.2), damage));
    system.compute_forces();
    BOOST_TEST(p.f[0][16] == sign, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(fluid_of_failed_cells_only_and_from_where_it_was) {
  ParticleSystem<2> system;
  Particles<2> &p = system.particles;
  add_square(p, 0., 0., 4, 1);
  add_square(p, 4.2, 0., 4, 1);
  p.x[0][16] =
      3.95;  // the first cell's fluid stands 0.25 before the second cell's wall, nearer than the range of 0.4
  p.x[1][16] = 2.1;
  const auto damage = std::make_shared<WallDamage>(2, 16, 16);
  auto &contact = system.add(std::make_unique<CellContact>(law(0., 0.1), damage));
  const auto force = [&](const double x) {
    p.x[0][16] = x;
    system.compute_forces();
    return p.f[0][16];
  };
  BOOST_TEST(force(3.95) == 0.);
  damage->cells[0].broken = 1;    // cracked
  BOOST_TEST(force(3.95) == 0.);  // no energy from nothing
  BOOST_TEST(contact.list_builds() == 2u);
  BOOST_TEST(system.potential_energy() == 0.);
  BOOST_TEST(force(4.) == -0.5, boost::test_tools::tolerance(1e-12));
  require_conservative(system);
  BOOST_TEST(force(3.7) == 0.);  // away, lists are built: it has its full range
  BOOST_TEST(force(3.95) == -1.5, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(lists_do_not_change_forces) {
  // The same motion with a skin that rebuilds rarely and one that rebuilds at once; and after a checkpoint.
  Particles<2>::Components forces[2];
  for (const int run : {0, 1}) {
    ParticleSystem<2> system;
    add_square(system.particles, 0., 0., 5);
    add_square(system.particles, 4.7, 0.3, 5);
    const auto &contact = system.add(std::make_unique<CellContact>(law(0.1, 0.5, run == 0 ? 1. : 1e-9)));
    for (int step = 0; step < 50; ++step) {
      system.compute_forces();
      for (std::size_t i = 20; i < 40; ++i) {
        system.particles.x[0][i] -= 0.015;
        system.particles.x[1][i] += 0.004;
      }
    }
    system.compute_forces();
    forces[run] = system.particles.f;
    BOOST_TEST(contact.list_builds() < (run == 0 ? 4u : 60u));
    restore(archived(system), system);
    system.compute_forces();
    BOOST_TEST(system.particles.f[0] == forces[run][0]);
  }
  for (int d = 0; d < 2; ++d) BOOST_TEST(forces[0][d] == forces[1][d]);
  double most = 0.;
  for (const double f : forces[0][0]) most = std::max(most, std::abs(f));
  BOOST_TEST(most > 1.);
}

BOOST_AUTO_TEST_CASE(lists_are_never_stale) {
  // A cell comes from far away, is pressed against another, drawn up along it over its torn wall and away
  // again, turning: at every moment the forces are, to the bit, those of lists that have just been built.
  ParticleSystem<2> system;
  Particles<2> &p = system.particles;
  add_square(p, 0., 0., 5);
  add_square(p, 8.3, 0.3, 5);
  const auto damage = std::make_shared<WallDamage>(2, 20, 20);
  const auto &contact = system.add(std::make_unique<CellContact>(law(0.1, 0.5, 0.3), damage));
  int touched = 0, wrong = 0;
  const int steps = 400;
  for (int step = 0; step < steps; ++step) {
    const double vx = step < 150 ? -0.03 : step < 300 ? 0. : 0.03, vy = step < 150 ? 0. : 0.04, turn = 0.002;
    for (std::size_t i = 20; i < 40; ++i) {
      const double x = p.x[0][i], y = p.x[1][i];
      p.x[0][i] += vx - turn * (y - 2.);
      p.x[1][i] += vy + turn * (x - 4.);
    }
    if (step == 170 || step == 171)  // the right wall of the first cell, between two builds
    {
      damage->cells[0].bond_broken[step - 163] = 1;
      ++damage->cells[0].broken;
    }
    system.compute_forces();
    ParticleSystem<2> fresh;
    fresh.particles.resize(p.size());
    fresh.particles.groups = p.groups;
    fresh.particles.inverse_mass = p.inverse_mass;
    fresh.add(std::make_unique<CellContact>(law(0.1, 0.5, 0.3), damage));
    fresh.particles.x = p.x;
    fresh.compute_forces();
    wrong += p.f != fresh.particles.f;
    double most = 0.;
    for (const double f : fresh.particles.f[0]) most = std::max(most, std::abs(f));
    touched += most > 0.1;
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(touched > 50);
  BOOST_TEST(touched < steps - 50);
  BOOST_TEST(contact.list_builds() > 20u);
  BOOST_TEST(contact.list_builds() < unsigned(steps) / 2);
}

// A square of side 4 in a period of 4.4: each of the five nodes of a side stands 0.4 before that of the image
// and within 0.9 of it, 0.5 deep: 5 N from the image's wall, and 5 N as the wall that the image's node meets.
BOOST_AUTO_TEST_CASE(own_image_by_hand) {
  ParticleSystem<2> system;
  Particles<2> &p = system.particles;
  add_square(p, 10., -3., 4);
  system.box.periodic = {true, false};
  system.box.H << 4.4, 0., 0., 1.;
  auto &contact = system.add(std::make_unique<CellContact>(law(0., 0.9)));
  system.compute_forces();
  const auto tolerance = boost::test_tools::tolerance(1e-12);
  for (const std::uint32_t right : {4, 5, 6, 7, 8}) BOOST_TEST(p.f[0][right] == -10., tolerance);
  for (const std::uint32_t left : {12, 13, 14, 15, 0}) BOOST_TEST(p.f[0][left] == 10., tolerance);
  BOOST_TEST(system.potential_energy() == 10 * 0.5 * 10. * 0.25, tolerance);
  BOOST_TEST(contact.image_virial(p, system.box, 0)(0, 0) == -10 * 5. * 4.4, tolerance);  // dE/dL L
  BOOST_TEST(contact.deepest() == 0.5, tolerance);
  BOOST_TEST(contact.crossed_bonds() == 0u);
  for (std::size_t i = 0; i < p.size(); ++i)  // a period away it is the same
    p.x[0][i] -= 4.4;
  system.compute_forces();
  BOOST_TEST(p.f[0][4] == -10., tolerance);
}

BOOST_AUTO_TEST_CASE(images_across_an_oblique_period) {
  ParticleSystem<2> system;
  Particles<2> &p = system.particles;
  const auto lay = [](Particles<2> &q, const Vector<2> &at) {
    add_square(q, at[0], at[1], 4);
    add_square(q, at[0] + 4.5, at[1] + 0.3, 6);
  };
  lay(p, Vector<2>::Zero());
  disturb(p, 0.08);
  system.box.periodic = {true, true};
  system.box.H << 8.9, 0.6, 0.2, 4.5;
  auto &contact = system.add(std::make_unique<CellContact>(law(0.3, 1.3)));
  require_conservative(system, false);

  // the middle ones of 5 x 5 copies in the open
  ParticleSystem<2> open;
  for (int a = -2; a <= 2; ++a)
    for (int b = -2; b <= 2; ++b) lay(open.particles, system.box.image({a, b}));
  const std::size_t n = p.size(), middle = 12 * n;
  for (std::size_t i = 0; i < open.particles.size(); ++i) {
    const int copy = int(i / n);
    const Vector<2> at = p.position(i % n) + system.box.image({copy / 5 - 2, copy % 5 - 2});
    open.particles.x[0][i] = at[0];
    open.particles.x[1][i] = at[1];
  }
  open.add(std::make_unique<CellContact>(law(0.3, 1.3)));
  open.compute_forces();
  system.compute_forces();
  for (std::size_t i = 0; i < n; ++i)
    for (int d = 0; d < 2; ++d) BOOST_TEST(std::abs(p.f[d][i] - open.particles.f[d][middle + i]) < 1e-10);

  // the stress is the slope of the energy along the lattice, and with the cells along an affine motion
  const Tensor2<2> H = system.box.H, virial = system.virial();
  const Particles<2>::Components x = p.x;
  Tensor2<2> images = Tensor2<2>::Zero();
  for (std::size_t c = 0; c < 2; ++c) images += contact.image_virial(p, system.box, c);
  const auto energy = [&](const Tensor2<2> &F, const bool cells_too) {
    system.box.H = F * H;
    for (std::size_t i = 0; i < n; ++i)
      for (int d = 0; d < 2; ++d) p.x[d][i] = cells_too ? F(d, 0) * x[0][i] + F(d, 1) * x[1][i] : x[d][i];
    system.compute_forces();
    return system.potential_energy();
  };
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      for (const bool cells_too : {false, true}) {
        Tensor2<2> up = Tensor2<2>::Identity(), down = up;
        up(a, b) += 1e-6;
        down(a, b) -= 1e-6;
        const double slope = (energy(up, cells_too) - energy(down, cells_too)) / 2e-6;
        BOOST_TEST(std::abs(slope - (cells_too ? virial : images)(a, b)) < 1e-6 * virial.norm(),
                   a << b << cells_too);
      }

  // lists follow a lattice that moves while the cells stand still
  energy(Tensor2<2>::Identity(), false);
  const std::size_t builds = contact.list_builds();
  Tensor2<2> far = Tensor2<2>::Identity();
  far(0, 0) = 1.03;
  const double with_lists = energy(far, false);
  BOOST_TEST(contact.list_builds() > builds);
  ParticleSystem<2> fresh;
  lay(fresh.particles, Vector<2>::Zero());
  fresh.particles.x = p.x;
  fresh.box = system.box;
  fresh.add(std::make_unique<CellContact>(law(0.3, 1.3)));
  fresh.compute_forces();
  BOOST_TEST(fresh.potential_energy() == with_lists, boost::test_tools::tolerance(1e-12));

  // and are the same after a checkpoint
  CellContact read(law(0.3, 1.3));
  read.declare(p);
  const auto list_of = [&](CellContact &some) { return [&](Archive &a) { some.archive(a, p); }; };
  const auto from = list_of(contact), to = list_of(read);
  restore(archived(from), to);
  for (std::size_t c = 0; c < 2; ++c)
    BOOST_TEST(read.energy(p, system.box, c) == contact.energy(p, system.box, c));
}

BOOST_AUTO_TEST_CASE(overloaded_ties_break_on_both_sides) {
  ParticleSystem<2> system;
  Particles<2> &p = system.particles;
  add_square(p, 0., 0., 4);
  add_square(p, 4.1, 0., 4);
  p.x[0][16 + 12] = 4.3;  // node (0, 4) of the second cell, a further 0.2 away
  std::vector<LamellaTie> list;
  for (std::uint32_t k = 0; k <= 4; ++k) list.push_back({4 + k, 16 + (16 - k) % 16, {{0, 0}}, 10.});
  auto &ties = system.add(std::make_unique<LamellaTies>(list, 1., 2.));
  system.compute_forces();
  BOOST_TEST(p.f[0][8] == 3., boost::test_tools::tolerance(1e-12));
  const auto broken = ties.break_overloaded(p, system.box);
  BOOST_REQUIRE(broken.size() == 1u);
  BOOST_TEST(list[broken[0]].a == 8u);
  system.compute_forces();
  BOOST_TEST(p.f[0][8] == 0.);
  BOOST_TEST(p.f[0][16 + 12] == 0.);
  BOOST_TEST(p.f[0][7] == 1., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(ties.break_overloaded(p, system.box).empty());
  BOOST_TEST(ties.broken_count() == 1u);
  LamellaTies read(list, 1., 2.);
  const auto list_of = [&](LamellaTies &some) { return [&](Archive &a) { some.archive(a, p); }; };
  const auto from = list_of(ties), to = list_of(read);
  restore(archived(from), to);
  BOOST_TEST(read.is_broken(broken[0]));
  require_conservative(system);
}

BOOST_AUTO_TEST_SUITE_END()
