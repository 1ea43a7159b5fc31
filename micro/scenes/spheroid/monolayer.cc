#include "micro/scenes/spheroid/monolayer.h"

#include "run/run_context.h"
#include "run/choice.h"

namespace turgor {
Monolayer::Monolayer() {
  flat = true;
  takes_body = false;  // one that is met would push cells out of their plane
  first_cells = 4;
  phases = FirstPhases::spread;
  duration = 10. * 61200.;  // cycles
  samples = 300;
  frames = 8;
  entries.stiffness = "closest";  // without it the soft contacts let cells pile up in the plane
  entries.numbers.life.growth.inhibition = Inhibition::hill;
  entries.step_coarsely();
  entries.numbers.growth_tolerance = 2e-3;
  entries.numbers.solve.tolerance = 1e-5;
  entries.numbers.medium_friction = 5e9;  // of the substrate
  entries.numbers.motility = 0.;
  entries.numbers.life.division.direction = DivisionDirection::random_in_plane;
  entries.in_plane = true;
}

void Monolayer::check_more() const {
  const CellDivision division = entries.parameters().life.division;
  if (division.direction != DivisionDirection::random_in_plane &&
      !(division.direction == DivisionDirection::given && division.axis[2] == 0.))
    throw InputError(
        "Division/Direction is " + word_of(division.direction) +
        ", but cells of a monolayer divide in its plane: random_in_plane, or given with an Axis x, y, 0.");
}

std::unique_ptr<Scenario> make_monolayer() { return std::make_unique<Monolayer>(); }
}  // namespace turgor
