#include "app/study_errors.h"

#include "micro/io/number_text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace turgor
{
namespace
{
/// Constant beyond the ends; times ascend.
double interpolated(const std::vector<double> &times, const std::vector<double> &values, const double time)
{
  const auto above = std::upper_bound(times.begin(), times.end(), time);
  if (above == times.begin())
    return values.front();
  if (above == times.end())
    return values.back();
  const auto i = static_cast<std::size_t>(above - times.begin());
  const double part = (time - times[i - 1]) / (times[i] - times[i - 1]);
  return values[i - 1] + part * (values[i] - values[i - 1]);
}

double relative(const double difference, const double size, const std::filesystem::path &file)
{
  if (!(size > 0.))
    throw std::runtime_error("The reference " + file.string() + " is zero throughout; no relative error exists.");
  return std::sqrt(difference / size);
}
} // namespace

double history_error(const CsvTable &run, const CsvTable &reference)
{
  const auto &times = reference.column("time");
  const auto &run_times = run.column("time");
  if (times.size() < 2 || run_times.empty())
    throw std::runtime_error((times.size() < 2 ? reference : run).file.string() + " has too few rows.");
  const double span = times.back() - times.front();
  if (run_times.back() < times.back() - 0.01 * span || run_times.front() > times.front() + 0.01 * span)
    throw std::runtime_error(run.file.string() + " covers " + number_text(run_times.front()) + " to " +
                             number_text(run_times.back()) + " s, the reference " + number_text(times.front()) +
                             " to " + number_text(times.back()) + " s.");
  std::vector<double> difference(times.size(), 0.), size(times.size(), 0.);
  for (const char *name : {"displacement_x", "displacement_y"})
    for (std::size_t i = 0; i < times.size(); ++i)
      {
        const double expected = reference.column(name)[i];
        const double gap = interpolated(run_times, run.column(name), times[i]) - expected;
        difference[i] += gap * gap;
        size[i] += expected * expected;
      }
  double integral = 0., norm = 0.;
  for (std::size_t i = 1; i < times.size(); ++i)
    {
      integral += 0.5 * (times[i] - times[i - 1]) * (difference[i] + difference[i - 1]);
      norm += 0.5 * (times[i] - times[i - 1]) * (size[i] + size[i - 1]);
    }
  return relative(integral, norm, reference.file);
}

double field_error(const CsvTable &run, const CsvTable &reference)
{
  std::map<std::pair<long, long>, std::size_t> rows;
  for (std::size_t row = 0; row < run.rows(); ++row)
    rows[{std::lround(run.column("cell_x")[row]), std::lround(run.column("cell_y")[row])}] = row;
  double difference = 0., norm = 0.;
  for (std::size_t row = 0; row < reference.rows(); ++row)
    {
      const std::pair<long, long> cell = {std::lround(reference.column("cell_x")[row]),
                                          std::lround(reference.column("cell_y")[row])};
      const auto there = rows.find(cell);
      if (there == rows.end())
        throw std::runtime_error(run.file.string() + " lacks cell (" + number_text(cell.first) + ", " +
                                 number_text(cell.second) + ") of the reference.");
      for (const char *name : {"displacement_x", "displacement_y"})
        {
          const double expected = reference.column(name)[row];
          const double gap = run.column(name)[there->second] - expected;
          difference += gap * gap;
          norm += expected * expected;
        }
    }
  return relative(difference, norm, reference.file);
}
} // namespace turgor
