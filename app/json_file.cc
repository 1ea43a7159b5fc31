#include "app/json_file.h"

#include "run/number_text.h"
#include "run/run_context.h"
#include "run/user_text.h"

#include <algorithm>
#include <vector>

namespace turgor {
using Json = nlohmann::json;

Json read_json(const std::filesystem::path &file) {
  constexpr int deepest = 64;
  const std::string text = read_text(file);
  const auto refuse = [&](const std::size_t byte, const std::string &what) {
    const auto end = text.begin() + static_cast<long>(std::min(byte, text.size()));
    throw InputError(file.string() + ", line " + number_text(std::count(text.begin(), end, '\n') + 1) + ": " +
                     what);
  };
  // Brackets outside texts; the parser itself would go as deep as they do.
  int depth = 0;
  for (std::size_t place = 0; place < text.size(); ++place)
    if (text[place] == '"')
      for (++place; place < text.size() && text[place] != '"'; ++place) place += text[place] == '\\' ? 1 : 0;
    else if (text[place] == '{' || text[place] == '[') {
      if (++depth > deepest)
        refuse(place,
               "brackets are nested more than " + number_text(deepest) + " deep; nothing here needs that.");
    } else if (text[place] == '}' || text[place] == ']')
      --depth;
  try {
    return Json::parse(text);
  } catch (const Json::parse_error &problem) {
    refuse(problem.byte > 0 ? problem.byte - 1 : 0,
           "this is not JSON; look for a comma, a quote or a bracket that is missing or too many here or "
           "just before.");
  } catch (const Json::exception &) {
    throw InputError(file.string() + ": it holds a number beyond what a double can hold.");
  }
  return {};
}

template <typename Value>
Value json_entry(const Json &json, const std::string &key, const Value &otherwise, const std::string &where,
                 const std::string &what) {
  if (!json.contains(key)) return otherwise;
  try {
    if (!std::is_same_v<Value, std::string> && !std::is_same_v<Value, std::vector<std::string>> &&
        !json[key].is_number())
      throw InputError("");
    return json[key].get<Value>();
  } catch (const std::exception &) {
    throw InputError(where + ": '" + key + "' has to be " + what + ".");
  }
}
template double json_entry(const Json &, const std::string &, const double &, const std::string &,
                           const std::string &);
template std::string json_entry(const Json &, const std::string &, const std::string &, const std::string &,
                                const std::string &);
template std::vector<std::string> json_entry(const Json &, const std::string &,
                                             const std::vector<std::string> &, const std::string &,
                                             const std::string &);
}  // namespace turgor
