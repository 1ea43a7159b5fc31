// A segmented picture of a tissue: one number a pixel, 0 where there is no cell (air, or the line between
// cells), one label a cell.
//
//   const LabelImage image = read_label_image("cells.png");
//     // PNG or TIFF (label_files.h): grey, palette or colour; a colour is a label
//
// Rows from below: (0, 0) is the lower left pixel. Throws InputError where the file is no such picture.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace turgor {
struct LabelImage {
  int width = 0, height = 0;
  std::vector<std::uint32_t> labels;  ///< row by row

  std::uint32_t at(const int x, const int y) const { return labels[std::size_t(y) * width + x]; }
  std::uint32_t &at(const int x, const int y) { return labels[std::size_t(y) * width + x]; }
  /// 0 outside.
  std::uint32_t around(const int x, const int y) const {
    return x < 0 || y < 0 || x >= width || y >= height ? 0 : at(x, y);
  }
};

LabelImage read_label_image(const std::filesystem::path &file);

/// Lines without a label, at most `width` pixels wide, go to the cells beside them; wider spaces stay as they
/// are.
void close_lines(LabelImage &image, int width);
}  // namespace turgor
