#include "app/typed_command.h"

#include <algorithm>
#include <cstdlib>

namespace turgor {
namespace {
std::vector<std::string> &typed() {
  static std::vector<std::string> words = {"turgor"};
  return words;
}

std::string quoted(const std::string &word) {
  const bool is_plain =
      !word.empty() &&
      word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%") ==
          std::string::npos;
  if (is_plain) return word;
  std::string text = "'";
  for (const char letter : word) text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return text + "'";
}
}  // namespace

void remember_command(const int argc, const char *const *argv) {
  typed().assign(argv, argv + argc);
  if (typed().empty()) typed().emplace_back("turgor");
  if (const char *launcher = std::getenv("TURGOR_CALLED_AS"); launcher != nullptr && *launcher != '\0')
    typed()[0] = launcher;
}

std::string command_again(const std::vector<std::string> &without, const std::vector<std::string> &with) {
  const auto is_one_of = [](const std::vector<std::string> &words, const std::string &word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  std::string command;
  for (const std::string &word : typed())
    if (!is_one_of(without, word) && !is_one_of(with, word) &&
        word != "--under-mpi")  // which --ranks adds for its own
      command += (command.empty() ? "" : " ") + quoted(word);
  for (const std::string &word : with) command += " " + quoted(word);
  return command;
}
}  // namespace turgor
