// What a running scenario is given: its output directory, a place for results,
// checkpoints, progress and the wish to stop. One per run; scenarios never touch
// files, signals or the terminal by any other way.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace turgor {
class Archive;

/// A run that cannot go on (divergence): says where and when; exit code 1. The last good state has been
/// saved.
class RunFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Wrong input: says which entry, its value and what is allowed; exit code 2, nothing written.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A run stopped by Ctrl-C or kill after it saved its checkpoint; exit code 130.
class RunStopped : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A table written row by row: DIR/NAME.csv, header "time [s],tip [m]". After resume, rows beyond the
/// checkpoint are cut.
class Series {
 public:
  virtual ~Series() = default;
  virtual void add_row(const std::vector<double> &values) = 0;  ///< throws RunFailed for a non-finite value
};

struct Column {
  std::string name, unit;
};

class RunContext {
 public:
  virtual ~RunContext() = default;

  virtual const std::filesystem::path &directory() const = 0;
  virtual unsigned int threads() const = 0;
  virtual bool is_writer() const = 0;  ///< false on MPI ranks > 0: every writing call is then a no-op

  /// results of summary.json; throws RunFailed for a non-finite value.
  virtual void result(const std::string &name, double value, const std::string &unit) = 0;
  virtual void note(const std::string &name, const std::string &text) = 0;
  virtual void active(const std::vector<std::string> &terms, const std::vector<std::string> &fields) = 0;

  virtual std::unique_ptr<Series> series(const std::string &name, const std::vector<Column> &columns) = 0;

  /// Throws std::logic_error where the scene does not define (Scenario::outputs) what it writes to a file of
  /// its directory.
  virtual void require_defined(const std::string & /*file*/, const std::string & /*name*/,
                               const std::string & /*unit*/) const {}

  /// Progress bar with time left; fraction in [0, 1]. Cheap to call every step.
  virtual void progress(double fraction, const std::string &what) = 0;

  /// A line for the person at the terminal.
  virtual void say(const std::string &line) = 0;

  /// True after Ctrl-C, SIGTERM: save a checkpoint, then throw RunStopped.
  virtual bool stop_requested() const = 0;

  /// Atomic (temp, fsync, rename), two generations, with version, input hash and checksum; the state is what
  /// the list names. Also records how long each Series is.
  virtual void save_checkpoint(const std::function<void(Archive &)> &list) = 0;

  /// With --resume and a checkpoint of this input: takes it from there by the same list and returns true.
  /// Falls back to the older generation when the newer is damaged. Throws InputError when it belongs to
  /// another input or version.
  virtual bool load_checkpoint(const std::function<void(Archive &)> &list) = 0;
};
}  // namespace turgor
