#include "micro/scenes/matrix/trial_entries.h"

#include "micro/scenes/matrix/protrusion_entries.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"

namespace turgor {
void TrialEntries::declare_matrix(InputEntries &prm) {
  using namespace Patterns;
  MatrixParameters &matrix = trial.matrix;
  prm.add_parameter("Pore size", matrix.pore, "Mean length of the fibres between two nodes. Units: m.",
                    Double(1e-7, 1e-3));
  prm.add_parameter("Side", matrix.side,
                    matrix.repeated
                        ? "Side of the network, of equal periodic pieces of 30 pores at most. Units: m."
                        : "Side of the periodic piece of network, but no more than 30 pores. Units: m.",
                    Double(1e-6, 1e-1));
  prm.add_parameter("Stiffness", matrix.stiffness, "Spring constant k_ECM of the fibres (2.38). Units: N/m.",
                    Double(1e-9, 1e3));
  prm.add_parameter(
      "Stiff side", matrix.stiff_side,
      "Stiffness of the right half of the network (x > 0) over that of the left one; each cell begins "
      "on the border of the two (durotaxis). Units: none.",
      Double(1e-6, 1e6));
  prm.add_parameter("Node radius", matrix.node_radius,
                    "Radius of a node in its contact with a cell. Units: m.", Double(1e-9, 1e-4));
  prm.add_parameter("Node friction", matrix.node_friction,
                    "Friction of a node with the medium (2.37), force over velocity. Units: N s/m.",
                    Double(1e-12, 1e3));
  prm.add_parameter("Anchors", matrix.anchors,
                    "Whether each node is tied to three fixed places above and three below it, a pore away. "
                    "Units: none.",
                    Bool());
  prm.add_parameter(
      "Degradation", trial.protruding.degradation,
      "Rate lambda at which nodes that touch the front of a cell lose their stiffness (2.39); 0: "
      "no degradation. Units: 1/s.",
      Double(0., 1e3));
}

void TrialEntries::declare_search(InputEntries &prm) {
  using namespace Patterns;
  ProtrudingParameters &search = trial.protruding;
  prm.add_parameter("Most", trial.most, "Number N_max of protrusions of a cell at most. Units: none.",
                    Integer(1, 100));
  prm.add_parameter("Reach", search.reach,
                    "Distance l_max of nodes that are reached from the middle of a half sphere. Units: m.",
                    Double(1e-7, 1e-3));
  prm.add_parameter("Waiting time", search.waiting,
                    "Mean time after which a free protrusion tries to take hold. Units: s.",
                    Double(1e-3, 1e9));
  prm.add_parameter(
      "Angle", search.spread,
      "Standard deviation sigma of the angle with the polarity at which nodes are taken (2.40). "
      "Units: rad.",
      Double(1e-3, 1e3));
  prm.add_parameter("Spreading time", search.spreading,
                    "Time for which a round cell takes hold all around before it has a polarity. Units: s.",
                    Double(0., 1e9));
  prm.add_parameter("Patience", search.patience,
                    "Time T_max after which a cell that is stuck lets go and rounds up. Units: s.",
                    Double(1e-3, 1e12));
  prm.add_parameter("Stuck distance", search.stuck,
                    "A cell that has come less far in that time is stuck. Units: m.", Double(0., 1e-3));
}

void TrialEntries::declare(InputEntries &prm) {
  using namespace Patterns;
  trial.cell.declare_motion(prm);
  prm.enter_subsection("Network");
  declare_matrix(prm);
  prm.leave_subsection();
  prm.enter_subsection("Cell");
  trial.cell.declare(prm);
  prm.add_parameter("Law", law, "Contact of the cell with nodes. " + contact_law_text() + ". Units: none.",
                    Selection(contact_law_names()));
  prm.add_parameter("Adhesion", adhesion,
                    "Energy W that an area of contact is worth, of laws with adhesion. Units: J/m^2.",
                    Double(0., 1.));
  prm.leave_subsection();
  prm.enter_subsection("Protrusion");
  declare_protrusion(prm, trial.protrusion);
  declare_search(prm);
  prm.leave_subsection();
}

TrialParameters TrialEntries::parameters() const {
  TrialParameters p = trial;
  p.law = make_contact_law(law, adhesion);
  return p;
}

void TrialEntries::check() const {
  trial.cell.check();
  const MatrixParameters &matrix = trial.matrix;
  if (matrix.side / matrix.pore < 4.)
    throw InputError("Network/Side = " + number_text(matrix.side) + " m holds " +
                     number_text(matrix.side / matrix.pore) + " pores of " + number_text(matrix.pore) +
                     " m: 4 are needed at least.");
  const double colony = colony_places(trial.cells, 2. * trial.cell.radius).back().norm() + trial.cell.radius,
               needed = 2. * (trial.protruding.reach + colony);
  if (matrix.width() * 0.85 < needed)
    throw InputError("The network of " + number_text(matrix.columns() * matrix.pieces()) +
                     " pores across is " + number_text(1e6 * matrix.width()) + " um wide, but " +
                     (trial.cells > 1 ? "the colony" : "a cell") + " reaches " + number_text(0.5e6 * needed) +
                     " um to both sides: a larger Network/Side or Network/Pore size, or a shorter "
                     "Protrusion/Reach.");
  if (trial.protruding.reach < trial.cell.radius)
    throw InputError("Protrusion/Reach (" + number_text(1e6 * trial.protruding.reach) +
                     " um, from the middle of a half sphere) ends inside of the cell of " +
                     number_text(1e6 * trial.cell.radius) + " um.");
  if (matrix.node_radius > 0.4 * matrix.pore)
    throw InputError("Network/Node radius (" + number_text(1e6 * matrix.node_radius) +
                     " um) leaves no gaps between nodes " + number_text(1e6 * matrix.pore) + " um apart.");
  if (const std::string wrong = wrong_adhesion(make_contact_law(law, adhesion), trial.cell.plane_modulus(),
                                               matrix.node_radius, "Network/Node radius");
      !wrong.empty())
    throw InputError(wrong);
}
}  // namespace turgor
