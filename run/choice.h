// The words of an input file for the values of an enum, said once, where the enum is declared.
//
//   enum class Rim { none, quiescent, necrotic };
//   constexpr const char *words_of(Rim) { return "none|quiescent|necrotic"; } // one for each value, in order
//
//   prm.add_parameter("Rim", rim, "What happens below the viable rim. Units: none.");   // InputEntries
//   word_of(rim)
//     // "none", for messages
#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <type_traits>

namespace turgor {
template <class E>
concept Choice = std::is_enum_v<E> && requires(E value) {
  { words_of(value) } -> std::convertible_to<const char *>;
};

/// words: "a|b|c". Throws std::out_of_range, or std::invalid_argument for a word that is not among them.
std::string word_at(const std::string &words, std::size_t number);
std::size_t number_of_word(const std::string &words, const std::string &word);

template <Choice E>
std::string word_of(const E value) {
  return word_at(words_of(value), static_cast<std::size_t>(value));
}

template <Choice E>
E choice_of(const std::string &word) {
  return static_cast<E>(number_of_word(words_of(E{}), word));
}
}  // namespace turgor
