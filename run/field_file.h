// Point and cell fields over time for ParaView: DIR/NAME.xdmf over one HDF5 file a frame,
// DIR/NAME.frames/000012.h5. Used by particle scenes (vertices) and by the tissue mesh
// (quads, hexes).
//
// A file a frame, because HDF5 updates its index in place: killed in the middle of that, a
// single file would lose all earlier frames too. Each frame is written whole and renamed,
// then the XDMF is replaced; both are readable at any moment.
//
// Datasets of a frame: points (n x 3), cells (m x nodes_per_cell; 0, 1, ... for vertices), then one a
// field, named by the field's name without unit in letters, digits and _, with the full name in
// its attribute "name"; the root has the attribute "time" (s).
// In Python: app/plots/fields.py, frames(directory, name).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace turgor {
struct NamedField {
  std::string name;             ///< with unit, e.g. "pressure [Pa]"
  unsigned int components = 1;  ///< 1, 3 (vector) or 9 (tensor)
  std::vector<double> values;   ///< components * (points or cells)
  bool on_cells = false;
};

struct FieldFrame {
  double time = 0.;            ///< s
  std::vector<double> points;  ///< m, 3 per point
  std::vector<std::uint32_t>
      cells;  ///< node indices, nodes_per_cell each; empty: points are drawn as vertices
  unsigned int nodes_per_cell = 1;  ///< 1 vertex, 2 line, 3 triangle, 4 quad, 8 hex
  std::vector<NamedField> fields;
};

/// With append, frames are added to those that are there. A frame replaces every earlier one that is not
/// before it in time, so that a resumed run cuts what was written beyond its checkpoint by itself.
/// Throws std::runtime_error naming the file when it cannot be written, and for a non-finite value.
class FieldFile {
 public:
  FieldFile(const std::filesystem::path &directory, const std::string &name, bool append);
  ~FieldFile();
  void write(const FieldFrame &frame);
  std::size_t frames() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl;
};
}  // namespace turgor
