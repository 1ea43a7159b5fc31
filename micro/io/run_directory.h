// The RunContext of a real run: one output directory with
//   summary.json            what was run, what came out and what it cost
//   input.prm               every entry with the value it had
//   NAME.csv                the series; NAME.xdmf with NAME.frames/ where a scene writes fields
//   checkpoint.0, .1        two generations
//   made_by_turgor.txt      the files that a later run into the same directory may remove
// The directory is made by the first thing written, so that wrong input leaves no trace.
//
// On ranks > 0 nothing is written; save_checkpoint() still calls its callback, with a
// stream that swallows everything, because collecting the state may need all ranks.
#pragma once

#include "micro/io/checkpoint_store.h"
#include "micro/io/progress_bar.h"
#include "micro/io/resource_use.h"
#include "micro/io/run_context.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace turgor
{
class SeriesFile;

struct RunSettings
{
  std::filesystem::path directory;
  std::string scenario, version, input_hash;
  std::string input_text; ///< for DIR/input.prm
  unsigned int threads = 1, ranks = 1;
  bool resume = false, writer = true, quiet = false;

  /// With ranks: true on all as soon as it is true on one. stop_requested() is then a collective call.
  std::function<bool(bool)> agree = [](const bool wish) { return wish; };
};

class RunDirectory : public RunContext
{
public:
  /// Throws InputError when the directory cannot be written or its checkpoint cannot be resumed.
  explicit RunDirectory(RunSettings settings);
  ~RunDirectory() override;

  const std::filesystem::path &directory() const override;
  unsigned int threads() const override { return settings.threads; }
  bool is_writer() const override { return settings.writer; }
  void result(const std::string &name, double value, const std::string &unit) override;
  void note(const std::string &name, const std::string &text) override;
  void active(const std::vector<std::string> &terms, const std::vector<std::string> &fields) override;
  std::unique_ptr<Series> series(const std::string &name, const std::vector<Column> &columns) override;
  void progress(double fraction, const std::string &what) override;
  void say(const std::string &line) override;
  bool stop_requested() const override;
  void save_checkpoint(const std::function<void(std::ostream &)> &write) override;
  bool load_checkpoint(const std::function<void(std::istream &)> &read) override;

  /// Writes summary.json. status: finished, failed or stopped; message: why, may be empty. Throws OutputFailed when that or a
  /// series cannot be written; the summary then says "failed" if it can be written itself.
  void finish(const std::string &status, const std::string &message);

  /// True if --resume would go on from somewhere.
  bool has_checkpoint() const { return saved || resumed.has_value(); }

  /// True once anything was written into the directory.
  bool has_written() const { return prepared; }

  /// A rank that has written nothing writes the summary, because the one that should is not coming.
  void take_over() { settings.writer = prepared = true; }

private:
  struct Result
  {
    double value;
    std::string unit;
  };

  void prepare() const;
  void restore_record(const std::string &record);

  RunSettings settings;
  CheckpointStore checkpoints;
  std::optional<Checkpoint> resumed;
  std::map<std::string, std::uint64_t> resumed_lengths; ///< bytes of each series at the checkpoint
  std::map<std::string, std::shared_ptr<SeriesFile>> open_series;
  std::vector<std::pair<std::string, Result>> results; ///< in the order of the first call
  std::vector<std::pair<std::string, std::string>> notes;
  std::vector<std::string> active_terms, active_fields;
  mutable ProgressBar bar;
  ResourceMeter meter;
  bool saved = false; ///< a checkpoint, by this run
  mutable bool prepared = false;
};
} // namespace turgor
