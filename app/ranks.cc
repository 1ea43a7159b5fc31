#include "app/ranks.h"

#include "app/child_process.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/stop_flag.h"

#include <unistd.h>

#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <thread>

namespace turgor {
namespace {
unsigned int number_in(const char *variable, const unsigned int otherwise) {
  const char *text = std::getenv(variable);
  unsigned int number = otherwise;
  return text != nullptr && std::from_chars(text, text + std::strlen(text), number).ec == std::errc()
             ? number
             : otherwise;
}
}  // namespace

SurroundingJob surrounding_job() {
  // What is nearer to the process comes first: mpirun starts its daemons by srun, and they the ranks.
  if (const unsigned int size = number_in("OMPI_COMM_WORLD_SIZE", 0))
    return {"mpirun", size, number_in("OMPI_COMM_WORLD_RANK", 0), true};
  if (const unsigned int size = number_in("PMI_SIZE", 0))
    return {"a launcher of another MPI than Open MPI", size, number_in("PMI_RANK", 0), false};
  // Only srun tells the size of its step; SLURM_NTASKS stands in a batch script too.
  if (const unsigned int size = number_in("SLURM_STEP_NUM_TASKS", 0))
    return {"srun", size, number_in("SLURM_PROCID", 0), false};
  return {};
}

void require_alone(const SurroundingJob &job, const std::string &instead) {
  if (job.is_shared())
    throw InputError(job.rank == 0 ? "This program was started " + number_text(job.size) +
                                         " times at once by " + job.launcher + ". " + instead
                                   : "");
}

void wait_for_refused_copies(const SurroundingJob &job, int &argc, char **&argv) {
  int begun = 0;
  MPI_Initialized(&begun);
  if (!job.is_shared() || begun != 0) return;
  if (!job.can_be_joined) {
    if (job.rank != 0) std::this_thread::sleep_for(std::chrono::seconds(1));
    return;
  }
  MpiSession mpi(argc, argv);
  if (!mpi.worst_at_end(2, 5.))  // a copy that was not refused has gone on
    mpi.abort(2);
}

int run_ranks(const unsigned int ranks, const std::vector<std::string> &arguments) {
  // mpirun's own way with SIGINT is to kill; SIGUSR1 it hands on to the ranks, who take it as the wish to
  // stop. They then end with 0: at another code mpirun kills those who are still saving. Who waits for the
  // others' answers gives the core away: with more ranks or other work than cores they would come later.
  std::vector<std::string> words = {"mpirun",    "--quiet", "-n",    number_text(ranks),    "--oversubscribe",
                                    "--bind-to", "none",    "--mca", "mpi_yield_when_idle", "1"};
  if (::geteuid() == 0) words.push_back("--allow-run-as-root");
  words.push_back(this_program());
  words.push_back("--under-mpi");
  words.insert(words.end(), arguments.begin(), arguments.end());
  try {
    const int code = run_child(words, "", SIGUSR1).code;
    if (code != 130 && (!stop_was_requested() || (code != 0 && code != 128 + SIGUSR1))) {
      if (code >
          2)  // the ranks say their own reasons, mpirun's are long and not for the user of this program
        std::cerr << "turgor: mpirun ended with code " << code
                  << ": a rank was killed, or the ranks could not be started." << std::endl;
      return code > 2 ? 1 : code;
    }
    if (code == 128 + SIGUSR1) std::cerr << "turgor: stopped while the ranks were started." << std::endl;
    return 130;
  } catch (const std::runtime_error &problem) {
    throw InputError(std::string("--ranks needs mpirun (package openmpi-bin): ") + problem.what());
  }
}

MpiSession::MpiSession(int &argc, char **&argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
  MPI_Comm_dup(MPI_COMM_WORLD, &at_end);
}

MpiSession::~MpiSession() {
  MPI_Comm_free(&at_end);
  MPI_Finalize();
}

unsigned int MpiSession::rank() const {
  int number = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &number);
  return static_cast<unsigned int>(number);
}

unsigned int MpiSession::size() const {
  int number = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &number);
  return static_cast<unsigned int>(number);
}

unsigned int MpiSession::size_on_this_machine() const {
  MPI_Comm here = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  int number = 1;
  MPI_Comm_size(here, &number);
  MPI_Comm_free(&here);
  return static_cast<unsigned int>(number);
}

double MpiSession::sum(double share) const {
  MPI_Allreduce(MPI_IN_PLACE, &share, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return share;
}

void MpiSession::wait_for_all() const { MPI_Barrier(MPI_COMM_WORLD); }

bool MpiSession::any(const bool wish) const {
  int flag = wish ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &flag, 1, MPI_INT, MPI_LOR, MPI_COMM_WORLD);
  return flag != 0;
}

std::optional<MpiSession::Worst> MpiSession::worst_at_end(const int severity, const double patience) const {
  static int mine[2], worst[2];  // they outlive a request that is given up
  mine[0] = severity;
  mine[1] = static_cast<int>(rank());
  MPI_Request request;
  MPI_Iallreduce(mine, worst, 1, MPI_2INT, MPI_MAXLOC, at_end, &request);
  const auto start = std::chrono::steady_clock::now();
  for (int done = 0;;) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done != 0) return Worst{worst[0], static_cast<unsigned int>(worst[1])};
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > patience) return {};
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

std::string MpiSession::told_by(const unsigned int from, const std::string &words) const {
  unsigned long long length = words.size();
  MPI_Bcast(&length, 1, MPI_UNSIGNED_LONG_LONG, static_cast<int>(from), at_end);
  std::string told = words;
  told.resize(length);
  MPI_Bcast(told.data(), static_cast<int>(length), MPI_CHAR, static_cast<int>(from), at_end);
  return told;
}

void MpiSession::abort(const int code) {
  MPI_Abort(MPI_COMM_WORLD, code);
  std::exit(code);
}
}  // namespace turgor
