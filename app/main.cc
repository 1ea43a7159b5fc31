// The command line:
//   turgor run FILE.prm [-o DIR] [--set 'Section/Name=value']... [--resume] [--threads N] [--ranks N]
//   turgor list | parameters SCENARIO | check FILE.prm | study FILE.prm [--list] | compare FILE.prm
//     | validate [NAME...] | plot DIR
#include "app/compare_command.h"
#include "app/nearest_name.h"
#include "app/outputs_text.h"
#include "app/plot_command.h"
#include "app/ranks.h"
#include "app/run_command.h"
#include "app/run_ending.h"
#include "app/study_input.h"
#include "app/study_runner.h"
#include "app/typed_command.h"
#include "app/validate_command.h"
#include "run/number_text.h"
#include "run/stop_flag.h"
#include "run/run_context.h"

#include <CLI/CLI.hpp>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>

namespace {
using namespace turgor;

/// Where a descriptor of input, output or messages is closed, the next file to be opened would take its
/// place, and messages end up in a table.
void open_standard_streams() {
  for (int number = STDIN_FILENO; number <= STDERR_FILENO; ++number)
    if (::fcntl(number, F_GETFD) == -1)
      ::open("/dev/null",
             number == STDIN_FILENO ? O_RDONLY : O_WRONLY);  // takes the lowest number that is free: this one
}

int list_command(const ScenarioRegistry &registry) {
  for (const ScenarioLine &scenario : registry.scenarios)
    std::cout << scenario.name << "\n    " << scenario.description << "\n";
  return 0;
}

/// Wrong input is told once, not by every rank.
void check_for_ranks(const RunOptions &run, const ScenarioRegistry &registry, const SurroundingJob &job) {
  Input input;
  try {
    input = load_input(run.file, run.overrides, registry);
  } catch (const InputError &problem) {
    throw InputError(job.rank == 0 ? problem.what() : "");
  }
  if (input.scenario->uses_ranks()) return;
  const std::string reason = "the scenario " + input.scenario_name + " does not share its work over ranks";
  require_alone(job, "But " + reason + ": start it once, without that launcher, and use --threads N.");
  throw InputError("--ranks " + number_text(run.ranks) + ": " + reason + "; use --threads N.");
}

int run_serial_or_on_ranks(RunOptions run, const bool ranks_given, const bool under_mpi,
                           const ScenarioRegistry &registry, int argc, char **argv) {
  const SurroundingJob job = surrounding_job();
  const bool joins = !under_mpi && job.is_shared();
  if (joins) {
    if (!job.can_be_joined)
      require_alone(job, "Start it once and let it start its ranks itself: --ranks " + number_text(job.size) +
                             " (or by the mpirun of Open MPI).");
    if (ranks_given && run.ranks != job.size)
      require_alone(job,
                    "--ranks " + number_text(run.ranks) + " is another number: leave one of the two away.");
    check_for_ranks(run, registry, job);
  } else if (run.ranks > 1 && !under_mpi) {
    check_for_ranks(run, registry, job);
    return run_ranks(run.ranks, {argv + 1, argv + argc});
  }
  if (!under_mpi && !joins) return run_command(run, registry, nullptr);
  MpiSession mpi(argc, argv);
  const int code = run_command(run, registry, &mpi);
  if (joins) mpi.wait_for_all();  // at a code other than 0 mpirun kills those who are still saving
  return under_mpi && code == 130 ? 0 : code;  // see run_ranks
}

/// What was asked for may be the output alone, of which a full disk has taken nothing. A reader who has read
/// enough is another matter.
bool all_was_printed() {
  const bool whole = std::cout.flush().good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  pollfd reader{STDOUT_FILENO, 0, 0};
  if (whole || (::poll(&reader, 1, 0) > 0 && (reader.revents & POLLERR) != 0)) return true;
  std::cerr << "turgor: the output could not be written whole: is its disk full?" << std::endl;
  return false;
}

/// What stands on the command line.
struct CommandLine {
  CLI::App app{
      "Turgor: soft tissue at two scales, a finite-element tissue whose stress comes from its cells."};
  bool under_mpi = false;
  RunOptions run;
  StudyOptions study;
  CompareOptions compare;
  ValidateOptions validate;
  std::string scenario, part, plot_directory, plot_data;
  bool all_outputs = false;
  CLI::App *run_app, *list_app, *parameters_app, *check_app, *study_app, *compare_app, *validate_app,
      *plot_app;

  CommandLine() {
    app.require_subcommand(1);
    app.set_version_flag("--version", program_version());
    app.add_flag("--under-mpi", under_mpi)->group("");
    add_run();
    list_app = app.add_subcommand("list", "All scenes");
    add_parameters();
    add_check();
    add_study();
    add_compare();
    add_validate();
    add_plot();
    app.add_subcommand("test", "Build and run all tests, or parts of them (by the launcher ./turgor)")
        ->footer(
            "It is the launcher's: ./turgor test [--fast] [PART...]; ./turgor test --help lists its "
            "options.");
  }

  void require_known(const std::string &command) const {
    std::vector<std::string> commands;
    for (const CLI::App *known : app.get_subcommands([](const CLI::App *) { return true; }))
      commands.push_back(known->get_name());
    if (std::find(commands.begin(), commands.end(), command) == commands.end())
      throw InputError("There is no command '" + command + "'." + suggestion(command, commands));
  }

 private:
  void add_input(CLI::App *command) {
    command->add_option("FILE", run.file, "Input file (.prm)")->required();
    command->add_option("--set", run.overrides, "Section/Name=value, over the file's value; may be repeated")
        ->allow_extra_args(false);
  }

  void add_run() {
    run_app = app.add_subcommand("run", "Run the scene of an input file");
    add_input(run_app);
    run_app->add_option("-o,--output", run.directory, "Output directory (default runs/<name of the file>)");
    run_app->add_flag("--resume", run.resume, "Continue from the last checkpoint");
    run_app->add_flag("--overwrite", run.overwrite,
                      "Replace a finished run of another input in the output directory");
    run_app->add_flag("--quiet", run.quiet,
                      "No progress bar, no remarks and no pictures (`turgor plot DIR` draws them later)");
    run_app->add_option("--threads", run.threads, "Threads (default: all cores)")
        ->check(CLI::Range(1u, 1024u));
    run_app->add_option("--ranks", run.ranks, "MPI ranks (default: 1, without MPI)")
        ->check(CLI::Range(1u, 1024u));
  }

  void add_parameters() {
    parameters_app = app.add_subcommand(
        "parameters", "A commented input file of a scene's entries with defaults, and what its runs leave");
    auto *const scenario_option = parameters_app->add_option(
        "SCENARIO", scenario, "Name of the scene; 'study' for the entries of a study");
    parameters_app->add_option("PART", part,
                               "A subsection or an entry, as 'Cell' or 'Cell/Turgor': only that");
    parameters_app->add_flag("--outputs", all_outputs, "What runs of all scenes leave: doc/outputs.md")
        ->excludes(scenario_option);
  }

  void add_check() {
    check_app = app.add_subcommand("check", "Parse and check an input file without running it");
    add_input(check_app);
    check_app->add_flag("--identity", run.identity,
                        "Print the run's identity: its entries, the files they name, this program");
  }

  void add_study() {
    study_app = app.add_subcommand(
        "study", "Run many variants of any scene: results over swept entries, error against run time");
    study_app->footer(
        "`turgor parameters study` prints all entries of a study file; inputs/studies holds ready-made ones; "
        "doc/studies.md explains them.");
    study_app->add_option("FILE", study.file, "Study file (.prm)")->required();
    study_app->add_option("-o,--output", study.directory,
                          "Directory of tables, pictures and, in its cache/, the runs (default runs/<name of "
                          "the file>, runs in runs/cache)");
    study_app->add_flag("--list", study.list_only, "Only print the runs and what is cached");
    study_app->add_flag("--fresh", study.fresh, "Compute every run again");
    study_app
        ->add_option("--jobs", study.jobs,
                     "Runs beside each other (default 1; run times are the most honest alone)")
        ->check(CLI::Range(1u, 1024u));
    study_app->add_option("--only", study.only, "Only the run with this label; may be repeated")
        ->allow_extra_args(false);
  }

  void add_compare() {
    compare_app = app.add_subcommand(
        "compare",
        "A tissue of finite elements against every one of its cells: error, where it comes from, run time");
    compare_app->footer(
        "Inputs of tissue_statics (against static_lattice: seconds), tissue_gravity (full_micro: minutes to "
        "hours), tissue_bruise (tissue_impact, struck by a plate: minutes, told before the runs).");
    compare_app->add_option("FILE", compare.file, "Input file of the tissue (.prm)")->required();
    compare_app
        ->add_option("--set", compare.overrides, "Section/Name=value, over the file's value; may be repeated")
        ->allow_extra_args(false);
    compare_app->add_option(
        "-o,--output", compare.directory,
        "Directory of tables, pictures and, in its cache/, the runs (default runs/<name of "
        "the file>_compared, runs in runs/cache)");
    compare_app->add_option("--threads", compare.threads, "Threads of each run (default 1)")
        ->check(CLI::Range(1u, 1024u));
    compare_app->add_option("--jobs", compare.jobs, "Runs beside each other (default 1)")
        ->check(CLI::Range(1u, 1024u));
    compare_app->add_flag("--list", compare.list_only, "Only print the runs and what is cached");
  }

  void add_validate() {
    validate_app =
        app.add_subcommand("validate", "Run the validation scenes; exit code 1 when a row misses its target");
    validate_app->add_option("NAME", validate.names, "Names of inputs/validation/NAME.json (default: all)");
    validate_app->add_option(
        "-o,--output", validate.directory,
        "Directory of the table and, in its cache/, the runs (default runs/validation, runs in runs/cache)");
    validate_app->add_flag("--update-doc", validate.update_doc,
                           "Also rewrite doc/validation.md and doc/results/validation.csv of the source");
    validate_app->add_option(
        "--root", validate.root,
        "Directory that holds inputs/validation and doc (default: this program's source)");
    validate_app->add_flag("--list", validate.list_only, "Only print the runs and what is cached");
    validate_app->add_flag("--fresh", validate.fresh, "Compute every run again");
  }

  void add_plot() {
    plot_app = app.add_subcommand("plot", "Pictures of a run, beside its results");
    plot_app->add_option("DIR", plot_directory, "Output directory of a run")->required();
    plot_app->add_option("--data", plot_data,
                         "CSV of your own measurements: columns named as in the run's tables, in any unit of "
                         "the quantity ('time [h],radius [um]'), are drawn as points");
  }
};

int print_parameters(const CommandLine &line, const ScenarioRegistry &registry) {
  if (line.all_outputs)
    std::cout << outputs_document(registry);
  else if (line.scenario.empty())
    throw InputError(
        "Which scene? `turgor parameters SCENARIO` with one of `turgor list`, or `turgor parameters "
        "--outputs`.");
  else
    std::cout << (line.scenario == "study" ? study_parameters_text(line.part)
                                           : parameters_text(line.scenario, registry, line.part));
  return 0;
}

int dispatch(int argc, char **argv) {
  CommandLine line;
  if (argc > 1 && argv[1][0] != '-') line.require_known(argv[1]);
  try {
    line.app.parse(argc, argv);
  } catch (const CLI::ParseError &problem) {
    return line.app.exit(problem) == 0 ? 0 : 2;
  }

  const ScenarioRegistry registry = product_registry();
  if (line.run_app->parsed())
    return run_serial_or_on_ranks(line.run, line.run_app->count("--ranks") > 0, line.under_mpi, registry,
                                  argc, argv);
  if (line.list_app->parsed()) return list_command(registry);
  if (line.parameters_app->parsed()) return print_parameters(line, registry);
  if (line.check_app->parsed()) return check_command(line.run, registry);
  if (line.study_app->parsed() || line.compare_app->parsed() || line.validate_app->parsed())
    require_alone(surrounding_job(),
                  "It runs many runs one after the other: start it once, without that launcher.");
  if (line.study_app->parsed()) return study_command(line.study, registry);
  if (line.compare_app->parsed()) return compare_command(line.compare, registry);
  if (line.validate_app->parsed()) return validate_command(line.validate, registry);
  if (line.plot_app->parsed()) return plot_command(line.plot_directory, line.plot_data);
  throw InputError("The tests are built and run by the launcher: ./turgor test");
}
}  // namespace

int main(int argc, char **argv) {
  open_standard_streams();
  remember_command(argc, argv);
  install_stop_handler();  // before all else: a wish to stop must not find its default action, death
  try {
    const int code = dispatch(argc, argv);
    const bool is_run = argc > 1 && std::string(argv[1]) == "run";  // whose results are files
    return code == 0 && !is_run && !all_was_printed() ? 1 : code;
  } catch (const turgor::InputError &problem) {
    if (*problem.what() != '\0')  // see require_alone
      std::cerr << "turgor: " << problem.what() << std::endl;
    wait_for_refused_copies(surrounding_job(), argc, argv);
    return 2;
  } catch (const std::exception &problem) {
    std::cerr << "turgor: " << words_of(problem) << std::endl;
    return code_of(problem);
  }
}
