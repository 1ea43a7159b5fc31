#include "micro/solve/second_level.h"

#include <algorithm>
#include <cmath>

namespace turgor {
void SecondLevel::groups(const std::vector<std::uint32_t> &first,
                         const std::array<std::vector<double>, 3> &x) {
  first_of = first;
  group_of.resize(first.back());
  arm.assign(first.back(), {});
  for (std::uint32_t group = 0; group + 1 < first.size(); ++group) {
    const double count = first[group + 1] - first[group];
    DoubleRow middle{};
    for (std::uint32_t i = first[group]; i < first[group + 1]; ++i) {
      group_of[i] = group;
      for (int d = 0; d < 3; ++d) arm[i].v[d] = x[std::size_t(d)][i];
      middle += arm[i].v / count;
    }
    double square = 0.;
    for (std::uint32_t i = first[group]; i < first[group + 1]; ++i) {
      arm[i].v -= middle;
      square += eight_floats::sum(arm[i].v * arm[i].v);
    }
    for (std::uint32_t i = first[group]; i < first[group + 1]; ++i) arm[i].v *= std::sqrt(count / square);
  }
}

SecondLevel::Modes SecondLevel::modes_of(const std::size_t body, const DoubleRow &g) const {
  const DoubleRow &a = arm[body].v;
  Modes q;
  q << g[0], g[1], g[2], a[1] * g[2] - a[2] * g[1], a[2] * g[0] - a[0] * g[2], a[0] * g[1] - a[1] * g[0];
  return q;
}

void SecondLevel::add(const std::array<std::uint32_t, 2> &of, const std::array<Modes, 2> &q, const double c) {
  own[of[0]] += c * q[0] * q[0].transpose();
  if (of[1] == of[0]) return;
  own[of[1]] += c * q[1] * q[1].transpose();
  const std::size_t low = of[0] < of[1] ? 0 : 1;
  auto &all = beside[of[low]];
  auto at =
      std::find_if(all.rbegin(), all.rend(), [&](const Beside &one) { return one.other == of[1 - low]; });
  if (at == all.rend()) {
    all.push_back({of[1 - low], Square::Zero()});
    at = all.rbegin();
  }
  Square &square = at->square;
  square += c * q[low] * q[1 - low].transpose();
}

bool SecondLevel::sum(const std::vector<double> &medium, const PushedLinks &links, const RowList &rows) {
  const std::uint32_t count = std::uint32_t(first_of.size()) - 1, bodies = first_of.back();
  own.assign(count, Square::Zero());
  beside.assign(count, {});
  for (std::uint32_t i = 0; i < bodies; ++i)
    for (int d = 0; d < 3; ++d) {
      DoubleRow e{};
      e[d] = 1.;
      const Modes q = modes_of(i, e);
      own[group_of[i]] += medium[i] * q * q.transpose();
    }
  // One vector of a row, or of a link: what is between bodies of one group moves with it.
  std::array<std::uint32_t, 2> of{};
  std::array<Modes, 2> q;
  std::size_t met = 0;
  const auto meet = [&](const std::uint32_t body, const DoubleRow &g) {
    if (body >= bodies) return;
    std::size_t k = 0;
    while (k < met && of[k] != group_of[body]) ++k;
    if (k == 2) return;  // a row of three groups: none of the contacts there are
    if (k == met) {
      of[met++] = group_of[body];
      q[k].setZero();
    }
    q[k] += modes_of(body, g);
  };
  const auto end = [&](const double c) {
    if (met == 1) of[1] = of[0];
    if (met > 0) add(of, q, c);
    met = 0;
  };
  links.for_all([&](const std::uint32_t i, const std::uint32_t j, const DoubleRow &e, const double normal,
                    const double tangential) {
    if (i < bodies && j < bodies && group_of[i] == group_of[j]) return;
    for (int d = 0; d < 4; ++d) {
      DoubleRow along = e;
      if (d < 3) {
        along = DoubleRow{};
        along[d] = 1.;
      }
      const double c = d < 3 ? tangential : normal - tangential;
      if (c == 0.) continue;
      meet(i, along);
      meet(j, -along);
      end(c);
    }
  });
  for (std::size_t r = 0; r < rows.rows(); ++r) {
    if (!rows.is_short(r)) continue;
    bool alone = true;  // within one group
    for (std::uint32_t k = rows.first[r]; k < rows.first[r + 1]; ++k)
      alone = alone && rows.body[k] < bodies && group_of[rows.body[k]] == group_of[rows.body[rows.first[r]]];
    if (alone) continue;
    for (std::uint32_t k = rows.first[r]; k < rows.first[r + 1]; ++k) meet(rows.body[k], rows.g[k].v);
    end(1.);
  }
  std::vector<Eigen::Triplet<double>> entries;
  const auto enter = [&](const std::uint32_t a, const std::uint32_t b, const Square &square) {
    for (int row = 0; row < 6; ++row)
      for (int column = 0; column < 6; ++column)
        entries.emplace_back(6 * a + std::uint32_t(row), 6 * b + std::uint32_t(column), square(row, column));
  };
  for (std::uint32_t a = 0; a < count; ++a) {
    enter(a, a, own[a]);
    for (const Beside &one : beside[a]) enter(one.other, a, one.square.transpose());
  }
  Eigen::SparseMatrix<double> matrix(6 * count, 6 * count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factors = std::make_unique<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>(matrix);
  return factors->info() == Eigen::Success && (factors->vectorD().array() > 0.).all();
}

double SecondLevel::ask(const std::vector<Eight> &r) {
  constexpr std::size_t width = 8;
  const std::uint32_t count = std::uint32_t(first_of.size()) - 1;
  asked = Eigen::VectorXd::Zero(6 * count);
  for (std::uint32_t group = 0; group < count; ++group) {
    Modes sum = Modes::Zero();
    for (std::uint32_t i = first_of[group]; i < first_of[group + 1]; ++i) {
      const Eight &eight = r[i / width];
      const std::size_t lane = i % width;
      sum += modes_of(i, DoubleRow{eight.x[lane], eight.y[lane], eight.z[lane], 0.});
    }
    asked.segment<6>(6 * group) = sum;
  }
  const Eigen::VectorXd moves = factors->solve(asked);
  moved.resize(r.size());
  for (std::uint32_t group = 0; group < count; ++group) {
    const double *const m = moves.data() + 6 * group;
    for (std::uint32_t i = first_of[group]; i < first_of[group + 1]; ++i) {
      const DoubleRow &a = arm[i].v;
      Eight &eight = moved[i / width];
      const std::size_t lane = i % width;
      eight.x[lane] = float(m[0] + m[4] * a[2] - m[5] * a[1]);
      eight.y[lane] = float(m[1] + m[5] * a[0] - m[3] * a[2]);
      eight.z[lane] = float(m[2] + m[3] * a[1] - m[4] * a[0]);
    }
  }
  return asked.dot(moves);
}

std::size_t SecondLevel::memory_bytes() const {
  std::size_t total = sizeof(BodyVector) * arm.capacity() + sizeof(Square) * own.capacity() +
                      sizeof(Eight) * moved.capacity() + sizeof(std::uint32_t) * group_of.capacity();
  for (const auto &all : beside) total += sizeof(Beside) * all.capacity();
  if (factors) total += 12u * std::size_t(factors->matrixL().nestedExpression().nonZeros());
  return total;
}
}  // namespace turgor
