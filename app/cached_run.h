// A run that somebody else keeps: a child process in a directory named by what it was asked to do,
// so that the same question is computed once and a stopped one is taken up again.
// Used by studies (`turgor study`) and by the validation (`turgor validate`).
#pragma once

#include "run/resource_use.h"
#include "run/run_identity.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace turgor {
/// What to run.
struct RunRequest {
  std::filesystem::path input;
  std::vector<std::string> overrides;  ///< Section/Name=value
  unsigned int threads = 1;
};

struct CachedRun {
  std::filesystem::path directory;
  std::string status = "waiting";  ///< waiting, partly, finished, failed, stopped
  std::string message;
  std::string date;  ///< of its summary: YYYY-MM-DD
  ResourceUse use;   ///< a resumed run's cost is that of all its parts
};

/// Where a study or a validation keeps its runs: in DIR/cache, if the person chose DIR; else in runs/cache,
/// which all of them share.
std::filesystem::path cache_of(const std::filesystem::path &chosen);

/// The run of this identity, in <cache>/<stem>_<hash>; status from what is already there (fresh: nothing is).
/// The program is part of it: nobody is shown what another program computed. So is the number of threads, for
/// the cost.
CachedRun cached_run(const std::filesystem::path &cache, const std::string &stem, const RunIdentity &identity,
                     unsigned int threads, bool fresh);

/// Status, message and cost from the run's own summary; true when it has finished.
bool read_summary(CachedRun &run);

/// Runs it, from its last checkpoint unless fresh. waiting: as of run_child().
void compute(CachedRun &run, const RunRequest &request, bool fresh,
             const std::function<void(double)> &waiting = {});
}  // namespace turgor
