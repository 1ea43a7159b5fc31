#include "rve/make_rve.h"

#include "run/run_context.h"
#include "rve/hydrostatic_rve.h"
#include "rve/sph_rve.h"

#include <numbers>
#include <stdexcept>

namespace turgor
{
namespace
{
/// Of squares: mirrors, and quarter turns where there are as many columns as rows. None is claimed of other cells.
std::vector<Tensor2<2>> symmetries(const RveParameters &p)
{
  if (!p.structure.square())
    return {};
  Tensor2<2> mirror, swap;
  mirror << 1., 0., 0., -1.;
  swap << 0., 1., 1., 0.;
  std::vector<Tensor2<2>> all = {mirror};
  if (p.columns == p.rows)
    all.insert(all.end(), {swap, Tensor2<2>(swap * mirror)});
  const Tensor2<2> R = Eigen::Rotation2Dd(p.structure.rotation * std::numbers::pi / 180.).toRotationMatrix();
  for (Tensor2<2> &Q : all)
    Q = (R * Q * R.transpose()).eval();
  return all;
}
} // namespace

std::unique_ptr<Rve<2>> make_rve(const RveParameters &p)
{
  try
    {
      p.check();
      if (p.fluid == "hydrostatic")
        {
          HydrostaticRveSettings settings;
          if (p.rule == "cauchy_born")
            settings.rule = HydrostaticRule::cauchy_born;
          else if (p.rule == "elastic_equilibrium")
            settings.rule = HydrostaticRule::elastic_equilibrium;
          else
            throw InputError("RVE/Rule is " + p.rule +
                             ", which needs a fluid that flows. With RVE/Fluid = hydrostatic use cauchy_born or "
                             "elastic_equilibrium.");
          settings.columns = p.columns;
          settings.rows = p.rows;
          settings.equilibrium = {p.equilibrium_tolerance(), p.max_iterations};
          settings.walls = p.wall_limits();
          settings.symmetries = symmetries(p);
          return std::make_unique<HydrostaticRve>(turgid_tissue(p.structure, p.yielding_cell(), p.columns, p.rows), settings);
        }
      SphRveSettings settings;
      settings.rule = p.rule == "cauchy_born"         ? SphRule::cauchy_born :
                      p.rule == "elastic_equilibrium" ? SphRule::elastic_equilibrium :
                                                        SphRule::constrained_runs;
      settings.columns = p.columns;
      settings.rows = p.rows;
      settings.sph = p.sph;
      settings.step_fraction = p.step_fraction;
      settings.burst = p.burst;
      settings.bursts = p.bursts;
      settings.window = p.window;
      settings.tolerance = p.equilibrium_tolerance();
      settings.relax_steps = p.relax_steps;
      return std::make_unique<SphRve>(p.cell, settings);
    }
  catch (const std::invalid_argument &wrong)
    {
      throw InputError(wrong.what());
    }
}

std::size_t state_size(const RveParameters &p)
{
  if (p.fluid == "hydrostatic")
    {
      const RveState<2> state = make_rve(p)->initial_state();
      return state.unknowns.size() + state.history.size();
    }
  try
    {
      p.check();
    }
  catch (const std::invalid_argument &wrong)
    {
      throw InputError(wrong.what());
    }
  const std::size_t particles = 4 * std::size_t(p.cell.nodes_per_side) + std::size_t(p.sph.particles_per_side) * p.sph.particles_per_side;
  return p.rule == "cauchy_born" ? 0 : std::size_t(p.columns) * p.rows * particles * (p.sph.formulation == "thesis" ? 5 : 4);
}
} // namespace turgor
