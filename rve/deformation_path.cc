#include "rve/deformation_path.h"

#include "micro/io/run_context.h"

#include <cmath>
#include <sstream>

namespace turgor
{
namespace
{
std::vector<std::string> split(const std::string &text, const char separator)
{
  std::vector<std::string> parts(1);
  for (const char c : text)
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

double parse_number(const std::string &text, const std::string &entry)
{
  std::istringstream in(text);
  double value;
  std::string rest;
  if (!(in >> value) || (in >> rest) || !std::isfinite(value))
    throw InputError(entry + " holds '" + text + "' where a finite number is expected.");
  return value;
}
} // namespace

Tensor2<2> parse_tensor(const std::string &text, const std::string &entry)
{
  const std::vector<std::string> rows = split(text, ';');
  Tensor2<2> result;
  if (rows.size() != 2)
    throw InputError(entry + " is '" + text + "', but a matrix is written as: xx, xy; yx, yy");
  for (int a = 0; a < 2; ++a)
    {
      const std::vector<std::string> columns = split(rows[a], ',');
      if (columns.size() != 2)
        throw InputError(entry + " is '" + text + "', but a matrix is written as: xx, xy; yx, yy");
      for (int b = 0; b < 2; ++b)
        result(a, b) = parse_number(columns[b], entry);
    }
  return result;
}

DeformationPath::DeformationPath(const std::string &text, const std::string &entry)
{
  for (const std::string &keyframe : split(text, '|'))
    {
      const std::vector<std::string> parts = split(keyframe, ':');
      if (parts.size() != 2)
        throw InputError(entry + " has the keyframe '" + keyframe + "', but one is written as: time : xx, xy; yx, yy");
      times.push_back(parse_number(parts[0], entry));
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
