#include "micro/scenes/single_cell/shell_oscillation.h"

#include "micro/scenes/single_cell/shell_run.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/judged.h"
#include "micro/scenes/shared_entries.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <complex>
#include <numbers>

namespace turgor {
namespace {
constexpr double pi = std::numbers::pi;

/// Amplitude of a signal's Hann-windowed mean-free part at omega (rad/s).
double amplitude(const std::vector<double> &time, const std::vector<double> &signal, const double omega) {
  double mean = 0.;
  for (const double s : signal) mean += s / double(signal.size());
  std::complex<double> sum = 0.;
  for (std::size_t k = 0; k < signal.size(); ++k) {
    const double window = 0.5 - 0.5 * std::cos(2. * pi * (k + 0.5) / double(signal.size()));
    sum += window * (signal[k] - mean) * std::polar(1., -omega * time[k]);
  }
  return 4. * std::abs(sum) / double(signal.size());
}

/// Spectrum on a grid four times as fine as the window's resolution, for the picture. last_mode: rad/s.
void write_spectrum(RunContext &context, const std::vector<double> &time, const std::vector<double> &moving,
                    const double last_mode) {
  const double fine = 2. * pi / time.back() / 4., highest = 1.2 * last_mode + 40. * fine;
  const auto spectrum = context.series("spectrum", {{"frequency", "Hz"}, {"amplitude", "m/s"}});
  for (std::size_t k = 0; k * fine < highest; ++k)
    spectrum->add_row({k * fine / (2. * pi), amplitude(time, moving, k * fine)});
}
}  // namespace

void ShellOscillation::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter(
      "Filled", filled,
      "Whether the shell is filled with liquid (A.2); else it is empty (A.3). Units: true or false.", Bool());
  prm.add_parameter("Sound speed", sound_speed,
                    "Speed of sound c of the liquid; Cell/Fluid modulus is then rho c^2/7, whatever is set "
                    "there. Units: m/s.",
                    Double(1., 5000.));
  prm.add_parameter("Inward speed", speed,
                    "Speed of all wall nodes towards the centre at the start. Units: m/s.",
                    Double(1e-6, 10.));
  prm.add_parameter(
      "Struck", all_struck,
      "wall: only its nodes move at the start (thesis A.1); most of that stays in tones of the wall above "
      "all that the "
      "liquid's particles carry. whole: the liquid moves with it in proportion to the radius. Units: none.",
      Selection("wall|whole"));
  prm.add_parameter("Periods", periods,
                    "Length of the run in periods of the lowest closed form. Units: none.",
                    Double(4., 10000.));
  prm.add_parameter("Samples per period", samples_per_period,
                    "Rows of radius.csv in each period of the lowest closed form. Units: none.",
                    Integer(20, 100000));
  prm.add_parameter(
      "Modes", modes,
      "Number of closed-form modes, from the lowest, that are looked for in the motion. Units: none.",
      Integer(1, 20));
  prm.add_parameter("Harmonics", fitted,
                    "Largest number of decaying cosines that are fitted to the radial speed. Units: none.",
                    Integer(1, 60));
  declare_step_fraction(prm, step_fraction);
  declare_checkpoints(prm, checkpoints);
  prm.enter_subsection("Cell");
  cell.add_parameters(prm);
  prm.leave_subsection();
}

RoundCellParameters ShellOscillation::shell() const {
  RoundCellParameters p = cell;
  p.turgor = 0.;  // closed forms are about a stress-free start
  p.fluid = filled ? CellFilling::sph : CellFilling::none;
  p.fluid_modulus = p.fluid_density * sound_speed * sound_speed / 7.;
  // The liquid has to carry tension: no cavitation in a linear wave. -K is where Eq. 2.22 ends.
  p.cavitation_pressure = -0.5 * p.fluid_modulus;
  return p;
}

void ShellOscillation::check() const {
  shell().check(3);
  if (periods * samples_per_period < 6. * fitted + 4.)
    throw std::invalid_argument(
        "Harmonics is " + number_text(fitted) +
        ", but Periods times Samples per period has to be at least 6 times as many and 4.");
  if (filled && speed > 0.02 * sound_speed)
    throw std::invalid_argument(
        "Inward speed is " + number_text(speed) +
        ", but has to be at most a fiftieth of Sound speed (m/s): the closed forms are linear.");
}

std::vector<double> ShellOscillation::closed_form(const RoundCellParameters &p, const double R,
                                                  const double c, const unsigned int count) {
  const double E_t = 3. * p.wall_stiffness, shell_mass = p.wall_density * p.wall_thickness;  // per area
  if (p.fluid == CellFilling::none) return {std::sqrt(4. * E_t / shell_mass) / R};
  // Multiplied by j1(q) q^2, which takes the poles away and keeps the roots: (with s, k of q)
  //   q sin q . q - ...: j0 = sin q/q, j1 = sin q/q^2 - cos q/q
  const auto f = [&](const double q) {
    const double j0 = std::sin(q) / q, j1 = std::sin(q) / (q * q) - std::cos(q) / q;
    return j0 + j1 * (4. * E_t / (q * p.fluid_density * c * c * R) - q * shell_mass / (p.fluid_density * R));
  };
  std::vector<double> roots;
  const double step = 0.01;
  for (double q = 0.02; roots.size() < count && q < 200.; q += step)
    if (f(q) * f(q + step) < 0.) {
      std::uintmax_t iterations = 100;
      const auto bracket = boost::math::tools::toms748_solve(
          f, q, q + step, boost::math::tools::eps_tolerance<double>(48), iterations);
      roots.push_back(0.5 * (bracket.first + bracket.second) * c / R);
    }
  return roots;
}

void ShellOscillation::compare(RunContext &context, const std::vector<Harmonic> &parts,
                               const std::vector<double> &theory, const double R) const {
  const auto lines = context.series("modes", {{"closed_form", "Hz"}, {"found", "Hz"}, {"deviation", "%"}});
  const RoundCellParameters p = shell();
  // The roots beyond the last one that is asked for, and the middle between two of them: what lies nearer to
  // a root belongs to it.
  std::vector<double> next = theory;
  next.push_back(p.fluid == CellFilling::none ? 2. * theory.back()
                                              : closed_form(p, R, sound_speed, modes + 1).back());
  for (std::size_t m = 0; m < theory.size(); ++m) {
    const double below = m == 0 ? 0.5 * theory[0] : 0.5 * (theory[m - 1] + theory[m]);
    const Harmonic part = largest_between(parts, below, 0.5 * (theory[m] + next[m + 1]));
    const std::string name = "mode_" + number_text(m + 1);
    context.result(name + "_closed_form", theory[m] / (2. * pi), "Hz");
    if (part.omega == 0.) {  // not excited, or not carried by the fluid's resolution
      remarked(
          context, name,
          "No tone that lasts is found near the closed form's " + number_text(theory[m] / (2. * pi)) +
              " Hz of mode " + number_text(m + 1) +
              ", so that it has no result: it was not struck hard enough, or the particles do not carry it.");
      continue;
    }
    const double deviation = 100. * (part.omega / theory[m] - 1.);
    lines->add_row({theory[m] / (2. * pi), part.omega / (2. * pi), deviation});
    context.result(name + "_found", part.omega / (2. * pi), "Hz");
    context.result(name + "_deviation", deviation, "%");
    context.result(name + "_amplitude", part.amplitude, "m/s");
    context.result(name + "_decay", 2. * pi * part.decay / part.omega, "1/period");
  }
}

void ShellOscillation::run(RunContext &context) {
  const RoundCellParameters p = shell();
  ShellRun shell_run(p, {.speed = speed,
                         .all_struck = all_struck,
                         .periods = periods,
                         .step_fraction = step_fraction,
                         .samples_per_period = samples_per_period,
                         .checkpoints = checkpoints});
  std::vector<double> theory;
  const ShellMotion &motion = shell_run.go(context, [&](const double radius) {
    theory = closed_form(p, radius, sound_speed, modes);
    return theory.front();
  });
  const double R = motion.rest_radius;
  write_spectrum(context, motion.time, motion.speed, theory.back());
  const std::vector<Harmonic> parts = harmonics(motion.speed, motion.sampling, fitted);
  const auto found =
      context.series("harmonics", {{"frequency", "Hz"}, {"decay", "1/s"}, {"amplitude", "m/s"}});
  for (const Harmonic &part : parts) found->add_row({part.omega / (2. * pi), part.decay, part.amplitude});
  context.result("radius", R, "m");
  context.result("energy_drift", motion.energy_drift, "1");
  if (filled) context.result("most_crossed", motion.crossed, "");
  compare(context, parts, theory, R);
  judge_outside(context, motion.crossed, shell_run.fluid_particles(),
                "more Cell/Fluid particles or a smaller Inward speed makes them fewer");
}

std::unique_ptr<Scenario> make_shell_oscillation() { return std::make_unique<ShellOscillation>(); }
}  // namespace turgor
