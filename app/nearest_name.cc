#include "app/nearest_name.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace turgor {
unsigned int edit_distance(const std::string &a, const std::string &b) {
  const auto lower = [](const char letter) { return std::tolower(static_cast<unsigned char>(letter)); };
  std::vector<unsigned int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0u);
  for (std::size_t i = 0; i < a.size(); ++i) {
    unsigned int diagonal = row[0];
    row[0] = static_cast<unsigned int>(i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const unsigned int replace = diagonal + (lower(a[i]) == lower(b[j]) ? 0u : 1u);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replace, diagonal + 1u, row[j] + 1u});
    }
  }
  return row.back();
}

std::string nearest_name(const std::string &name, const std::vector<std::string> &known) {
  std::string nearest;
  unsigned int least = std::max(2u, static_cast<unsigned int>(name.size()) / 3u) + 1u;
  for (const std::string &candidate : known)
    if (const unsigned int distance = edit_distance(name, candidate); distance < least) {
      least = distance;
      nearest = candidate;
    }
  return nearest;
}

std::string suggestion(const std::string &name, const std::vector<std::string> &known) {
  if (const std::string near = nearest_name(name, known); !near.empty())
    return " Did you mean '" + near + "'?";
  if (known.empty()) return "";
  std::string list;
  for (std::size_t i = 0; i < known.size() && i < 12; ++i) list += (i == 0 ? "" : ", ") + known[i];
  return " Known: " + list + (known.size() > 12 ? ", ..." : "") + ".";
}
}  // namespace turgor
