// A part of the matrix of motion (motion_matrix.h) that multiplies by itself: rows (row_matrix.h), or a term
// whose neighbour list holds the pairs anyway. Symmetric and positive semi-definite; N s/m.
//
// p: in single precision, v: in double; rows of four numbers a body, the fourth is 0, bodies of given
// velocity behind the others (their p is 0).
#pragma once

#include "micro/solve/links.h"

#include <functional>

namespace turgor {
/// Symmetric 3 x 3 block.
struct Block {
  double xx = 0., xy = 0., xz = 0., yy = 0., yz = 0., zz = 0.;
};

class OwnProduct {
 public:
  virtual ~OwnProduct() = default;

  /// Before the products with one vector: what is summed over several bodies first.
  virtual void begin(const FloatRow * /*p*/, unsigned int /*threads*/) {}
  virtual void begin(const BodyVector * /*v*/, unsigned int /*threads*/) {}

  /// product[i - begin] += (A p)_i for bodies [begin, end); called from several threads.
  virtual void add(const FloatRow *p, std::size_t begin, std::size_t end, FloatRow *product) const = 0;
  virtual void add(const BodyVector *v, std::size_t begin, std::size_t end, BodyVector *product) const = 0;

  /// v'Av (W) of bodies [0, bodies), after begin(v). A part that bodies of given velocity enter counts them
  /// in.
  virtual double power(const BodyVector *v, const std::size_t bodies) const {
    std::vector<BodyVector> product(bodies);
    add(v, 0, bodies, product.data());
    double total = 0.;
    for (std::size_t i = 0; i < bodies; ++i) total += eight_floats::sum(v[i].v * product[i].v);
    return total;
  }

  /// blocks[i - begin] += A_ii for bodies [begin, end).
  virtual void add_blocks(std::size_t begin, std::size_t end, Block *blocks) const = 0;

  /// Bodies of which one's velocity acts on the other's force: join(i, j), as many as connect them all.
  virtual void connect(const std::function<void(std::uint32_t, std::uint32_t)> &join) const = 0;
};
}  // namespace turgor
