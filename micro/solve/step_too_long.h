// What a step throws that led where forces or velocities are not defined any more: a cell's centre behind a
// wall, centres that coincide, a friction matrix that is not solved. Where it came of a trial that can be
// taken back (heun's x + h v, an implicit step's matrix) the stepper tries a shorter one; where a step has
// been accepted that led there, the run fails with the sentence.
#pragma once

#include <stdexcept>

namespace turgor {
struct StepTooLong : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The matrix of motion was not solved: an implicit step is too long for the stiffness of its contacts, or
/// there is too little friction.
struct NotSolved : StepTooLong {
  using StepTooLong::StepTooLong;
};

/// Nor will it be by a shorter step: forces or friction are no finite numbers.
struct NoNumbers : NotSolved {
  using NotSolved::NotSolved;
};
}  // namespace turgor
