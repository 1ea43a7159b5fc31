// Matrices as a user writes them in an entry and reads them in a message.
//
//   const Tensor2<2> F = parse_tensor("1, 0.1; 0, 1", "Path/F");
#pragma once

#include "micro/geometry/tensor.h"

#include <string>

namespace turgor {
/// "xx, xy; yx, yy" as a matrix. Throws InputError naming the entry.
Tensor2<2> parse_tensor(const std::string &text, const std::string &entry);

/// "xx, xy; yx, yy" for messages, to so many digits.
std::string tensor_text(const Tensor2<2> &tensor, int digits);
}  // namespace turgor
