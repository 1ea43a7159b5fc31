#include "app/struck_counterpart.h"

#include "app/counterpart_entries.h"
#include "micro/cells/tissue_strip.h"
#include "micro/scenes/tissue/tissue_loading.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "rve/rve_parameters.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
constexpr const char *cells_scene = "tissue_impact";
constexpr unsigned int columns_of_a_strip = 2;  // one would fail with all of its row at once

/// The piece as so many cells, and how large they are at rest.
struct Piece {
  bool strip = false, in_twos = false;  ///< rows come in twos: in a block, but of squares
  unsigned int rows = 2, columns = columns_of_a_strip;
  double row = 0., column = 0.;  // m
};

double number(const EntryValues &values, const std::string &entry) {
  return read_number(values.at(entry)).value_or(0.);
}

void refuse_what_cells_lack(const EntryValues &values) {
  const auto refuse = [&](const std::string &entry, const std::string &why) {
    throw InputError(entry + " is " + values.at(entry) + ", but " + why);
  };
  if (values.at("Tissue/Lateral sides") == "clamped")
    refuse("Tissue/Lateral sides",
           "all cells have sides that are free or periodic: compare with one of them.");
  if (const auto air = values.find("Structure/Air"); air != values.end() && air->second != "connected")
    refuse("Structure/Air", "all cells have air that leaves freely: compare with connected.");
  for (const char *entry : {"Tissue/Body force", "Tissue/Traction"})
    if (without_blanks(values.at(entry)) != "0,0")
      refuse(entry, "all cells are struck and carry nothing else: compare with 0, 0.");
  const std::string &structure = values.at("Structure/Structure");
  if (structure == "voronoi")
    refuse("Structure/Structure", "all cells stand in rows: compare with square, hexagon or brick.");
  const bool square = structure == "square";
  const double turned = std::fmod(number(values, "Structure/Rotation"), 180.);
  if (square ? std::fmod(turned, 90.) != 0. : std::abs(turned) != 90.)
    refuse("Structure/Rotation",
           std::string("the rows of all cells lie across the blow, which comes along x: compare with ") +
               (square ? "0." : "90."));
}

/// How large cells are at rest, the input's as they stand in rows. Throws InputError.
Piece piece_of(const EntryValues &values) {
  RveParameters rve;
  InputEntries prm;
  rve.add_parameters(prm);
  for (const InputEntry &entry : prm.entries())
    if (const auto given = values.find(entry.path()); given != values.end())
      set_entry(prm, entry.path(), given->second);
  rve.structure.rotation = 0.;
  Piece piece;
  piece.strip = values.at("Tissue/Lateral sides") == "periodic";
  try {
    check_strip(rve.structure, rve.yielding_cell(), 2, StripEnds::above_and_below);
    const CellLayout some = turgid_tissue(rve.structure, rve.yielding_cell(), 2, 2, Periods::upright);
    piece.column = 0.5 * some.lattice(0, 0);
    piece.row = 0.5 * some.lattice(1, 1);
  } catch (const std::invalid_argument &problem) {
    throw InputError("The block of all cells (" + std::string(cells_scene) +
                     ") cannot be had: " + problem.what());
  }
  piece.in_twos = !piece.strip && values.at("Structure/Structure") != "square";
  const auto count = [](const double size, const double of_one, const double step) {
    return unsigned(std::max(2., step * std::round(size / (step * of_one))));
  };
  piece.rows = count(number(values, "Tissue/Width"), piece.row, piece.in_twos ? 2. : 1.);
  if (!piece.strip) piece.columns = count(number(values, "Tissue/Height"), piece.column, 1.);
  return piece;
}

/// What finite elements are given so that both sides are the same piece under the same tool.
Counterpart::Entries changes(const EntryValues &values, const Piece &piece) {
  const double width = piece.rows * piece.row;
  Counterpart::Entries wanted = {{"Impact/Tool", "plate"},
                                 {"Impact/Motion", "steady"},
                                 {"Impact/Support", "plate"},
                                 {"Tissue/Width", number_text(width)}};
  if (piece.strip) {
    wanted.emplace_back("Tissue/Elements y", "2");  // the fewest that periodic sides take
    wanted.emplace_back("Tissue/Height", number_text(2. * width / number(values, "Tissue/Elements x")));
  } else
    wanted.emplace_back("Tissue/Height", number_text(piece.columns * piece.column));
  wanted.emplace_back("Time/End time",
                      number_text(number(values, "Impact/Depth") / number(values, "Impact/Speed")));
  return wanted;
}

Counterpart::Entries of_all_cells(const EntryValues &values, const Piece &piece,
                                  const ScenarioRegistry &registry) {
  Counterpart::Entries entries;
  for (const auto &[entry, value] : shared_entries(values, cells_scene, registry))
    entries.emplace_back(entry, entry == "Structure/Rotation" ? "0" : value);
  entries.insert(entries.end(),
                 {{"Columns", number_text(piece.columns)},
                  {"Rows", number_text(piece.rows)},
                  {"Sides", piece.strip ? "periodic" : "cut"},
                  {"Speed", values.at("Impact/Speed")},
                  {"End strain", number_text(number(values, "Impact/Depth") / (piece.rows * piece.row))}});
  for (const char *entry : {"Yielding", "Yield sharpness", "Yield drop", "Critical stretch"})
    entries.emplace_back(entry, values.at("Wall/" + std::string(entry)));
  return entries;
}

/// What of the input is not compared, in sentences.
std::string left_out(const EntryValues &values, const Counterpart &cells, const Piece &piece) {
  std::string replaced;
  for (const auto &[entry, value] : cells.tissue)
    if (values.at(entry) != value && entry.starts_with("Impact/"))
      replaced += (replaced.empty() ? "" : ", ") + entry + " = " + values.at(entry) + " (" + value + ")";
  std::string text = "Compared is a " + std::string(piece.strip ? "strip" : "block") + " of " +
                     number_text(piece.rows) + " rows of " + number_text(piece.columns) +
                     " cells, struck by a plate at " + values.at("Impact/Speed") + " m/s until it has gone " +
                     number_text(1e3 * number(values, "Impact/Depth")) + " mm.";
  if (!replaced.empty())
    text += " All cells have no other tools, so what the input says besides is left out on both sides: " +
            replaced + ".";
  if (number(values, "Wall/Critical stretch") > 0.)
    text +=
        " Not the same on both sides: a failed RVE drains by Wall/Leak time and Wall/Residue, a failed cell "
        "of particles by what flows through its hole.";
  return text;
}
}  // namespace

bool is_struck(const Input &tissue) { return tissue.scenario_name == "tissue_bruise"; }

Counterpart struck_counterpart(const Input &tissue, const ScenarioRegistry &registry) {
  const EntryValues values = values_of(tissue);
  refuse_files(tissue);
  refuse_what_cells_lack(values);
  const Piece piece = piece_of(values);
  Counterpart cells{cells_scene, of_all_cells(values, piece, registry), false, false, {}, {}};
  cells.struck = true;
  cells.breaks = number(values, "Wall/Critical stretch") > 0.;
  cells.tissue = changes(values, piece);
  const bool rows_halve = piece.rows >= 4 && piece.rows % (piece.in_twos ? 4 : 2) == 0;
  if (rows_halve && (piece.strip || piece.columns % 2 == 0)) {
    cells.half = {{"Rows", number_text(piece.rows / 2)}};
    if (!piece.strip) cells.half.emplace_back("Columns", number_text(piece.columns / 2));
  }
  const std::unique_ptr<Scenario> scene = possible_scene(cells, registry,
                                                         {{"Rows", "Tissue/Width in rows"},
                                                          {"Columns", "Tissue/Height in columns"},
                                                          {"Speed", "Impact/Speed"},
                                                          {"Critical stretch", "Wall/Critical stretch"},
                                                          {"End strain", "Impact/Depth over Tissue/Width"}});
  if (const auto *loading = dynamic_cast<const TissueLoading *>(scene.get()))
    cells.cpu = loading->expected_cpu();
  cells.remark = left_out(values, cells, piece);
  Counterpart::Entries finer = {{"Tissue/Elements x", doubled(values.at("Tissue/Elements x"))}};
  if (!piece.strip) finer.emplace_back("Tissue/Elements y", doubled(values.at("Tissue/Elements y")));
  cells.refinements.emplace_back("mesh", finer);
  refine_rves_and_steps(cells, values);
  return cells;
}
}  // namespace turgor
