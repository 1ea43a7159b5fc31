// The field output of a scene: its regular frames, NAME.xdmf (field_file.h), and, where the run fails, a look
// at what failed: NAME_at_failure.xdmf with two frames, the last state that was in order and the one that was
// not. What is no finite number there is written as 0 (a position: where the point last was), and the field
// "not finite" counts how many of them a point had.
//
//   FieldOutput fields(context, "cells", resumed, [&] { return frame_of(particles, time); });
//   fields.write();   // a regular frame
//   fields.accept();  // the present state has been found in order
//
// The failure is seen by the destructor, which runs while the scene is left by an exception: declare it after
// all that `frame` uses. A wish to stop is no failure. On ranks that do not write nothing happens.
#pragma once

#include "run/field_file.h"

#include <functional>
#include <optional>

namespace turgor {
class RunContext;

class FieldOutput {
 public:
  /// frame: the present state. failing: the state that failed, where the scene keeps it apart; no points:
  /// there is none.
  FieldOutput(const RunContext &context, std::string name, bool append, std::function<FieldFrame()> frame,
              std::function<FieldFrame()> failing = {});
  ~FieldOutput();
  FieldOutput(const FieldOutput &) = delete;
  FieldOutput &operator=(const FieldOutput &) = delete;

  static constexpr const char *look_ending = "_at_failure.xdmf";

  void write();  ///< throws as FieldFile::write() and RunContext::require_defined()
  void accept();

 private:
  void look_at_failure();

  const RunContext &context;
  std::filesystem::path directory;
  std::string name;
  std::function<FieldFrame()> frame, failing;
  std::optional<FieldFile> file;  ///< empty on ranks that do not write
  FieldFrame accepted;            ///< without points: none yet
  int exceptions;                 ///< under way when it was made
};

/// The frame with finite numbers only, and the field "not finite" (per point) that tells where it had others;
/// positions are taken from `before` if it has the same points. Returns how many numbers were replaced.
std::size_t mark_not_finite(FieldFrame &frame, const FieldFrame &before);
}  // namespace turgor
