// Why cells could not be moved, where it is for their friction, and which entries help: told by what the
// friction is worth beside the stiffness of a contact, which the solver and the stepper below know nothing
// of.
#pragma once

#include <string>

namespace turgor {
struct CultureParameters;

/// A sentence for cells of these parameters; "": their friction is not the cause. not_solved: the equations
/// for the velocities were not; else the steps fell too short. interval: s, between two looks at the cells'
/// life.
std::string friction_advice(const CultureParameters &parameters, bool not_solved, double interval);
}  // namespace turgor
