// A RunContext that keeps everything in memory: series as rows, one checkpoint, results.
// It can ask to stop at the n-th question, or while a named work is under way. Fields go to its directory,
// removed at the end.
#pragma once

#include "run/run_context.h"
#include "run/archive.h"

#include <unistd.h>

#include <cmath>
#include <map>

namespace turgor::test {
struct Disk  // what survives a run
{
  std::map<std::string, std::vector<std::vector<double>>> series;
  std::string checkpoint;
  std::map<std::string, std::size_t> rows_at_checkpoint;
};

class MemoryContext : public RunContext {
 public:
  MemoryContext(Disk &d, bool resume_)
      : disk(d),
        resume(resume_),
        path(std::filesystem::temp_directory_path() / ("turgor_memory_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path);
  }
  ~MemoryContext() override { std::filesystem::remove_all(path); }

  unsigned int use_threads = 1;
  unsigned long stop_at = 0;  // the question that is answered with yes; 0 = never
  std::string stop_while;     // as progress() names it; empty = never
  mutable unsigned long asked = 0;
  std::map<std::string, double> results;
  std::map<std::string, std::string> notes;

  const std::filesystem::path &directory() const override { return path; }
  unsigned int threads() const override { return use_threads; }
  bool is_writer() const override { return true; }
  void result(const std::string &name, double value, const std::string &) override {
    if (!std::isfinite(value)) throw RunFailed(name + " is not finite");
    results[name] = value;
  }
  void note(const std::string &name, const std::string &text) override { notes[name] = text; }
  void active(const std::vector<std::string> &, const std::vector<std::string> &) override {}

  std::unique_ptr<Series> series(const std::string &name, const std::vector<Column> &) override {
    auto &rows = disk.series[name];
    rows.resize(resume ? disk.rows_at_checkpoint[name] : 0);
    struct Rows : Series {
      std::vector<std::vector<double>> &to;
      explicit Rows(std::vector<std::vector<double>> &r) : to(r) {}
      void add_row(const std::vector<double> &values) override { to.push_back(values); }
    };
    return std::make_unique<Rows>(rows);
  }

  void progress(double, const std::string &what) override { doing = what; }
  void say(const std::string &) override {}
  bool stop_requested() const override {
    return ++asked == stop_at || (!stop_while.empty() && doing == stop_while);
  }
  void save_checkpoint(const std::function<void(Archive &)> &list) override {
    disk.checkpoint = archived(list);
    for (const auto &[name, rows] : disk.series) disk.rows_at_checkpoint[name] = rows.size();
  }
  bool load_checkpoint(const std::function<void(Archive &)> &list) override {
    if (!resume || disk.checkpoint.empty()) return false;
    restore(disk.checkpoint, list);
    return true;
  }

 private:
  Disk &disk;
  bool resume;
  std::string doing;
  std::filesystem::path path;
};
}  // namespace turgor::test
