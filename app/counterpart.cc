#include "app/counterpart.h"

#include "app/counterpart_entries.h"
#include "app/struck_counterpart.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace turgor {
namespace {
struct Scenes {
  const char *tissue, *cells;
  bool moves;
  const char *direction, *traction;                       ///< entries
  std::vector<std::pair<std::string, std::string>> same;  ///< entry of the tissue, entry of the cells
  std::string sides;                                      ///< entry
  std::vector<std::string> elements;                      ///< entries; 0: as many as the first
};

const std::vector<Scenes> &known_scenes() {
  static const std::vector<Scenes> scenes = {
      {"tissue_statics",
       "static_lattice",
       false,
       "Loads/Direction",
       "Loads/Traction",
       {{"Tissue statics/Cells", "Columns"}, {"Tissue statics/Load", "Load"}},
       "Tissue statics/Lateral sides",
       {"Tissue statics/Elements", "Tissue statics/Elements across"}},
      {"tissue_gravity",
       "full_micro",
       true,
       "Tissue gravity/Direction",
       "Tissue/Traction",
       {{"Tissue gravity/Cells", "Columns"}, {"Tissue gravity/Load", "Load"}, {"Time/End time", "End time"}},
       "Tissue/Lateral sides",
       {"Tissue/Elements x", "Tissue/Elements y"}}};
  return scenes;
}

const Scenes &scenes_of(const Input &tissue) {
  std::string names;
  for (const Scenes &one : known_scenes()) {
    if (one.tissue == tissue.scenario_name) return one;
    names += (names.empty() ? "" : ", ") + std::string(one.tissue);
  }
  names += ", tissue_bruise";
  throw InputError("There is no scene that has every cell of " + tissue.scenario_name +
                   "; compared are inputs of " + names + ".");
}

/// Of what only RVEs can do.
void refuse_what_cells_lack(const std::map<std::string, std::string> &values, const std::string &cells) {
  for (const char *entry : {"Wall/Yielding", "Wall/Critical stretch"}) {
    const auto found = values.find(entry);
    if (found == values.end() || found->second == "none" || read_number(found->second) == 0.) continue;
    throw InputError(std::string(entry) + " is " + found->second + ", but the scene of all cells (" + cells +
                     ") has walls that neither yield nor break: compare with none, or 0.");
  }
  if (const auto air = values.find("Structure/Air"); air != values.end() && air->second != "connected")
    throw InputError("Structure/Air is " + air->second + ", but the scene of all cells (" + cells +
                     ") has air that leaves freely: compare with connected.");
}

/// The entry that says how many rows the tissue has.
std::string rows_from(const std::map<std::string, std::string> &values, const Scenes &scenes) {
  const auto own = values.find(scenes.same.front().first + " across");
  return own != values.end() && own->second != "0" ? own->first : scenes.same.front().first;
}

/// All cells are loaded at once, and their right side is free.
void refuse_other_loads(const std::map<std::string, std::string> &values) {
  for (const auto &[entry, wanted, cells] :
       {std::tuple("Loads/Way", "at_once", "is loaded by all of its load at once"),
        {"Tissue/Right side", "free", "is held at its left side alone"}})
    if (const auto found = values.find(entry); found != values.end() && found->second != wanted)
      throw InputError(std::string(entry) + " is " + found->second + ", but a block of all cells " + cells +
                       ": compare with " + wanted + ".");
}

/// Pa: what the load pushes with along x and y, and the largest of its parts.
struct Push {
  Push(const std::map<std::string, std::string> &values, const Scenes &scenes) {
    const double size = read_number(values.at(scenes.same[1].first)).value_or(0.);
    const std::vector<double> way = InputEntries::list_of(values.at(scenes.direction)),
                              side = InputEntries::list_of(values.at(scenes.traction));
    const double length = std::hypot(way[0], way[1]);
    for (int d = 0; d < 2; ++d) total[d] = size * (length > 0. ? way[d] / length : 0.) + side[d];
    largest = std::max({std::abs(size), std::abs(side[0]), std::abs(side[1])});
  }
  double total[2], largest;
};

/// Pa. Below it the cells of a block at rest do not feel their load.
void refuse_lost_loads(const std::map<std::string, std::string> &values, const std::string &entry,
                       const double load) {
  constexpr double least_share = 1e-7;
  const double least = least_share * read_number(values.at("Cell/Turgor")).value_or(0.);
  if (load < least)
    throw InputError(entry + " is " + values.at(entry) +
                     " Pa, which drowns in the round-off of all cells' forces: use at least " +
                     number_text(least) +
                     " Pa (a ten millionth of Cell/Turgor); what is compared is linear "
                     "in small loads.");
}

/// What a block of all cells at rest is balanced to, so that it feels its load; "": what it is by itself.
std::string tolerance_for(const std::map<std::string, std::string> &values, const double load,
                          const InputEntries &of_cells) {
  constexpr double share_of_load = 1e-6, least = 1e-13;
  const double turgor = read_number(values.at("Cell/Turgor")).value_or(1.),
               wanted = std::max(share_of_load * load / turgor, least);
  for (const InputEntry &one : of_cells.entries())
    if (one.path() == "Tolerance" && wanted < read_number(one.value).value_or(0.)) return number_text(wanted);
  return "";
}
}  // namespace

Counterpart counterpart_of(const Input &tissue, const ScenarioRegistry &registry) {
  if (is_struck(tissue)) return struck_counterpart(tissue, registry);
  const Scenes &scenes = scenes_of(tissue);
  const std::map<std::string, std::string> values = values_of(tissue);
  refuse_what_cells_lack(values, scenes.cells);
  refuse_other_loads(values);
  const std::string sides = values.at(scenes.sides), structure = values.at("Structure/Structure");
  if (sides == "clamped")
    throw InputError(scenes.sides +
                     " is clamped, but a block of all cells is held at its left side alone: "
                     "compare with free or periodic.");
  const Push push(values, scenes);
  if (push.largest == 0.)
    throw InputError(scenes.same[1].first +
                     " is 0: without a load there is nothing to compare; use another.");
  if (const double turned = read_number(values.at("Structure/Rotation")).value_or(0.); turned != 0.)
    throw InputError(
        "Structure/Rotation is " + number_text(turned) +
        " degrees, but the sides of a block of all cells are upright, and so is its tissue: compare "
        "with 0.");
  Counterpart cells{scenes.cells, {}, sides == "free", scenes.moves, {}, {}};
  const std::unique_ptr<Scenario> scene = registry.make(scenes.cells);
  InputEntries prm;
  scene->declare_parameters(prm);
  cells.entries = shared_entries(values, scenes.cells, registry);
  refuse_files(tissue);
  for (const auto &[from, to] : scenes.same) cells.entries.emplace_back(to, values.at(from));
  cells.entries.emplace_back("Direction", values.at(scenes.direction));
  cells.entries.emplace_back("Traction", values.at(scenes.traction));
  cells.along_x = std::abs(push.total[0]) > std::abs(push.total[1]);
  std::string rows = values.at(scenes.same.front().first);
  const std::string across = rows_from(values, scenes);
  rows = values.at(across);
  // Nothing depends on y in a slab: one row, or the two that make a period.
  if (sides == "periodic" && scenes.moves) rows = structure == "hexagon" || structure == "brick" ? "2" : "1";
  cells.entries.emplace_back("Rows", rows);
  const bool in_twos = structure == "hexagon" || structure == "brick",
             one_period = sides == "periodic" && scenes.moves;
  const std::string columns = values.at(scenes.same.front().first);
  if (divides(2, columns) && (one_period || divides(in_twos ? 4 : 2, rows))) {
    cells.half = {{"Columns", halved(columns)}, {"Rows", one_period ? rows : halved(rows)}};
    if (scenes.moves) cells.half.emplace_back("End time", halved(values.at("Time/End time")));
  }
  cells.entries.emplace_back("Surfaces", cells.has_sides ? "frozen" : "slab");
  if (!scenes.moves) {
    refuse_lost_loads(values, scenes.same[1].first, push.largest);
    if (const std::string finer = tolerance_for(values, push.largest, prm); !finer.empty())
      cells.entries.emplace_back("Tolerance", finer);
  }
  std::vector<std::pair<std::string, std::string>> names = {
      {"Rows", across}, {"Direction", scenes.direction}, {"Traction", scenes.traction}};
  for (const auto &[from, to] : scenes.same) names.emplace_back(to, from);
  possible_scene(cells, registry, names);

  if (const auto held = values.find("RVE/Boundary"); held != values.end() && held->second != "periodic")
    cells.remark = "RVE/Boundary is " + held->second + ": such RVEs are windows cut out of the tissue, " +
                   (held->second == "uniform_traction" ? "softer" : "stiffer") +
                   " than it, the more so the fewer cells they have. The error of FE2 is that of its windows "
                   "first of all; 'RVE size' is the part of it that twice as many cells a side take away. "
                   "RVE/Boundary = periodic has no such error.";

  Counterpart::Entries finer;
  for (const std::string &entry : scenes.elements)
    if (values.at(entry) != "0") finer.emplace_back(entry, doubled(values.at(entry)));
  cells.refinements.emplace_back("mesh", finer);
  refine_rves_and_steps(cells, values);
  return cells;
}
}  // namespace turgor
