// Cells of their own sizes filled with particles: own counts and masses, F = -dE/dx, stress, and annealed
// apart.
#include "micro/processes/annealed_cells.h"
#include "tests/micro/unlike_cells.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <set>
#include <stdexcept>

using namespace turgor;

namespace {
SphParameters coarse() {
  SphParameters sph;
  sph.particles_per_side = 9;
  sph.anneal_steps = 6000;
  return sph;
}

CellLayout inviscid_cells() {
  CellLayout layout = test::unlike_cells(10e-6);
  layout.parameters.fluid_viscosity = 0.;
  return layout;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(unlike_sph_cells)

BOOST_AUTO_TEST_CASE(counts_and_masses_are_the_layouts) {
  const CellLayout layout = inviscid_cells();
  const auto patch = make_sph_patch(layout, coarse(), unannealed_cells(layout, coarse()));
  const Particles<2> &p = patch->system.particles;
  BOOST_REQUIRE(p.groups.size() == layout.cells());
  std::set<std::uint32_t> walls, fluids;
  for (std::size_t c = 0; c < layout.cells(); ++c) {
    const Group &g = p.groups[c];
    walls.insert(g.wall_count());
    fluids.insert(g.fluid_count());
    BOOST_TEST(g.wall_count() == layout.rings[c].count);
    BOOST_TEST(patch->fluid->particle_mass()[c] * g.fluid_count() == layout.fluid_mass[c],
               boost::test_tools::tolerance(1e-12));
    for (std::uint32_t k = 0; k < g.wall_count(); ++k) {
      const std::uint32_t node = layout.rings[c].first + k;
      BOOST_TEST(patch->particle(node) == g.begin + k);
      BOOST_TEST(p.inverse_mass[g.begin + k] * layout.node_mass[node] == 1.,
                 boost::test_tools::tolerance(1e-12));
    }
  }
  BOOST_TEST(walls.size() > 2u);
  BOOST_TEST(fluids.size() > 2u);
  const double volume = layout.lattice.determinant() * layout.parameters.depth;
  BOOST_TEST(patch->density() * volume == layout.total_fluid_mass() + layout.total_wall_mass(),
             boost::test_tools::tolerance(1e-12));
  BOOST_CHECK_THROW(make_sph_patch(layout, coarse(), unannealed_cells(layout, coarse()).front()),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(forces_and_stress_are_slopes_of_the_energy) {
  const CellLayout layout = inviscid_cells();
  const auto patch = make_sph_patch(layout, coarse(), unannealed_cells(layout, coarse()));
  ParticleSystem<2> &system = patch->system;
  Particles<2> &p = system.particles;
  system.compute_forces();
  const Particles<2>::Components f = p.f, x = p.x;
  const Tensor2<2> virial = system.virial(), H = system.box.H;
  double scale = 0.;
  Vector<2> sum = Vector<2>::Zero();
  for (std::size_t i = 0; i < p.size(); ++i) {
    sum += Vector<2>(f[0][i], f[1][i]);
    scale = std::max(scale, std::hypot(f[0][i], f[1][i]));
  }
  BOOST_TEST(sum.norm() < 1e-12 * double(p.size()) * scale);
  const auto energy = [&] {
    system.compute_forces();
    return system.potential_energy();
  };
  const double h = 1e-6 * layout.spacing;
  for (std::size_t i = 0; i < p.size(); i += 7)
    for (int d = 0; d < 2; ++d) {
      p.x[d][i] = x[d][i] + h;
      const double up = energy();
      p.x[d][i] = x[d][i] - h;
      const double down = energy();
      p.x[d][i] = x[d][i];
      BOOST_TEST(std::abs((up - down) / (2. * h) + f[d][i]) < 1e-5 * scale, "particle " << i);
    }
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      double e[2];
      for (const int side : {0, 1}) {
        Tensor2<2> F = Tensor2<2>::Identity();
        F(a, b) += side == 0 ? -1e-6 : 1e-6;
        system.box.H = F * H;
        for (std::size_t i = 0; i < p.size(); ++i)
          for (int d = 0; d < 2; ++d) p.x[d][i] = F(d, 0) * x[0][i] + F(d, 1) * x[1][i];
        e[side] = energy();
      }
      BOOST_TEST(std::abs((e[1] - e[0]) / 2e-6 - virial(a, b)) < 1e-5 * virial.norm());
    }
}

// Every cell comes to rest as what it is; what one factor of all masses can take away of the stress is gone.
BOOST_AUTO_TEST_CASE(cells_are_annealed_apart) {
  const CellLayout layout = inviscid_cells();
  const std::vector<CellContents> start = unannealed_cells(layout, coarse());
  const AnnealedCells rest = anneal(layout, coarse(), start);
  BOOST_TEST(rest.residual < 0.02);
  const double turgor = layout.parameters.turgor;
  BOOST_TEST(std::abs(rest.residual_stress[0] + rest.residual_stress[1]) < 1e-3 * turgor);
  BOOST_TEST(rest.mean_pressure > 0.4 * turgor);
  BOOST_TEST(rest.mean_pressure < 1.5 * turgor);
  const double factor = rest.cells[0].particle_mass / start[0].particle_mass;
  for (std::size_t c = 0; c < layout.cells(); ++c) {
    BOOST_TEST(rest.cells[c].x.size() == start[c].x.size());
    BOOST_TEST(rest.cells[c].particle_mass / start[c].particle_mass == factor,
               boost::test_tools::tolerance(1e-10));
  }
  // and goes on resting
  const auto patch = make_sph_patch(layout, coarse(), rest.cells);
  patch->system.compute_forces();
  BOOST_TEST(std::abs(patch->system.virial().trace()) <
             2e-3 * turgor * layout.lattice.determinant() * layout.parameters.depth);
}

BOOST_AUTO_TEST_SUITE_END()
