// All that is wrong with an input, so that it is mended at once: each sentence on a line of its own in one
// InputError.
//
//   Mistakes mistakes;
//   mistakes.take([&] { refuse_repeated(text); });
//   mistakes.refuse();                              // throws, if there was one
#pragma once

#include "run/number_text.h"
#include "run/run_context.h"

#include <string>
#include <vector>

namespace turgor {
class Mistakes {
 public:
  void add(const std::string &sentence) { all.push_back(sentence); }
  bool none() const { return all.empty(); }

  /// What the action is refused for.
  template <class Action>
  void take(const Action &action) {
    try {
      action();
    } catch (const InputError &problem) {
      add(problem.what());
    }
  }

  /// Throws InputError where there are some.
  void refuse() const {
    constexpr std::size_t most = 20;  // more than that is no input of ours
    std::string text;
    for (std::size_t k = 0; k < all.size() && k < most; ++k) text += (k == 0 ? "" : next_line) + all[k];
    if (all.size() > most) text += next_line + "and " + number_text(all.size() - most) + " more.";
    if (!none()) throw InputError(text);
  }

 private:
  inline static const std::string next_line = "\n        ";  // below the first, after "turgor: "
  std::vector<std::string> all;
};
}  // namespace turgor
