#include "micro/scenarios/tissue_loading.h"

#include "micro/cells/sph_cell_entries.h"
#include "micro/engine/binary.h"
#include "micro/engine/respa.h"
#include "micro/engine/watched_steps.h"
#include "micro/io/field_file.h"
#include "micro/processes/failure.h"
#include "micro/processes/osmosis.h"
#include "micro/processes/wall_yielding.h"
#include "micro/scenarios/shared_entries.h"
#include "micro/scenarios/stepping.h"
#include "micro/scenarios/tissue_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>

#include <deal.II/base/parameter_handler.h>

namespace turgor
{
TissueLoading::TissueLoading(const TissueLoadingDefaults &defaults)
  : text(defaults.description)
  , speed(defaults.speed)
  , end_strain(defaults.end_strain)
  , damping(defaults.damping)
{
  brick.critical_stretch = defaults.critical_stretch;
  brick.lamella_strength = defaults.lamella_strength;
  cell.nodes_per_side = 16;
  sph.particles_per_side = 12;
}

void TissueLoading::declare_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  brick.add_parameters(prm);
  prm.add_parameter("Speed", speed, "Of the upper plate, downward. Units: m/s.", Double(1e-4, 100.));
  prm.add_parameter("End strain", end_strain, "Way of the plate over the height of the inflated tissue. Units: none.",
                    Double(1e-4, 0.9));
  prm.add_parameter("Damping", damping,
                    "Rate at which all velocities decay while the plate moves: for quasi-static loading; 0: none. Units: 1/s.",
                    Double(0., 1e9));
  prm.add_parameter("Inflation time", inflation_time, "Time in which osmosis brings the cells to turgor. Units: s.",
                    Double(1e-7, 1.));
  prm.add_parameter("Inflation damping", inflation_damping, "Rate at which velocities decay meanwhile. Units: 1/s.",
                    Double(1e3, 1e9));
  declare_step_fraction(prm, step_fraction);
  declare_substeps(prm, substeps);
  prm.add_parameter("Samples", samples, "Rows of loading.csv. Units: none.", Integer(10, 1000000));
  prm.add_parameter("Frames", frames, "Frames of the field file after the first; 0 writes no fields. Units: none.",
                    Integer(0, 100000));
  declare_checkpoints(prm, checkpoints);
  declare_sph_cell(prm, cell, sph);
}

void TissueLoading::check() const
{
  check_sph_cell(cell, sph);
  check_substeps(substeps, sph);
  brick.check(cell, sph);
  if (brick.yielding != "none") // throws where the wall yields before it can carry turgor
    NeoHookeanWall(cell.wall_stiffness, cell.depth, cell.wall_beta, brick.yield)
      .stretch_at(0.5 * cell.turgor * cell.period * cell.depth);
}

class TissueLoading::Run
{
public:
  Run(const TissueLoading &scene_, RunContext &context_)
    : scene(scene_)
    , context(context_)
    , tissue(make_brick_tissue(scene.cell, scene.sph, scene.brick))
    , system(tissue->system)
  {
    system.threads = context.threads();
    const double far = 10. * (scene.brick.rows + 2.) * scene.cell.period;
    const bool fluid = bool(tissue->damage);
    plates = &system.add(std::make_unique<Plates<2>>(
      std::vector<Plate>{{.axis = 1, .side = 1, .position = -far, .touches_fluid = fluid},
                         {.axis = 1, .side = -1, .position = far, .touches_fluid = fluid}},
      scene.brick.contact_ratio * tissue->spring_stiffness));
    if (tissue->damage)
      failure.emplace(*tissue->wall, tissue->damage, scene.brick.critical_stretch);
    if (tissue->flow)
      yielding.emplace(*tissue->wall, tissue->flow);
    integrator.emplace(system, scene.step_fraction, 0.02);
    dt = integrator->safe_step();
    inflation_steps = std::uint64_t(std::ceil(scene.inflation_time / dt));
    if (scene.substeps > 1)
      split.emplace(system, scene.substeps);
    reach = 20. * std::max(scene.brick.columns, scene.brick.rows) * scene.cell.period;
    sound = tissue->fluid->equation_of_state().sound_speed(scene.cell.fluid_density);
  }

  void go()
  {
    context.active(system.term_names(), system.particles.field_names());
    if (double(scene.end_strain) * scene.brick.rows * scene.cell.period / scene.speed / dt > 2e9)
      throw InputError("Speed is so small that the run would take more than 2e9 steps; choose a larger Speed or a smaller End strain.");
    const bool resumed = context.load_checkpoint([this](std::istream &in) { load(in); });
    if (!resumed)
      {
        angle_before = tissue->angle_deviation();
        system.compute_forces();
      }
    if (load_steps == 0)
      inflate();
    squeeze(resumed);
    report();
  }

private:
  void save(std::ostream &out) const
  {
    write_binary(out, step);
    write_binary(out, load_steps);
    write_binary(out, dt);
    write_binary(out, angle_before);
    write_binary(out, angle_inflated);
    write_binary(out, void_fraction);
    write_binary(out, tie_stress);
    write_binary(out, start_energy);
    write_binary(out, start.low);
    write_binary(out, start.high);
    write_binary(out, start.width);
    write_binary(out, start.cell_height);
    write_binary(out, start.depth);
    write_binary(out, history);
    write_binary(out, broken_bonds);
    write_binary(out, broken_at_junction);
    write_binary(out, broken_ties);
    write_binary(out, deepest);
    if (tissue->damage)
      tissue->damage->save(out);
    if (tissue->flow)
      tissue->flow->save(out);
    system.save(out);
    integrator->save(out);
    if (load_steps > 0 && split)
      split->save(out);
  }

  void load(std::istream &in)
  {
    read_binary(in, step);
    read_binary(in, load_steps);
    read_binary(in, dt);
    read_binary(in, angle_before);
    read_binary(in, angle_inflated);
    read_binary(in, void_fraction);
    read_binary(in, tie_stress);
    read_binary(in, start_energy);
    read_binary(in, start.low);
    read_binary(in, start.high);
    read_binary(in, start.width);
    read_binary(in, start.cell_height);
    read_binary(in, start.depth);
    read_binary(in, history);
    read_binary(in, broken_bonds);
    read_binary(in, broken_at_junction);
    read_binary(in, broken_ties);
    read_binary(in, deepest);
    if (tissue->damage) // before the terms: lists of the fluid depend on it
      tissue->damage->load(in);
    if (tissue->flow)
      tissue->flow->load(in);
    system.load(in);
    integrator->load(in);
    if (load_steps > 0 && split)
      split->load(in);
  }

  void require_finite(const std::string &where) const
  {
    const Particles<2> &p = system.particles;
    for (std::size_t c = 0; c < p.groups.size(); ++c)
      for (std::uint32_t i = p.groups[c].begin; i < p.groups[c].end; ++i)
        if (!(std::abs(p.x[0][i]) < reach && std::abs(p.x[1][i]) < reach && std::hypot(p.v[0][i], p.v[1][i]) < 2. * sound))
          {
            std::ostringstream sentence;
            sentence << "the run diverged " << where << " (step " << step << "): a " << (i < p.groups[c].fluid ? "wall node" : "fluid particle")
                     << " at (" << p.x[0][i] << ", " << p.x[1][i] << ") m of cell (" << c % scene.brick.columns << ", "
                     << c / scene.brick.columns << ") left the scene or moves at more than twice the speed of sound. The last checkpoint "
                     << "holds the last good state; use a smaller Step fraction (now " << scene.step_fraction
                     << ") or a smaller Speed (now " << scene.speed << " m/s).";
            throw RunFailed(sentence.str());
          }
  }

  /// Drag, flow and breaking only take energy; the integrator's own error is far below a fiftieth of it.
  void require_energy(const std::string &where) const
  {
    const double given = start_energy + plates->work(), now = system.potential_energy() + system.kinetic_energy();
    if (load_steps > 0 && now - given > 0.02 * (start_energy + std::abs(plates->work())))
      {
        std::ostringstream sentence;
        sentence << "energy appeared from nothing " << where << " (step " << step << "): torn walls and the fluid of failed cells have run "
                 << "into foreign cells so far that their contact no longer tells inside from outside. What was written before holds; "
                 << "use a smaller End strain, or a larger Critical stretch (now " << scene.brick.critical_stretch << ").";
        throw RunFailed(sentence.str());
      }
  }

  void checked_save(const std::string &where)
  {
    require_finite(where);
    require_energy(where);
    context.save_checkpoint([this](std::ostream &out) { save(out); });
  }

  void inflate()
  {
    const auto where = [] { return std::string("while the tissue was inflated"); };
    const Osmosis osmosis(scene.cell.turgor, 200. / scene.inflation_time, 7. * scene.cell.fluid_modulus);
    const StepCheckpoints keep(context, inflation_steps, 0, [&] { checked_save(where()); }, where);
    while (step < inflation_steps)
      {
        integrator->step(dt, scene.inflation_damping);
        ++step;
        if (yielding)
          yielding->apply(system);
        if (step % 10 == 0)
          {
            osmosis.apply(system, *tissue->fluid, 10. * dt);
            system.compute_forces();
          }
        if (step % 64 == 0)
          {
            require_finite(where());
            context.progress(double(step) / double(inflation_steps), "inflating the tissue");
          }
        keep.after_step(step);
      }
    const double pressure = mean_pressure();
    if (!(std::abs(pressure - scene.cell.turgor) < 0.1 * scene.cell.turgor))
      {
        std::ostringstream sentence;
        sentence << "the cells have reached " << pressure * 1e-3 << " kPa of their turgor of " << scene.cell.turgor * 1e-3
                 << " kPa within Inflation time (" << scene.inflation_time << " s): use a longer one, or stiffer walls.";
        throw RunFailed(sentence.str());
      }
    Particles<2> &p = system.particles;
    for (int d = 0; d < 2; ++d)
      std::fill(p.v[d].begin(), p.v[d].end(), 0.);
    start = TissueStart::of(*tissue);
    angle_inflated = tissue->angle_deviation();
    void_fraction = tissue->void_fraction();
    if (tissue->ties)
      for (const LamellaTie &tie : tissue->ties->all())
        tie_stress = std::max(tie_stress, tissue->ties->stiffness() * (p.position(tie.a) - p.position(tie.b)).norm()
                                            / (tissue->spacing * scene.cell.depth));
    plates->set_position(0, start.low);
    plates->set_position(1, start.high);
    plates->set_velocity(1, -scene.speed);
    if (split) // impulses resonate with the fast terms from half their shortest period on (doc/results/stability)
      dt = scene.step_fraction
           * std::min({system.stable_time_step(Pace::slow), 0.45 * std::numbers::pi * system.stable_time_step(Pace::fast),
                       scene.substeps * system.stable_time_step(Pace::fast)});
    load_steps = std::max<std::uint64_t>(1, std::uint64_t(std::ceil(scene.end_strain * start.height() / (scene.speed * dt))));
    step = 0;
    system.compute_forces();
    start_energy = system.potential_energy();
  }

  double mean_pressure() const
  {
    double sum = 0.;
    for (std::size_t c = 0; c < system.particles.groups.size(); ++c)
      sum += tissue->fluid->mean_pressure(system.particles, c);
    return sum / double(system.particles.groups.size());
  }

  /// True when a force has changed.
  bool processes()
  {
    bool changed = false;
    if (yielding)
      changed = yielding->apply(system);
    if (failure)
      for (const auto &[c, bond] : failure->apply(system, tissue->fluid))
        {
          changed = true;
          broken_bonds += 1.;
          // within an eighth of a cell side of where three cells meet
          if (tissue->to_junction(c, std::uint32_t(bond)) <= std::max(1u, scene.cell.nodes_per_side / 8))
            broken_at_junction += 1.;
        }
    if (tissue->ties && scene.brick.lamella_strength > 0.)
      {
        const std::vector<std::size_t> now = tissue->ties->break_overloaded(system.particles, system.box);
        for (const std::size_t t : now)
          broken_ties.push_back(double(ring_distance(t)));
        if (!now.empty())
          {
            changed = true;
            system.compute_forces();
          }
      }
    return changed;
  }

  /// Bonds from a tie to the next place where three cells meet.
  std::uint32_t ring_distance(const std::size_t tie) const
  {
    const std::uint32_t node = tissue->ties->all()[tie].a;
    const std::vector<Group> &groups = system.particles.groups;
    const auto after = std::upper_bound(groups.begin(), groups.end(), node,
                                        [](const std::uint32_t i, const Group &g) { return i < g.begin; });
    const std::size_t c = std::size_t(after - groups.begin()) - 1;
    return tissue->to_junction(c, node - groups[c].begin);
  }

  void squeeze(const bool resumed)
  {
    const auto rows = row_columns();
    const auto loading = context.series("loading", {{"time", "s"}, {"strain", ""}, {"force_top", "N"}, {"force_bottom", "N"},
                                                    {"stress_top", "Pa"}, {"stress_bottom", "Pa"}, {"plate_top", "m"},
                                                    {"mean_pressure", "Pa"}, {"potential", "J"}, {"kinetic", "J"}, {"work", "J"},
                                                    {"centre", ""}, {"flattest_cell", ""}, {"stretch_near", ""}, {"stretch", ""},
                                                    {"largest_stretch", ""}, {"failed_cells", ""}, {"broken_bonds", ""}, {"broken_ties", ""},
                                                    {"failed_depth", ""}, {"crossed", ""}});
    const auto by_row = context.series("rows", rows);
    std::unique_ptr<FieldFile> fields;
    if (scene.frames > 0 && context.is_writer())
      fields = std::make_unique<FieldFile>(context.directory(), "cells", resumed);
    const std::uint64_t sample_every = steps_between(load_steps, scene.samples), frame_every = steps_between(load_steps, scene.frames);
    const double area = start.width * scene.cell.depth;
    const auto where = [this] { return "at a strain of " + std::to_string(strain()); };

    const auto record = [&] {
      require_finite(where());
      require_energy(where());
      TissueSample s = measure(*tissue, start);
      s.time = double(step) * dt;
      s.strain = strain();
      s.bottom = plates->force(0);
      s.top = plates->force(1);
      history.push_back(s);
      loading->add_row({s.time, s.strain, s.top, s.bottom, s.top / area, s.bottom / area, (*plates)[1].position, mean_pressure(),
                        system.potential_energy(), system.kinetic_energy(), plates->work(), s.centre, s.flattest, s.stretch_near,
                        s.stretch, s.largest_stretch, s.failed_cells, s.broken_bonds, s.broken_ties, s.failed_depth, double(tissue->fluid->crossed())});
      std::vector<double> row{s.time, s.strain};
      for (const double f : flattening_of_rows(*tissue, start, scene.brick.rows))
        row.push_back(f);
      by_row->add_row(row);
      deepest = std::max(deepest, tissue->contact->deepest(system.particles));
    };
    if (step == 0)
      {
        record();
        if (fields)
          fields->write(frame());
      }
    if (split && !resumed)
      split->compute_forces();
    const StepCheckpoints keep(context, load_steps, scene.checkpoints, [&] { checked_save(where()); }, where);
    while (step < load_steps)
      {
        if (split)
          split->step(dt, scene.damping);
        else
          integrator->step(dt, scene.damping);
        ++step;
        if (processes() && split)
          split->compute_forces();
        if (step % sample_every == 0)
          record();
        if (fields && step % frame_every == 0)
          fields->write(frame());
        if (step % 16 == 0)
          context.progress(double(step) / double(load_steps), "squeezing the tissue");
        keep.after_step(step);
      }
    require_finite(where());
  }

  double strain() const { return (start.high - (*plates)[1].position) / start.height(); }

  std::vector<Column> row_columns() const
  {
    std::vector<Column> columns{{"time", "s"}, {"strain", ""}};
    for (unsigned int r = 0; r < scene.brick.rows; ++r)
      columns.push_back({"row_" + std::to_string(r), ""});
    return columns;
  }

  FieldFrame frame() const
  {
    const Particles<2> &p = system.particles;
    FieldFrame f;
    f.time = double(step) * dt;
    NamedField velocity{"velocity [m/s]", 3, {}, false}, pressure{"pressure [Pa]", 1, {}, false}, wall{"wall [-]", 1, {}, false},
      cell{"cell [-]", 1, {}, false}, failed{"failed [-]", 1, {}, false};
    for (std::size_t c = 0; c < p.groups.size(); ++c)
      for (std::uint32_t i = p.groups[c].begin; i < p.groups[c].end; ++i)
        {
          for (int d = 0; d < 2; ++d)
            {
              f.points.push_back(p.x[d][i]);
              velocity.values.push_back(p.v[d][i]);
            }
          f.points.push_back(0.);
          velocity.values.push_back(0.);
          pressure.values.push_back(p.field("pressure")[i]);
          wall.values.push_back(i < p.groups[c].fluid);
          cell.values.push_back(double(c));
          failed.values.push_back(tissue->damage && tissue->damage->cells[c].failed());
        }
    f.fields = {velocity, pressure, wall, cell, failed};
    return f;
  }

  void report()
  {
    const double area = start.width * scene.cell.depth, degrees = 180. / std::numbers::pi;
    const Particles<2> &p = system.particles;
    context.result("particles", double(p.size()), "");
    context.result("steps", double(inflation_steps + load_steps), "");
    context.result("time_step", dt, "s");
    context.result("inflated_height", start.height(), "m");
    context.result("inflated_width", start.width, "m");
    context.result("void_fraction", void_fraction, "");
    context.result("junction_angle_deviation_inflated", angle_inflated * degrees, "degree");
    context.result("junction_angle_deviation_laid", angle_before * degrees, "degree");
    context.result("junction_angle_deviation_end", tissue->angle_deviation() * degrees, "degree");
    context.result("deepest_overlap", deepest, "m");
    context.result("stress_at_end", history.back().bottom / area, "Pa");
    context.result("modulus_start", slope_between(history, 0.02, 0.06) / area, "Pa");
    context.result("modulus_later", slope_between(history, 0.2, 0.3) / area, "Pa");
    for (const double e : {0.05, 0.1, 0.2, 0.3})
      if (e <= history.back().strain * (1. + 1e-9))
        {
          const std::string at = "_at_" + std::to_string(int(std::lround(100. * e))) + "_percent";
          context.result("transmitted_stress" + at, at_strain(history, &TissueSample::bottom, e) / area, "Pa");
          context.result("impact_stress" + at, at_strain(history, &TissueSample::top, e) / area, "Pa");
          context.result("centre_of_flattening" + at, at_strain(history, &TissueSample::centre, e), "");
          context.result("flattest_cell" + at, at_strain(history, &TissueSample::flattest, e), "");
          context.result("stretch_near_plate" + at, at_strain(history, &TissueSample::stretch_near, e), "");
          context.result("largest_stretch" + at, at_strain(history, &TissueSample::largest_stretch, e), "");
          context.result("mean_stretch" + at, at_strain(history, &TissueSample::stretch, e), "");
        }
    double peak = 0., flat = 0.;
    for (const TissueSample &s : history)
      {
        peak = std::max(peak, s.bottom);
        flat = std::max(flat, s.flattest);
      }
    context.result("transmitted_stress_peak", peak / area, "Pa");
    context.result("flattest_cell_ever", flat, "");
    // a mean over 1/80 of the run: what is faster is ringing of single walls
    context.result("transmitted_oscillation", oscillation(history, std::max<std::size_t>(1, history.size() / 80)), "");
    const double energy = system.potential_energy() + system.kinetic_energy();
    context.result("energy_unaccounted", start_energy + plates->work() - energy, "J"); // dissipated, if nothing fails
    context.result("plate_work", plates->work(), "J");
    if (tissue->flow)
      context.result("largest_permanent_stretch", tissue->flow->largest(), "");
    if (tissue->damage)
      {
        const double cells = double(p.groups.size()), failed = history.back().failed_cells;
        context.result("failed_cells", failed, "");
        context.result("failed_share", failed / cells, "");
        context.result("strain_first_failure", strain_reaching(history, &TissueSample::failed_cells, 1.), "");
        for (const int share : {10, 50, 90})
          context.result("strain_at_" + std::to_string(share) + "_percent_of_failures",
                         strain_reaching(history, &TissueSample::failed_cells, 0.01 * share * failed), "");
        context.result("failed_depth_first", at_strain(history, &TissueSample::failed_depth,
                                                       strain_reaching(history, &TissueSample::failed_cells, 0.25 * failed)), "");
        context.result("failed_depth", history.back().failed_depth, "");
        context.result("broken_bonds", broken_bonds, "");
        context.result("broken_bonds_at_junctions", broken_bonds > 0. ? broken_at_junction / broken_bonds : 0., "");
      }
    if (tissue->ties)
      context.result("largest_tie_stress_inflated", tie_stress, "Pa");
    if (tissue->ties && scene.brick.lamella_strength > 0.)
      {
        const std::size_t n = broken_ties.size(), part = std::max<std::size_t>(1, n / 5);
        const auto mean = [&](const std::size_t from, const std::size_t to) {
          double sum = 0.;
          for (std::size_t k = from; k < to; ++k)
            sum += broken_ties[k];
          return to > from ? sum / double(to - from) * tissue->spacing : 0.;
        };
        context.result("broken_ties", double(n), "");
        context.result("broken_tie_share", double(n) / double(tissue->ties->all().size()), "");
        context.result("strain_first_tie", strain_reaching(history, &TissueSample::broken_ties, 1.), "");
        // peeling: the first fifth breaks near the junctions, the last fifth farther along the walls
        context.result("first_ties_from_junction", mean(0, std::min(n, part)), "m");
        context.result("last_ties_from_junction", mean(n - std::min(n, part), n), "m");
      }
  }

  const TissueLoading &scene;
  RunContext &context;
  std::unique_ptr<BrickTissue> tissue;
  ParticleSystem<2> &system;
  std::optional<WatchedSteps<2>> integrator;
  std::optional<Respa<2>> split; ///< while the plate moves, with Substeps > 1; its step is not watched
  Plates<2> *plates = nullptr;
  std::optional<Failure<2>> failure;
  std::optional<WallYielding<2>> yielding;
  double dt = 0., reach = 0., sound = 0.;
  std::uint64_t inflation_steps = 0;

  // what changes while the scene runs, and is in the checkpoint
  std::uint64_t step = 0, load_steps = 0; ///< load_steps = 0: still inflating
  double angle_before = 0., angle_inflated = 0., void_fraction = 0., tie_stress = 0., start_energy = 0.;
  TissueStart start;
  std::vector<TissueSample> history;
  double broken_bonds = 0., broken_at_junction = 0., deepest = 0.;
  std::vector<double> broken_ties; ///< distance to the next junction (bonds), in the order in which they broke
};

void TissueLoading::run(RunContext &context) { Run(*this, context).go(); }

std::unique_ptr<Scenario> make_tissue_compression()
{
  return std::make_unique<TissueLoading>(TissueLoadingDefaults{
    .description = "Aggregate of turgid cells squeezed slowly between two plates: stress against strain, dense or sparse.",
    .speed = 0.25,
    .damping = 2e4});
}

std::unique_ptr<Scenario> make_tissue_impact()
{
  return std::make_unique<TissueLoading>(TissueLoadingDefaults{
    .description = "Aggregate of turgid cells hit by a plate at 5 m/s: where it deforms, what reaches the other side."});
}

std::unique_ptr<Scenario> make_tissue_failure()
{
  return std::make_unique<TissueLoading>(TissueLoadingDefaults{
    .description = "Impact on an aggregate whose walls and lamella break: which cells fail, when and how deep.",
    .end_strain = 0.5,
    .critical_stretch = 1.1,
    .lamella_strength = 4e6});
}
} // namespace turgor
