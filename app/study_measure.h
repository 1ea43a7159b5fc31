// What a study measures in a run, and how far it is from the reference.
//
//   u(x)   columns of a table of the run over its abscissa x, a vector where there are several; a result is
//          one number
//   rms    value sqrt(int |u|^2 dx / int dx),  error sqrt(int |u - u_ref|^2 dx / int |u_ref|^2 dx)
//   max    largest |u|,                        error largest |u - u_ref| over largest |u_ref|
//   end    u in the last row (|u| of several), error |u - u_ref| over |u_ref|
//   mean, largest, amplitude, period, result   value f(u), error f(u)/f(u_ref) - 1, with its sign
// With a size S the differences are over S instead (rms: of the root of the mean). Integrals are of the line
// through the samples; the run is interpolated linearly to the reference's abscissae, or both are averaged
// over equal parts. Matched rows are summed: sqrt(sum |u - u_ref|^2 / sum |u_ref|^2). A reference's columns
// are brought into the units of the run's (units.h) or refused.
#pragma once

#include "app/study_input.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace turgor {
struct MeasuredRun {
  double value = 0.;
  std::string unit;
  std::optional<double> error;  ///< nothing without a reference
};

/// Results of summary.json of a finished run: (value, unit) by name.
std::map<std::string, std::pair<double, std::string>> results_of(const std::filesystem::path &run);

/// What is measured in a run: without errors where it answers another question than the references.
StudyMeasure asked_of(const StudyRun &run, StudyMeasure measure);

/// Of the finished run in a directory; reference_run: directory of the run that the measure's reference
/// names, if it names one. Throws std::runtime_error saying which table, column or row is missing, or why no
/// error exists.
MeasuredRun measure(const StudyMeasure &measure, const std::filesystem::path &run,
                    const std::filesystem::path &reference_run);
}  // namespace turgor
