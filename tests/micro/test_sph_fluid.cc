// The fluid, wall and lamella terms of a patch of cells: F = -dE/dx by finite differences,
// momentum, gamma against direct quadrature, both instruction sets against each other.
#include "micro/processes/annealed_cells.h"
#include "micro/engine/kick_drift_kick.h"
#include "micro/terms/sph_fluid.h"
#include "run/archive.h"
#include "tests/micro/small_patch.h"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace turgor;
using test::largest_force;

namespace {
struct Fixture : test::SmallPatch {
  Fixture() { box_shear = 0.1; }
};
}  // namespace

BOOST_FIXTURE_TEST_SUITE(sph_fluid, Fixture)

BOOST_DATA_TEST_CASE(force_is_minus_energy_gradient, boost::unit_test::data::make({"exact", "summed"}),
                     volume) {
  sph.summed = std::string(volume) == "summed";
  auto patch = disturbed(2, 1);
  ParticleSystem<2> &system = patch->system;
  system.compute_forces();
  const Particles<2> at = system.particles;
  const double scale = largest_force(at), h = 1e-6 * patch->layout.spacing;
  for (std::size_t i = 0; i < at.size(); i += 7)
    for (int d = 0; d < 2; ++d) {
      double e[4];
      const double offset[4] = {-2 * h, -h, h, 2 * h};
      for (int k = 0; k < 4; ++k) {
        system.particles.x[d][i] = at.x[d][i] + offset[k];
        system.compute_forces();
        e[k] = system.potential_energy();
      }
      system.particles.x[d][i] = at.x[d][i];
      const double gradient = (e[0] - 8. * e[1] + 8. * e[2] - e[3]) / (12. * h);
      BOOST_TEST(std::abs(at.f[d][i] + gradient) < 2e-6 * scale,
                 "particle " << i << " component " << d << ": " << at.f[d][i] << " against " << -gradient);
    }
}

BOOST_AUTO_TEST_CASE(virial_is_energy_derivative_by_strain) {
  auto patch = disturbed(1, 1);
  ParticleSystem<2> &system = patch->system;
  system.compute_forces();
  const Tensor2<2> virial = system.virial();
  const ParticleSystem<2> *const_system = &system;
  const Particles<2> at = const_system->particles;
  const Tensor2<2> H = system.box.H;
  const double h = 1e-6;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      double e[2];
      for (int k = 0; k < 2; ++k) {
        Tensor2<2> F = Tensor2<2>::Identity();
        F(a, b) += k == 0 ? -h : h;
        system.box.H = F * H;
        for (std::size_t i = 0; i < at.size(); ++i) {
          const Vector<2> x = F * at.position(i);
          system.particles.x[0][i] = x[0];
          system.particles.x[1][i] = x[1];
        }
        system.compute_forces();
        e[k] = system.potential_energy();
      }
      BOOST_TEST((e[1] - e[0]) / (2. * h) == virial(a, b), boost::test_tools::tolerance(1e-4));
    }
}

BOOST_AUTO_TEST_CASE(volumes_fill_the_cell_and_packing_does_not_decide_the_pressure) {
  // The annealed cell, and the same sheared affinely: other packings of the same mass in the same volume. The
  // mean pressure is that of the mass over the volume up to the second order in the spread of densities.
  const CellLayout patch = make_parenchyma(cell, 1, 1, true, true);
  const auto cells = make_sph_patch(patch, sph, anneal_square_cell(cell, sph));
  Particles<2> &p = cells->system.particles;
  const Group &g = p.groups[0];
  const EquationOfState &eos = cells->fluid->equation_of_state();
  const double mass = cells->fluid->particle_mass()[0], bulk = 7. * cell.fluid_modulus;
  double twice_area = 0.;
  for (std::uint32_t k = g.begin; k < g.fluid; ++k) {
    const Vector<2> a = p.position(k), b = p.position(k + 1 < g.fluid ? k + 1 : g.begin);
    twice_area += a[0] * b[1] - a[1] * b[0];
  }
  const double volume = 0.5 * twice_area * cell.depth, rho_mean = mass * g.fluid_count() / volume;
  for (const double shear : {0., 0.01, 0.01})  // added up
  {
    for (std::size_t i = 0; i < p.size(); ++i) p.x[0][i] += shear * p.x[1][i];
    cells->system.box.H(0, 1) += shear * cells->system.box.H(1, 1);
    cells->system.compute_forces();
    double filled = 0., mean = 0., spread = 0.;
    for (std::uint32_t i = g.fluid; i < g.end; ++i) {
      const double rho = p.field("density")[i], share = mass / rho / volume;
      filled += share;
      mean += share * p.field("pressure")[i];
      spread += share * (rho / rho_mean - 1.) * (rho / rho_mean - 1.);
    }
    BOOST_TEST(filled == 1., boost::test_tools::tolerance(1e-12));
    // sum v_i p(v_i) with the mean of v = 1/rho fixed: half the second derivative of v p(v), p ~ v^-7, is
    // 21 K = 3 bulk; 4 leaves room for the third order.
    BOOST_TEST(std::abs(mean - eos.pressure(rho_mean)) < 4. * bulk * spread);
  }
}

BOOST_AUTO_TEST_CASE(momentum_is_conserved_to_round_off) {
  auto patch = disturbed(2, 2, 1.);
  ParticleSystem<2> &system = patch->system;
  system.compute_forces();
  const Particles<2> &p = system.particles;
  BOOST_TEST(test::total_force(p).norm() < 1e-12 * largest_force(p) * std::sqrt(double(p.size())));
}

BOOST_AUTO_TEST_CASE(wall_share_matches_quadrature) {
  auto patch = disturbed(1, 1);
  patch->system.compute_forces();
  const Particles<2> &particles = patch->system.particles;
  const Group &g = particles.groups[0];
  const double R = patch->fluid->support();
  const std::vector<double> &gamma = particles.field("wall_share");
  const std::uint32_t nw = g.wall_count();
  // In polar coordinates about the particle (the cell is star-shaped from there): along a ray the
  // kernel is integrated by a fine midpoint table, over the angle by the midpoint rule.
  const int table_size = 20000;
  std::vector<double> integral(table_size + 1, 0.);
  for (int k = 0; k < table_size; ++k) {
    const double u = (k + 0.5) / table_size;
    integral[k + 1] = integral[k] + 7. / M_PI * std::pow(1. - u, 4) * (4. * u + 1.) * u / table_size;
  }
  for (const std::uint32_t i : {g.fluid, g.fluid + 4, g.fluid + 10}) {
    const int rays = 20000;
    const Vector<2> x = particles.position(i);
    double total = 0.;
    for (int r = 0; r < rays; ++r) {
      const double angle = 2. * M_PI * (r + 0.5) / rays;
      const Vector<2> e(std::cos(angle), std::sin(angle));
      double reach = R;
      for (std::uint32_t k = 0; k < nw; ++k) {
        const Vector<2> a = particles.position(k) - x, b = particles.position((k + 1) % nw) - x, t = b - a;
        const double det = e[0] * t[1] - e[1] * t[0];
        const double along = (a[0] * t[1] - a[1] * t[0]) / det, share = (a[0] * e[1] - a[1] * e[0]) / det;
        if (along > 0. && share >= 0. && share <= 1.) reach = std::min(reach, along);
      }
      const double place = reach / R * table_size;
      const int k = std::min(int(place), table_size - 1);
      total += (integral[k] + (place - k) * (integral[k + 1] - integral[k])) * 2. * M_PI / rays;
    }
    BOOST_TEST(std::abs(gamma[i] - total) < 2e-6, gamma[i] << " against " << total);
  }
}

BOOST_AUTO_TEST_CASE(sweeps_of_all_instruction_sets_agree) {
  // Through the raw interface: the same cell, all sweeps.
  auto patch = disturbed(1, 1, 1.);
  Particles<2> &p = patch->system.particles;
  const Group &g = p.groups[0];
  const std::uint32_t n = g.fluid_count(), nw = g.wall_count();
  std::vector<std::uint16_t> list;
  std::vector<std::uint32_t> first{0}, first_arc{0};
  std::vector<sph::Arc> arcs;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j)
      if (j != i) list.push_back(std::uint16_t(j));
    while (list.size() % sph::list_padding) list.push_back(std::uint16_t(n));
    first.push_back(std::uint32_t(list.size()));
    arcs.push_back({0, std::uint16_t(nw)});
    first_arc.push_back(std::uint32_t(arcs.size()));
  }
  const auto aligned = [](std::size_t size) {
    return std::unique_ptr<double, void (*)(void *)>(
        static_cast<double *>(std::aligned_alloc(64, (size * 8 + 63) / 64 * 64)), std::free);
  };
  const std::size_t variants = sph::known_sweeps<2>().size();
  std::vector<std::vector<double>> results(variants), densities(variants);
  std::vector<double> means(variants);
  for (std::size_t variant = 0; variant < variants; ++variant) {
    const auto rows = aligned((n + 1) * sph::row_doubles);
    sph::CellView<2> c;
    c.n = n;
    c.n_wall = nw;
    c.volume = cell.period * cell.period * cell.depth;
    c.ordering = sph.ordering * cell.fluid_modulus;
    c.arc_stride = (n + 7) / 8 * 8;
    const auto scratch =
                   aligned(4 * sph::list_padding * n * ((nw + sph::list_padding - 1) / sph::list_padding)),
               ends = aligned(5 * c.arc_stride);
    c.arc_ends = ends.get();
    c.rows = rows.get();
    c.scratch = scratch.get();
    const auto viscous_rows = aligned((n + 1) * sph::viscous_row<2>),
               moments = aligned((n + 1) * sph::viscous_row<2>);
    c.viscous_rows = viscous_rows.get();
    c.moments = moments.get();
    c.particle_volume = c.volume / n;
    std::vector<double> f[2], rho(n), gamma(n), pressure(n), push(n), wall_x[2], wall_v[2], wall_f[2],
        wall_next[2];
    for (int d = 0; d < 2; ++d) {
      f[d].assign(n, 0.);
      for (std::uint32_t k = 0; k < 2 * nw + sph::list_padding + 1; ++k) {
        wall_x[d].push_back(p.x[d][k % nw]);
        wall_v[d].push_back(p.v[d][k % nw]);
      }
      wall_f[d].assign(wall_x[d].size(), 0.);
      wall_next[d].assign(wall_x[d].size(), 0.);
      c.wall_f_next[d] = wall_next[d].data();
      c.x[d] = p.x[d].data() + g.fluid;
      c.v[d] = p.v[d].data() + g.fluid;
      c.f[d] = f[d].data();
      c.wall_x[d] = wall_x[d].data();
      c.wall_v[d] = wall_v[d].data();
      c.wall_f[d] = wall_f[d].data();
    }
    c.rho = rho.data();
    c.gamma = gamma.data();
    c.pressure = pressure.data();
    c.push = push.data();
    c.neighbours = list.data();
    c.first_neighbour = first.data();
    c.arcs = arcs.data();
    c.first_arc = first_arc.data();
    c.support = patch->fluid->support();
    c.mass = patch->fluid->particle_mass()[0];
    c.depth = cell.depth;
    c.viscosity = 1.;
    c.eos_data = &patch->fluid->equation_of_state();
    c.eos = [](const void *eos, std::uint32_t count, const double *density, double *p_out) {
      for (std::uint32_t k = 0; k < count; ++k)
        p_out[k] = static_cast<const EquationOfState *>(eos)->pressure(density[k]);
    };
    const sph::Sweeps<2> &sweeps = *sph::known_sweeps<2>()[variant];
    BOOST_TEST_INFO_SCOPE(sweeps.name);
    sweeps.density(c);
    sweeps.force(c);
    sweeps.viscosity(c);
    for (const auto *part : {&f[0], &f[1], &wall_f[0], &wall_f[1], &wall_next[0], &wall_next[1]})
      results[variant].insert(results[variant].end(), part->begin(), part->end());
    densities[variant] = rho;
    means[variant] = c.mean_pressure;
  }
  for (std::size_t variant = 1; variant < variants; ++variant) {
    BOOST_TEST_INFO_SCOPE(sph::known_sweeps<2>()[variant]->name);
    BOOST_TEST(means[0] == means[variant], boost::test_tools::tolerance(1e-9));
    for (std::uint32_t i = 0; i < n; ++i)
      BOOST_TEST(densities[0][i] == densities[variant][i], boost::test_tools::tolerance(1e-12));
    double largest = 0., difference = 0.;
    for (std::size_t k = 0; k < results[0].size(); ++k) {
      largest = std::max(largest, std::abs(results[0][k]));
      difference = std::max(difference, std::abs(results[0][k] - results[variant][k]));
    }
    BOOST_TEST(difference < 1e-10 * largest);
  }
}

BOOST_AUTO_TEST_CASE(lists_do_not_change_results) {
  // With and without a skin, after many steps: the same forces up to the order of summation.
  auto patch = disturbed(1, 1);
  KickDriftKick<2> integrator(patch->system);
  patch->system.compute_forces();
  const double dt = 0.3 * patch->system.stable_time_step();
  for (int s = 0; s < 300; ++s) integrator.step(dt);
  const Particles<2> after = patch->system.particles;
  auto fresh = disturbed(1, 1);
  fresh->system.particles.x = after.x;
  fresh->system.compute_forces();
  BOOST_TEST(test::largest_difference(after, fresh->system.particles) < 1e-10 * largest_force(after));
}

BOOST_AUTO_TEST_CASE(undamped_energy_is_bounded_and_second_order) {
  double drift[2];
  for (int refine = 0; refine < 2; ++refine) {
    auto patch = disturbed(1, 1);
    KickDriftKick<2> integrator(patch->system);
    for (int d = 0; d < 2; ++d)
      std::fill(patch->system.particles.v[d].begin(), patch->system.particles.v[d].end(), 0.);
    patch->system.compute_forces();
    const double start = patch->system.potential_energy() + patch->system.kinetic_energy();
    const double dt = 0.1 * patch->system.stable_time_step() / (1 << refine);
    double worst = 0., kinetic = 0.;
    for (int s = 0; s < 400 << refine; ++s) {
      integrator.step(dt);
      const double k = patch->system.kinetic_energy();
      kinetic = std::max(kinetic, k);
      worst = std::max(worst, std::abs(patch->system.potential_energy() + k - start));
    }
    drift[refine] = worst / kinetic;
  }
  BOOST_TEST_MESSAGE("energy error " << drift[0] << " " << drift[1]);
  BOOST_TEST(drift[0] < 1e-2);
  BOOST_TEST(std::log2(drift[0] / drift[1]) > 1.7);
}

BOOST_AUTO_TEST_CASE(a_scene_carries_only_the_fields_it_uses) {
  // Osmosis, viscosity and failure have no field of their own.
  const std::vector<std::string> expected{"density", "pressure", "wall_share"};
  const auto inviscid = disturbed(1, 1)->system.particles.field_names();
  const auto viscous = disturbed(1, 1, 1.)->system.particles.field_names();
  BOOST_TEST(inviscid == expected, boost::test_tools::per_element());
  BOOST_TEST(viscous == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(saved_and_loaded_state_continues_with_the_same_bits) {
  auto a = disturbed(2, 2, 1.), b = disturbed(2, 2, 1.);
  KickDriftKick<2> run_a(a->system), run_b(b->system);
  a->system.compute_forces();
  const double dt = 0.5 * a->system.stable_time_step();
  for (int s = 0; s < 57; ++s) run_a.step(dt);
  restore(archived(a->system), b->system);
  b->system.threads = 2;
  for (int s = 0; s < 200; ++s) {
    run_a.step(dt);
    run_b.step(dt);
  }
  for (int d = 0; d < 2; ++d) {
    BOOST_TEST((a->system.particles.x[d] == b->system.particles.x[d]));
    BOOST_TEST((a->system.particles.v[d] == b->system.particles.v[d]));
  }
}

BOOST_AUTO_TEST_SUITE_END()
