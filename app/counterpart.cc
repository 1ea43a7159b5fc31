#include "app/counterpart.h"

#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"

#include <cmath>
#include <map>

namespace turgor {
namespace {
/// All entries of an input by Section/Name.
std::map<std::string, std::string> values_of(const Input &input) {
  std::map<std::string, std::string> values;
  for (const auto *list : {&input.identity.deciding, &input.identity.ends, &input.identity.free})
    values.insert(list->begin(), list->end());
  return values;
}

struct Scenes {
  const char *tissue, *cells;
  bool moves;
  std::vector<std::pair<std::string, std::string>> same;  ///< entry of the tissue, entry of the cells
  std::string sides;                                      ///< entry
  std::vector<std::string> elements;                      ///< entries; 0: as many as the first
};

const std::vector<Scenes> &known_scenes() {
  static const std::vector<Scenes> scenes = {
      {"tissue_statics",
       "static_lattice",
       false,
       {{"Tissue statics/Cells", "Columns"}, {"Tissue statics/Load", "Load"}},
       "Tissue statics/Lateral sides",
       {"Tissue statics/Elements", "Tissue statics/Elements across"}},
      {"tissue_gravity",
       "full_micro",
       true,
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
}

bool divides(const int factor, const std::string &whole) {
  return std::fmod(read_number(whole).value_or(1.), factor) == 0.;
}

std::string halved(const std::string &number) { return number_text(0.5 * read_number(number).value_or(1.)); }
std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

/// All cells are loaded by their weight alone, downwards and at once.
void refuse_other_loads(const std::map<std::string, std::string> &values) {
  for (const auto &[entry, wanted] :
       {std::pair("Loads/Way", "at_once"), {"Loads/Direction", "0, -1"}, {"Loads/Traction", "0, 0"}})
    if (const auto found = values.find(entry);
        found != values.end() && without_blanks(found->second) != without_blanks(wanted))
      throw InputError(
          std::string(entry) + " is " + found->second +
          ", but a block of all cells is loaded by a body force downwards, all of it at once: compare with " +
          wanted + ".");
}

std::string doubled(const std::string &whole) { return number_text(2. * read_number(whole).value_or(1.)); }
}  // namespace

Counterpart counterpart_of(const Input &tissue, const ScenarioRegistry &registry) {
  const Scenes &scenes = scenes_of(tissue);
  const std::map<std::string, std::string> values = values_of(tissue);
  refuse_what_cells_lack(values, scenes.cells);
  refuse_other_loads(values);
  const std::string sides = values.at(scenes.sides), structure = values.at("Structure/Structure");
  if (sides == "clamped")
    throw InputError(scenes.sides +
                     " is clamped, but a block of all cells is held at its left side alone: "
                     "compare with free or periodic.");
  if (read_number(values.at(scenes.same[1].first)) == 0.)
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
  for (const InputEntry &entry : prm.entries())
    if (const auto found = values.find(entry.path());
        found != values.end() && entry.path().find('/') != std::string::npos)
      cells.entries.emplace_back(entry.path(), found->second);
  for (const RunIdentity::NamedFile &file : tissue.identity.files)
    throw InputError(file.entry + ": the tissue of a file is not compared; use a Structure without one.");
  for (const auto &[from, to] : scenes.same) cells.entries.emplace_back(to, values.at(from));
  std::string rows = values.at(scenes.same.front().first);
  if (const auto across = values.find("Tissue statics/Cells across");
      across != values.end() && across->second != "0")
    rows = across->second;
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

  Counterpart::Entries finer;
  for (const std::string &entry : scenes.elements)
    if (values.at(entry) != "0") finer.emplace_back(entry, doubled(values.at(entry)));
  cells.refinements.emplace_back("mesh", finer);
  cells.refinements.emplace_back("RVE size",
                                 Counterpart::Entries{{"RVE/Columns", doubled(values.at("RVE/Columns"))},
                                                      {"RVE/Rows", doubled(values.at("RVE/Rows"))}});
  if (const auto skipping = values.find("Skipping/Skipping");
      skipping != values.end() && skipping->second != "none")
    cells.refinements.emplace_back("skipping", Counterpart::Entries{{"Skipping/Skipping", "none"}});
  if (scenes.moves)
    cells.refinements.emplace_back(
        "time step",
        Counterpart::Entries{{"Time/Step fraction",
                              number_text(0.5 * read_number(values.at("Time/Step fraction")).value_or(1.))}});
  return cells;
}
}  // namespace turgor
