// The XDMF text over a sequence of HDF5 frames, and back: the list of frames is kept in the
// text itself, one <Grid> a frame, so that a resumed run continues from the file alone.
#pragma once

#include "run/field_file.h"

#include <string>
#include <vector>

namespace turgor {
struct XdmfGrid {
  double time = 0.;  ///< s
  std::string text;  ///< the <Grid> element, whole lines
};

/// h5 is the path of the frame's HDF5 file relative to the XDMF; dataset_names are those of frame.fields.
XdmfGrid xdmf_grid(const FieldFrame &frame, const std::string &h5,
                   const std::vector<std::string> &dataset_names);

std::string xdmf_document(const std::vector<XdmfGrid> &grids);

/// The grids of a text made by xdmf_document().
std::vector<XdmfGrid> parse_xdmf(const std::string &document);
}  // namespace turgor
