// The RunContext of a real run: one output directory with
//   summary.json            what was run, what came out and what it cost
//   input.prm               every entry with the value it had; input_files/ with the files they name
//   NAME.csv                the series; NAME.xdmf with NAME.frames/ where a scene writes fields
//   checkpoint.0, .1        two generations
//   made_by_turgor.txt      the files that a later run into the same directory may replace (output_files.h)
// Wrong input leaves no trace.
//
// On ranks > 0 nothing is written; save_checkpoint() still calls its callback, with a
// stream that swallows everything, because collecting the state may need all ranks.
#pragma once

#include "run/checkpoint_store.h"
#include "run/output_files.h"
#include "run/output_list.h"
#include "run/progress_bar.h"
#include "run/resource_use.h"
#include "run/run_context.h"
#include "run/run_record.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace turgor {
class SeriesFile;

/// For people who read a summary; none of it decides anything.
struct BuildFacts {
  std::string version, commit, compiler, instruction_set;
};

struct RunSettings {
  std::filesystem::path directory;
  std::string scenario;
  RunIdentity identity;
  BuildFacts build;
  std::filesystem::path input_file;  ///< is not replaced, wherever it lies; may be empty
  std::string input_text;            ///< for DIR/input.prm
  std::optional<Outputs> outputs;    ///< what may be written; none: anything
  unsigned int threads = 1, ranks = 1;
  bool resume = false, writer = true, quiet = false;
  bool overwrite = false;  ///< a finished run of another input too

  /// With ranks: true on all as soon as it is true on one. stop_requested() is then a collective call.
  std::function<bool(bool)> agree = [](const bool wish) { return wish; };
};

class RunDirectory : public RunContext {
 public:
  /// Throws InputError when the directory cannot be written, is in use, holds what must not be replaced, or
  /// its checkpoint cannot be resumed; on all ranks.
  explicit RunDirectory(RunSettings settings);
  ~RunDirectory() override;

  const std::filesystem::path &directory() const override;
  unsigned int threads() const override { return settings.threads; }
  bool is_writer() const override { return settings.writer; }
  void result(const std::string &name, double value, const std::string &unit) override;
  void note(const std::string &name, const std::string &text) override { record.note(name, text); }
  void active(const std::vector<std::string> &terms, const std::vector<std::string> &fields) override {
    record.active(terms, fields);
  }
  std::unique_ptr<Series> series(const std::string &name, const std::vector<Column> &columns) override;
  void require_defined(const std::string &file, const std::string &name,
                       const std::string &unit) const override;
  void progress(double fraction, const std::string &what) override;
  void say(const std::string &line) override;
  bool stop_requested() const override;
  void save_checkpoint(const std::function<void(Archive &)> &list) override;
  bool load_checkpoint(const std::function<void(Archive &)> &list) override;

  /// Writes summary.json; returns where it is. status: finished, failed or stopped; message: why, may be
  /// empty. Throws OutputFailed when that or a series cannot be written; the summary then says "failed" if it
  /// can be written itself.
  std::filesystem::path finish(const std::string &status, const std::string &message);

  /// With resume: this run has finished in this directory already.
  bool has_finished() const { return finished_already; }

  /// Whether what is there is more than a start that can be taken back.
  bool has_results() const { return prepared && (resumed || !files || files->has_kept()); }

  /// Leaves the directory as it was found; false when this run has results in it.
  bool withdraw();

  /// True if --resume would go on from somewhere.
  bool has_checkpoint() const { return saved || resumed.has_value(); }

  /// True once anything was written into the directory.
  bool has_written() const { return prepared; }

  /// A rank that has written nothing writes the summary, because the one that should is not coming.
  void take_over() { settings.writer = prepared = true; }

 private:
  void prepare() const;
  bool input_is_its_copy() const;
  bool holds_another_input(const nlohmann::json &summary) const;
  void refuse_to_replace_input() const;
  void require_replaceable();

  RunSettings settings;
  mutable std::optional<OutputFiles> files;  ///< of the writer
  CheckpointStore checkpoints;
  std::string date;  ///< of the start
  std::optional<Checkpoint> resumed;
  std::map<std::string, std::uint64_t> resumed_lengths;  ///< bytes of each series at the checkpoint
  std::map<std::string, std::shared_ptr<SeriesFile>> open_series;
  RunRecord record;
  mutable ProgressBar bar;
  ResourceMeter meter;
  bool saved = false;  ///< a checkpoint, by this run
  bool finished_already = false;
  mutable bool prepared = false;
};
}  // namespace turgor
