#include "app/study_input.h"

#include "app/input.h"
#include "app/nearest_name.h"
#include "micro/io/input_entries.h"
#include "micro/io/prm_text.h"
#include "micro/io/run_context.h"

#include <algorithm>
#include <deque>

namespace turgor
{
namespace
{
struct RunEntries
{
  std::string section, label, method, settings, input, overrides, entry, values;
  bool axis = false;
  unsigned int threads = 1;
};
} // namespace

StudyInput load_study(const std::filesystem::path &file)
{
  using namespace Patterns;
  const PrmText text = read_prm(file);
  InputEntries prm;
  std::string reference, picture;
  prm.add_parameter("Picture", picture, "Without Reference: app/plots/study_NAME.py draws the results.", Anything());
  prm.add_parameter("Reference", reference,
                    "Label of the run, or directory of a finished run (relative to the study file), that all are measured against.",
                    Anything());
  std::deque<RunEntries> entries; // addresses stay: the handler keeps them
  std::vector<std::string> labels;
  for (const PrmSection &section : text.sections)
    {
      const bool axis = section.path[0].compare(0, 5, "Axis ") == 0;
      if (section.path.size() != 1 || (!axis && section.path[0].compare(0, 4, "Run ") != 0))
        throw InputError(section.where + ": a study holds subsections 'Axis LABEL' and 'Run LABEL' only, not '" + section.path.back() + "'.");
      RunEntries &run = entries.emplace_back();
      run.section = section.path[0];
      run.axis = axis;
      run.label = trimmed(run.section.substr(axis ? 5 : 4));
      if (std::find(labels.begin(), labels.end(), run.label) != labels.end())
        throw InputError(section.where + ": there are two runs with the label '" + run.label + "'.");
      labels.push_back(run.label);
      run.method = run.label;
      prm.enter_subsection(run.section);
      prm.add_parameter("Method", run.method, "Name of the method in table and legend.", Anything());
      prm.add_parameter("Settings", run.settings, "What distinguishes this run within its method.", Anything());
      prm.add_parameter("Input", run.input, "Input file, relative to the study file.", Anything());
      prm.add_parameter("Overrides", run.overrides, "Section/Name=value, separated by semicolons.", Anything());
      prm.add_parameter("Threads", run.threads, "Threads of the run.", Integer(1, 1024));
      if (axis)
        {
          prm.add_parameter("Entry", run.entry, "Section/Name of the entry that takes the values.", Anything());
          prm.add_parameter("Values", run.values, "Values of the entry, separated by |.", Anything());
        }
      prm.leave_subsection();
    }
  apply(text, prm);
  if (entries.empty())
    throw InputError(file.string() + ": a study needs at least one 'subsection Run LABEL'.");

  StudyInput study;
  const std::filesystem::path base = file.parent_path();
  for (const RunEntries &run : entries)
    {
      if (run.input.empty())
        throw InputError(file.string() + ": '" + run.section + "/Input' is missing; it names the run's input file.");
      StudyRun made;
      made.label = run.label;
      made.method = run.method;
      made.settings = run.settings;
      made.input = base / run.input;
      made.threads = run.threads;
      for (const std::string &part : split_trimmed(run.overrides, ';'))
        if (!part.empty())
          made.overrides.push_back(part);
      if (!run.axis)
        study.runs.push_back(made);
      else if (run.entry.empty() || trimmed(run.values).empty())
        throw InputError(file.string() + ": '" + run.section + "' needs both 'Entry' and 'Values'.");
      else
        for (const std::string &value : split_trimmed(run.values, '|'))
          {
            StudyRun point = made;
            point.label = run.label + " " + value;
            point.settings = value;
            point.overrides.push_back(run.entry + "=" + value);
            study.runs.push_back(point);
          }
    }
  study.picture = picture;
  if (reference.empty() && !picture.empty())
    return study;
  if (reference.empty())
    throw InputError(file.string() + ": 'Reference' is missing; it names a run or a directory. (A study of results has 'Picture' instead.)" + suggestion("", labels));
  if (std::find(labels.begin(), labels.end(), reference) != labels.end())
    study.reference = reference;
  else if (std::error_code problem; std::filesystem::exists(base / reference / "probe.csv", problem))
    study.reference_directory = base / reference;
  else
    throw InputError(file.string() + ": 'Reference' = '" + reference + "' is neither a run of this study nor a directory with a probe.csv." +
                     suggestion(reference, labels));
  return study;
}
} // namespace turgor
