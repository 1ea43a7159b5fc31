#include "run/choice.h"

#include "run/entry_pattern.h"

#include <algorithm>
#include <stdexcept>

namespace turgor {
std::string word_at(const std::string &words, const std::size_t number) {
  return Patterns::Selection(words).choices.at(number);
}

std::size_t number_of_word(const std::string &words, const std::string &word) {
  const std::vector<std::string> all = Patterns::Selection(words).choices;
  const auto found = std::find(all.begin(), all.end(), word);
  if (found == all.end()) throw std::invalid_argument("'" + word + "' is none of " + words + ".");
  return std::size_t(found - all.begin());
}
}  // namespace turgor
