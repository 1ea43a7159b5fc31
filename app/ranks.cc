#include "app/ranks.h"

#include "app/child_process.h"
#include "micro/io/number_text.h"
#include "micro/io/run_context.h"
#include "micro/io/stop_flag.h"

#include <mpi.h>

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace turgor
{
int run_ranks(const unsigned int ranks, const std::vector<std::string> &arguments)
{
  // mpirun's own way with SIGINT is to kill; SIGUSR1 it hands on to the ranks, who take it as the wish to stop. They then
  // end with 0: at another code mpirun kills those who are still saving.
  std::vector<std::string> words = {"mpirun", "-n", number_text(ranks), "--oversubscribe", "--bind-to", "none"};
  if (::geteuid() == 0)
    words.push_back("--allow-run-as-root");
  words.push_back(this_program());
  words.push_back("--under-mpi");
  words.insert(words.end(), arguments.begin(), arguments.end());
  install_stop_handler();
  try
    {
      const int code = run_child(words, "", SIGUSR1).code;
      return stop_was_requested() && (code == 0 || code == 128 + SIGUSR1) ? 130 : code;
    }
  catch (const std::runtime_error &problem)
    {
      throw InputError(std::string("--ranks needs mpirun (package openmpi-bin): ") + problem.what());
    }
}

MpiSession::MpiSession(int &argc, char **&argv)
{
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
}

MpiSession::~MpiSession()
{
  MPI_Finalize();
}

unsigned int MpiSession::rank() const
{
  int number = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &number);
  return static_cast<unsigned int>(number);
}

unsigned int MpiSession::size() const
{
  int number = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &number);
  return static_cast<unsigned int>(number);
}

bool MpiSession::any(const bool wish) const
{
  int flag = wish ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &flag, 1, MPI_INT, MPI_LOR, MPI_COMM_WORLD);
  return flag != 0;
}

void MpiSession::abort(const int code)
{
  MPI_Abort(MPI_COMM_WORLD, code);
  std::exit(code);
}
} // namespace turgor
