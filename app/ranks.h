// MPI only where it is asked for: `--ranks N` starts this program again under mpirun, and
// only the ranks initialise MPI. A serial run never touches it.
#pragma once

#include <string>
#include <vector>

namespace turgor
{
/// Replaces this process by `mpirun -n ranks program --under-mpi arguments...`. Returns only by InputError.
void start_ranks(unsigned int ranks, const std::vector<std::string> &arguments);

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
