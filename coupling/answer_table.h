// What the RVEs of one batch answered, one row of doubles a point, so that one message gathers it over
// the ranks: stresses (Pa), the viscous part of P (Pa), energy (J/m^3), heating (W/m^3), fluid pressure (Pa),
// diagnostics, tangents (Pa, Pa s) where asked for, the condition of the cells where it can change, failed or
// not.
#pragma once

#include "coupling/point_shares.h"
#include "macro/material_law.h"
#include "rve/rve.h"

#include <cstddef>
#include <vector>

namespace turgor {
template <int dim>
class AnswerTable {
 public:
  AnswerTable() = default;
  /// begin()s.
  AnswerTable(std::size_t points, const LawRequest &request, bool conditions = false);

  /// Nobody has answered, nobody failed; what a row holds otherwise says nothing before its put(). Rows are
  /// as wide as what the batch is asked for. The memory of the batch before serves again.
  void begin(std::size_t points, const LawRequest &request, bool conditions);

  /// Rows of this rank's points; different points at once from different threads.
  void put(std::size_t point, const RveAnswer<dim> &answer);
  void put_failed(std::size_t point);  ///< all else of its row is zero
  /// Collective: afterwards every rank holds the rows of these points (ascending).
  void gather(const PointShares &shares, const std::vector<std::size_t> &points);

  bool failed(std::size_t point) const;
  bool any_failed() const;
  double pressure(std::size_t point) const;
  double energy(std::size_t point) const;
  double safe_strain(std::size_t point) const;  ///< only if the table has conditions
  Tensor2<dim> P(std::size_t point) const;
  Tensor4<dim> tangent(std::size_t point) const;  ///< only if the table has tangents
  Tensor2<dim> sigma(std::size_t point) const;
  RveCondition condition(std::size_t point) const;  ///< only if the table has conditions
  RveDiagnostics diagnostics(
      std::size_t point) const;  ///< numbers only: no message, converged as it failed or not
  /// P, energy and the tangents, if there are any, of the point; the answer's lists are long enough.
  void read(std::size_t point, LawAnswer<dim> &answer) const;

 private:
  template <int size>
  Eigen::Matrix<double, size, size> square(std::size_t point, std::size_t column) const;

  bool tangents = false, rate_tangents = false, conditions = false;
  std::size_t rate_tangent = 0, width = 0;  ///< columns: where it begins, all
  std::vector<double> table;
};
}  // namespace turgor
