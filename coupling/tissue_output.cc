#include "coupling/tissue_output.h"

#include <algorithm>

namespace turgor {
using dealii::Point;
using dealii::Tensor;

FieldFrame tissue_frame(const Tissue<2> &tissue, const RveLaw<2> &law) {
  TissueFields fields = tissue.fields();
  FieldFrame frame;
  frame.time = tissue.time();
  frame.points = fields.points;
  for (std::size_t i = 0; i < frame.points.size(); ++i) frame.points[i] += fields.displacement[i];
  frame.cells = std::move(fields.cells);
  frame.nodes_per_cell = fields.nodes_per_cell;

  const TissueMesh<2> &mesh = tissue.mesh();
  const auto mean = [&](const auto &of_point) {
    std::vector<double> result;
    for (const unsigned int element : mesh.picture_element) {
      double sum = 0., weight = 0.;
      for (unsigned int q = element * mesh.gauss_points; q < (element + 1) * mesh.gauss_points; ++q) {
        sum += mesh.gauss_weight[q] * of_point(q);
        weight += mesh.gauss_weight[q];
      }
      result.push_back(sum / weight);
    }
    return result;
  };
  frame.fields.push_back({"displacement [m]", 3, std::move(fields.displacement), false});
  frame.fields.push_back({"velocity [m/s]", 3, std::move(fields.velocity), false});
  frame.fields.push_back({"stress [Pa]", 9, std::move(fields.stress), true});
  frame.fields.push_back({"pressure [Pa]", 1, std::move(fields.pressure), true});
  frame.fields.push_back(
      {"fluid pressure [Pa]", 1, mean([&](unsigned int q) { return law.pressure()[q]; }), true});
  if (!law.condition().empty()) {
    frame.fields.push_back(
        {"failed [1]", 1, mean([&](unsigned int q) { return law.condition()[q].failed; }), true});
    frame.fields.push_back({"permanent stretch [1]", 1,
                            mean([&](unsigned int q) { return law.condition()[q].permanent; }), true});
  }
  return frame;
}

FieldFrame failing_tissue_frame(const Tissue<2> &tissue) {
  const TissueOperator<2> &op = tissue.forces();
  const std::vector<double> &u = op.failed_displacement();
  FieldFrame frame;
  if (u.empty()) return frame;
  TissueFields fields = tissue.fields();
  const TissueMesh<2> &mesh = tissue.mesh();
  frame.time = op.failed_time();
  frame.points = fields.points;
  for (std::size_t i = 0; i < mesh.picture_node.size(); ++i)
    for (std::size_t c = 0; c < 2; ++c) {
      fields.displacement[3 * i + c] = u[std::size_t(mesh.picture_node[i]) * 2 + c];
      frame.points[3 * i + c] += fields.displacement[3 * i + c];
    }
  frame.cells = std::move(fields.cells);
  frame.nodes_per_cell = fields.nodes_per_cell;
  std::vector<double> failed(mesh.cells, 0.);
  failed[op.failure().element] = 1.;
  for (const FailedPoint &point : op.answer().failed) failed[point.point / mesh.gauss_points] = 1.;
  NamedField marks{"a point failed [1]", 1, {}, true};
  for (const unsigned int element : mesh.picture_element) marks.values.push_back(failed[element]);
  frame.fields = {{"displacement [m]", 3, std::move(fields.displacement), false}, std::move(marks)};
  return frame;
}

void write_cell_displacement(RunContext &context, const Tissue<2> &tissue,
                             const std::array<unsigned int, 2> &cells, const std::array<double, 2> &cell_size,
                             unsigned int samples) {
  std::vector<Point<2>> points;
  for (unsigned int j = 0; j < cells[1]; ++j)
    for (unsigned int i = 0; i < cells[0]; ++i)
      for (unsigned int b = 0; b < samples; ++b)
        for (unsigned int a = 0; a < samples; ++a)
          points.emplace_back((i + (a + 0.5) / samples) * cell_size[0],
                              (j + (b + 0.5) / samples) * cell_size[1]);
  const std::vector<Tensor<1, 2>> u = tissue.displacement_at(points);

  const auto table =
      context.series("cell_displacement",
                     {{"cell_x", ""}, {"cell_y", ""}, {"displacement_x", "m"}, {"displacement_y", "m"}});
  const std::size_t per_cell = std::size_t(samples) * samples;
  for (unsigned int j = 0; j < cells[1]; ++j)
    for (unsigned int i = 0; i < cells[0]; ++i) {
      Tensor<1, 2> mean;
      for (std::size_t k = 0; k < per_cell; ++k) mean += u[(std::size_t(j) * cells[0] + i) * per_cell + k];
      mean /= static_cast<double>(per_cell);
      table->add_row({double(i), double(j), mean[0], mean[1]});
    }
}

RveOutlines::RveOutlines(RunContext &context, const Tissue<2> &tissue, const Tensor2<2> &lattice,
                         unsigned int how_many, const std::vector<std::array<double, 2>> &places)
    : oblique(lattice(0, 1) != 0. || lattice(1, 0) != 0.) {
  const std::vector<Point<2>> &points = tissue.quadrature_points();
  for (const auto &place : places) {
    if (chosen.size() == how_many) break;
    const Point<2> target(place[0] * tissue.size()[0], place[1] * tissue.size()[1]);
    std::size_t nearest = 0;
    for (std::size_t p = 1; p < points.size(); ++p)
      if (points[p].distance_square(target) < points[nearest].distance_square(target)) nearest = p;
    if (std::find(chosen.begin(), chosen.end(), nearest) == chosen.end()) chosen.push_back(nearest);
  }
  std::vector<Column> columns = {
      {"time", "s"}, {"rve", ""}, {"ring", ""}, {"point_x", "m"}, {"point_y", "m"}};
  for (const char *component : {"F_xx", "F_xy", "F_yx", "F_yy"}) columns.push_back({component, "1"});
  for (const char *component : {"period_x", "period_y"}) columns.push_back({component, "m"});
  for (const char *name : {"pressure", "stress_xy"}) columns.push_back({name, "Pa"});
  for (const char *name : {"x", "y"}) columns.push_back({name, "m"});
  if (oblique)
    for (const char *component : {"period_xy", "period_yx"}) columns.push_back({component, "m"});
  table = context.series("rve_outlines", columns);
}

void RveOutlines::write(const Tissue<2> &tissue, const RveLaw<2> &law, const Rve<2> &rve) {
  const std::vector<Point<2>> &points = tissue.quadrature_points();
  const std::vector<RveState<2>> states = law.states(chosen);
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const RveState<2> &state = states[k];
    const Point<2> at = points[chosen[k]] + tissue.displacement_at(points[chosen[k]]);
    const auto rings = rve.outlines(state);
    for (std::size_t ring = 0; ring < rings.size(); ++ring)
      for (const Vector<2> &x : rings[ring]) {
        std::vector<double> row = {tissue.time(),
                                   double(chosen[k]),
                                   double(ring),
                                   at[0],
                                   at[1],
                                   state.F(0, 0),
                                   state.F(0, 1),
                                   state.F(1, 0),
                                   state.F(1, 1),
                                   rve.lattice()(0, 0),
                                   rve.lattice()(1, 1),
                                   law.pressure()[chosen[k]],
                                   law.cauchy_stress()[chosen[k]](0, 1),
                                   x[0],
                                   x[1]};
        if (oblique) row.insert(row.end(), {rve.lattice()(0, 1), rve.lattice()(1, 0)});
        table->add_row(row);
      }
  }
}
}  // namespace turgor
