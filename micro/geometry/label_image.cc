#include "micro/geometry/label_image.h"

#include "run/number_text.h"
#include "run/run_context.h"

#include <png.h>

#include <cstdio>
#include <memory>
#include <string>
#include <utility>

namespace turgor {
namespace {
constexpr png_uint_32 largest_side = 20000;

/// Distance, in steps from pixel to pixel, of those that are not `from` to the nearest that is; -1 where
/// further than `reach`.
template <class From>
std::vector<int> steps_away(const LabelImage &image, const int reach, const From &from) {
  std::vector<int> distance(image.labels.size(), -1);
  std::vector<std::size_t> front, next;
  for (std::size_t i = 0; i < distance.size(); ++i)
    if (from(i)) {
      distance[i] = 0;
      front.push_back(i);
    }
  for (int d = 1; d <= reach && !front.empty(); ++d, front.swap(next), next.clear())
    for (const std::size_t i : front)
      for (const auto &[dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const int x = int(i % std::size_t(image.width)) + dx, y = int(i / std::size_t(image.width)) + dy;
        if (x < 0 || y < 0 || x >= image.width || y >= image.height) continue;
        const std::size_t j = std::size_t(y) * image.width + x;
        if (distance[j] < 0) {
          distance[j] = d;
          next.push_back(j);
        }
      }
  return distance;
}

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
  rows.too_large =
      rows.width > largest_side || rows.height > largest_side || rows.width < 3 || rows.height < 3;
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

LabelImage read_label_image(const std::filesystem::path &file) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE *)> open(std::fopen(file.c_str(), "rb"), &std::fclose);
  if (!open) throw InputError(file.string() + " cannot be opened.");
  Rows rows;
  if (!read_rows(open.get(), rows))
    throw InputError(file.string() + " cannot be read as a PNG picture" +
                     (rows.too_large
                          ? ": it has " + number_text(rows.width) + " x " + number_text(rows.height) +
                                " pixels, allowed are 3 to " + number_text(largest_side) + " each way."
                          : std::string(".")));
  LabelImage image{int(rows.width), int(rows.height), {}};
  image.labels.reserve(std::size_t(rows.width) * rows.height);
  for (png_uint_32 y = rows.height; y-- > 0;)  // the first row is the upper one
    for (png_uint_32 x = 0; x < rows.width; ++x) {
      std::uint32_t label = 0;
      for (int c = 0; c < rows.bytes_a_pixel; ++c)
        label = label * 256u + rows.at[y][std::size_t(x) * rows.bytes_a_pixel + c];
      image.labels.push_back(label);
    }
  return image;
}

void close_lines(LabelImage &image, const int width) {
  const int half = (width + 1) / 2;
  if (half < 1) return;
  const std::vector<int> from_cell =
      steps_away(image, half, [&](const std::size_t i) { return image.labels[i] != 0; });
  // What is further away than that, or at the border, is space, and so is what lies as near to it.
  const std::vector<int> from_space = steps_away(image, half, [&](const std::size_t i) {
    const int x = int(i % std::size_t(image.width)), y = int(i / std::size_t(image.width));
    return from_cell[i] < 0 ||
           (from_cell[i] > 0 && (x == 0 || y == 0 || x == image.width - 1 || y == image.height - 1));
  });
  for (int d = 1; d <= half; ++d) {
    const LabelImage before = image;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        if (const std::size_t i = std::size_t(y) * image.width + x; from_cell[i] == d && from_space[i] < 0)
          for (const auto &[dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
            if (const std::uint32_t label = before.around(x + dx, y + dy); label != 0) image.at(x, y) = label;
  }
}
}  // namespace turgor
