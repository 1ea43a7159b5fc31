#include "micro/cells/tissue_structure.h"

#include "micro/cells/parenchyma.h"
#include "micro/cells/tiled_layout.h"
#include "micro/cells/turgid_layout.h"
#include "micro/cells/turgid_limit.h"
#include "micro/cells/turned_cells.h"
#include "micro/geometry/joined_polygons.h"
#include "micro/geometry/laguerre_tiling.h"
#include "micro/geometry/regular_tilings.h"
#include "micro/geometry/tiling_measures.h"
#include "micro/geometry/traced_cells.h"
#include "micro/laws/random_normal.h"
#include "run/csv_text.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/word_or_file.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace turgor {
namespace {
/// side: m if the file keeps to it, of a square as large as the cells in the mean; refused where no cell is
/// so large, with the unit that it may be in: the one in which these cells come nearest to the usual size.
/// remedy: what is to be given anew, before "times 1e-6".
void require_metres(const double side, const std::string &remedy) {
  constexpr double least = 1e-7, most = 1e-2;  // m, as Cell/Period
  constexpr double usual = 5e-5;               // m
  if (side >= least && side <= most) return;
  std::string text = "its cells are " + number_text(side, 3) + " m wide in the mean, allowed are " +
                     number_text(least) + " to " + number_text(most) + " m";
  struct Unit {
    const char *name, *factor;
    double metres;
  };
  const Unit *likely = nullptr;
  double nearest = HUGE_VAL;
  static constexpr Unit units[] = {{"metres times 1e-6 once too often", "1e6", 1e6},
                                   {"metres times 1e-3 once too often", "1e3", 1e3},
                                   {"millimetres", "1e-3", 1e-3},
                                   {"micrometres", "1e-6", 1e-6},
                                   {"nanometres", "1e-9", 1e-9}};
  for (const Unit &unit : units)
    if (const double as = side * unit.metres, away = std::abs(std::log(as / usual));
        as >= least && as <= most && away < nearest) {
      likely = &unit;
      nearest = away;
    }
  text += likely
              ? std::string(": it looks like ") + likely->name + ". " + remedy + ", times " + likely->factor
              : ". " + remedy;
  throw std::invalid_argument(text + ".");
}

double mean_side(const Tiling &tiling) { return std::sqrt(TilingMeasures(tiling).mean_area()); }

/// Rows of one cell after the other: its number, x, y. Corners nearer than a thousandth of the mean size are
/// one.
Tiling polygons_of(const std::string &file) {
  const CsvText table{file};
  std::vector<std::vector<Vector<2>>> polygons;
  double last = 0.;
  for (const CsvRow &row : table.rows) {
    table.require_fields(row, 3);
    const double cell = table.number(row, 0);
    if (polygons.empty() || cell != last) polygons.emplace_back();
    last = cell;
    polygons.back().push_back({table.number(row, 1), table.number(row, 2)});
  }
  double area = 0.;
  for (const auto &polygon : polygons) area += std::abs(polygon_area(polygon)) / double(polygons.size());
  if (area > 0.) require_metres(std::sqrt(area), "Give x and y in m");
  return join_polygons(polygons, nullptr, 1e-3 * std::sqrt(area));
}

/// Seeds anywhere in the box, areas log-normal about the same mean.
Tiling random_laguerre(const TissueStructure &s, const double side, const unsigned int columns,
                       const unsigned int rows) {
  const Vector<2> periods(columns * side, rows * side);
  const double width = std::sqrt(std::log1p(s.area_scatter * s.area_scatter));
  std::vector<Vector<2>> seeds;
  std::vector<double> areas;
  for (std::uint64_t i = 0; i < std::uint64_t(columns) * rows; ++i) {
    seeds.push_back(
        {periods[0] * random_uniform(s.seed, 2 * i), periods[1] * random_uniform(s.seed, 2 * i + 1)});
    areas.push_back(std::exp(width * random_normals(s.seed, i, 0)[0]));
  }
  return laguerre_tiling(periods, seeds, areas, s.ordering);
}
}  // namespace

void TissueStructure::add_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Structure", kind,
                    "How the cells lie: square cells, whose Cell/Period is the side at turgor; or, with a "
                    "mean area of Cell/Period squared before "
                    "turgor stretches the walls, regular hexagon cells, brick (square cells whose rows are "
                    "moved by half a cell, thesis 3.3.2), "
                    "voronoi (a random Laguerre tessellation), or voronoi cells as large, and as different "
                    "in size, as those of Tissue file: "
                    "polygons (a table) or image (a segmented picture); Cell/Period then counts for nothing. "
                    "Other than square they find their periods at turgor themselves, free of stress. "
                    "Units: none.");
  prm.add_parameter(
      "Structure seed", seed,
      "Seed of what is random in the tissue: Corner jitter, places and areas of voronoi cells. Units: none.",
      Integer(0));
  prm.add_parameter("Rotation", rotation,
                    "Angle by which the tissue is turned, counter-clockwise. Units: degrees.",
                    Double(-360., 360.));
  prm.add_parameter("Corner jitter", jitter,
                    "Largest random displacement of a corner of hexagon or brick cells, in x and in y, over "
                    "Cell/Period. Units: 1.",
                    Double(0., 0.2));
  prm.add_parameter(
      "Gap", gap,
      "Length without lamella ties at either end of a wall that two cells share where three cells or "
      "more meet, as laid: 0 gives dense tissue, more opens air spaces between the cells (void fraction "
      "at turgor in per cent with 0.1, 0.15, 0.2 of Cell/Period: brick 2, 4, 6; hexagon 2, 4, 7; square 3, "
      "6, 9; voronoi "
      "3, 6, 11; rve_response tells it exactly and finds the gap of a Void fraction); a wall "
      "shorter than two of it is not tied at all. Needs RVE/Fluid = hydrostatic in an RVE. Square cells "
      "then have the side Cell/Period before turgor stretches the walls. Units: m.",
      Double(0., 1e-2));
  prm.add_parameter(
      "Area scatter", area_scatter,
      "Standard deviation of the areas of voronoi cells over their mean (log-normal). Units: 1.",
      Double(0., 0.6));
  prm.add_parameter("Ordering", ordering,
                    "Rounds in which the seeds of voronoi cells go to the centroids of their cells: none "
                    "gives wild shapes, many a nearly regular "
                    "tissue. Units: 1.",
                    Integer(0, 1000));
  prm.add_parameter(
      "Tissue file", file,
      "File of a tissue that is given. Structure polygons: a CSV with the columns cell, x, y, "
      "one row for each corner in m, those of a cell one "
      "after the other. Structure image: a PNG or TIFF with one grey value or colour for each cell, 0 "
      "where there is none. Other structures: "
      "none. Units: none.",
      WordOrFile("none"));
  prm.add_parameter("Pixel size", pixel, "Side of a pixel of Structure image. Units: m.", Double(1e-9, 1e-3));
  prm.add_parameter("Line width", line_width,
                    "Pixels across the lines without a label that part the cells of Structure image: they go "
                    "to the cells beside "
                    "them, wider spaces stay spaces. Units: 1.",
                    Integer(0, 100));
}

Tiling TissueStructure::given() const {
  check();
  try {
    if (kind == StructureKind::polygons) return polygons_of(file);
    LabelImage image = read_label_image(file);
    close_lines(image, int(line_width));
    Tiling cells = trace_cells(image, pixel);
    require_metres(mean_side(cells), "Give Structure/Pixel size in m");
    return cells;
  } catch (const std::invalid_argument &wrong) {
    throw InputError("Structure/Tissue file " + file + ": " + wrong.what());
  }
}

void TissueStructure::check() const {
  if (measured() != (file != "none"))
    throw std::invalid_argument("Structure/Tissue file is " + file + ", but Structure = " + word_of(kind) +
                                (measured() ? " needs one." : " has none: use none, or polygons or image."));
  if (jitter > 0. && kind != StructureKind::hexagon && kind != StructureKind::brick)
    throw std::invalid_argument("Structure/Corner jitter is " + number_text(jitter) +
                                ", but with Structure = " + word_of(kind) +
                                " corners are not displaced: use 0, or hexagon or brick.");
}

Tiling TissueStructure::tiling(const double side, const unsigned int columns, const unsigned int rows,
                               const double shortest, const Periods periods) const {
  check();
  if (kind == StructureKind::voronoi)
    return without_short_sides(random_laguerre(*this, side, columns, rows), shortest);
  const Tiling one = kind == StructureKind::hexagon ? hexagon_tiling(side)
                     : kind == StructureKind::brick ? brick_tiling(side)
                                                    : square_tiling(side);
  Tiling tiling =
      periods == Periods::upright ? replicated_upright(one, columns, rows) : replicated(one, columns, rows);
  for (std::size_t v = 0; v < tiling.vertices.size(); ++v)
    for (std::size_t d = 0; d < 2; ++d)
      tiling.vertices[v][d] += jitter * side * (2. * random_uniform(seed, 2 * v + d) - 1.);
  return without_short_sides(tiling, shortest);
}

void TissueStructure::check_file(const double wall_thickness) const {
  if (!measured()) return;
  const double side = mean_side(given());
  if (wall_thickness < 0.5 * side) return;
  const bool image = kind == StructureKind::image;
  throw InputError(
      "Structure/Tissue file " + file + ": its cells are " + number_text(side, 3) + " m wide in the mean" +
      (image ? ", " + number_text(side / pixel, 3) + " pixels" : "") + ", but walls (Cell/Wall thickness = " +
      number_text(wall_thickness) + " m) have to be thinner than half of that. " +
      (image ? "Give Structure/Pixel size (now " + number_text(pixel) + " m)" : std::string("Give x and y")) +
      " so that cells have their true size in m, or thinner walls.");
}

// What cells of any shape hold at most is p = P^2/A F(lambda)/(2 lambda P_0 z0), as turgid_limit.h has it of
// round ones. P_0 is no less than 3.5 Cell/Period and P^2/A no more than 18 in the mean of a tissue, so that
// twice the limit of a round cell with P_0 = 4 Cell/Period is beyond what any of them holds.
void require_walls_that_hold(const TissueStructure &structure, const ParenchymaParameters &held) {
  if (structure.square() || structure.measured()) return;
  const double limit = 2. * turgid_limit(held.wall_law(), round_cell, 4. * held.period, held.depth).pressure;
  if (held.turgor < limit) return;
  throw std::invalid_argument(
      "Cell/Turgor is " + number_text(held.turgor) + " Pa, but cells of Structure/Structure = " +
      word_of(structure.kind) + " with walls of Cell/Wall stiffness = " + number_text(held.wall_stiffness) +
      " N/m and Cell/Period = " + number_text(held.period) + " m hold less than " + number_text(limit) +
      " Pa: beyond it walls stretch without end. Use less turgor, stiffer walls or smaller cells.");
}

CellLayout laid_tissue(const TissueStructure &structure, ParenchymaParameters cell,
                       const unsigned int columns, const unsigned int rows, const Periods periods) {
  structure.check();
  if (structure.square()) return make_parenchyma(cell, columns, rows, true, true);
  TissueStructure laid = structure;
  if (structure.measured()) {
    const TilingMeasures found(structure.given());
    laid.kind = StructureKind::voronoi;
    laid.file = "none";
    laid.area_scatter = found.area_scatter();
    cell.period = std::sqrt(found.mean_area());
  }
  if (!(laid.gap < 0.25 * cell.period))
    throw std::invalid_argument("Structure/Gap is " + number_text(laid.gap) +
                                " m, but it has to be less than a quarter of Cell/Period (" +
                                number_text(0.25 * cell.period) + " m): too little would tie the cells.");
  const double least = 0.1 * cell.period / cell.nodes_per_side;
  if (laid.gap > 0. && laid.gap < least)
    throw std::invalid_argument("Structure/Gap is " + number_text(laid.gap) +
                                " m, less than a tenth of the distance of wall nodes: nothing of it would be "
                                "resolved. Use 0, or at least " +
                                number_text(least, 3) + " m.");
  return lay_cells(laid.tiling(cell.period, columns, rows, cell.period / cell.nodes_per_side, periods), cell,
                   laid.gap);
}

CellLayout turgid_tissue(const TissueStructure &structure, const ParenchymaParameters &cell,
                         const unsigned int columns, const unsigned int rows, const Periods periods) {
  structure.check();
  CellLayout layout = structure.square()
                          ? turgid_parenchyma(cell, columns, rows, true, true)
                          : turgid_with_lattice(laid_tissue(structure, cell, columns, rows, periods));
  return turned(std::move(layout), structure.rotation * std::numbers::pi / 180.);
}
}  // namespace turgor
