// Point and cell fields over time for ParaView: one XDMF file beside one HDF5 file.
// Used by particle scenes (vertices) and by the tissue mesh (quads, hexes).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace turgor
{
struct NamedField
{
  std::string name;           ///< with unit, e.g. "pressure [Pa]"
  unsigned int components = 1; ///< 1, 3 (vector) or 9 (tensor)
  std::vector<double> values; ///< components * (points or cells)
  bool on_cells = false;
};

struct FieldFrame
{
  double time = 0.;               ///< s
  std::vector<double> points;     ///< m, 3 per point
  std::vector<std::uint32_t> cells; ///< node indices, nodes_per_cell each; empty: points are drawn as vertices
  unsigned int nodes_per_cell = 1;  ///< 1 vertex, 2 line, 4 quad, 8 hex
  std::vector<NamedField> fields;
};

/// DIR/NAME.xdmf + DIR/NAME.h5, appended frame by frame; each frame leaves both files readable.
/// Throws std::runtime_error naming the file when it cannot be written, and for a non-finite value.
class FieldFile
{
public:
  FieldFile(const std::filesystem::path &directory, const std::string &name, bool append);
  ~FieldFile();
  void write(const FieldFrame &frame);
  std::size_t frames() const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl;
};
} // namespace turgor
