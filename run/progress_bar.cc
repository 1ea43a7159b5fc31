#include "run/progress_bar.h"

#include "run/number_text.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace turgor {
ProgressBar::ProgressBar(const bool enabled_)
    : enabled(enabled_), terminal(::isatty(STDERR_FILENO) == 1), start(Clock::now()), last_shown(start) {}

std::string ProgressBar::in_words(const double seconds) {
  constexpr double year = 365.25 * 86400.;
  if (!(seconds < year)) return number_text(std::floor(std::min(seconds / year, 1e12))) + " years or more";
  const long whole = std::lround(std::max(seconds, 0.));
  if (whole < 60) return number_text(whole) + " s";
  if (whole < 3600) return number_text(whole / 60) + " min " + number_text(whole % 60) + " s";
  return number_text(whole / 3600) + " h " + number_text(whole % 3600 / 60) + " min";
}

void ProgressBar::update(const double fraction, const std::string &what) {
  if (!enabled) return;
  const auto now = Clock::now();
  if (!first_fraction) {
    first_fraction = fraction;
    start = now;
  }
  const auto pause = terminal ? std::chrono::milliseconds(200) : std::chrono::milliseconds(10000);
  if (now - last_shown < pause) return;
  last_shown = now;
  const double part = std::clamp(fraction, 0., 1.);
  const double elapsed = std::chrono::duration<double>(now - start).count();
  const double gained = part - *first_fraction;
  const std::string left =
      gained > 0. ? in_words(elapsed * (1. - part) / gained) + " left" : "time left unknown";
  if (terminal) {
    constexpr int width = 30;
    const int full = static_cast<int>(part * width);
    const std::string bar = std::string(static_cast<std::size_t>(full), '#') +
                            std::string(static_cast<std::size_t>(width - full), '.');
    std::fprintf(stderr, "\r\033[K[%s] %5.1f %%  %s  %s", bar.c_str(), 100. * part, left.c_str(),
                 what.c_str());
    line_shown = true;
  } else
    std::fprintf(stderr, "%5.1f %%  %s  %s\n", 100. * part, left.c_str(), what.c_str());
  std::fflush(stderr);
}

void ProgressBar::clear() {
  if (line_shown) std::fprintf(stderr, "\r\033[K");
  line_shown = false;
}

void ProgressBar::finish() {
  clear();
  std::fflush(stderr);
}
}  // namespace turgor
