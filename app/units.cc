#include "app/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>

namespace turgor {
namespace {
/// A number of base units: powers of m, kg, s, rad.
struct Unit {
  double factor = 1.;
  std::array<int, 4> powers = {0, 0, 0, 0};
};

struct NamedUnit {
  Unit unit;
  bool takes_prefix;
};

const std::map<std::string, NamedUnit> named = {{"m", {{1., {1, 0, 0, 0}}, true}},
                                                {"g", {{1e-3, {0, 1, 0, 0}}, true}},
                                                {"s", {{1., {0, 0, 1, 0}}, true}},
                                                {"N", {{1., {1, 1, -2, 0}}, true}},
                                                {"Pa", {{1., {-1, 1, -2, 0}}, true}},
                                                {"J", {{1., {2, 1, -2, 0}}, true}},
                                                {"W", {{1., {2, 1, -3, 0}}, true}},
                                                {"Hz", {{1., {0, 0, -1, 0}}, true}},
                                                {"bar", {{1e5, {-1, 1, -2, 0}}, true}},
                                                {"min", {{60., {0, 0, 1, 0}}, false}},
                                                {"h", {{3600., {0, 0, 1, 0}}, false}},
                                                {"d", {{86400., {0, 0, 1, 0}}, false}},
                                                {"rad", {{1., {0, 0, 0, 1}}, false}},
                                                {"1", {{1., {0, 0, 0, 0}}, false}},
                                                {"%", {{1e-2, {0, 0, 0, 0}}, false}},
                                                {"deg", {{M_PI / 180., {0, 0, 0, 1}}, false}},
                                                {"degrees", {{M_PI / 180., {0, 0, 0, 1}}, false}}};

const std::map<std::string, double> prefixes = {{"f", 1e-15},     {"p", 1e-12},     {"n", 1e-9}, {"u", 1e-6},
                                                {"\u00b5", 1e-6}, {"\u03bc", 1e-6}, {"m", 1e-3}, {"c", 1e-2},
                                                {"k", 1e3},       {"M", 1e6},       {"G", 1e9}};

std::optional<Unit> without_power(const std::string &word) {
  if (const auto found = named.find(word); found != named.end()) return found->second.unit;
  for (const auto &[prefix, size] : prefixes)
    if (word.compare(0, prefix.size(), prefix) == 0)
      if (const auto found = named.find(word.substr(prefix.size()));
          found != named.end() && found->second.takes_prefix) {
        Unit unit = found->second.unit;
        unit.factor *= size;
        return unit;
      }
  return std::nullopt;
}

/// A product of words, each with an integer power; / divides by the word behind it.
std::optional<Unit> parsed(const std::string &text) {
  Unit unit;
  int sign = 1;
  for (std::size_t place = 0; place < text.size();) {
    if (text[place] == ' ' || text[place] == '*' || text[place] == '/') {
      if (text[place] == '/' && sign < 0) return std::nullopt;
      sign = text[place++] == '/' ? -1 : sign;
      continue;
    }
    const std::size_t end = std::min(text.find_first_of(" */", place), text.size());
    const std::string word = text.substr(place, end - place);
    const std::size_t mark = std::min(word.find('^'), word.size());
    char *rest = nullptr;
    const long power = mark == word.size() ? 1 : std::strtol(word.c_str() + mark + 1, &rest, 10);
    const std::optional<Unit> base = without_power(word.substr(0, mark));
    if (!base || (rest != nullptr && *rest != '\0') || power < -9 || power > 9 || power == 0)
      return std::nullopt;
    const int times = sign * int(power);
    unit.factor *= std::pow(base->factor, times);
    for (std::size_t k = 0; k < unit.powers.size(); ++k) unit.powers[k] += times * base->powers[k];
    sign = 1;
    place = end;
  }
  return sign > 0 ? std::optional<Unit>(unit) : std::nullopt;
}
}  // namespace

std::optional<double> unit_factor(const std::string &from, const std::string &to) {
  if (from == to) return 1.;
  const std::optional<Unit> a = parsed(from), b = parsed(to);
  if (!a || !b || a->powers != b->powers) return std::nullopt;
  return a->factor / b->factor;
}
}  // namespace turgor
