#include "app/run_command.h"

#include "app/plot_command.h"
#include "app/ranks.h"
#include "micro/io/number_text.h"
#include "micro/io/resource_use.h"
#include "micro/io/run_directory.h"
#include "micro/io/stop_flag.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/multithread_info.h>

#include <tbb/global_control.h>

#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <thread>

namespace turgor
{
namespace
{
struct Ending
{
  int code;
  std::string status, message;
};

std::filesystem::path default_directory(const std::filesystem::path &file)
{
  return std::filesystem::path("runs") / file.stem();
}

/// What this machine does not have is refused when it is asked for (std::bad_alloc, a sentence), not promised and then killed for.
/// Not in a program that has mapped more than that already: a sanitizer's shadow is many terabytes of which little is ever held.
void keep_within_memory()
{
  rlimit limit = {};
  if (getrlimit(RLIMIT_DATA, &limit) != 0 || limit.rlim_cur <= physical_memory() || mapped_for_data() > physical_memory())
    return;
  limit.rlim_cur = physical_memory();
  setrlimit(RLIMIT_DATA, &limit);
}

/// The scene's own ending; an InputError passes through while nothing has been written.
Ending run_scene(Scenario &scenario, RunDirectory &directory)
{
  try
    {
      scenario.run(directory);
      return {0, "finished", ""};
    }
  catch (const RunStopped &why)
    {
      return {130, "stopped", why.what()};
    }
  catch (const InputError &why)
    {
      if (!directory.has_written())
        throw;
      return {2, "failed", why.what()};
    }
  catch (const std::invalid_argument &why)
    {
      if (!directory.has_written())
        throw InputError(why.what());
      return {1, "failed", why.what()};
    }
  catch (const std::bad_alloc &)
    {
      return {1, "failed", "There is not enough memory for this run: take fewer cells, particles or elements."};
    }
  catch (const std::exception &why)
    {
      return {1, "failed", why.what()};
    }
}
} // namespace

std::string program_version()
{
  return TURGOR_VERSION;
}

int run_command(const RunOptions &options, const ScenarioRegistry &registry, MpiSession *mpi)
{
  keep_within_memory();
  const Input input = load_input(options.file, options.overrides, registry);
  const unsigned int ranks = mpi != nullptr ? mpi->size() : 1;
  if (ranks > 1 && !input.scenario->uses_ranks())
    throw InputError("--ranks " + number_text(ranks) + ": the scenario " + input.scenario_name +
                     " does not share its work over ranks; use --threads N.");

  const unsigned int cores = std::max(1u, std::thread::hardware_concurrency());
  const unsigned int threads = options.threads > 0 ? options.threads : std::max(1u, cores / ranks);
  dealii::deal_II_exceptions::suppress_stacktrace_in_exceptions();
  // Never one for deal.II: with one thread its FEValues reuses the geometry of the cell before it
  // where the two look alike, with more it does not, and the last bits of a run would depend on
  // --threads. TBB's own limit below is what counts.
  ::unsetenv("DEAL_II_NUM_THREADS");
  dealii::MultithreadInfo::set_thread_limit(std::max(2u, threads));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  install_stop_handler();

  RunSettings settings;
  settings.directory = options.directory.empty() ? default_directory(options.file) : options.directory;
  settings.scenario = input.scenario_name;
  settings.version = program_version();
  settings.input_hash = input.hash;
  settings.input_text = input.text;
  settings.threads = threads;
  settings.ranks = ranks;
  settings.resume = options.resume;
  settings.quiet = options.quiet;
  settings.writer = mpi == nullptr || mpi->rank() == 0;
  if (mpi != nullptr)
    settings.agree = [mpi](const bool wish) { return mpi->any(wish); };

  RunDirectory directory(settings);
  const Ending ending = run_scene(*input.scenario, directory);
  directory.finish(ending.status, ending.message);
  const std::string place = settings.directory.string();
  if (ending.code == 0)
    {
      directory.say("Finished; results are in " + place + ".");
      // Pictures are a service: the run has its results whether or not they can be drawn.
      if (settings.writer && !options.quiet && !draw_run(place))
        directory.say("The pictures could not be drawn; try: turgor plot " + place);
    }
  else if (settings.writer)
    std::cerr << "turgor: " << ending.message << "\n"
              << (ending.code != 130              ? "The run has failed. " :
                  directory.has_checkpoint() ? "Stopped; continue with --resume. " :
                                                    "Stopped before there was a checkpoint; run it again. ")
              << "What there is, is in " << place << "." << std::endl;
  // Another rank may wait for this one for ever.
  if (mpi != nullptr && ranks > 1 && ending.code == 1)
    mpi->abort(ending.code);
  return ending.code;
}

int check_command(const RunOptions &options, const ScenarioRegistry &registry)
{
  load_input(options.file, options.overrides, registry);
  std::cout << "ok" << std::endl;
  return 0;
}
} // namespace turgor
