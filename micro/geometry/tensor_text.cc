#include "micro/geometry/tensor_text.h"

#include "run/number_text.h"
#include "run/run_context.h"
#include "run/user_text.h"

namespace turgor {
Tensor2<2> parse_tensor(const std::string &text, const std::string &entry) {
  const std::string written = "xx, xy; yx, yy";
  const std::vector<std::string> rows = split_trimmed(text + ";", ';');
  if (rows.size() != 2)
    throw InputError(entry + " is '" + text + "', but a matrix is written as: " + written);
  Tensor2<2> result;
  for (int a = 0; a < 2; ++a) {
    const std::vector<double> row = read_numbers(rows[a], 2, entry, written);
    result.row(a) << row[0], row[1];
  }
  return result;
}

std::string tensor_text(const Tensor2<2> &tensor, const int digits) {
  const auto number = [&](const int a, const int b) { return number_text(tensor(a, b), digits); };
  return number(0, 0) + ", " + number(0, 1) + "; " + number(1, 0) + ", " + number(1, 1);
}
}  // namespace turgor
