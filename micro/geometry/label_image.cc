#include "micro/geometry/label_image.h"

#include "micro/geometry/label_files.h"
#include "run/number_text.h"

#include <array>
#include <fstream>
#include <utility>

namespace turgor {
namespace {
constexpr unsigned int largest_side = 20000;

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

/// Whether the file begins as TIFF files do, of either order of bytes, small or big.
bool is_tiff(const std::filesystem::path &file) {
  std::array<char, 4> first{};
  std::ifstream(file, std::ios::binary).read(first.data(), first.size());
  const bool little = first[0] == 'I' && first[1] == 'I' && first[3] == 0,
             big = first[0] == 'M' && first[1] == 'M' && first[2] == 0;
  return (little && (first[2] == 42 || first[2] == 43)) || (big && (first[3] == 42 || first[3] == 43));
}
}  // namespace

bool allowed_size(const std::uint64_t width, const std::uint64_t height) {
  return width >= 3 && height >= 3 && width <= largest_side && height <= largest_side;
}

InputError wrong_size(const std::filesystem::path &file, const std::uint64_t width,
                      const std::uint64_t height) {
  return InputError(file.string() + " cannot be read: it has " + number_text(width) + " x " +
                    number_text(height) + " pixels, allowed are 3 to " + number_text(largest_side) +
                    " each way.");
}

LabelImage read_label_image(const std::filesystem::path &file) {
  return is_tiff(file) ? labels_of_tiff(file) : labels_of_png(file);
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
