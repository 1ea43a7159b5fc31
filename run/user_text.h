// Text a user wrote: blanks around it, lists, whole files. Numbers in it are read by read_number() of
// number_text.h.
//
//   for (const std::string &part : split_trimmed("a; b", ';')) use(part);
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace turgor {
/// Without blanks, tabs and ends of lines around it.
std::string trimmed(std::string_view text);

/// The parts between separators, each trimmed; nothing follows a separator at the very end.
std::vector<std::string> split_trimmed(std::string_view text, char separator);

/// The same without empty parts, where a part may hold the separator itself, written with a backslash before
/// it: split_escaped("a\\;b; c;", ';') is {"a;b", "c"}.
std::vector<std::string> split_escaped(std::string_view text, char separator);

/// At most 200 bytes for a message, at the end of a character, with "..." where something was cut.
std::string shortened(const std::string &text);

/// "x, y, z": `count` numbers. Throws InputError naming the entry and how it is `written` ("x, y, z").
std::vector<double> read_numbers(const std::string &text, std::size_t count, const std::string &entry,
                                 const std::string &written);

/// The number of the first line (from 1) that is not UTF-8; 0 where all are.
unsigned int line_that_is_not_utf8(std::string_view text);

/// A text file as a user's editor may have saved it, without its byte-order mark. Throws InputError, naming
/// file and line, when it cannot be read, is no text in UTF-8 or holds more than `largest` bytes.
std::string read_text(const std::filesystem::path &file, std::uint64_t largest = std::uint64_t(1) << 26);
}  // namespace turgor
