// Osmotic pressure of a dextran solution on a spheroid (thesis Eq. 5.3): a force towards the centre on every outer cell
// (outer_cells.h),
//
//   F_i = F_0 [ V_i/V_ref,i towards the centroid, minus the mean of these ]          (they sum to zero),
//
// with F_0 such that the mean pressure of the cells is the given one. In equilibrium the virial theorem gives it without a search:
// sum_i p_i V_i = -1/3 sum_outer F_i . r_i = p sum_i V_i, r_i from the centroid. Then the mean weighted with V_i is p up to what
// the medium's friction carries.
//
// Who is an outer cell and F_0 are found in update(); in between the forces are dead loads.
// F_0 fixed ("fixed for each experiment"): it keeps the value of the first update.
//
// Fields read: radius, reference_volume.
#pragma once

#include "micro/cells/outer_cells.h"
#include "micro/cells/surroundings.h"

namespace turgor
{
struct DextranParameters
{
  double pressure = 5e3;    ///< Pa
  double start = 0.;        ///< s, when the dextran is added
  bool fixed_force = false; ///< F_0 of the first update for good
};

class DextranPressure final : public Surroundings
{
public:
  explicit DextranPressure(const DextranParameters &parameters);

  std::string name() const override { return "dextran_pressure"; }
  void update(const CellPopulation &population, double t) override;
  void add_forces(Particles<3> &particles) override;
  void gather(const std::vector<std::uint32_t> &source) override;
  std::vector<Value> values(const CellPopulation &) const override;
  void save(std::ostream &out) const override;
  void load(std::istream &in) override;

  double unit_force() const { return F_0; } ///< N
  const std::vector<std::uint32_t> &outer_cells() const { return cells; }

private:
  DextranParameters parameters;
  double F_0 = 0.;
  std::vector<std::uint32_t> cells;
  std::vector<Vector<3>> forces; ///< N, of cells
};
} // namespace turgor
