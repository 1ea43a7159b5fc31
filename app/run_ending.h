// How a run ends: one code, one status and one sentence, whatever was thrown, and the same on every rank.
//   0 finished, 1 the run failed, 2 wrong input, 130 stopped.
//
//   Ending ending = ending_of([&] { scene.run(directory); });
//   agree_on_ending(ending, mpi);
#pragma once

#include <functional>
#include <string>

namespace turgor {
class MpiSession;

struct Ending {
  int code = 0;
  std::string status = "finished", message;
  bool output_failed =
      false;  ///< the results could not be written; the run itself may go on from its checkpoint
};

/// Does it, and says how it ended. Throws nothing.
Ending ending_of(const std::function<void()> &action);

/// An exception as a sentence: file systems' and libraries' own words are replaced by ours.
std::string words_of(const std::exception &problem);

/// Exit code for it: 2 for a name that no file can have, which is wrong input; else 1.
int code_of(const std::exception &problem);

/// With ranks, a collective call at a run's end: the ending of the worst rank becomes everybody's. True if
/// all ranks came to it; false when the others did not within some seconds: they wait for this rank inside
/// the scene and have to be aborted.
bool agree_on_ending(Ending &ending, const MpiSession *mpi);
}  // namespace turgor
