// MPI only where it is asked for: `--ranks N` starts this program again under mpirun, and
// only the ranks initialise MPI. A serial run never touches it.
#pragma once

#include <string>
#include <vector>

namespace turgor
{
/// Runs `mpirun -n ranks program --under-mpi arguments...` and returns its exit code; a wish to stop is passed on to
/// the ranks. Throws InputError when there is no mpirun.
int run_ranks(unsigned int ranks, const std::vector<std::string> &arguments);

/// Initialised MPI, for the time of a run under mpirun.
class MpiSession
{
public:
  MpiSession(int &argc, char **&argv);
  ~MpiSession();
  MpiSession(const MpiSession &) = delete;
  MpiSession &operator=(const MpiSession &) = delete;

  unsigned int rank() const;
  unsigned int size() const;
  bool any(bool wish) const;         ///< collective
  [[noreturn]] void abort(int code); ///< ends all ranks, when one cannot go on
};
} // namespace turgor
