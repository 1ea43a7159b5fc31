// What a step throws that led where forces or velocities are not defined any more: a cell's centre behind a wall, centres that coincide, a
// friction matrix that is not solved. A stepper takes such a step back and tries a shorter one; where there is none to take back, the run
// fails with the sentence.
#pragma once

#include <stdexcept>

namespace turgor
{
struct StepTooLong : std::runtime_error
{
  using std::runtime_error::runtime_error;
};
} // namespace turgor
