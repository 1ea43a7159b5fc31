#include "micro/scenes/spheroid/spheroid_entries.h"

#include "micro/scenes/life_entries.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/user_text.h"
#include "run/word_or_file.h"

#include <cmath>

namespace turgor {
namespace {
Vector<3> vector_of(const std::string &text, const std::string &entry) {
  const std::vector<double> values = read_numbers(text, 3, entry, "x, y, z");
  return {values[0], values[1], values[2]};
}
}  // namespace

void CultureEntries::step_coarsely() {
  numbers.motion.method = OverdampedMethod::implicit;
  numbers.motion.tolerance = 1e-2;
  numbers.motion.mean_error = true;
  numbers.growth_tolerance = 1e-2;
  numbers.solve.tolerance = 1e-4;
}

void CultureEntries::declare_cell(InputEntries &prm) {
  using namespace Patterns;
  CellLifeParameters &life = numbers.life;
  prm.enter_subsection("Cell");
  prm.add_parameter(
      "Birth radius", life.birth_radius,
      "Radius of a newborn cell without pressure on it; it divides at twice the volume. Units: m.",
      Double(1e-9, 1.));
  prm.add_parameter("Cycle time", life.cycle_time,
                    "Mean time T from birth to division of uncompressed cells, mitosis included. Units: s.",
                    Double(1., 1e12));
  prm.add_parameter("Modulus", life.modulus,
                    "Mean Young's modulus E of the cells where they touch. Units: Pa.", Double(1e-3, 1e12));
  prm.add_parameter("Poisson ratio", life.poisson,
                    "Poisson ratio of the cells where they touch. Units: none.", Double(0., 0.5));
  prm.add_parameter("Bulk modulus", life.bulk_modulus,
                    "Mean bulk modulus K_0 of a cell without pressure on it (C.1). Units: Pa.",
                    Double(1e-3, 1e12));
  prm.add_parameter("Strain hardening", life.volume.hardening,
                    "Whether cells harden as they are compressed, K = K_0 V_ref/V (C.2); else K = K_0. "
                    "Units: true or false.",
                    Bool());
  prm.add_parameter("Relaxation time", life.relaxation,
                    "Time T_rel in which a cell's volume follows its pressure (C.3); 0: at once. Units: s.",
                    Double(0., 1e12));
  prm.add_parameter(
      "Variability", life.variability.spread,
      "Standard deviation over the mean of T, E, K_0, T_lys and p_th, clamped at 4 of them. Units: none.",
      Double(0., 0.24));
  prm.add_parameter("Seed", seed,
                    "Seed of all that is drawn at random: another one, another run. Units: none.",
                    Double(0., 1e15));
  prm.leave_subsection();
}

void CultureEntries::declare_contact(InputEntries &prm) {
  using namespace Patterns;
  prm.enter_subsection("Contact");
  prm.add_parameter("Law", numbers.law, "Contact law of two cells. " + contact_law_text() + ". Units: none.",
                    Selection(contact_law_names()));
  prm.add_parameter("Adhesion", numbers.adhesion,
                    "Energy of adhesion W per area of contact between two cells; without effect with Law = "
                    "hertz. Units: J/m^2.",
                    Double(0., 1e3));
  prm.add_parameter(
      "Local stiffness", stiffness,
      "Rise of the modulus with the packing: none, closest (derived: cells of a closest packing fill all "
      "space and have the"
      " pressure of their volume), C9 (the thesis's, as errata repairs it; refuted: under it the space "
      "between cells grows"
      " with the pressure), B19 or the name of a CSV file with a monotone table or polynomial. Units: none.",
      WordOrFile("none|closest|C9|B19"));
  prm.add_parameter("Compression", numbers.compression,
                    "What the local stiffness goes by: the mean compression of each cell, or that of each "
                    "contact, whose force is then"
                    " the slope of an energy. Units: none.");
  prm.add_parameter("Normal friction", numbers.friction.normal,
                    "Friction between two cells that move along the line of their centres: force over "
                    "velocity and area of contact. Units: N s/m^3.",
                    Double(0., 1e20));
  prm.add_parameter("Tangential friction", numbers.friction.tangential,
                    "Friction between two cells that slide along each other: force over velocity and area of "
                    "contact. Units: N s/m^3.",
                    Double(0., 1e20));
  prm.add_parameter("Medium friction", numbers.medium_friction,
                    "Friction of a cell with the medium or matrix around it: force over velocity and surface "
                    "4 pi R^2. Units: N s/m^3.",
                    Double(1e-3, 1e20));
  prm.leave_subsection();
}

void CultureEntries::declare_growth(InputEntries &prm) {
  prm.enter_subsection("Growth");
  turgor::declare_growth(prm, numbers.life.growth, numbers.life.cycle);
  prm.leave_subsection();
}

void CultureEntries::declare_division(InputEntries &prm) {
  using namespace Patterns;
  CellDivision &division = numbers.life.division;
  prm.enter_subsection("Division");
  declare_direction(prm, division, axis);
  prm.add_parameter("Distance", division.least_energy,
                    "How far apart daughters are laid: inside the mother's sphere, or where their contact "
                    "has least_energy. Units: none.",
                    Selection("inside|least_energy"));
  prm.leave_subsection();
}

void CultureEntries::declare_death(InputEntries &prm) {
  using namespace Patterns;
  CellLifeParameters &life = numbers.life;
  prm.enter_subsection("Death");
  prm.add_parameter(
      "Rim", life.death.rim,
      "What happens below the viable rim: none, quiescent (Model II) or necrotic (Model I). Units: none.");
  prm.add_parameter("Rim thickness", life.death.rim_thickness,
                    "Depth lambda (counted as Rim from says) to which nutrients reach: what is deeper rests "
                    "or dies; with Rim = none without effect. Units: m.",
                    Double(0., 1.));
  prm.add_parameter("Rim from", life.death.from,
                    "What the depth of a cell in the rim counts from: surface (the nearest outer cell or "
                    "wall) or edge (the thesis's mean edge of the whole"
                    " spheroid, under which whatever stands out runs ahead). Units: none.");
  prm.add_parameter("Necrosis pressure", life.death.necrosis_pressure,
                    "Mean of the pressure p_th above which a cell deeper than the rim dies, with Rim = "
                    "necrotic. Units: Pa.",
                    Double(0., 1e12));
  prm.add_parameter("Lysis time", life.death.lysis_time,
                    "Mean of the time T_lys in which a dead cell's fluid drains. Units: s.",
                    Double(1., 1e12));
  prm.add_parameter("Solid fraction", life.death.solid_fraction,
                    "Share phi of a cell's volume at death that is solid and does not drain. Units: none.",
                    Double(0.01, 1.));
  prm.add_parameter("Lysis", life.death.linear,
                    "How a dead cell's volume falls to its solid part: delayed, exponentially (C.1.3), or "
                    "linear in time (2.12). Units: none.",
                    Selection("delayed|linear"));
  prm.add_parameter("Remove lysed", life.death.remove,
                    "Whether the remains of lysed cells are taken away (as in a living body); else they stay "
                    "(in vitro). Units: true or false.",
                    Bool());
  prm.leave_subsection();
}

void CultureEntries::declare_motion(InputEntries &prm) {
  using namespace Patterns;
  prm.enter_subsection("Motion");
  prm.add_parameter("Method", numbers.motion.method,
                    "Steps of the cells' motion: euler (explicit, first order), heun (explicit, second "
                    "order) or implicit (first order, long steps). Units: none.");
  prm.add_parameter("Tolerance", numbers.motion.tolerance,
                    "Allowed error of a cell's place in one step over the mean radius; decides the length of "
                    "steps. Units: none.",
                    Double(1e-9, 1.));
  prm.add_parameter(
      "Motility", numbers.motility,
      "Diffusion coefficient D of a lone cell's random motion in the medium; 0: none. Units: m^2/s.",
      Double(0., 1.));
  prm.add_parameter(
      "Migration force", numbers.migration.force,
      "Force F_0 with which cells crawl along their polarity (2.10); 0: they do not crawl. Units: N.",
      Double(0., 1.));
  prm.add_parameter("Persistence time", numbers.migration.persistence,
                    "Time tau in which a cell's polarity is forgotten; with Migration force > 0. Units: s.",
                    Double(1e-3, 1e12));
  prm.add_parameter(
      "Preferred direction", preferred,
      "P_0, the mean of the polarity, whose components scatter by 1/sqrt(3): x, y, z. Units: none.",
      List(Double(-1e6, 1e6), 3, 3, ","));
  prm.add_parameter("Mean error", numbers.motion.mean_error,
                    "Whether Tolerance is for the root mean square error of all cells; else for the largest "
                    "error. Units: true or false.",
                    Bool());
  prm.add_parameter("Growth tolerance", numbers.growth_tolerance,
                    "Largest growth of a cell's radius between two looks at the cells' life, over the "
                    "radius; decides their interval. Units: none.",
                    Double(1e-6, 0.1));
  prm.add_parameter(
      "Solver tolerance", numbers.solve.tolerance,
      "Allowed residual of the equations for the velocities, over the norm of the forces. Units: none.",
      Double(1e-14, 0.1));
  prm.leave_subsection();
}

void CultureEntries::declare(InputEntries &prm) {
  declare_cell(prm);
  declare_contact(prm);
  declare_growth(prm);
  declare_division(prm);
  declare_death(prm);
  declare_motion(prm);
}

void CultureEntries::check() const {
  const CellLifeParameters &life = numbers.life;
  try {
    parameters();
  } catch (const InputError &error) {
    throw InputError("Contact/Local stiffness: " + std::string(error.what()));
  } catch (const std::invalid_argument &error) {
    throw InputError("Contact/Local stiffness is " + stiffness + ": " + error.what());
  }
  if (const std::string wrong =
          wrong_adhesion(contact_law(numbers), life.modulus, life.birth_radius, "Birth radius");
      !wrong.empty())
    throw InputError("Contact/" + wrong);
  check_mitosis(life.cycle, life.cycle_time);
  check_direction(life.division, axis);
  if (seed != std::floor(seed))
    throw InputError("Cell/Seed is " + number_text(seed) + ", but has to be a whole number.");
  if (in_plane && parameters().migration.preferred[2] != 0.)
    throw InputError("Motion/Preferred direction is " + preferred +
                     ", but cells of a monolayer crawl in its plane: x, y, 0.");
}

CultureParameters CultureEntries::parameters() const {
  CultureParameters result = numbers;
  CellLifeParameters &life = result.life;
  life.division.axis = division_axis(axis);
  result.migration.preferred = vector_of(preferred, "Motion/Preferred direction");
  result.in_plane = in_plane;
  life.division.seed = life.variability.seed = std::uint64_t(seed);
  if (stiffness == "C9")
    result.stiffness = LocalStiffness::repaired_C9();
  else if (stiffness == "B19")
    result.stiffness = LocalStiffness(0., {life.modulus, 0., 0., 0., 4e6}, HUGE_VAL);
  else if (stiffness == "closest")
    result.stiffness =
        LocalStiffness::closest_packing(life.modulus, life.poisson, life.bulk_modulus, life.volume.hardening);
  else if (stiffness != "none")
    result.stiffness = LocalStiffness::from_file(stiffness);
  return result;
}
}  // namespace turgor
