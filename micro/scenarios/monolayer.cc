#include "micro/scenarios/monolayer.h"

#include "micro/io/run_context.h"

namespace turgor
{
Monolayer::Monolayer()
{
  flat = true;
  entries.direction = "random_in_plane";
  entries.in_plane = true;
}

std::string Monolayer::description() const
{
  return "Centre-based cells that grow and divide on a flat substrate.";
}

void Monolayer::check_more() const
{
  const Vector<3> axis = entries.parameters().life.division.axis;
  if (entries.direction != "random_in_plane" && !(entries.direction == "given" && axis[2] == 0.))
    throw InputError("Division/Direction is " + entries.direction
                     + ", but cells of a monolayer divide in its plane: random_in_plane, or given with an Axis x, y, 0.");
}

std::unique_ptr<Scenario> make_monolayer() { return std::make_unique<Monolayer>(); }
} // namespace turgor
