// The kinds of files in which label images come (label_image.h), each with a reader of its own: rows from
// below, one number a pixel. Numbers of several bytes, and the bytes of a colour, make one label, the first
// byte the highest.
//
//   const LabelImage image = labels_of_tiff("cells.tif");
#pragma once

#include "micro/geometry/label_image.h"
#include "run/run_context.h"

namespace turgor {
/// Grey of 1 to 16 bits, palette or colour. Throws InputError.
LabelImage labels_of_png(const std::filesystem::path &file);

/// One picture of whole numbers of 8, 16 or 32 bits a pixel, or colours of 8 bits; strips or tiles, of any
/// compression that libtiff knows, which is loaded here and nowhere else. Throws InputError.
LabelImage labels_of_tiff(const std::filesystem::path &file);

bool allowed_size(std::uint64_t width, std::uint64_t height);
InputError wrong_size(const std::filesystem::path &file, std::uint64_t width, std::uint64_t height);

/// A label from its bytes, the highest first.
inline std::uint32_t number_of(const unsigned char *bytes, const int count) {
  std::uint32_t label = 0;
  for (int c = 0; c < count; ++c) label = label * 256u + bytes[c];
  return label;
}
}  // namespace turgor
