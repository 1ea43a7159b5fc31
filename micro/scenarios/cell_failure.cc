// cell_failure: a cell squeezed slowly or struck until its wall breaks: where the crack starts and at what deformation.
// Thesis 3.3.3, Fig. 3.5A, B.
#include "micro/io/run_context.h"
#include "micro/scenarios/squeezed_cell.h"

#include <algorithm>

namespace turgor
{
namespace
{
class CellFailure final : public SqueezedCell
{
public:
  CellFailure() { critical_stretch = 1.04; }

  std::string description() const override
  {
    return "A cell squeezed slowly or struck until its wall breaks: where the crack starts, and how much fluid escapes.";
  }

  void check() const override
  {
    SqueezedCell::check();
    if (critical_stretch == 0.)
      throw InputError("Critical stretch is 0, but cell_failure needs one above 1 (cell_impact and cell_compression do without).");
    if (cell.fluid == "pressure")
      throw InputError("Cell/Fluid is pressure, but an opened cell does not have one pressure; use sph or none.");
  }

protected:
  void report(RunContext &context, const std::vector<Row> &rows) const override
  {
    double upper = 0., lower = 0.;
    for (const Row &row : rows)
      {
        upper = std::max(upper, row.force_upper);
        lower = std::max(lower, row.force_lower);
      }
    context.result("largest_force_upper", upper, "N");
    context.result("largest_force_lower", lower, "N");
  }
};
} // namespace

std::unique_ptr<Scenario> make_cell_failure() { return std::make_unique<CellFailure>(); }
} // namespace turgor
