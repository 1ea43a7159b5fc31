#include "coupling/answer_table.h"

#include <algorithm>

namespace turgor {
namespace {
constexpr std::size_t condition_columns = 6;  // at the end of a row, safe_strain last

/// Columns of a row.
template <int dim>
struct Row {
  static constexpr std::size_t P = 0, sigma = dim * dim, viscous = 2 * dim * dim, energy = 3 * dim * dim,
                               pressure = energy + 1, iterations = energy + 2, residual = energy + 3,
                               spread = energy + 4, cpu = energy + 5, failed = energy + 6,
                               dragged = energy + 7, heating = energy + 8, air = energy + 9,
                               tangent = energy + 10;
};

template <int dim>
void write(const Tensor4<dim> &from, double *row) {
  for (int i = 0; i < dim * dim; ++i)
    for (int j = 0; j < dim * dim; ++j) row[i * dim * dim + j] = from(i, j);
}

template <int dim>
void read(const double *row, dealii::Tensor<4, dim> &to) {
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b)
      for (int c = 0; c < dim; ++c)
        for (int d = 0; d < dim; ++d) to[a][b][c][d] = row[(a * dim + b) * dim * dim + c * dim + d];
}
}  // namespace

template <int dim>
AnswerTable<dim>::AnswerTable(const std::size_t points, const LawRequest &request, const bool conditions_) {
  begin(points, request, conditions_);
}

template <int dim>
void AnswerTable<dim>::begin(const std::size_t points, const LawRequest &request, const bool conditions_) {
  tangents = request.tangents;
  rate_tangents = request.rate_tangents;
  conditions = conditions_;
  rate_tangent = Row<dim>::tangent + (tangents ? dim * dim * dim * dim : 0);
  width = rate_tangent + (rate_tangents ? dim * dim * dim * dim : 0) + (conditions ? condition_columns : 0);
  table.resize(points * width);
  for (std::size_t point = 0; point < points; ++point) table[point * width + Row<dim>::failed] = 0.;
}

template <int dim>
void AnswerTable<dim>::put(const std::size_t point, const RveAnswer<dim> &a) {
  using R = Row<dim>;
  double *row = table.data() + point * width;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j) {
      row[R::P + i * dim + j] = a.P(i, j);
      row[R::sigma + i * dim + j] = a.sigma(i, j);
      row[R::viscous + i * dim + j] = a.viscous(i, j);
    }
  row[R::energy] = a.energy;
  row[R::heating] = a.heating;
  row[R::pressure] = a.pressure;
  row[R::iterations] = a.diagnostics.iterations;
  row[R::residual] = a.diagnostics.residual;
  row[R::spread] = a.diagnostics.stress_spread;
  row[R::cpu] = a.diagnostics.cpu_seconds;
  row[R::dragged] = a.diagnostics.dragged;
  row[R::air] = a.diagnostics.air;
  if (tangents) write<dim>(a.tangent, row + R::tangent);
  if (rate_tangents) write<dim>(a.rate_tangent, row + rate_tangent);
  if (conditions) {
    const RveCondition &c = a.condition;
    const double values[condition_columns] = {
        c.failed, c.permanent, c.flow_dissipated, c.failure_dissipated, c.torn_dissipated, a.safe_strain};
    std::copy(values, values + condition_columns, row + width - condition_columns);
  }
}

template <int dim>
RveCondition AnswerTable<dim>::condition(const std::size_t point) const {
  const double *last = table.data() + (point + 1) * width - condition_columns;
  return {last[0], last[1], last[2], last[3], last[4]};
}

template <int dim>
void AnswerTable<dim>::put_failed(const std::size_t point) {
  std::fill_n(table.begin() + static_cast<std::ptrdiff_t>(point * width), width, 0.);
  table[point * width + Row<dim>::failed] = 1.;
}

template <int dim>
void AnswerTable<dim>::gather(const PointShares &shares, const std::vector<std::size_t> &points) {
  shares.gather(width, table, points);
}

template <int dim>
bool AnswerTable<dim>::any_failed() const {
  bool any = false;
  for (std::size_t point = 0; point * width < table.size(); ++point) any = any || failed(point);
  return any;
}

template <int dim>
bool AnswerTable<dim>::failed(const std::size_t point) const {
  return table[point * width + Row<dim>::failed] != 0.;
}

template <int dim>
double AnswerTable<dim>::pressure(const std::size_t point) const {
  return table[point * width + Row<dim>::pressure];
}

template <int dim>
double AnswerTable<dim>::energy(const std::size_t point) const {
  return table[point * width + Row<dim>::energy];
}

template <int dim>
double AnswerTable<dim>::safe_strain(const std::size_t point) const {
  return table[(point + 1) * width - 1];
}

template <int dim>
template <int size>
Eigen::Matrix<double, size, size> AnswerTable<dim>::square(const std::size_t point,
                                                           const std::size_t column) const {
  return Eigen::Map<const Eigen::Matrix<double, size, size, Eigen::RowMajor>>(table.data() + point * width +
                                                                              column);
}

template <int dim>
Tensor2<dim> AnswerTable<dim>::P(const std::size_t point) const {
  return square<dim>(point, Row<dim>::P);
}

template <int dim>
Tensor4<dim> AnswerTable<dim>::tangent(const std::size_t point) const {
  return square<dim * dim>(point, Row<dim>::tangent);
}

template <int dim>
Tensor2<dim> AnswerTable<dim>::sigma(const std::size_t point) const {
  return square<dim>(point, Row<dim>::sigma);
}

template <int dim>
RveDiagnostics AnswerTable<dim>::diagnostics(const std::size_t point) const {
  using R = Row<dim>;
  const double *row = table.data() + point * width;
  RveDiagnostics diagnostics;
  diagnostics.converged = !failed(point);
  diagnostics.iterations = static_cast<int>(row[R::iterations]);
  diagnostics.residual = row[R::residual];
  diagnostics.stress_spread = row[R::spread];
  diagnostics.cpu_seconds = row[R::cpu];
  diagnostics.dragged = row[R::dragged] != 0.;
  diagnostics.air = row[R::air];
  return diagnostics;
}

template <int dim>
void AnswerTable<dim>::read(const std::size_t point, LawAnswer<dim> &answer) const {
  using R = Row<dim>;
  const double *row = table.data() + point * width;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j) answer.P[point][i][j] = row[R::P + i * dim + j];
  answer.energy[point] = row[R::energy];
  if (!answer.viscous.empty()) {
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) answer.viscous[point][i][j] = row[R::viscous + i * dim + j];
    answer.heating[point] = row[R::heating];
  }
  if (conditions) answer.spent[point] = condition(point).dissipated();
  if (!answer.tangent.empty()) turgor::read<dim>(row + R::tangent, answer.tangent[point]);
  if (rate_tangents) turgor::read<dim>(row + rate_tangent, answer.rate_tangent[point]);
}

template class AnswerTable<2>;
template class AnswerTable<3>;
}  // namespace turgor
