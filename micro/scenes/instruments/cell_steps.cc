#include "micro/scenes/instruments/cell_steps.h"

#include "micro/laws/counter_random.h"
#include "run/cpu_clock.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/end_in_sight.h"
#include "run/judged.h"
#include "run/stop_flag.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace turgor {
namespace {
constexpr std::array<OverdampedMethod, 3> methods{OverdampedMethod::euler, OverdampedMethod::heun,
                                                  OverdampedMethod::implicit};
constexpr std::array<const char *, 3> method_names{"euler", "heun", "implicit"};
}  // namespace

void CellSteps::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Cells", count,
                    "Number of cells in the ball at the start, before pairs replace some. Units: none.",
                    Integer(2, 1000000));
  prm.add_parameter("End time", duration,
                    "Simulated time over which the ball relaxes in every run. Units: s.", Double(1e-9, 1e12));
  prm.rename("Duration", "End time");
  prm.add_parameter(
      "Newborn share", newborn,
      "Share of the cells that are replaced by a pair of daughters a fifth of a radius apart. Units: none.",
      Double(0., 1.));
  prm.add_parameter("Compression", compression,
                    "Volume of the ball at rest over that at the start. Units: none.", Double(0.1, 1000.));
  prm.add_parameter("Stiffer", stiffer, "Factor on Modulus: cells that are that much stiffer. Units: none.",
                    Double(1e-6, 1e9));
  prm.add_parameter("Less friction", less_friction,
                    "Divisor of Cell friction and Medium friction: motion that much faster. Units: none.",
                    Double(1e-6, 1e9));
  prm.add_parameter("Radius", radius, "Radius of a cell that is not a daughter. Units: m.", Double(1e-9, 1.));
  prm.add_parameter("Modulus", modulus,
                    "Plane modulus E/(1 - nu^2) of a cell where it touches others. Units: Pa.",
                    Double(1e-3, 1e12));
  prm.add_parameter(
      "Cell friction", pair_friction,
      "Friction between two cells in any direction: force over velocity and area of contact. Units: N s/m^3.",
      Double(0., 1e20));
  prm.add_parameter(
      "Medium friction", medium_friction,
      "Friction of a cell with the medium: force over velocity and surface 4 pi R^2. Units: N s/m^3.",
      Double(1e-3, 1e20));
  prm.add_parameter("Halvings", halvings,
                    "How often the fixed step, at first End time, is halved at most. Units: none.",
                    Integer(1, 24));
  prm.add_parameter(
      "Reference tolerance", tightest,
      "Allowed error of a step of the reference run (heun, adaptive), over Radius. Units: none.",
      Double(1e-9, 0.1));
}

void CellSteps::check() const {
  if (newborn > 0. && count * newborn < 1.)
    throw InputError("Newborn share is " + number_text(newborn) + ", but of " + number_text(count) +
                     " Cells that is less than one: use a larger share, or 0.");
}

Particles<3> CellSteps::start() const {
  const int reach = int(std::cbrt(double(count))) + 2;
  std::vector<std::array<int, 4>> sites;
  for (int z = -reach; z <= reach; ++z)
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x)
        if ((x + y + z) % 2 == 0) sites.push_back({x * x + y * y + z * z, x, y, z});
  std::sort(sites.begin(), sites.end());
  const double unit = 2. * radius / std::sqrt(2.) / std::cbrt(compression);
  std::vector<Vector<3>> places;
  std::vector<double> radii;
  for (std::size_t i = 0; i < count; ++i) {
    Vector<3> x(sites[i][1], sites[i][2], sites[i][3]), direction;
    for (int d = 0; d < 3; ++d) {
      x[d] = unit * (x[d] + 0.05 * (random_uniform(1, 6 * i + std::size_t(d)) - 0.5));
      direction[d] = random_uniform(1, 6 * i + 3 + std::size_t(d)) - 0.5;
    }
    if (double(i + 1) * newborn >= std::floor(double(i) * newborn) + 1.) {
      for (const double side : {-0.1, 0.1}) {
        places.push_back(x + side * radius * direction.normalized());
        radii.push_back(radius * std::cbrt(0.5));
      }
    } else {
      places.push_back(x);
      radii.push_back(radius);
    }
  }
  Particles<3> cells;
  cells.resize(places.size());
  cells.groups = {{0, 0, std::uint32_t(places.size())}};
  cells.declare("radius");
  cells.declare("modulus");
  cells.field("radius") = radii;
  cells.field("modulus").assign(places.size(), modulus * stiffer);
  for (std::size_t i = 0; i < places.size(); ++i)
    for (int d = 0; d < 3; ++d) cells.x[d][i] = places[i][d];
  return cells;
}

CellSteps::Outcome CellSteps::relax(const OverdampedMethod method, const double tolerance, const double step,
                                    RunContext &context) const {
  Outcome result;
  ParticleSystem<3> system;
  system.particles = start();
  system.threads = context.threads();
  const double between = pair_friction / less_friction;  // N s/m^3
  system.add(std::make_unique<SphereContacts>(HertzContact(), 0.2 * radius)).friction = {
      .normal = between, .tangential = between};
  SystemMotion<3> motion(system, {.tolerance = 1e-7, .max_iterations = 5000});
  Overdamped<3> stepper({.method = method,
                         .tolerance = step > 0. ? 1e12 : tolerance,
                         .first_step = step > 0. ? step : 1e-6,
                         .least_step = 1e-12,
                         .longest_step = step > 0. ? step : 1e9,
                         .longest_move = step > 0. ? HUGE_VAL : 1.},
                        motion, context.threads());
  for (const double R : system.particles.field("radius"))
    motion.medium.push_back(4. * std::numbers::pi * R * R * medium_friction / less_friction);
  const double begin = process_cpu_seconds();
  EndInSight sight;
  try {
    for (double t = 0.; t < duration * (1. - 1e-12); ++result.steps) {
      t += stepper.step(system.particles, duration - t);
      stop_here("during one of the runs");
      if (const std::string far = sight.after_step(t / duration); !far.empty())
        remarked(context, "no_end_in_sight",
                 "in one of the runs, at t = " + number_text(t) + " s, " + far +
                     ". A smaller End time, a smaller Stiffer or a larger Reference tolerance helps.");
    }
    result.ended = true;
  } catch (const RunStopped &) {
    throw;
  } catch (const std::runtime_error &failure) {
    result.sentence = failure.what();
  }
  result.cpu = process_cpu_seconds() - begin;
  result.cells = system.particles;
  return result;
}

double CellSteps::error(const Outcome &outcome, const Outcome &reference) const {
  double sum = 0.;
  for (int d = 0; d < 3; ++d)
    for (std::size_t i = 0; i < reference.cells.size(); ++i)
      sum += std::pow(outcome.cells.x[d][i] - reference.cells.x[d][i], 2);
  return std::sqrt(sum / double(reference.cells.size())) / radius;
}

void CellSteps::run(RunContext &context) {
  const auto table = context.series("steps", {{"method", ""},
                                              {"adaptive", ""},
                                              {"time_step", "s"},
                                              {"tolerance", "1"},
                                              {"error", "1"},
                                              {"cpu_time", "s"},
                                              {"steps", ""},
                                              {"stable", ""}});
  context.active({"hertz_contact", pair_friction > 0. ? "cell_friction" : "medium_friction"},
                 start().field_names());
  const Outcome reference = relax(OverdampedMethod::heun, tightest, 0., context);
  if (!reference.ended) throw RunFailed("the reference did not reach the end: " + reference.sentence);
  const Particles<3> first = start();
  double largest_move = 0.;
  for (std::size_t i = 0; i < first.size(); ++i)
    largest_move = std::max(largest_move, (reference.cells.position(i) - first.position(i)).norm());
  context.result("cells", double(first.size()), "");
  context.result("largest_displacement_over_radius", largest_move / radius, "1");
  context.result("reference_cpu_time", reference.cpu, "s");
  for (std::size_t m = 0; m < methods.size(); ++m) {
    double stable_step = 0., stable_error = 0., fewest = 0.;
    for (unsigned int k = 0; k <= halvings; ++k) {
      if (context.stop_requested()) throw RunStopped("stopped between two runs");
      context.progress((double(m) + double(k) / (halvings + 1.)) / 3., method_names[m]);
      const double step = duration / std::exp2(k);
      const Outcome run = relax(methods[m], 0., step, context);
      const double e = run.ended ? error(run, reference) : 0.;
      const bool stable = run.ended && e < 0.1;
      table->add_row({double(m), 0., step, 0., e, run.cpu, double(run.steps), double(stable)});
      if (stable && stable_step == 0.) {
        stable_step = step;
        stable_error = e;
        fewest = run.cpu;
      }
      if (stable && e < 3. * tightest) break;
    }
    const std::string name = method_names[m];
    if (stable_step > 0.) {
      context.result("longest_stable_step_" + name, stable_step, "s");
      context.result("error_at_it_" + name, stable_error, "1");
      context.result("cpu_time_at_it_" + name, fewest, "s");
    }
    for (const double tolerance : {3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4}) {
      const Outcome run = relax(methods[m], tolerance, 0., context);
      table->add_row({double(m), 1., run.steps > 0 ? duration / double(run.steps) : 0., tolerance,
                      run.ended ? error(run, reference) : 0., run.cpu, double(run.steps), double(run.ended)});
      if (tolerance == 1e-3 && run.ended) {
        context.result("adaptive_error_" + name, error(run, reference), "1");
        context.result("adaptive_cpu_time_" + name, run.cpu, "s");
      }
    }
  }
}

std::unique_ptr<Scenario> make_cell_steps() { return std::make_unique<CellSteps>(); }
}  // namespace turgor
