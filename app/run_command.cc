#include "app/run_command.h"

#include "app/plot_command.h"
#include "app/program_build.h"
#include "app/ranks.h"
#include "app/run_ending.h"
#include "app/typed_command.h"
#include "run/field_output.h"
#include "run/manifest.h"
#include "run/number_text.h"
#include "run/resource_use.h"
#include "run/run_directory.h"
#include "run/stop_flag.h"

#include <tbb/global_control.h>

#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <thread>

namespace turgor {
namespace {
std::filesystem::path default_directory(const std::filesystem::path &file) {
  return std::filesystem::path("runs") / file.stem();
}

/// What this machine does not have is refused when it is asked for (std::bad_alloc, a sentence), not promised
/// and then killed for. Not in a program that has mapped more than that already: a sanitizer's shadow is many
/// terabytes of which little is ever held.
void keep_within_memory() {
  rlimit limit = {};
  if (getrlimit(RLIMIT_DATA, &limit) != 0 || limit.rlim_cur <= physical_memory() ||
      mapped_for_data() > physical_memory())
    return;
  limit.rlim_cur = physical_memory();
  setrlimit(RLIMIT_DATA, &limit);
}

/// All cores this process may use, shared among the ranks of this machine.
unsigned int default_threads(const MpiSession *mpi) {
  const unsigned int cores = std::max(1u, std::thread::hardware_concurrency());
  return mpi != nullptr ? std::max(1u, cores / mpi->size_on_this_machine()) : cores;
}

/// What a run needs before its scene begins. Nothing has been written when it is there.
struct Start {
  Input input;
  RunSettings settings;
  std::unique_ptr<RunDirectory> directory;
  std::unique_ptr<tbb::global_control> limit;  ///< of threads

  Start(const RunOptions &options, const ScenarioRegistry &registry, MpiSession *mpi);
};

Start::Start(const RunOptions &options, const ScenarioRegistry &registry, MpiSession *mpi)
    : input(load_input(options.file, options.overrides, registry)) {
  const unsigned int ranks = mpi != nullptr ? mpi->size() : 1;
  if (ranks > 1 && !input.scenario->uses_ranks())
    throw InputError("--ranks " + number_text(ranks) + ": the scenario " + input.scenario_name +
                     " does not share its work over ranks; use --threads N.");

  const unsigned int threads = options.threads > 0 ? options.threads : default_threads(mpi);
  limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, threads);

  settings.directory = options.directory.empty() ? default_directory(options.file) : options.directory;
  settings.scenario = input.scenario_name;
  settings.identity = input.identity;
  settings.outputs = input.scenario->outputs();
  settings.build = {program_version(), program_build().commit, program_build().compiler,
                    program_build().instruction_set};
  settings.input_file = options.file;
  settings.input_text = input.text;
  settings.threads = threads;
  settings.ranks = ranks;
  settings.resume = options.resume;
  settings.overwrite = options.overwrite;
  settings.quiet = options.quiet;
  settings.writer = mpi == nullptr || mpi->rank() == 0;
  if (mpi != nullptr) settings.agree = [mpi](const bool wish) { return mpi->any(wish); };
  directory = std::make_unique<RunDirectory>(settings);
  if (stop_was_requested()) throw RunStopped("stopped before the run began; nothing was written.");
}

Ending run_scene(Scenario &scenario, RunDirectory &directory) {
  return ending_of([&] {
    try {
      scenario.run(directory);
    } catch (const std::invalid_argument &why)  // what a law says of numbers it cannot take
    {
      if (directory.has_results()) throw;
      throw InputError(why.what());
    }
  });
}

/// Writes the summary. What goes wrong with that is added to the ending, never put in the place of what was
/// wrong before. Where the results are is put into `place`.
void write_ending(Ending &ending, RunDirectory &directory, std::filesystem::path &place) {
  const Ending written = ending_of([&] { place = directory.finish(ending.status, ending.message); });
  std::error_code problem;
  const bool is_gone = directory.has_written() && !std::filesystem::is_directory(place, problem);
  if (written.code == 0 && !(is_gone && ending.code == 1)) return;
  std::string why = ending.code == 1 ? ending.message : "";
  if (why.find(written.message) == std::string::npos)
    why += (why.empty() ? "" : " Besides: ") + written.message;
  if (is_gone)
    why = "The output directory " + place.string() +
          " was removed or renamed while the run was writing into it (" + why + ").";
  ending = {1, "failed", why, true};
}

/// Pictures are a service: the run has its results whether or not they can be drawn.
Drawn draw_pictures(RunDirectory &directory, const std::string &place) {
  const Drawn drawn = draw_run(place);
  if (drawn == Drawn::stopped)
    directory.say("Stopped before the pictures were drawn; to draw them: turgor plot " + place);
  else if (drawn == Drawn::failed)
    directory.say("The pictures could not be drawn; try: turgor plot " + place);
  return drawn;
}

/// States to look at are left where one of them has failed, not where only the disk has.
void tell_what_to_look_at(const Ending &ending, const std::filesystem::path &place) {
  std::error_code problem;
  std::vector<std::filesystem::path> begun;
  for (const auto &entry : std::filesystem::directory_iterator(place, problem)) {
    std::filesystem::path description = entry.path();
    if (!description.replace_extension(".xdmf").string().ends_with(FieldOutput::look_ending)) continue;
    if (ending.output_failed && is_made(place, entry.path().filename().string()))
      begun.push_back(entry.path());
    else if (!ending.output_failed && entry.path() == description)
      std::cerr << "\nThe last state that was in order and the one that failed are in "
                << description.string() << ", to look at in ParaView.";
  }
  for (const std::filesystem::path &path : begun) std::filesystem::remove_all(path, problem);
}

/// To whoever started the run, after everything is on disk.
void tell(const Ending &ending, RunDirectory &directory, const std::string &place, const bool quiet) {
  if (ending.code == 0) {
    directory.say("Finished; results are in " + place + ".");
    if (!quiet) draw_pictures(directory, place);
    return;
  }
  const std::string again = command_again({"--overwrite"}, {"--resume"});
  std::string end = "The run has failed. ";
  if (ending.code == 130)
    end = directory.has_checkpoint() ? "Stopped; continue with --resume:\n  " + again + "\n"
                                     : "Stopped before there was a checkpoint; run it again. ";
  else if (ending.output_failed && directory.has_checkpoint())
    end += "Once it can be written, --resume continues from the last checkpoint:\n  " + again + "\n";
  std::cerr << "turgor: " << ending.message << "\n" << end;
  std::error_code problem;
  if (std::filesystem::exists(place, problem)) std::cerr << "What there is, is in " << place << ".";
  tell_what_to_look_at(ending, place);
  std::cerr << std::endl;
}
}  // namespace

std::string program_version() { return TURGOR_VERSION; }

int run_command(const RunOptions &options, const ScenarioRegistry &registry, MpiSession *mpi) {
  keep_within_memory();
  std::unique_ptr<Start> start;
  Ending ending = ending_of([&] { start = std::make_unique<Start>(options, registry, mpi); });
  bool together = agree_on_ending(ending, mpi);
  const bool is_begun = together && ending.code == 0, is_writer = mpi == nullptr || mpi->rank() == 0;
  if (is_begun)
    for (const std::string &remark : start->input.remarks) start->directory->say(remark);
  if (is_begun && start->directory->has_finished()) {
    const std::string place = start->settings.directory.string();
    const bool is_complete = !is_writer || options.quiet || has_pictures(place);
    const bool drawn = !is_complete && draw_pictures(*start->directory, place) == Drawn::yes;
    start->directory->say("The run in " + place + " has finished already: " +
                          (drawn ? "its pictures are drawn." : "nothing is left to do."));
    return 0;
  }
  if (is_begun) {
    ending = run_scene(*start->input.scenario, *start->directory);
    together = agree_on_ending(ending, mpi);
  }
  if (!is_begun || (together && ending.code == 2 && start->directory->withdraw())) {
    if (mpi == nullptr && ending.code == 2) throw InputError(ending.message);
    if (is_writer || !together) std::cerr << "turgor: " << ending.message << std::endl;
  } else if (is_writer || !together) {
    if (!is_writer)
      start->directory->take_over();  // the rank that writes waits inside the scene and is not coming
    std::filesystem::path place = start->settings.directory;
    write_ending(ending, *start->directory, place);
    tell(ending, *start->directory, place.string(), options.quiet);
  }
  if (!together) mpi->abort(ending.code);
  return ending.code;
}

int check_command(const RunOptions &options, const ScenarioRegistry &registry) {
  const Input input = load_input(options.file, options.overrides, registry);
  for (const std::string &remark : input.remarks) std::cerr << "turgor: " << remark << "\n";
  std::cout << (options.identity ? input.identity.hash() : "ok") << std::endl;
  return 0;
}
}  // namespace turgor
