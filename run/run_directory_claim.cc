// What of a directory a run may take or replace, and taking it.
#include "run/run_directory.h"

#include "run/atomic_file.h"
#include "run/manifest.h"
#include "run/output_failed.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <iostream>
#include <iterator>

namespace turgor {
namespace {
constexpr const char *fixed_names[] = {"summary.json", "input.prm", CheckpointStore::file_names[0],
                                       CheckpointStore::file_names[1]};
}  // namespace

bool RunDirectory::input_is_its_copy() const {
  std::error_code ignored;  // one of the two is not there
  return !settings.input_file.empty() &&
         std::filesystem::equivalent(settings.input_file, settings.directory / "input.prm", ignored);
}

void RunDirectory::refuse_to_replace_input() const {
  if (input_is_its_copy())
    throw InputError("The input file " + settings.input_file.string() +
                     " would be replaced by the copy of it that a run leaves in its "
                     "output directory. Choose another output directory with -o DIR.");
}

/// By its summary or, where it was killed and has none, by its copy of the input.
bool RunDirectory::holds_another_input(const nlohmann::json &summary) const {
  if (summary.contains("input_hash"))
    return summary.value("input_hash", "") != settings.identity.input_hash();
  std::ifstream copy(settings.directory / "input.prm", std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(copy), {});
  return copy && !input_is_its_copy() && is_made(settings.directory, "input.prm") &&
         text != settings.input_text;
}

/// Throws InputError when something is in the way that this run must not replace.
void RunDirectory::require_replaceable() {
  const std::filesystem::path &directory = settings.directory;
  if (!settings.resume) refuse_to_replace_input();
  for (const std::string name : fixed_names)
    if (name != "input.prm" || !input_is_its_copy()) require_claimable(directory, name);
  const nlohmann::json summary = earlier_summary(directory);
  const std::string status = summary.value("status", "");
  if (settings.overwrite) return;
  if (!settings.resume && status == "stopped" && checkpoints.exists())
    throw InputError(directory.string() +
                     " holds a run that was stopped and can go on: add --resume. To begin anew, choose "
                     "another directory with "
                     "-o DIR, or replace it with --overwrite.");
  if (settings.resume && status != "finished" && !checkpoints.exists() && holds_another_input(summary))
    throw InputError(directory.string() + " holds a run of another input (" +
                     (directory / "input.prm").string() +
                     " shows it) that has no checkpoint to go on from. Choose another directory with -o DIR, "
                     "or replace it with --overwrite.");
  if (status != "finished") return;
  if (!settings.resume && summary.value("input_hash", "") != settings.identity.input_hash())
    throw InputError(directory.string() + " holds a finished run of another input (" +
                     (directory / "input.prm").string() +
                     " shows it). Choose another directory with -o DIR, or replace it with --overwrite.");
  if (settings.resume && !checkpoints.exists() &&
      !has_finished_as(summary, settings.identity))  // else the checkpoint says whether it can go on
    throw InputError(directory.string() +
                     " holds a finished run of another input, end or program without a checkpoint to go on "
                     "from. Choose another directory with -o DIR, or replace it with --overwrite.");
}

void RunDirectory::prepare() const {
  if (prepared || !settings.writer) return;
  prepared = true;
  const auto &directory = settings.directory;
  std::error_code problem;
  std::filesystem::create_directories(directory, problem);
  if (problem) throw OutputFailed("cannot make " + directory.string() + ": " + problem.message() + ".");
  if (!resumed)
    if (const std::size_t count = files->begin(); count > 0 && !settings.quiet) {
      bar.clear();
      std::cout << "The " << count << " files of an earlier run in " << directory.string()
                << " are replaced as soon as this one has results." << std::endl;
    }
  const bool keeps_input = input_is_its_copy();
  for (const std::string name : fixed_names)
    if (!keeps_input || name != "input.prm") claim(directory, name);
  if (!std::filesystem::remove(directory / "summary.json", problem) &&
      problem)  // a run that is killed must not leave an older one's
    throw OutputFailed("cannot replace " + (directory / "summary.json").string() + ": " + problem.message() +
                       ".");
  if (!keeps_input) write_atomically(directory / "input.prm", settings.input_text);
  for (const RunIdentity::NamedFile &file : settings.identity.files) {
    claim(directory, "input_files");
    std::filesystem::create_directories(directory / "input_files");
    const std::string copy = "input_files/" + file.name;
    claim(directory, copy);
    write_atomically(directory / copy, file.bytes);
  }
}
}  // namespace turgor
