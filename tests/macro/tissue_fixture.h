// A small piece of tissue shared by the tests of macro/: stretch modulus 51 MPa, shear 0.20 MPa, 1057 kg/m^3.
#pragma once

#include "macro/neo_hookean_law.h"
#include "macro/tissue.h"

#include <cmath>

namespace turgor::test {
constexpr double mu = 0.2e6, lambda = 50.6e6, rho = 1057., width = 1.6e-3;

inline TissueParameters<2> gravity(unsigned int elements, unsigned int degree = 1,
                                   const std::string &locking = "f_bar") {
  TissueParameters<2> p;
  p.size = {width, width};
  p.elements = {elements, elements};
  p.degree = degree;
  p.locking = choice_of<Locking>(locking);
  p.body_force[1] = -1.2e4;
  return p;
}

/// Smooth, not symmetric nodal values of the given size.
template <int dim>
std::vector<double> wavy(const TissueMesh<dim> &mesh, double size, double phase) {
  std::vector<double> u;
  for (const auto &x : mesh.node_position)
    for (unsigned int c = 0; c < dim; ++c)
      u.push_back(size * std::sin(phase + 2.1 * (c + 1) * x[0] / width - 1.7 * x[1] / width + 0.3 * c));
  return u;
}

/// A law that answers like another one but fails in chosen calls.
class FailingLaw : public NeoHookeanLaw<2> {
 public:
  using NeoHookeanLaw<2>::NeoHookeanLaw;
  unsigned long calls = 0, fail_from = 0, fail_to = 0;  // fails in calls fail_from <= n < fail_to
  unsigned int commits = 0;

  void evaluate(const std::vector<dealii::Tensor<2, 2>> &F, const std::vector<dealii::Tensor<2, 2>> &F_dot,
                const LawRequest &request, LawAnswer<2> &answer) override {
    NeoHookeanLaw<2>::evaluate(F, F_dot, request, answer);
    if (calls >= fail_from && calls < fail_to)
      answer.failed.push_back({5, "the cell wall cannot be balanced"});
    ++calls;
  }
  void commit() override {
    NeoHookeanLaw<2>::commit();
    ++commits;
  }
};
}  // namespace turgor::test
