#include "micro/scenes/deformable/rbc_tweezers.h"

#include "run/csv_text.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/word_or_file.h"

#include <cmath>

namespace turgor {
void RbcTweezers::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter(
      "Forces", forces,
      "Forces F at each end at which the diameters are measured, one after another and rising. Units: N.",
      List(Double(0., 1e-6), 1, 200));
  prm.add_parameter("Ramp time", ramp,
                    "Time in which the force rises from one of Forces to the next. Units: s.",
                    Double(1e-6, 1e6));
  prm.add_parameter("Hold time", hold,
                    "Time for which each force is held before the diameters are measured. Units: s.",
                    Double(0., 1e6));
  prm.add_parameter("Pulled share", pulled,
                    "Share of the nodes that is pulled at each end, the outermost ones. Units: none.",
                    Double(1e-4, 0.4));
  prm.add_parameter("Experiment", experiment,
                    "none, or a file with measured diameters: force_pN, then mean, low, high of the axial "
                    "and of the transverse diameter in um."
                    " Units: none.",
                    WordOrFile("none"));
  material.declare_steps(prm, "half the diameter");
  prm.add_parameter("Samples", samples,
                    "Number of rows of history.csv at least, spread evenly over time. Units: none.",
                    Integer(1, 100000));
  prm.add_parameter(
      "Fields", fields,
      "Whether the surface is written at each of Forces, for pictures and ParaView. Units: none.", Bool());
  prm.enter_subsection("Cell");
  material.declare_cell(prm, " of half the diameter");
  prm.add_parameter("Diameter", diameter, "Diameter of the disc at rest. Units: m.", Double(1e-7, 1e-4));
  prm.add_parameter("Shear modulus", shear_modulus,
                    "Shear modulus of the net at rest, per length. Units: N/m.", Double(1e-9, 1.));
  prm.add_parameter(
      "Largest stretch", largest_stretch,
      "Length at which an edge cannot be stretched any further, over its length at rest. Units: none.",
      Double(1.05, 20.));
  prm.add_parameter("Bending rigidity", rigidity,
                    "Bending rigidity of the membrane; hinges have 2/sqrt(3) of it. Units: J.",
                    Double(0., 1e-12));
  prm.add_parameter(
      "Local area modulus", local_area,
      "Resistance of each triangle against a change of its area, beside that of its edges. Units: N/m.",
      Double(0., 1.));
  prm.add_parameter("Whole area modulus", whole_area,
                    "Resistance of the whole surface against a change of its area. Units: N/m.",
                    Double(0., 1.));
  prm.add_parameter("Cortex viscosity", cortex_viscosity,
                    "Shear viscosity of the membrane, per length; each edge has a dashpot of 4/sqrt(3) of "
                    "it. Units: N s/m.",
                    Double(0., 1.));
  prm.leave_subsection();
}

void RbcTweezers::check() const {
  for (std::size_t k = 0; k < forces.size(); ++k)
    if (!(forces[k] > (k > 0 ? forces[k - 1] : 0.)))
      throw InputError("Forces have to be positive and rising, but number " + number_text(k + 1) + " is " +
                       number_text(forces[k]) + " N.");
  experiment_points();
}

std::vector<RbcTweezers::Measured> RbcTweezers::experiment_points() const {
  std::vector<Measured> points;
  if (experiment == "none") return points;
  const CsvText table(experiment);
  for (const CsvRow &row : table.rows) {
    table.require_fields(row, 7);
    Measured point;
    point.force = 1e-12 * table.number(row, 0);
    for (int which = 0; which < 2; ++which) {
      const auto length = [&](const int k) {
        return 1e-6 * table.number(row, std::size_t(1 + 3 * which + k));
      };
      point.mean[which] = length(0);
      const bool range = !row.fields[std::size_t(2 + 3 * which)].empty();
      point.low[which] = range ? length(1) : 1.;
      point.high[which] = range ? length(2) : 0.;
    }
    points.push_back(point);
  }
  return points;
}

DeformableCellParameters<FeneSpring> RbcTweezers::cell() const {
  DeformableCellParameters<FeneSpring> p;
  static_cast<DeformableMaterial &>(p) = material;
  p.spring = FeneSpring::of_net(shear_modulus, 1. / largest_stretch);
  p.dashpots = 4. / std::sqrt(3.) * cortex_viscosity;
  p.bending = 2. / std::sqrt(3.) * rigidity;
  p.area = {.local = local_area, .whole = whole_area};
  p.radius = 0.5 * diameter;
  p.first_step = 1e-3 * ramp;
  return p;
}
}  // namespace turgor
