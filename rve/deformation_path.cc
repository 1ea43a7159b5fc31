#include "rve/deformation_path.h"

#include "micro/engine/tensor_text.h"
#include "micro/io/run_context.h"
#include "micro/io/user_text.h"

namespace turgor
{
DeformationPath::DeformationPath(const std::string &text, const std::string &entry)
{
  for (const std::string &keyframe : split_trimmed(text + "|", '|'))
    {
      const std::vector<std::string> parts = split_trimmed(keyframe + ":", ':');
      if (parts.size() != 2)
        throw InputError(entry + " has the keyframe '" + keyframe + "', but one is written as: time : xx, xy; yx, yy");
      times.push_back(read_numbers(parts[0], 1, entry, "time : xx, xy; yx, yy")[0]);
      keyframes.push_back(parse_tensor(parts[1], entry));
      if (times.size() > 1 && !(times.back() > times[times.size() - 2]))
        throw InputError(entry + " has the keyframe '" + keyframe + "', but times have to rise.");
      if (!(keyframes.back().determinant() > 0.))
        throw InputError(entry + " has the keyframe '" + keyframe + "', but det F has to be positive.");
    }
  if (times.size() < 2)
    throw InputError(entry + " has one keyframe, but a path needs at least two (or set Path/F).");
}

std::size_t DeformationPath::segment(const double time) const
{
  std::size_t s = 0;
  while (s + 2 < times.size() && time > times[s + 1])
    ++s;
  return s;
}

Tensor2<2> DeformationPath::F(const double time) const
{
  const std::size_t s = segment(time);
  if (time == times[s + 1])
    return keyframes[s + 1];
  const double part = (time - times[s]) / (times[s + 1] - times[s]);
  return keyframes[s] + part * (keyframes[s + 1] - keyframes[s]);
}

Tensor2<2> DeformationPath::F_dot(const double time) const
{
  const std::size_t s = segment(time);
  return (keyframes[s + 1] - keyframes[s]) / (times[s + 1] - times[s]);
}
} // namespace turgor
