// Osmotic pressure of a dextran solution on a spheroid (thesis Eq. 5.3): a force towards the centre on every
// cell in so far as it is an outer one, w_i its exposure (outer_cells.h),
//
//   F_i = F_0 w_i V_i/V_ref,i towards the centroid, minus what all sum up to in the same shares
//     (they sum to zero),
//
// with F_0 such that the mean pressure of the cells is the given one. In equilibrium the virial theorem gives
// it without a search: sum_i p_i V_i = -1/3 sum_outer F_i . r_i = p sum_i V_i, r_i from the centroid. Then
// the mean weighted with V_i is p up to what the medium's friction carries.
//
// Why w_i: full forces on the outermost cells alone, one to a cell's area, do not press a loose spheroid
// together. They are pushed in between others that carry nothing, those become the outermost, and so on
// without end (10 kPa on 400 cells: 6.4 kPa were held).
//
// Exposures, the centroid and F_0 are found in update(), and again after a step in which one of the cells has
// gone farther than a quarter of a mean radius since: a force that stays on a cell that has sunk in pushes it
// on, through a loose spheroid and out. In between the forces keep their size and point to that centroid
// (within a mean radius of it they fall to zero). The pressure rises in proportion to time over `rise`. F_0
// fixed ("fixed for each experiment"): it keeps the first value found for the whole pressure.
//
// Fields read: radius, reference_volume.
#pragma once

#include "micro/terms/outer_cells.h"
#include "micro/engine/term.h"

namespace turgor {
struct DextranParameters {
  double pressure = 5e3;     ///< Pa
  double start = 0.;         ///< s, when the dextran is added
  double rise = 0.;          ///< s, until the whole pressure is there
  bool fixed_force = false;  ///< the first F_0 of the whole pressure for good
};

class DextranPressure final : public Term<3> {
 public:
  explicit DextranPressure(const DextranParameters &parameters);

  std::string name() const override { return "dextran_pressure"; }
  void declare(Particles<3> &) override {}
  /// The forces at time t (s).
  void update(const Particles<3> &particles, double t);
  void advance(const Particles<3> &particles, double dt) override;
  void prepare(const Particles<3> &particles, const Box<3> &box, unsigned int threads, bool trial) override;
  void add_forces(Particles<3> &particles, const Box<3> &box, std::size_t group) override {
    add_forces_of(particles, box, group, group + 1);
  }
  void add_forces_of(Particles<3> &particles, const Box<3> &box, std::size_t begin, std::size_t end) override;
  double energy(const Particles<3> &, const Box<3> &, std::size_t) const override { return 0.; }
  double active_work(const Particles<3> &particles, const Box<3> &box, std::size_t group,
                     double h) const override;
  void gather(const Rearrangement &places) override;
  void archive(Archive &a, Particles<3> &particles) override;

  double unit_force() const { return F_0; }     ///< N
  double exposures() const { return exposed; }  ///< sum of all
  const std::vector<std::uint32_t> &outer_cells() const { return cells; }

 private:
  void press(const Particles<3> &particles);  ///< at time `now`
  /// The forces on the outer cells where they are now (N), for F_0 = 1.
  void unit_forces(const Particles<3> &particles);

  DextranParameters parameters;
  double now = 0.;     ///< s
  bool whole = false;  ///< F_0 has been found for the whole pressure
  double F_0 = 0., softened = 0.,
         exposed = 0.;  ///< N; m, within it of the centroid forces fall to zero; sum of exposures
  Vector<3> centre = Vector<3>::Zero();
  std::vector<std::uint32_t> cells;
  std::vector<Vector<3>> found_at;  ///< m, where the cells were when they were found
  std::vector<double> share;        ///< w V/V_ref of cells
  std::vector<Vector<3>> forces;
};
}  // namespace turgor
