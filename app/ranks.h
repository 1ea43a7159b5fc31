// MPI only where it is asked for: `--ranks N` starts this program again under mpirun, and
// only the ranks initialise MPI. A serial run never touches it. Who starts the program by mpirun
// himself gets the same: the copies are the ranks of one run.
#pragma once

#include <mpi.h>

#include <optional>
#include <string>
#include <vector>

namespace turgor {
/// Runs `mpirun -n ranks program --under-mpi arguments...` and returns its exit code; a wish to stop is
/// passed on to the ranks. Throws InputError when there is no mpirun.
int run_ranks(unsigned int ranks, const std::vector<std::string> &arguments);

/// The job whose launcher has started this process and others beside it.
struct SurroundingJob {
  std::string launcher;  ///< mpirun, srun, ...; empty: nobody's
  unsigned int size = 1, rank = 0;
  bool can_be_joined = false;  ///< by the MPI this program is linked with

  bool is_shared() const { return size > 1; }
};

/// From what the launchers leave in the environment (Open MPI, Slurm's srun, PMI). A batch script of Slurm is
/// no such job: what runs in it runs once.
SurroundingJob surrounding_job();

/// Refuses a job of copies that would all do the same and write to the same place: InputError, whose sentence
/// only the first copy has. `instead`: what to do.
void require_alone(const SurroundingJob &job, const std::string &instead);

/// Before the end of copies that were refused before they met: waits until all of them have said what they
/// say, because mpirun kills the others as soon as one ends with a code that is not 0, and the sentence of
/// the first copy would be lost.
void wait_for_refused_copies(const SurroundingJob &job, int &argc, char **&argv);

/// Initialised MPI, for the time of a run under mpirun.
class MpiSession {
 public:
  MpiSession(int &argc, char **&argv);
  ~MpiSession();
  MpiSession(const MpiSession &) = delete;
  MpiSession &operator=(const MpiSession &) = delete;

  unsigned int rank() const;
  unsigned int size() const;
  unsigned int size_on_this_machine() const;  ///< collective
  bool any(bool wish) const;                  ///< collective
  double sum(double share) const;             ///< collective
  void wait_for_all() const;                  ///< collective
  [[noreturn]] void abort(int code);          ///< ends all ranks, when one cannot go on

  struct Worst {
    int severity;
    unsigned int rank;  ///< the lowest of those with it
  };
  /// Collective, apart from all that the scene itself sends: nothing when the other ranks do not call it
  /// within `patience` seconds.
  std::optional<Worst> worst_at_end(int severity, double patience) const;
  std::string told_by(unsigned int rank, const std::string &words)
      const;  ///< collective, after worst_at_end(): that rank's words

 private:
  MPI_Comm at_end;  ///< what is sent at the end never meets what a scene on another rank still sends
};
}  // namespace turgor
