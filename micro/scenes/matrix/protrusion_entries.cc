#include "micro/scenes/matrix/protrusion_entries.h"

#include "run/input_entries.h"

namespace turgor {
namespace {
void declare_bonds(InputEntries &prm, ProtrusionLaw &law) {
  using namespace Patterns;
  prm.add_parameter("Sites", law.sites,
                    "Number of sites for bonds that a focal adhesion gets with each step of the stall force. "
                    "Units: none.",
                    Double(1., 1e6));
  prm.add_parameter("Binding rate", law.binding, "Rate at which a free site binds. Units: 1/s.",
                    Double(1e-6, 1e6));
  prm.add_parameter("Longest bond", law.longest_bond,
                    "Mean lifetime of a catch bond under the force at which it is longest. Units: s.",
                    Double(1e-6, 1e6));
  prm.add_parameter("Best force", law.best_force, "Force on one bond at which it lasts longest. Units: N.",
                    Double(1e-15, 1e-6));
  prm.add_parameter(
      "Force scale", law.force_scale,
      "Change of the force on a bond over which its rate of unbinding changes by a factor e far "
      "from the best force. Units: N.",
      Double(1e-14, 1e-6));
}
}  // namespace

void declare_protrusion(InputEntries &prm, ProtrusionLaw &law) {
  using namespace Patterns;
  prm.add_parameter("Stiffness", law.stiffness, "Spring constant k_pro of a protrusion. Units: N/m.",
                    Double(1e-9, 1e3));
  prm.add_parameter("Speed", law.speed, "Speed v_0 of contraction without load. Units: m/s.",
                    Double(1e-12, 1e-2));
  prm.add_parameter("Stall step", law.stall_step,
                    "First stall force, and by how much it rises after each stall. Units: N.",
                    Double(1e-15, 1e-6));
  prm.add_parameter("Stalled speed", law.stalled,
                    "Speed below which a protrusion has stalled, over that without load. Units: none.",
                    Double(1e-3, 0.5));
  prm.add_parameter("Resting time", law.resting, "Time that a stalled protrusion rests. Units: s.",
                    Double(0., 1e6));
  prm.add_parameter("Work limit", law.work_limit,
                    "Work W_max of a protrusion's contraction (2.41), after which it lets out. Units: J.",
                    Double(1e-24, 1e-6));
  prm.add_parameter("Relaxation time", law.relaxation,
                    "Time in which the force falls by a factor e after that, between held ends. Units: s.",
                    Double(1e-3, 1e9));
  prm.add_parameter("Lifetime", law.lifetime, "Time T_pro after which a protrusion lets go. Units: s.",
                    Double(1e-3, 1e9));
  declare_bonds(prm, law);
}
}  // namespace turgor
