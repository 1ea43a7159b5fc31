#include "run/user_text.h"

#include "run/number_advice.h"
#include "run/number_text.h"
#include "run/run_context.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

namespace turgor {
namespace {
std::string_view inside(const std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\v\f";
  const auto first = text.find_first_not_of(blanks);
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Bytes of the character that begins here; 0: it is none (RFC 3629: no overlong forms, no surrogates, up to
/// U+10FFFF).
std::size_t length_of_character(const std::string_view text) {
  const auto byte = [&](const std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xC2 && first < 0xE0   ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(k) & 0xC0) != 0x80) return 0;
  const unsigned char second = byte(1);
  const bool is_wrong = (first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) ||
                        (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90);
  return is_wrong ? 0 : length;
}
}  // namespace

std::string trimmed(const std::string_view text) { return std::string(inside(text)); }

std::vector<std::string> split_trimmed(const std::string_view text, const char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(trimmed(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return parts;
}

std::vector<std::string> split_escaped(const std::string_view text, const char separator) {
  std::vector<std::string> parts(1);
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\\' && i + 1 < text.size() && text[i + 1] == separator)
      parts.back() += text[++i];
    else if (text[i] == separator)
      parts.emplace_back();
    else
      parts.back() += text[i];
  for (std::string &part : parts) part = trimmed(part);
  parts.erase(std::remove(parts.begin(), parts.end(), std::string()), parts.end());
  return parts;
}

std::string shortened(const std::string &text) {
  constexpr std::size_t longest = 200;
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

std::vector<double> read_numbers(const std::string &text, const std::size_t count, const std::string &entry,
                                 const std::string &written) {
  std::vector<double> numbers;
  for (const std::string &word : split_trimmed(text + ",", ',')) {
    const auto value = read_number(word);
    if (!value || !std::isfinite(*value))
      throw InputError(entry + " holds '" + word + "' where a finite number is expected; it is written as: " +
                       written + "." + number_advice(word, ""));
    numbers.push_back(*value);
  }
  if (numbers.size() != count)
    throw InputError(entry + " is '" + text + "', but it is written as: " + written);
  return numbers;
}

unsigned int line_that_is_not_utf8(const std::string_view text) {
  unsigned int line = 1;
  for (std::size_t place = 0; place < text.size();) {
    const std::size_t length = length_of_character(text.substr(place));
    if (length == 0) return line;
    line += text[place] == '\n' ? 1 : 0;
    place += length;
  }
  return 0;
}

std::string read_text(const std::filesystem::path &file, const std::uint64_t largest) {
  const auto refuse = [&](const std::string &why) {
    throw InputError("cannot read " + file.string() + ": " + why + ".");
  };
  errno = 0;
  std::error_code problem;
  if (std::filesystem::is_directory(file, problem)) refuse("it is a directory");
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse(std::strerror(errno));
  std::string text;
  char block[1 << 16];
  while (in.read(block, sizeof block) || in.gcount() > 0) {
    text.append(block, static_cast<std::size_t>(in.gcount()));
    if (text.size() > largest)
      refuse("it holds more than " + number_text(static_cast<double>(largest) / 1e6, 3) +
             " MB, too much for a file of this kind");
  }
  if (text.find('\0') != std::string::npos) throw InputError(file.string() + " is not a text file.");
  if (const unsigned int line = line_that_is_not_utf8(text); line > 0)
    throw InputError(file.string() + ", line " + number_text(line) +
                     ": it is not text in UTF-8; save the file as UTF-8.");
  if (text.compare(0, 3, "\xEF\xBB\xBF") == 0) text.erase(0, 3);
  return text;
}
}  // namespace turgor
