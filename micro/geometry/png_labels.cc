#include "micro/geometry/label_files.h"

#include "run/run_context.h"

#include <png.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace turgor {
namespace {
struct Rows {
  png_uint_32 width = 0, height = 0;
  int bytes_a_pixel = 0;
  bool too_large = false;
  std::vector<png_byte> bytes;
  std::vector<png_bytep> at;
};

void say_nothing(png_structp, png_const_charp) {}
[[noreturn]] void leave(png_structp png, png_const_charp) { png_longjmp(png, 1); }

/// The picture's numbers as they are: no gamma, palettes as their colours, no transparency. libpng leaves by
/// longjmp, so nothing with a destructor is begun here.
bool read_rows(std::FILE *file, Rows &rows) {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, &leave, &say_nothing);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  if (info == nullptr || setjmp(png_jmpbuf(png))) {
    png_destroy_read_struct(&png, &info, nullptr);
    return false;
  }
  png_init_io(png, file);
  png_read_info(png, info);
  rows.width = png_get_image_width(png, info);
  rows.height = png_get_image_height(png, info);
  rows.too_large = !allowed_size(rows.width, rows.height);
  if (rows.too_large) png_error(png, "size");
  if (png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE)
    png_set_palette_to_rgb(png);
  else if (png_get_color_type(png, info) & PNG_COLOR_MASK_COLOR)
    png_set_scale_16(png);
  png_set_packing(png);
  png_set_strip_alpha(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  rows.bytes_a_pixel = png_get_channels(png, info) * png_get_bit_depth(png, info) / 8;
  const std::size_t row = png_get_rowbytes(png, info);
  rows.bytes.resize(row * rows.height);
  for (png_uint_32 y = 0; y < rows.height; ++y) rows.at.push_back(rows.bytes.data() + row * y);
  png_read_image(png, rows.at.data());
  png_destroy_read_struct(&png, &info, nullptr);
  return true;
}
}  // namespace

LabelImage labels_of_png(const std::filesystem::path &file) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE *)> open(std::fopen(file.c_str(), "rb"), &std::fclose);
  if (!open) throw InputError(file.string() + " cannot be opened.");
  Rows rows;
  if (!read_rows(open.get(), rows)) {
    if (rows.too_large) throw wrong_size(file, rows.width, rows.height);
    throw InputError(file.string() + " cannot be read as a PNG or TIFF picture.");
  }
  LabelImage image{int(rows.width), int(rows.height), {}};
  image.labels.reserve(std::size_t(rows.width) * rows.height);
  for (png_uint_32 y = rows.height; y-- > 0;)  // the first row is the upper one
    for (png_uint_32 x = 0; x < rows.width; ++x)
      image.labels.push_back(number_of(rows.at[y] + std::size_t(x) * rows.bytes_a_pixel, rows.bytes_a_pixel));
  return image;
}
}  // namespace turgor
