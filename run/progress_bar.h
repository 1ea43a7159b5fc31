// Progress with the time left, on stderr: one updating line on a terminal, else a line
// about every ten seconds. update() looks at the clock only, so it may be called every step.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace turgor {
class ProgressBar {
 public:
  explicit ProgressBar(bool enabled);
  void update(double fraction, const std::string &what);
  void clear();  ///< before another line is printed
  void finish();

  static std::string in_words(double seconds);  ///< "42 s", "3 min 5 s", "2 h 10 min"

 private:
  using Clock = std::chrono::steady_clock;
  bool enabled, terminal;
  bool line_shown = false;
  std::optional<double> first_fraction;  ///< a resumed run does not begin at 0
  Clock::time_point start, last_shown;
};
}  // namespace turgor
