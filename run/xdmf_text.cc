#include "run/xdmf_text.h"

#include "run/number_text.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace turgor {
namespace {
const std::string grid_start = "    <Grid Name=\"frame\" GridType=\"Uniform\">";
const std::string grid_end = "    </Grid>";
const std::string time_start = "      <Time Value=\"";

std::string escaped(const std::string &text) {
  std::string result;
  for (const char letter : text) switch (letter) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += letter;
    }
  return result;
}

const char *topology(const unsigned int nodes_per_cell) {
  switch (nodes_per_cell) {
    case 1:
      return "Polyvertex";
    case 2:
      return "Polyline";
    case 3:
      return "Triangle";
    case 4:
      return "Quadrilateral";
    case 8:
      return "Hexahedron";
    default:
      throw std::logic_error("A cell of a field file has 1, 2, 3, 4 or 8 nodes, not " +
                             number_text(nodes_per_cell) + ".");
  }
}

std::string item(const std::string &h5, const std::string &dataset, const std::string &dimensions,
                 const bool is_double) {
  return "<DataItem Dimensions=\"" + dimensions + "\" NumberType=\"" + (is_double ? "Float" : "UInt") +
         "\" Precision=\"" + (is_double ? "8" : "4") + "\" Format=\"HDF\">" + escaped(h5) + ":/" + dataset +
         "</DataItem>";
}
}  // namespace

XdmfGrid xdmf_grid(const FieldFrame &frame, const std::string &h5,
                   const std::vector<std::string> &dataset_names) {
  const std::size_t points = frame.points.size() / 3;
  const std::size_t cells = frame.cells.empty() ? points : frame.cells.size() / frame.nodes_per_cell;
  const unsigned int nodes = frame.cells.empty() ? 1 : frame.nodes_per_cell;
  char time[40];
  std::snprintf(time, sizeof(time), "%.17g", frame.time);
  std::ostringstream out;
  out << grid_start << "\n" << time_start << time << "\"/>\n";
  out << "      <Topology TopologyType=\"" << topology(nodes) << "\" NumberOfElements=\"" << cells << "\"";
  if (nodes <= 2)
    out << " NodesPerElement=\"" << nodes << "\"";  // without it ParaView's reader of XDMF 3 finds no element
  out << ">" << item(h5, "cells", number_text(cells) + " " + number_text(nodes), false) << "</Topology>\n";
  out << "      <Geometry GeometryType=\"XYZ\">" << item(h5, "points", number_text(points) + " 3", true)
      << "</Geometry>\n";
  for (std::size_t i = 0; i < frame.fields.size(); ++i) {
    const NamedField &field = frame.fields[i];
    const std::size_t count = field.values.size() / field.components;
    const char *type = field.components == 1 ? "Scalar" : field.components == 3 ? "Vector" : "Tensor";
    out << "      <Attribute Name=\"" << escaped(field.name) << "\" AttributeType=\"" << type
        << "\" Center=\"" << (field.on_cells ? "Cell" : "Node") << "\">"
        << item(h5, dataset_names[i],
                number_text(count) + (field.components == 1 ? "" : " " + number_text(field.components)), true)
        << "</Attribute>\n";
  }
  out << grid_end << "\n";
  return {frame.time, out.str()};
}

std::string xdmf_document(const std::vector<XdmfGrid> &grids) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n <Domain>\n"
      "  <Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (const XdmfGrid &grid : grids) text += grid.text;
  return text + "  </Grid>\n </Domain>\n</Xdmf>\n";
}

std::vector<XdmfGrid> parse_xdmf(const std::string &document) {
  std::vector<XdmfGrid> grids;
  bool inside = false;
  std::istringstream in(document);
  for (std::string line; std::getline(in, line);) {
    if (line == grid_start) {
      grids.emplace_back();
      inside = true;
    }
    if (!inside) continue;
    grids.back().text += line + "\n";
    if (line.compare(0, time_start.size(), time_start) == 0)
      grids.back().time = std::strtod(line.c_str() + time_start.size(), nullptr);
    inside = line != grid_end;
  }
  return grids;
}
}  // namespace turgor
