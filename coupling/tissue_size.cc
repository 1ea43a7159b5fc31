#include "coupling/tissue_size.h"

#include "run/resource_use.h"
#include "run/run_context.h"

#include <sstream>

namespace turgor {
namespace {
double points_of(const TissueParameters<2> &tissue) {
  const double per_element = (tissue.degree + 1.) * (tissue.degree + 1.);
  return per_element * tissue.elements[0] * tissue.elements[1];
}
}  // namespace

double tissue_memory(const TissueParameters<2> &tissue, const std::size_t state_size, const double sampled) {
  const double bytes_of_state = 2. * (sizeof(RveState<2>) + 8. * double(state_size));
  // tissue_bruise of 100 x 100 elements: 701 MB, 100 MB of them the program itself; trial and committed state
  // are 3.4 kB of a point's 15 kB.
  constexpr double bytes_of_point = 11500., bytes_of_sample = 100.;
  return points_of(tissue) * (bytes_of_point + bytes_of_state) + sampled * bytes_of_sample;
}

void check_tissue_size(const TissueParameters<2> &tissue, const std::size_t state_size,
                       const double sampled) {
  const double needed = tissue_memory(tissue, state_size, sampled), there = double(physical_memory());
  if (needed <= there) return;
  std::ostringstream text;
  text.precision(3);
  text << tissue.elements[0] << " x " << tissue.elements[1] << " elements with " << points_of(tissue)
       << " RVEs";
  if (sampled > 0.) text << " and " << sampled << " sampled points";
  text << " need about " << needed / 1e9 << " GB of memory, this machine has " << there / 1e9
       << " GB: take fewer elements, or smaller RVEs (RVE/Columns, RVE/Rows, Cell/Nodes per side)"
       << (sampled > 0. ? ", or fewer Cells" : "") << ".";
  throw InputError(text.str());
}
}  // namespace turgor
