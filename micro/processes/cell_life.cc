#include "micro/processes/cell_life.h"

#include "micro/cells/cell_stress.h"
#include "micro/cells/depth_below_surface.h"
#include "micro/cells/outer_cells.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace turgor
{
CellLife::CellLife(const CellLifeParameters &parameters_)
  : parameters(parameters_)
  , V_0(sphere_volume(parameters_.birth_radius))
{}

void CellLife::declare(Particles<3> &particles) const
{
  particles.declare("reference_volume");
  for (const char *name : {"strain", "phase", "cycle_time", "bulk_modulus"})
    particles.cells.declare(name);
  if (parameters.death.rim == Rim::necrotic)
    particles.cells.declare("volume_at_death");
}

void CellLife::draw(CellPopulation &cells, const std::size_t i) const
{
  const CellVariability &vary = parameters.variability;
  const std::uint64_t id = cells.id()[i];
  Particles<3> &p = cells.particles;
  p.cells.column("cycle_time")[i] = vary(parameters.cycle_time, id, Varied::cycle_time);
  p.cells.column("bulk_modulus")[i] = vary(parameters.bulk_modulus, id, Varied::bulk_modulus);
  p.field("modulus")[i] = vary(parameters.modulus, id, Varied::modulus) / (1. - parameters.poisson * parameters.poisson);
}

void CellLife::add(CellPopulation &cells, const Vector<3> &x, const double phase) const
{
  const std::size_t i = cells.add(x, parameters.birth_radius, parameters.modulus);
  draw(cells, i);
  const double T = cells.particles.cells.column("cycle_time")[i];
  double V_ref = V_0, reached = 0.;
  parameters.cycle.advance(parameters.growth, V_0, T, 1., phase * T, reached, V_ref);
  cells.particles.field("reference_volume")[i] = V_ref;
  cells.particles.cells.column("phase")[i] = phase;
  cells.particles.field("radius")[i] = sphere_radius(V_ref);
}

double CellLife::volume(const CellPopulation &cells, const std::size_t i) const
{
  return compressed_volume(cells.particles.field("reference_volume")[i], cells.particles.cells.column("strain")[i]);
}

const std::vector<double> &CellLife::measure_pressures(const CellPopulation &cells, const SphereContacts &contacts, const unsigned int threads)
{
  cell_virials(cells.particles, contacts, threads, virial);
  cells.add_virials(virial);
  const std::vector<double> &V_ref = cells.particles.field("reference_volume"), &eps = cells.particles.cells.column("strain");
  pressure.resize(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    pressure[i] = -virial[i].trace() / (3. * compressed_volume(V_ref[i], eps[i]));
  return pressure;
}

std::vector<unsigned char> CellLife::below_rim(const Particles<3> &p, const Surroundings &surroundings) const
{
  const CellDeath &death = parameters.death;
  std::vector<unsigned char> below(p.size(), 0);
  if (death.rim == Rim::none)
    return below;
  const OuterCells outer = find_outer_cells(p);
  if (death.from == RimFrom::edge)
    {
      for (std::size_t i = 0; i < p.size(); ++i)
        below[i] = outer.edge - (p.position(i) - outer.centre).norm() > death.rim_thickness;
      return below;
    }
  below = deeper_than(death.rim_thickness, p, outer);
  for (std::size_t i = 0; i < p.size(); ++i)
    below[i] = below[i] && surroundings.depth_of(p.position(i)) > death.rim_thickness;
  return below;
}

void CellLife::advance(CellPopulation &cells, const SphereContacts &contacts,
                       const Surroundings &surroundings, const double dt,
                       const unsigned int threads,
                       const std::function<void(const Rearrangement &)> &gather_others)
{
  measure_pressures(cells, contacts, threads);
  Particles<3> &p = cells.particles;
  std::vector<double> &V_ref = p.field("reference_volume"), &R = p.field("radius"), &eps = p.cells.column("strain"),
                      &phase = p.cells.column("phase"), &T = p.cells.column("cycle_time"), &K = p.cells.column("bulk_modulus");
  std::vector<double> *V_at_death = p.cells.has("volume_at_death") ? &p.cells.column("volume_at_death") : nullptr;
  std::vector<std::uint64_t> &id = cells.id();
  const CellStates state = cells.state();
  const CellDeath &death = parameters.death;
  const CellCycle &cycle = parameters.cycle;
  const std::vector<unsigned char> below = below_rim(p, surroundings);

  struct Division
  {
    std::uint32_t mother;
    double left; ///< of dt, s
    Vector<3> offset;
  };
  std::vector<Division> divisions_now;
  std::vector<unsigned char> gone(cells.size(), 0);
  bool any_gone = false;
  for (std::uint32_t i = 0; i < cells.size(); ++i)
    {
      const double rest = parameters.volume.strain_at_rest(pressure[i], K[i]);
      if (!state.alive(i))
        {
          const double T_lys = parameters.variability(death.lysis_time, id[i], Varied::lysis_time);
          eps[i] = relaxed_strain(eps[i], rest, dt, death.linear ? parameters.relaxation : T_lys);
          const double before = V_ref[i];
          V_ref[i] = death.drained(V_ref[i], (*V_at_death)[i], T_lys, dt);
          drained += before - V_ref[i];
          if (state[i] == CellState::necrotic && death.ended(V_ref[i], (*V_at_death)[i], eps[i], rest))
            {
              cells.set_state(i, CellState::lysed);
              gone[i] = death.remove;
              any_gone = any_gone || death.remove;
              drained += death.remove ? V_ref[i] : 0.;
            }
          continue;
        }
      eps[i] = relaxed_strain(eps[i], rest, dt, parameters.relaxation);
      const bool deep = below[i];
      if (deep && death.rim == Rim::necrotic
          && death.dies(HUGE_VAL, pressure[i],
                        parameters.variability(death.necrosis_pressure, id[i], Varied::necrosis_pressure)))
        {
          (*V_at_death)[i] = V_ref[i];
          cells.set_state(i, CellState::necrotic);
          ++deaths;
          continue;
        }
      const double f = parameters.growth.factor(eps[i]);
      const bool resting = state[i] == CellState::quiescent;
      const bool rests = (deep && death.rim == Rim::quiescent) || cycle.rests(resting, phase[i], f);
      cells.set_state(i, rests ? CellState::quiescent : CellState::proliferating);
      if (rests)
        continue;
      const double before = V_ref[i];
      const double left = cycle.advance(parameters.growth, V_0, T[i], f, dt, phase[i], V_ref[i]);
      grown += V_ref[i] - before;
      if (left >= 0.)
        divisions_now.push_back({i, left, Vector<3>::Zero()});
    }
  for (std::size_t i = 0; i < cells.size(); ++i)
    R[i] = sphere_radius(compressed_volume(V_ref[i], eps[i]));
  if (divisions_now.empty() && !any_gone)
    return;

  const double half = std::cbrt(0.5);
  double reach = 0.;
  for (const Division &division : divisions_now)
    reach = std::max(reach, CellDivision::reach(R[division.mother]));
  PairList<3> near(reach);
  if (!divisions_now.empty() && parameters.division.least_energy)
    {
      std::vector<unsigned char> no_marks;
      near.build(p, R, no_marks, threads);
    }
  for (Division &division : divisions_now)
    {
      const std::uint32_t i = division.mother;
      const Vector<3> along = parameters.division.choose(id[i], virial[i]);
      division.offset = parameters.division.half_distance(cells, contacts, near, surroundings, i, along, half * R[i]) * along;
    }
  Rearrangement places;
  std::vector<std::uint32_t> &source = places.source, place(cells.size());
  for (std::uint32_t i = 0; i < cells.size(); ++i)
    if (!gone[i])
      {
        place[i] = std::uint32_t(source.size());
        source.push_back(i);
      }
    else
      ++removed;
  const std::size_t kept = source.size();
  for (const Division &division : divisions_now)
    source.push_back(division.mother);
  cells.gather(places);
  gather_others(places);
  pressure = places.of(pressure);
  for (std::size_t k = 0; k < divisions_now.size(); ++k)
    {
      const Division &division = divisions_now[k];
      for (const auto &[i, sign] : {std::pair(std::size_t(place[division.mother]), 1.), std::pair(kept + k, -1.)})
        {
          id[i] = cells.next_id++;
          draw(cells, i);
          V_ref[i] *= 0.5;
          phase[i] = 0.;
          const double before = V_ref[i];
          cycle.advance(parameters.growth, V_0, T[i], 1., division.left, phase[i], V_ref[i]);
          grown += V_ref[i] - before;
          R[i] = sphere_radius(compressed_volume(V_ref[i], eps[i]));
          for (int d = 0; d < 3; ++d)
            p.x[d][i] += sign * division.offset[d];
        }
      ++divisions;
    }
}
} // namespace turgor
