#include "app/expression.h"

#include <muParser.h>

#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
mu::Parser parser_of(const std::string &text) {
  mu::Parser parser;
  parser.DefineConst("pi", M_PI);
  parser.SetExpr(text);
  return parser;
}
}  // namespace

Expression::Expression(const std::string &text_) : text(text_) {
  try {
    mu::Parser parser = parser_of(text);
    for (const auto &variable : parser.GetUsedVar()) names.push_back(variable.first);
    std::vector<double> any(names.size(), 1.);
    for (std::size_t i = 0; i < names.size(); ++i) parser.DefineVar(names[i], &any[i]);
    parser.Eval();  // some mistakes are found only now
  } catch (const mu::ParserError &problem) {
    throw std::invalid_argument(problem.GetMsg());
  }
}

double Expression::operator()(const std::function<double(const std::string &)> &value_of) const {
  mu::Parser parser = parser_of(text);
  std::vector<double> values(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    values[i] = value_of(names[i]);
    parser.DefineVar(names[i], &values[i]);
  }
  return parser.Eval();
}
}  // namespace turgor
