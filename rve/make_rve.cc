#include "rve/make_rve.h"

#include "micro/cells/turned_cells.h"
#include "micro/processes/annealed_cells.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/stop_flag.h"
#include "rve/hydrostatic_rve.h"
#include "rve/sph_rve.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace turgor {
namespace {
/// Mirrors and turns that leave cells and periods as they are, but for the identity and its negative. Squares
/// and bricks: both axes; squares and hexagons, where there are as many columns as rows: quarter or sixth
/// turns and the mirrors between. The periods of bricks lean: their mirror images are periods too only where
/// the rows are a multiple of the columns. None is claimed of cells with jitter, of Laguerre
/// cells or of windows.
std::vector<Tensor2<2>> symmetries(const RveParameters &p) {
  const StructureKind kind = p.structure.kind;
  const bool even = p.columns == p.rows, square = kind == StructureKind::square,
             hexagon = kind == StructureKind::hexagon && even,
             brick = kind == StructureKind::brick && p.rows % p.columns == 0;
  if (p.structure.jitter > 0. || !(square || hexagon || brick) || p.boundary != RveBoundary::periodic)
    return {};
  Tensor2<2> mirror, swap;
  mirror << 1., 0., 0., -1.;
  swap << 0., 1., 1., 0.;
  std::vector<Tensor2<2>> all = {mirror};
  if (square && even) all.insert(all.end(), {swap, Tensor2<2>(swap * mirror)});
  if (hexagon)
    for (const double third : {std::numbers::pi / 3., 2. * std::numbers::pi / 3.}) {
      const Tensor2<2> turn = Eigen::Rotation2Dd(third).toRotationMatrix();
      all.insert(all.end(), {turn, Tensor2<2>(turn * mirror)});
    }
  const Tensor2<2> R = Eigen::Rotation2Dd(p.structure.rotation * std::numbers::pi / 180.).toRotationMatrix();
  for (Tensor2<2> &Q : all) Q = (R * Q * R.transpose()).eval();
  return all;
}

HydrostaticRveSettings hydrostatic_settings(const RveParameters &p) {
  HydrostaticRveSettings settings;
  settings.rule =
      p.rule == RveRule::cauchy_born ? HydrostaticRule::cauchy_born : HydrostaticRule::elastic_equilibrium;
  settings.boundary = p.boundary;
  settings.columns = p.columns;
  settings.rows = p.rows;
  settings.equilibrium = {p.equilibrium_tolerance(), p.max_iterations};
  settings.equilibrium.each_iteration = [] { stop_here("while the walls of an RVE came to rest"); };
  settings.walls = p.wall_limits();
  settings.symmetries = symmetries(p);
  settings.air = p.air_gas();
  return settings;
}

SphRveSettings sph_settings(const RveParameters &p) {
  SphRveSettings settings;
  settings.rule = p.rule == RveRule::cauchy_born           ? SphRule::cauchy_born
                  : p.rule == RveRule::elastic_equilibrium ? SphRule::elastic_equilibrium
                                                           : SphRule::constrained_runs;
  settings.columns = p.columns;
  settings.rows = p.rows;
  settings.sph = p.sph;
  settings.step_fraction = p.step_fraction;
  settings.burst = p.burst;
  settings.bursts = p.bursts;
  settings.window = p.window;
  settings.tolerance = p.equilibrium_tolerance();
  settings.relax_steps = p.relax_steps;
  return settings;
}

/// Cells filled upright and then turned, so that a turned tissue answers as the upright one in its own frame.
std::unique_ptr<SphRve> filled_with_particles(const RveParameters &p) {
  const double angle = p.structure.rotation * std::numbers::pi / 180.;
  if (p.structure.square()) return std::make_unique<SphRve>(p.cell, sph_settings(p), angle);
  TissueStructure upright = p.structure;
  upright.rotation = 0.;
  CellLayout layout = turgid_tissue(upright, p.cell, p.columns, p.rows);
  AnnealedCells at_rest = anneal(layout, p.sph, unannealed_cells(layout, p.sph),
                                 [](double) { stop_here("while the cells of an RVE were annealed"); });
  return std::make_unique<SphRve>(turned(std::move(layout), angle), turned(std::move(at_rest.cells), angle),
                                  sph_settings(p));
}

/// What is wrong with the entries is told as such, whoever finds it.
template <class Build>
auto of_entries(const RveParameters &p, const Build &build) {
  try {
    p.check();
    return build();
  } catch (const std::invalid_argument &wrong) {
    throw InputError(wrong.what());
  }
}
}  // namespace

std::unique_ptr<Rve<2>> make_rve(const RveParameters &p) {
  return of_entries(p, [&]() -> std::unique_ptr<Rve<2>> {
    if (p.fluid == RveFluid::hydrostatic)
      return std::make_unique<HydrostaticRve>(
          turgid_tissue(p.structure, p.yielding_cell(), p.columns, p.rows), hydrostatic_settings(p));
    return filled_with_particles(p);
  });
}

std::array<double, 2> cell_size(const RveParameters &p, const Rve<2> &rve) {
  if (p.structure.square()) return {{p.cell.period, p.cell.period}};
  const double area = rve.lattice().determinant() / (double(p.columns) * p.rows),
               width = p.structure.rotation != 0. ? std::sqrt(area) : rve.lattice().col(0).norm() / p.columns;
  return {{width, area / width}};
}

std::size_t state_size(const RveParameters &p) {
  return of_entries(p, [&]() -> std::size_t {
    const std::size_t cells = std::size_t(p.columns) * p.rows;
    if (p.fluid == RveFluid::hydrostatic) {
      const std::size_t nodes =
          p.structure.square() ? cells * 4 * p.cell.nodes_per_side
                               : laid_tissue(p.structure, p.yielding_cell(), p.columns, p.rows).nodes.size();
      return 2 * nodes + WallHistory::packed_size(p.wall_limits(), nodes, cells);
    }
    if (p.rule == RveRule::cauchy_born) return 0;
    return cells * particles_of_square_cell(p.cell, p.sph) *
           (p.sph.formulation == SphFormulation::thesis ? 5 : 4);
  });
}
}  // namespace turgor
