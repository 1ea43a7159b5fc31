#include "app/ranks.h"

#include "app/child_process.h"
#include "micro/io/run_context.h"

#include <mpi.h>

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace turgor
{
void start_ranks(const unsigned int ranks, const std::vector<std::string> &arguments)
{
  // The stop signal must leave the ranks time to save their checkpoint.
  std::vector<std::string> words = {"mpirun", "-n", std::to_string(ranks), "--oversubscribe", "--bind-to", "none",
                                    "--mca", "odls_base_sigkill_timeout", "120"};
  if (::geteuid() == 0)
    words.push_back("--allow-run-as-root");
  words.push_back(this_program());
  words.push_back("--under-mpi");
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char *> pointers;
  for (std::string &word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execvp(pointers[0], pointers.data());
  throw InputError(std::string("--ranks needs mpirun (package openmpi-bin), which could not be started: ") +
                   std::strerror(errno) + ".");
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
