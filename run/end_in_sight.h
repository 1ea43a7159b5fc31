// Whether a run comes to its end in any time that somebody waits for: steps may have shrunk so far that what
// is left would take weeks, and a run that stays at 0.0 % says nothing of it.
//
//   EndInSight sight;
//   if (const std::string far = sight.after_step(t / end); !far.empty()) context.say(far + advice);
//
// The pace is that of the last steps: steps begin short and grow, and what one look has seen is no judgement.
#pragma once

#include "run/number_text.h"

#include <chrono>
#include <cstdint>
#include <string>

namespace turgor {
class EndInSight {
 public:
  /// share: of the run that lies behind, in [0, 1], not falling; seconds: that it has taken. Once in a run a
  /// sentence without its full stop, else empty.
  std::string after_step(const double share, const double seconds) {
    ++steps;
    if (said || seconds - seconds_then < pause) return {};
    const double gained = share - share_then, left = 1. - share;
    const bool is_far = left * (seconds - seconds_then) > weeks * gained;
    const std::string count =
        gained > 0. ? "about " + number_text(double(steps) * left / gained) : "countless";
    far = is_far ? far + 1 : 0;
    steps = 0;
    seconds_then = seconds;
    share_then = share;
    if (far < looks) return {};
    said = true;
    return "no end is in sight: the steps are so short that " + count +
           " more of them are left, more than two weeks at this pace";
  }

  std::string after_step(const double share) {
    return after_step(share, std::chrono::duration<double>(Clock::now() - start).count());
  }

  static constexpr double weeks = 14. * 86400.;  ///< s
  static constexpr double pause = 5.;            ///< s between two looks
  static constexpr int looks = 3;                ///< in turn, that see no end

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start = Clock::now();
  std::uint64_t steps = 0;
  double share_then = 0., seconds_then = 0.;
  int far = 0;
  bool said = false;
};
}  // namespace turgor
