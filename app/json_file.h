// A JSON file that a user may have written or touched: read whole, or refused in a sentence with file and
// line. Nesting is limited before anything is built from it, so that no file can exhaust stack or memory.
//
//   const nlohmann::json json = read_json("inputs/validation/laplace.json");
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace turgor {
/// Throws InputError when the file cannot be read, is not text, not JSON or nested more than 64 deep.
nlohmann::json read_json(const std::filesystem::path &file);

/// The entry `key` of an object, or `otherwise` where it is not there. Throws InputError: "WHERE: 'key' has
/// to be `what`."
template <typename Value>
Value json_entry(const nlohmann::json &json, const std::string &key, const Value &otherwise,
                 const std::string &where, const std::string &what);
}  // namespace turgor
