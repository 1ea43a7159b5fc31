#include "app/cached_run.h"

#include "app/child_process.h"
#include "app/json_file.h"
#include "run/checksum.h"
#include "run/number_text.h"

namespace turgor {
std::filesystem::path cache_of(const std::filesystem::path &chosen) {
  return (chosen.empty() ? std::filesystem::path("runs") : chosen) / "cache";
}

CachedRun cached_run(const std::filesystem::path &cache, const std::string &stem, const RunIdentity &identity,
                     const unsigned int threads, const bool fresh) {
  CachedRun run;
  const std::string key = identity.hash() + " " + number_text(threads);
  run.directory = cache / (stem + "_" + hexadecimal(fnv1a(key)));
  if (read_summary(run) && !fresh)
    run.status = "finished";
  else if (run.status != "finished" && std::filesystem::exists(run.directory / "checkpoint.0"))
    run.status = "partly";
  else if (fresh)
    run.status = "waiting";
  return run;
}

bool read_summary(CachedRun &run) {
  const std::filesystem::path file = run.directory / "summary.json";
  if (!std::filesystem::exists(file)) return false;
  try {
    const nlohmann::json json = read_json(file);
    run.use = {json.value("wall_time_s", 0.), json.value("cpu_time_s", 0.),
               json.value("peak_memory_bytes", std::uint64_t(0))};
    run.message = json.value("message", "");
    run.date = json.value("date", "").substr(0, 10);
    run.status = json.value("status", "failed");
  } catch (const std::exception &)  // no summary of ours
  {
    return false;
  }
  return run.status == "finished";
}

void compute(CachedRun &run, const RunRequest &request, const bool fresh,
             const std::function<void(double)> &waiting) {
  std::filesystem::create_directories(run.directory.parent_path());
  const std::string log = run.directory.string() + ".log";
  std::filesystem::remove(log);
  std::vector<std::string> words = {
      this_program(), "run",       request.input.string(),      "-o", run.directory.string(),
      "--quiet",      "--threads", number_text(request.threads)};
  for (const std::string &value : request.overrides) words.insert(words.end(), {"--set", value});
  if (!fresh) words.push_back("--resume");
  words.push_back("--overwrite");  // this cache is ours: what cannot be resumed is started again
  const ChildEnd end = run_child(words, log, SIGTERM, waiting);
  run.status.clear();
  if (!read_summary(run) && run.status.empty()) {
    run.status = end.code == 130 ? "stopped" : "failed";
    run.message = "It ended with code " + number_text(end.code) + "; " + log + " has its last words.";
    run.use = end.use;
  }
}
}  // namespace turgor
