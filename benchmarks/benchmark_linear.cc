// The linear systems of a static tissue: direct against multigrid (macro/linear_solver.h), CPU seconds of one
// tangent (assembly and factors, or hierarchy) and one solution, and the iterations.
//
//   benchmark_linear [most unknowns, default 1e5]
//
// Tissue: a cube (square) of neo-Hookean solid under its weight, clamped at one side, bent by some percent;
// F-bar elements. lambda/mu: 3, and 250 as of turgid cells. "translations": multigrid without the rotations
// among its modes.
#include "macro/neo_hookean_law.h"
#include "macro/static_balance.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace turgor {
namespace {
struct Cost {
  double setup = 0., solve = 0., off = 0.;
  unsigned long iterations = 0, fallbacks = 0;
};

template <int dim>
class System {
 public:
  System(const unsigned int n, const double ratio) : law(1e6, ratio * 1e6, 0., 1000.), mesh(parameters(n)) {
    TissueOperator<dim> op(mesh, parameters(n), law);
    std::vector<double> u(op.size());
    for (std::size_t i = 0; i < u.size(); ++i) {
      const dealii::Point<dim> &x = mesh.node_position[i / dim];
      u[i] = i % dim == 1 ? -0.05 * x[0] * x[0] / 1e-3 : 0.;
    }
    op.evaluate(0., 0., u, std::vector<double>(u.size(), 0.), true);
    op.element_stiffness(element);
    right = op.external_forces();
    for (std::size_t i = 0; i < right.size(); ++i)
      if (op.fixed(i)) right[i] = 0.;
  }

  static TissueParameters<dim> parameters(const unsigned int n) {
    TissueParameters<dim> p;
    p.size.fill(1e-3);
    p.elements.fill(n);
    p.body_force[1] = -10.;
    return p;
  }

  Cost cost(const LinearMethod method, const bool rotations, std::vector<double> &x) const {
    LinearSettings settings;
    settings.method = method;
    settings.rigid_body_modes = rotations;
    LinearSolver<dim> solver(mesh, settings);
    // pattern and MPI are made once a run, not once a tangent
    solver.set_matrix(element, {});
    const LinearStatistics before = solver.statistics();
    solver.set_matrix(element, {});
    const std::vector<double> found = solver.solve(right);
    const LinearStatistics &s = solver.statistics();
    Cost c{s.setup_seconds - before.setup_seconds, s.solve_seconds, 0., s.iterations, s.fallbacks};
    if (x.empty()) x = found;
    double most = 0., size = 0.;
    for (std::size_t i = 0; i < x.size(); ++i) {
      most = std::max(most, std::abs(found[i] - x[i]));
      size = std::max(size, std::abs(x[i]));
    }
    c.off = most / size;
    return c;
  }

  std::size_t unknowns() const { return right.size(); }

 private:
  NeoHookeanLaw<dim> law;
  TissueMesh<dim> mesh;
  std::vector<double> element, right;
};

template <int dim>
void row(const unsigned int n, const double ratio) {
  const System<dim> system(n, ratio);
  std::vector<double> x;
  const Cost direct = system.cost(LinearMethod::direct, true, x),
             multigrid = system.cost(LinearMethod::multigrid, true, x),
             poor = system.cost(LinearMethod::multigrid, false, x);
  std::printf("| %dD | %g | %zu | %.3g + %.3g | %.3g + %.3g | %lu%s | %.1e | %lu%s | %.2f |\n", dim, ratio,
              system.unknowns(), direct.setup, direct.solve, multigrid.setup, multigrid.solve,
              multigrid.iterations, multigrid.fallbacks > 0 ? " (gave up)" : "", multigrid.off,
              poor.iterations, poor.fallbacks > 0 ? " (gave up)" : "",
              (direct.setup + direct.solve) / (multigrid.setup + multigrid.solve));
  std::fflush(stdout);
}
}  // namespace
}  // namespace turgor

int main(int argc, char **argv) {
  const double most = argc > 1 ? std::atof(argv[1]) : 1e5;
  std::printf(
      "| | lambda/mu | unknowns | direct: factors + solution, CPU s | multigrid: hierarchy + solution | "
      "iterations | off by | iterations, translations only | direct over multigrid |\n"
      "|---|---|---|---|---|---|---|---|---|\n");
  for (const double ratio : {3., 250.}) {
    for (const unsigned int n : {22u, 70u, 223u, 707u})
      if (2. * n * n <= most) turgor::row<2>(n, ratio);
    for (const unsigned int n : {6u, 14u, 22u, 31u})
      if (3. * n * n * n <= most) turgor::row<3>(n, ratio);
  }
}
