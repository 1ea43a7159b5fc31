#include "run/field_output.h"

#include "run/manifest.h"
#include "run/run_context.h"
#include "run/stop_flag.h"

#include <cmath>
#include <exception>
#include <limits>

namespace turgor {
namespace {
const std::string suffix = "_at_failure";
}

std::size_t mark_not_finite(FieldFrame &frame, const FieldFrame &before) {
  const std::size_t points = frame.points.size() / 3;
  const bool has_place = before.points.size() == frame.points.size();
  std::vector<double> count(points, 0.);
  std::size_t replaced = 0;
  for (std::size_t k = 0; k < 3 * points; ++k)
    if (!std::isfinite(frame.points[k])) {
      frame.points[k] = has_place ? before.points[k] : 0.;
      count[k / 3] += 1.;
      ++replaced;
    }
  for (NamedField &field : frame.fields)
    for (std::size_t k = 0; k < field.values.size(); ++k)
      if (!std::isfinite(field.values[k])) {
        field.values[k] = 0.;
        ++replaced;
        const std::size_t item = k / field.components;
        if (!field.on_cells)
          count[item] += 1.;
        else if (frame.cells.empty())
          count.at(item) += 1.;
        else
          for (std::size_t node = item * frame.nodes_per_cell; node < (item + 1) * frame.nodes_per_cell;
               ++node)
            count[frame.cells.at(node)] += 1.;
      }
  frame.fields.push_back({"not finite [1]", 1, std::move(count), false});
  return replaced;
}

FieldOutput::FieldOutput(const RunContext &context_, std::string name_, const bool append,
                         std::function<FieldFrame()> frame_, std::function<FieldFrame()> failing_)
    : context(context_),
      directory(context_.directory()),
      name(std::move(name_)),
      frame(std::move(frame_)),
      failing(std::move(failing_)),
      exceptions(std::uncaught_exceptions()) {
  if (!context.is_writer()) return;
  // What an earlier part of the run failed of is no longer what there is to look at.
  std::error_code ignored;
  if (is_made(directory, name + suffix + ".xdmf")) {
    std::filesystem::remove(directory / (name + suffix + ".xdmf"), ignored);
    std::filesystem::remove_all(directory / (name + suffix + ".frames"), ignored);
  }
  file.emplace(directory, name, append);
}

FieldOutput::~FieldOutput() {
  if (!file || std::uncaught_exceptions() <= exceptions || stop_was_requested()) return;
  try {
    look_at_failure();
  } catch (const std::exception &)  // the failure itself is what the user is told of
  {
  }
}

void FieldOutput::write() {
  if (!file) return;
  const FieldFrame now = frame();
  for (const NamedField &field : now.fields) {
    const std::size_t unit = field.name.rfind(" [");
    const bool has_unit = unit != std::string::npos && field.name.ends_with(']');
    context.require_defined(name + ".xdmf", field.name.substr(0, unit),
                            has_unit ? field.name.substr(unit + 2, field.name.size() - unit - 3) : "");
  }
  file->write(now);
}

void FieldOutput::accept() {
  if (!file) return;
  accepted = {};  // not two of them at once
  accepted = frame();
}

void FieldOutput::look_at_failure() {
  FieldFrame last = failing ? failing() : frame();
  if (failing) accepted = frame();  // the scene keeps it
  FieldFile look(directory, name + suffix, false);
  if (!accepted.points.empty()) {
    mark_not_finite(accepted, {});
    look.write(accepted);
  }
  if (last.points.empty()) return;
  mark_not_finite(last, accepted);
  // A frame replaces those that are not before it.
  if (!accepted.points.empty() && !(last.time > accepted.time))
    last.time = std::nextafter(accepted.time, std::numeric_limits<double>::infinity());
  if (!std::isfinite(last.time)) last.time = 0.;
  look.write(last);
}
}  // namespace turgor
