#include "app/study_input.h"

#include "app/csv_table.h"
#include "app/declared_entries.h"
#include "app/expression.h"
#include "app/input.h"
#include "app/nearest_name.h"
#include "app/study_grid.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/prm_text.h"
#include "run/run_context.h"
#include "run/user_text.h"

#include <algorithm>
#include <deque>

namespace turgor {
namespace {
using namespace Patterns;

struct RunEntries {
  std::string section, label, method, settings, input, overrides, grid, axes;
  unsigned int threads = 0;
  bool compared = true;

  void declare(InputEntries &prm) {
    prm.enter_subsection(section);
    prm.add_parameter("Method", method, "Name in tables and pictures; the label, if empty. Units: none.",
                      Anything());
    prm.add_parameter("Settings", settings,
                      "What distinguishes this run from others of its method. Units: none.", Anything());
    prm.add_parameter("Input", input,
                      "Scene's input file, relative to the study file; the study's, if empty. Units: none.",
                      Anything());
    prm.add_parameter("Overrides", overrides,
                      "Section/Name=value; Section/Name=value, after the study's. Units: none.", Anything());
    prm.add_parameter("Threads", threads, "Of each run; the study's, if 0. Units: none.", Integer(0, 1024));
    prm.add_parameter(
        "Grid", grid,
        "One run for each value, with several entries for each combination: A = 1 | 2; B & C = 3 & 4 | 5 & 6 "
        "(B and C change together). Units: none.",
        Anything());
    prm.add_parameter("Compared", compared,
                      "Whether it answers the same question as the references; else it has values and no "
                      "errors. Units: true or false.");
    prm.add_parameter("Axes", axes, "Written as Grid, but one entry is changed at a time. Units: none.",
                      Anything());
    prm.leave_subsection();
  }
};

struct MeasureEntries {
  std::string section, title, table, columns, against, match, result, weight = "rms", reference;
  unsigned int parts = 0;
  double size = 0.;

  void declare(InputEntries &prm) {
    prm.enter_subsection(section);
    prm.add_parameter("Title", title,
                      "What pictures say is measured; its columns or result, if empty. Units: none.",
                      Anything());
    prm.add_parameter("Table", table, "Name of a CSV of the runs, without .csv. Units: none.", Anything());
    prm.add_parameter(
        "Columns", columns,
        "Of the table, without units, separated by commas: together the components of a vector. "
        "Units: none.",
        Anything());
    prm.add_parameter(
        "Against", against,
        "Column that is the abscissa, which rises or falls all the way; the first, if empty. Units: none.",
        Anything());
    prm.add_parameter("Match", match,
                      "Columns that name a row, if the table is no curve: cell_x, cell_y. Units: none.",
                      Anything());
    prm.add_parameter("Result", result, "Instead of a table: a result of summary.json. Units: none.",
                      Anything());
    prm.add_parameter(
        "Weight", weight,
        "rms, max, end: of values and differences over the abscissa, largest, in the last row; mean, "
        "largest, amplitude, period (of the first swing): one number of each curve is compared. Units: none.",
        Selection("rms|max|end|mean|largest|amplitude|period"));
    prm.add_parameter(
        "Parts", parts,
        "Compared are means over so many equal parts of the abscissa; 0: the rows. Units: none.",
        Integer(0, 100000));
    prm.add_parameter(
        "Relative to", size,
        "What a difference is divided by, in the unit of the columns; 0: the reference's size; 1: absolute "
        "errors. Units: those of the columns.",
        Double(0.));
    prm.add_parameter(
        "Reference", reference,
        "Label of a run, directory of a finished run, CSV file, or an expression of the columns (of the "
        "results) of the run itself, one for each column, separated by ;. The study's, if empty. Units: "
        "none.",
        Anything());
    prm.leave_subsection();
  }
};

struct TopEntries {
  std::string input, overrides, reference, draw = "all";
  unsigned int threads = 1;

  void declare(InputEntries &prm) {
    prm.add_parameter(
        "Input", input,
        "Scene's input file of the runs that name no other, relative to the study file. Units: none.",
        Anything());
    prm.add_parameter("Overrides", overrides, "Of all runs, before their own. Units: none.", Anything());
    prm.add_parameter("Threads", threads, "Of the runs that say nothing else. Units: none.",
                      Integer(1, 1024));
    prm.add_parameter("Reference", reference, "Of the measures that name no other. Units: none.", Anything());
    prm.add_parameter("Draw", draw,
                      "Results and measures drawn against the swept values: all, none, or names separated by "
                      "; with + between those of "
                      "one panel. Units: none.",
                      Anything());
  }
};

const std::vector<std::string> weights = {"rms", "max", "end", "mean", "largest", "amplitude", "period"};

StudyReference reference_of(const std::string &text, const std::filesystem::path &base,
                            const std::vector<std::string> &labels, const std::string &where) {
  using Kind = StudyReference::Kind;
  if (text.empty()) return {};
  if (std::find(labels.begin(), labels.end(), text) != labels.end()) return {Kind::run, text, {}};
  const std::filesystem::path path = base / text;
  std::error_code none;  // a text that is no path, because it is too long, is an expression
  if (std::filesystem::is_directory(path, none)) return {Kind::directory, text, path};
  if (std::filesystem::is_regular_file(path, none)) return {Kind::file, text, path};
  try {
    for (const std::string &part : split_escaped(text, ';')) Expression{part};
  } catch (const std::invalid_argument &problem) {
    throw InputError(where + " = '" + text +
                     "' is neither a run of this study nor a directory or file, and no expression: " +
                     problem.what() + "." + suggestion(text, labels));
  }
  return {Kind::expression, text, {}};
}

StudyMeasure measure_of(const MeasureEntries &entries, const TopEntries &top,
                        const std::filesystem::path &file, const std::vector<std::string> &labels) {
  using Kind = StudyReference::Kind;
  const std::string where = file.string() + ": '" + entries.section;
  StudyMeasure measure;
  measure.name = trimmed(entries.section.substr(8));
  measure.title = entries.title;
  measure.table = entries.table;
  measure.against = entries.against;
  measure.columns = split_escaped(entries.result.empty() ? entries.columns : entries.result, ',');
  measure.match = split_escaped(entries.match, ',');
  measure.parts = entries.parts;
  measure.size = entries.size;
  measure.weight =
      static_cast<Weight>(std::find(weights.begin(), weights.end(), entries.weight) - weights.begin());
  measure.reference = reference_of(entries.reference.empty() ? top.reference : entries.reference,
                                   file.parent_path(), labels, where + "/Reference'");
  if (entries.result.empty() == (entries.table.empty() || measure.columns.empty()))
    throw InputError(where + "' needs either 'Table' and 'Columns' or 'Result'.");
  if (!entries.result.empty() && (measure.columns.size() > 1 || measure.reference.kind == Kind::file ||
                                  !measure.match.empty() || measure.parts > 0))
    throw InputError(where +
                     "' measures a result: one name, without 'Match', 'Parts' or a CSV as reference.");
  if (!measure.match.empty() &&
      (measure.weight > Weight::max || measure.parts > 0 || !measure.against.empty()))
    throw InputError(where +
                     "/Match' goes with the weights rms and max only, without 'Against' and 'Parts': matched "
                     "rows have no order.");
  if (measure.weight > Weight::end && measure.columns.size() > 1)
    throw InputError(where + "/Weight' = '" + entries.weight + "' is of one column; 'Columns' names " +
                     number_text(measure.columns.size()) + ".");
  if (measure.reference.kind == Kind::expression &&
      split_escaped(measure.reference.text, ';').size() != measure.columns.size())
    throw InputError(where + "/Reference' needs one expression for each column, separated by ;.");
  // What is already there is looked at now, not after the first run.
  const std::filesystem::path there = measure.reference.kind == Kind::directory && !measure.table.empty()
                                          ? measure.reference.path / (measure.table + ".csv")
                                          : measure.reference.path;
  if (measure.reference.kind == Kind::file ||
      (measure.reference.kind == Kind::directory && !measure.table.empty()))
    try {
      const CsvTable table = read_csv(there);
      for (const auto &names : {measure.columns, measure.match})
        for (const std::string &name : names) table.column(name);
    } catch (const std::runtime_error &problem) {
      throw InputError(where + "/Reference': " + problem.what());
    }
  return measure;
}
}  // namespace

std::string StudyMeasure::weight_name() const {
  return table.empty() ? "" : weights[static_cast<std::size_t>(weight)];
}

std::string StudyMeasure::value_column() const {
  const std::string kind = weight_name();
  return kind.empty() || name == kind || name.ends_with("_" + kind) ? name : name + "_" + kind;
}

bool StudyInput::of_errors() const {
  return std::any_of(measures.begin(), measures.end(), [](const StudyMeasure &measure) {
    return measure.reference.kind != StudyReference::Kind::none;
  });
}

StudyInput load_study(const std::filesystem::path &file) {
  const PrmText text = read_prm(file);
  InputEntries prm;
  TopEntries top;
  top.declare(prm);
  std::deque<RunEntries> runs;  // addresses stay: the handler keeps them
  std::deque<MeasureEntries> measures;
  for (const PrmSection &section : text.sections) {
    const std::string &name = section.path[0];
    const bool run = name.compare(0, 4, "Run ") == 0;
    if (section.path.size() != 1 || (!run && name.compare(0, 8, "Measure ") != 0))
      throw InputError(section.where +
                       ": a study holds subsections 'Run LABEL' and 'Measure NAME' only, not '" +
                       section.path.back() + "'.");
    for (const PrmSection &other : text.sections)
      if (&other < &section && other.path == section.path)
        throw InputError(section.where + ": there is a second subsection '" + name +
                         "' (first: " + other.where + ").");
    if (run) {
      RunEntries &entries = runs.emplace_back();
      entries.section = name;
      entries.label = trimmed(name.substr(4));
      entries.declare(prm);
    } else {
      measures.emplace_back().section = name;
      measures.back().declare(prm);
    }
  }
  apply(text, prm);
  if (runs.empty()) throw InputError(file.string() + ": a study needs at least one 'subsection Run LABEL'.");

  StudyInput study;
  std::vector<std::string> labels;
  for (const RunEntries &entries : runs) {
    if (entries.input.empty() && top.input.empty())
      throw InputError(file.string() + ": '" + entries.section +
                       "/Input' is missing; it names the run's input file.");
    StudyRun run;
    run.label = entries.label;
    run.method = entries.method.empty() ? entries.label : entries.method;
    run.settings = entries.settings;
    run.input = file.parent_path() / (entries.input.empty() ? top.input : entries.input);
    run.compared = entries.compared;
    run.threads = entries.threads == 0 ? top.threads : entries.threads;
    for (const std::string &overrides : {top.overrides, entries.overrides})
      for (const std::string &part : split_escaped(overrides, ';')) run.overrides.push_back(part);
    for (const StudyRun &point :
         points_of(run, entries.grid, entries.axes, file.string() + ": '" + entries.section)) {
      if (std::find(labels.begin(), labels.end(), point.label) != labels.end())
        throw InputError(file.string() + ": there are two runs with the label '" + point.label + "'.");
      labels.push_back(point.label);
      study.runs.push_back(point);
    }
  }
  for (const MeasureEntries &entries : measures)
    study.measures.push_back(measure_of(entries, top, file, labels));
  if (!top.reference.empty() && measures.empty())
    throw InputError(file.string() +
                     ": 'Reference' is set, but no 'subsection Measure NAME' says what is compared with it.");
  study.draw_all = top.draw == "all";
  if (!study.draw_all && top.draw != "none")
    for (const std::string &panel : split_escaped(top.draw, ';'))
      study.draw.push_back(split_escaped(panel, '+'));
  return study;
}

std::string study_parameters_text(const std::string &part) {
  InputEntries prm;
  TopEntries top;
  RunEntries run;
  MeasureEntries measure;
  run.section = "Run LABEL";
  measure.section = "Measure NAME";
  top.declare(prm);
  run.declare(prm);
  measure.declare(prm);
  if (!part.empty()) return prm_of(part_of(prm.entries(), part), true, true);
  return "# A study: many runs, what is measured in them and against what. Any number of subsections Run and "
         "Measure.\n"
         "# ; | & inside a value are written \\; \\| \\&.\n" +
         prm_of(prm.entries(), true, true);
}
}  // namespace turgor
