// A 2 x 2 matrix written in one line, row by row.
#pragma once

#include "rve/rve.h"

namespace turgor::test {
inline Tensor2<2> matrix(const double a, const double b, const double c, const double d) {
  Tensor2<2> F;
  F << a, b, c, d;
  return F;
}
}  // namespace turgor::test
