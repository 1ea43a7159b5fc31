#include "run/field_file.h"

#include "run/atomic_file.h"
#include "run/hdf5_file.h"
#include "run/manifest.h"
#include "run/number_text.h"
#include "run/output_failed.h"
#include "run/run_context.h"
#include "run/xdmf_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace turgor {
namespace {
std::string frame_name(const std::size_t index) {
  char name[32];
  std::snprintf(name, sizeof(name), "%06zu.h5", index);
  return name;
}

/// "velocity [m/s]" -> "velocity"; HDF5 takes a / for a group.
std::string dataset_name(const std::string &title, const std::vector<std::string> &taken) {
  std::string name = title.substr(0, title.find(" ["));
  for (char &letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
  if (name.empty()) name = "field";
  const auto is_taken = [&](const std::string &candidate) {
    return candidate == "points" || candidate == "cells" ||
           std::find(taken.begin(), taken.end(), candidate) != taken.end();
  };
  std::string unique = name;
  for (unsigned int number = 2; is_taken(unique); ++number) unique = name + "_" + number_text(number);
  return unique;
}

void check(const FieldFrame &frame, const std::string &file) {
  const auto refuse = [&](const std::string &what) { throw std::logic_error(file + ": " + what); };
  const std::size_t points = frame.points.size() / 3;
  if (frame.points.size() % 3 != 0) refuse("points need three coordinates each.");
  if (frame.nodes_per_cell == 0 || frame.cells.size() % frame.nodes_per_cell != 0)
    refuse("the cells' indices are not a multiple of the nodes per cell.");
  if (std::any_of(frame.cells.begin(), frame.cells.end(),
                  [&](const std::uint32_t node) { return node >= points; }))
    refuse("a cell names a point that is not there.");
  const std::size_t cells = frame.cells.empty() ? points : frame.cells.size() / frame.nodes_per_cell;
  const auto is_bad = [](const double value) { return !std::isfinite(value); };
  const auto refuse_value = [&](const std::string &name, const std::size_t index) {
    throw RunFailed(file + ": '" + name + "' is not a finite number at " + number_text(index) +
                    ", t = " + number_text(frame.time) + " s; the run has diverged.");
  };
  if (is_bad(frame.time)) throw RunFailed(file + ": the time of a frame is not a finite number.");
  if (const auto bad = std::find_if(frame.points.begin(), frame.points.end(), is_bad);
      bad != frame.points.end())
    refuse_value("position", static_cast<std::size_t>(bad - frame.points.begin()) / 3);
  for (const NamedField &field : frame.fields) {
    if (field.components != 1 && field.components != 3 && field.components != 9)
      refuse("'" + field.name + "' needs 1, 3 or 9 components.");
    if (field.values.size() != field.components * (field.on_cells ? cells : points))
      refuse("'" + field.name + "' has " + number_text(field.values.size()) + " values for " +
             number_text(field.on_cells ? cells : points) + (field.on_cells ? " cells." : " points."));
    if (const auto bad = std::find_if(field.values.begin(), field.values.end(), is_bad);
        bad != field.values.end())
      refuse_value(field.name, static_cast<std::size_t>(bad - field.values.begin()) / field.components);
  }
}
}  // namespace

struct FieldFile::Impl {
  std::filesystem::path directory, folder, xdmf;
  std::string name;
  std::vector<XdmfGrid> grids;

  void remove_frames_from(const std::size_t first) const {
    std::error_code problem;
    for (std::size_t index = first; is_made(directory, name + ".frames/" + frame_name(index)) &&
                                    std::filesystem::remove(folder / frame_name(index), problem);
         ++index) {
    }
    if (problem)
      throw OutputFailed("cannot remove old frames in " + folder.string() + ": " + problem.message() + ".");
  }
};

FieldFile::FieldFile(const std::filesystem::path &directory, const std::string &name, const bool append)
    : impl(std::make_unique<Impl>()) {
  impl->directory = directory;
  impl->name = name;
  impl->folder = directory / (name + ".frames");
  impl->xdmf = directory / (name + ".xdmf");
  claim(directory, name + ".frames");
  claim(directory, name + ".xdmf");
  std::error_code problem;
  std::filesystem::create_directories(impl->folder, problem);
  if (problem) throw OutputFailed("cannot make " + impl->folder.string() + ": " + problem.message() + ".");
  if (append && std::filesystem::exists(impl->xdmf)) impl->grids = parse_xdmf(read_whole(impl->xdmf));
  const std::size_t count = impl->grids.size();
  for (std::size_t index = 0; append && (index < count || index == 0); ++index)
    if (std::filesystem::exists(impl->folder / frame_name(index)) != (index < count))
      throw InputError(
          (index < count ? impl->folder / frame_name(index) : impl->xdmf).string() +
          " is gone; the checkpoint continues it. Put it back, or run without --resume to start again.");
  // Killed between a frame and its entry in the XDMF: the frame was never announced.
  impl->remove_frames_from(impl->grids.size());
}

FieldFile::~FieldFile() = default;

std::size_t FieldFile::frames() const { return impl->grids.size(); }

void FieldFile::write(const FieldFrame &frame) {
  check(frame, impl->xdmf.string());
  auto &grids = impl->grids;
  const std::size_t before = grids.size();
  while (!grids.empty() && grids.back().time >= frame.time) grids.pop_back();
  if (grids.size() < before) {
    // The XDMF first: it must never name a frame that is gone.
    write_atomically(impl->xdmf, xdmf_document(grids));
    impl->remove_frames_from(grids.size());
  }
  const std::string relative = impl->name + ".frames/" + frame_name(grids.size());
  const std::filesystem::path path = impl->directory / relative, temporary = temporary_of(path);
  claim(impl->directory, relative);
  std::vector<std::string> names;
  {
    Hdf5Writer h5(temporary);
    h5.root_attribute("time", frame.time);
    h5.dataset("points", frame.points, 3, "position [m]");
    if (!frame.cells.empty())
      h5.dataset("cells", frame.cells, frame.nodes_per_cell, "node indices");
    else {
      std::vector<std::uint32_t> vertices(frame.points.size() / 3);
      std::iota(vertices.begin(), vertices.end(), 0u);
      h5.dataset("cells", vertices, 1, "node indices");
    }
    for (const NamedField &field : frame.fields) {
      names.push_back(dataset_name(field.name, names));
      h5.dataset(names.back(), field.values, field.components, field.name);
    }
    h5.close();
  }
  std::error_code problem;
  std::filesystem::rename(temporary, path, problem);
  if (problem) throw OutputFailed("cannot write " + path.string() + ": " + problem.message() + ".");
  grids.push_back(xdmf_grid(frame, relative, names));
  write_atomically(impl->xdmf, xdmf_document(grids));
}
}  // namespace turgor
