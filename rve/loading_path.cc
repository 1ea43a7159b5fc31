#include "rve/loading_path.h"

#include "micro/geometry/tensor_text.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/user_text.h"

#include <algorithm>

namespace turgor {
namespace {
/// What no cell lives through: a wave crosses it ten thousand times slower.
void require_rate(const Tensor2<2> &F_dot, const std::string &entry, const std::string &advice) {
  constexpr double most = 1e9;  // 1/s
  if (const double rate = F_dot.cwiseAbs().maxCoeff(); !(rate <= most))
    throw InputError(entry + " has a rate of " + number_text(rate) + " 1/s, allowed are " +
                     number_text(most) + ": " + advice + ".");
}

std::vector<int> found_components(const std::string &text) {
  std::vector<int> all;
  if (text == "none") return all;
  const std::string entry = "Path/Stress components is '" + text + "', but ";
  for (const std::string &word : split_trimmed(text + ",", ',')) {
    const std::vector<std::string> names = {"xx", "xy", "yx", "yy"};
    const auto at = std::find(names.begin(), names.end(), word);
    if (at == names.end()) throw InputError(entry + "allowed are none or a list of xx, xy, yx, yy.");
    const int k = int(at - names.begin());
    if (std::find(all.begin(), all.end(), k) != all.end())
      throw InputError(entry + word + " is named twice.");
    all.push_back(k);
  }
  std::sort(all.begin(), all.end());
  if (std::count(all.begin(), all.end(), 1) + std::count(all.begin(), all.end(), 2) == 2)
    throw InputError(entry +
                     "of xy and yx one has to be given as F: it fixes the rotation, which no stress can.");
  return all;
}
}  // namespace

void LoadingEntries::add_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter(
      "Keyframes", path,
      "Deformation gradient over time, linear between keyframes: time : xx, xy; yx, yy | time : ... "
      "Units: s, 1.",
      Anything());
  prm.add_parameter("Points", points, "Evenly spaced times at which the stress is asked for. Units: 1.",
                    Integer(2, 1000000));
  prm.add_parameter("F", F_by_hand,
                    "One deformation gradient by hand, xx, xy; yx, yy, instead of the path. Units: 1.",
                    Anything());
  prm.add_parameter(
      "F_dot", F_dot_by_hand,
      "Its rate, xx, xy; yx, yy; empty: the slope of the path, or zero where F is given by hand. "
      "Units: 1/s.",
      Anything());
  prm.add_parameter(
      "Stress components", found,
      "Components of F, xx, xy, yx or yy, that are not taken from Keyframes but found so that the stress P "
      "there is that of Stress keyframes: xx for tissue pressed along y with free sides, 'xx, xy, yy' for "
      "uniaxial or biaxial stress and creep. Of xy and yx one has to be given, which fixes the rotation. "
      "Where "
      "F_dot is empty, rates of what is found are part of the search (implicit Euler), and the first "
      "point is at rest. none: F is as it is given. Units: none.",
      Anything());
  prm.rename("Free component", "Stress components");
  prm.add_parameter(
      "Stress keyframes", stress,
      "First Piola-Kirchhoff stress P (force over undeformed area) over time, linear between keyframes: "
      "time : xx, xy; yx, yy | time : ...; only the Stress components count. Empty: zero. Units: s, Pa.",
      Anything());
}

LoadingPath::LoadingPath(const LoadingEntries &e) : components(found_components(e.found)), points(e.points) {
  if (!e.F_dot_by_hand.empty()) {
    F_dot = parse_tensor(e.F_dot_by_hand, "Path/F_dot");
    require_rate(*F_dot, "Path/F_dot", "take a smaller one");
  }
  if (e.F_by_hand.empty()) {
    path.emplace(e.path, "Path/Keyframes");
    for (const double time : path->keyframe_times())
      require_rate(path->F_dot(time), "Path/Keyframes", "give the path more time");
  } else {
    F = parse_tensor(e.F_by_hand, "Path/F");
    if (!(F->determinant() > 0.))
      throw InputError("Path/F is '" + e.F_by_hand + "', but its determinant has to be positive.");
  }
  if (e.stress.empty()) return;
  if (components.empty())
    throw InputError("Path/Stress keyframes is given, but Path/Stress components = none finds no F for it.");
  stress.emplace(e.stress, "Path/Stress keyframes");
  constexpr double most = 1e9;  // Pa
  for (const double time : stress->keyframe_times())
    if (const double largest = stress->at(time).cwiseAbs().maxCoeff(); !(largest <= most))
      throw InputError("Path/Stress keyframes has a stress of " + number_text(largest) + " Pa, allowed are " +
                       number_text(most) + ".");
}

std::vector<double> LoadingPath::times() const {
  if (F) return {0.};
  std::vector<double> all;
  for (unsigned int i = 0; i < points; ++i)
    all.push_back(i + 1 == points ? path->end()
                                  : path->start() + (path->end() - path->start()) * i / (points - 1));
  return all;
}

LoadingPath::Load LoadingPath::at(const double time) const {
  Load load;
  load.time = time;
  if (F)
    load.F = *F;
  else {
    load.F = path->F(time);
    load.F_dot = path->F_dot(time);
  }
  if (F_dot) load.F_dot = *F_dot;
  if (stress) load.P = stress->at(time);
  return load;
}
}  // namespace turgor
