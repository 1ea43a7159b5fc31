// A closed form written in an input file: "2e5*(1 - exp(-time/1e-3))". Operators, functions and constants are
// muParser's
// (+ - * / ^, sin, exp, sqrt, min, max, a < b ? c : d, ...) and pi; every other name is a variable.
//
//   Expression("force/2")([&](const std::string &name) { return table.column(name)[row]; })
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace turgor {
class Expression {
 public:
  /// Throws std::invalid_argument with the reason when the text cannot be understood.
  explicit Expression(const std::string &text);

  /// Its variables, sorted.
  const std::vector<std::string> &variables() const { return names; }

  /// Asks for each variable once. Throws what value_of throws.
  double operator()(const std::function<double(const std::string &)> &value_of) const;

 private:
  std::string text;
  std::vector<std::string> names;
};
}  // namespace turgor
