// Frames of a round cell for ParaView and pictures: wall.xdmf (lines or triangles with the stretch of the
// bonds at each node, bonds broken there) and fluid.xdmf (particles with pressure and velocity).
#pragma once

#include "micro/cells/round_cell.h"
#include "run/field_output.h"
#include "run/run_context.h"

#include <algorithm>
#include <functional>

namespace turgor {
template <int dim>
class RoundCellFields {
 public:
  /// time: s, of the present state. Cell and time must outlive this.
  RoundCellFields(const RunContext &context, const bool append, const RoundCell<dim> &cell_,
                  std::function<double()> time_)
      : cell(cell_),
        time(std::move(time_)),
        wall(context, "wall", append, [this] { return wall_frame(); }),
        fluid(context, "fluid", append, [this] { return fluid_frame(); }) {}

  void write() {
    wall.write();
    if (cell.group().fluid_count() > 0) fluid.write();
  }

  void accept() {
    wall.accept();
    if (cell.group().fluid_count() > 0) fluid.accept();
  }

 private:
  static std::vector<double> points(const std::uint32_t from, const std::uint32_t to,
                                    const typename Particles<dim>::Components &values) {
    std::vector<double> out;
    for (std::uint32_t i = from; i < to; ++i)
      for (int d = 0; d < 3; ++d) out.push_back(d < dim ? values[d][i] : 0.);
    return out;
  }

  FieldFrame wall_frame() const {
    const Particles<dim> &p = cell.system.particles;
    const Group &g = cell.group();
    FieldFrame frame;
    frame.time = time();
    frame.points = points(g.begin, g.fluid, p.x);
    std::vector<double> stretch(g.wall_count(), 0.), broken(g.wall_count(), 0.);
    for (std::size_t k = 0; k < cell.bonds(); ++k) {
      const auto [a, b] = cell.ends(k);
      const bool gone = cell.damage && cell.damage->cells[0].bond_broken[k];
      for (const auto node : {a, b}) {
        broken[node] += gone;
        if (!gone) stretch[node] = std::max(stretch[node], cell.wall->stretch(p, 0, k));
      }
    }
    if constexpr (dim == 3) {
      frame.nodes_per_cell = 3;
      for (std::size_t f = 0; f < cell.mesh->faces.size(); ++f)
        if (!(cell.damage && cell.damage->cells[0].face_gone[f]))
          frame.cells.insert(frame.cells.end(), cell.mesh->faces[f].begin(), cell.mesh->faces[f].end());
    } else {
      frame.nodes_per_cell = 2;
      for (std::size_t k = 0; k < cell.bonds(); ++k)
        if (!(cell.damage && cell.damage->cells[0].bond_broken[k]))
          frame.cells.insert(frame.cells.end(), {cell.ends(k).first, cell.ends(k).second});
    }
    frame.fields = {{"stretch [1]", 1, stretch, false}, {"broken", 1, broken, false}};
    return frame;
  }

  FieldFrame fluid_frame() const {
    const Particles<dim> &p = cell.system.particles;
    const Group &g = cell.group();
    FieldFrame drops;
    if (g.fluid_count() == 0) return drops;
    drops.time = time();
    drops.points = points(g.fluid, g.end, p.x);
    const std::vector<double> &pressure = p.field("pressure");
    drops.fields = {{"pressure [Pa]", 1, {pressure.begin() + g.fluid, pressure.begin() + g.end}, false},
                    {"velocity [m/s]", 3, points(g.fluid, g.end, p.v), false}};
    return drops;
  }

  const RoundCell<dim> &cell;
  std::function<double()> time;
  FieldOutput wall, fluid;
};
}  // namespace turgor
