#include "rve/tensor_path.h"

#include "micro/geometry/tensor_text.h"
#include "run/run_context.h"
#include "run/user_text.h"

#include <algorithm>

namespace turgor {
TensorPath::TensorPath(const std::string &text, const std::string &entry) {
  for (const std::string &keyframe : split_trimmed(text + "|", '|')) {
    const std::vector<std::string> parts = split_trimmed(keyframe + ":", ':');
    if (parts.size() != 2)
      throw InputError(entry + " has the keyframe '" + keyframe +
                       "', but one is written as: time : xx, xy; yx, yy");
    times.push_back(read_numbers(parts[0], 1, entry, "time : xx, xy; yx, yy")[0]);
    keyframes.push_back(parse_tensor(parts[1], entry));
    texts.push_back(keyframe);
    if (times.size() > 1 && !(times.back() > times[times.size() - 2]))
      throw InputError(entry + " has the keyframe '" + keyframe + "', but times have to rise.");
  }
}

std::size_t TensorPath::segment(const double time) const {
  std::size_t s = 0;
  while (s + 2 < times.size() && time > times[s + 1]) ++s;
  return s;
}

Tensor2<2> TensorPath::at(const double time) const {
  if (times.size() < 2) return keyframes.front();
  const std::size_t s = segment(time);
  if (time == times[s + 1]) return keyframes[s + 1];
  const double part = std::clamp((time - times[s]) / (times[s + 1] - times[s]), 0., 1.);
  return keyframes[s] + part * (keyframes[s + 1] - keyframes[s]);
}

Tensor2<2> TensorPath::rate(const double time) const {
  if (times.size() < 2 || time > times.back()) return Tensor2<2>::Zero();
  const std::size_t s = segment(time);
  return (keyframes[s + 1] - keyframes[s]) / (times[s + 1] - times[s]);
}
}  // namespace turgor
