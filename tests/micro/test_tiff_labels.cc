// Label images from TIFF files, as microscopes and their programs write them.
#include "micro/geometry/label_image.h"
#include "run/run_context.h"
#include "tests/temporary_directory.h"

#include <boost/test/unit_test.hpp>

#include <tiffio.h>

#include <cstdint>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace turgor {
namespace {
std::function<bool(const std::exception &)> says(const std::string &words) {
  return [words](const std::exception &e) {
    BOOST_TEST_MESSAGE(e.what());
    return std::string(e.what()).find(words) != std::string::npos;
  };
}

struct Kind {
  std::uint16_t compression = COMPRESSION_NONE, photometric = PHOTOMETRIC_MINISBLACK, samples = 1,
                format = SAMPLEFORMAT_UINT, orientation = ORIENTATION_TOPLEFT;
  std::uint32_t tile = 0;  ///< side; 0: strips
};

/// width x height pixels of one type, the upper row first; pages: the same picture so many times.
template <class Number>
std::string write(const std::filesystem::path &file, const std::uint32_t width, const std::uint32_t height,
                  std::vector<Number> numbers, const Kind &kind = {}, const int pages = 1) {
  const std::unique_ptr<TIFF, void (*)(TIFF *)> tiff(TIFFOpen(file.c_str(), "w"), &TIFFClose);
  BOOST_REQUIRE(tiff != nullptr);
  for (int page = 0; page < pages; ++page) {
    TIFF *t = tiff.get();
    TIFFSetField(t, TIFFTAG_IMAGEWIDTH, width);
    TIFFSetField(t, TIFFTAG_IMAGELENGTH, height);
    TIFFSetField(t, TIFFTAG_BITSPERSAMPLE, int(8 * sizeof(Number)));
    TIFFSetField(t, TIFFTAG_SAMPLESPERPIXEL, int(kind.samples));
    TIFFSetField(t, TIFFTAG_SAMPLEFORMAT, int(kind.format));
    TIFFSetField(t, TIFFTAG_PHOTOMETRIC, int(kind.photometric));
    TIFFSetField(t, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(t, TIFFTAG_COMPRESSION, int(kind.compression));
    TIFFSetField(t, TIFFTAG_ORIENTATION, int(kind.orientation));
    const std::size_t row = std::size_t(width) * kind.samples;
    if (kind.tile == 0) {
      TIFFSetField(t, TIFFTAG_ROWSPERSTRIP, 2);
      for (std::uint32_t y = 0; y < height; ++y)
        BOOST_REQUIRE(TIFFWriteScanline(t, numbers.data() + y * row, y, 0) == 1);
    } else {
      TIFFSetField(t, TIFFTAG_TILEWIDTH, kind.tile);
      TIFFSetField(t, TIFFTAG_TILELENGTH, kind.tile);
      for (std::uint32_t top = 0; top < height; top += kind.tile)
        for (std::uint32_t left = 0; left < width; left += kind.tile) {
          std::vector<Number> tile(std::size_t(kind.tile) * kind.tile, Number(77));
          for (std::uint32_t y = top; y < std::min(height, top + kind.tile); ++y)
            for (std::uint32_t x = left; x < std::min(width, left + kind.tile); ++x)
              tile[(y - top) * kind.tile + (x - left)] = numbers[y * row + x];
          BOOST_REQUIRE(TIFFWriteTile(t, tile.data(), left, top, 0, 0) >= 0);
        }
    }
    BOOST_REQUIRE(TIFFWriteDirectory(t) == 1);
  }
  return file.string();
}

/// Labels beyond 8 bits, by x and y counted from the upper left.
std::vector<std::uint32_t> pattern(const std::uint32_t width, const std::uint32_t height) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) numbers.push_back(1000 * y + x);
  return numbers;
}

void check(const std::string &file, const std::uint32_t width, const std::uint32_t height) {
  const LabelImage image = read_label_image(file);
  BOOST_REQUIRE(image.width == int(width));
  BOOST_REQUIRE(image.height == int(height));
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x)
      BOOST_REQUIRE(image.at(int(x), int(height - 1 - y)) == 1000 * y + x);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(tiff_labels)

BOOST_AUTO_TEST_CASE(strips_and_tiles_of_any_compression) {
  const test::TemporaryDirectory directory;
  const std::vector<std::uint32_t> wide = pattern(37, 21);
  const std::vector<std::uint16_t> narrow(wide.begin(), wide.end());
  for (const std::uint16_t compression :
       {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS}) {
    const std::string name = std::to_string(compression);
    for (const std::uint32_t tile : {0u, 16u}) {
      const Kind kind{.compression = compression, .tile = tile};
      check(write(directory.path / ("a" + name + ".tif"), 37, 21, narrow, kind), 37, 21);
      check(write(directory.path / ("b" + name + ".tif"), 37, 21, wide, kind), 37, 21);
    }
  }
  // the first bytes decide, not the name
  check(write(directory.path / "cells.png", 37, 21, narrow), 37, 21);
}

BOOST_AUTO_TEST_CASE(colours_and_bytes) {
  const test::TemporaryDirectory directory;
  std::vector<std::uint8_t> colours(27, 0);
  colours[0] = 1;
  colours[26] = 9;
  const LabelImage colour = read_label_image(
      write(directory.path / "c.tif", 3, 3, colours, {.photometric = PHOTOMETRIC_RGB, .samples = 3}));
  BOOST_TEST((colour.at(0, 2) == 65536u && colour.at(2, 0) == 9u && colour.at(1, 1) == 0u));
  const LabelImage grey = read_label_image(
      write(directory.path / "g.tif", 3, 3, std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 8, 200}));
  BOOST_TEST(grey.labels == (std::vector<std::uint32_t>{7, 8, 200, 4, 5, 6, 1, 2, 3}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(other_files_get_a_sentence) {
  const test::TemporaryDirectory directory;
  const auto refused = [](const std::string &file, const std::string &words) {
    BOOST_CHECK_EXCEPTION(read_label_image(file), InputError, says(words));
  };
  const std::vector<float> reals(9, 1.f);
  refused(write(directory.path / "f.tif", 3, 3, reals, {.format = SAMPLEFORMAT_IEEEFP}),
          "its pixels are no whole numbers: save labels as whole numbers of 8, 16 or 32 bits");
  const std::vector<std::uint8_t> bytes(9, 1);
  refused(write(directory.path / "p.tif", 3, 3, bytes, {}, 2), "it holds 2 pictures; save one by itself");
  refused(write(directory.path / "o.tif", 3, 3, bytes, {.orientation = ORIENTATION_BOTLEFT}),
          "save it upright");
  refused(write(directory.path / "s.tif", 2, 2, bytes), "it has 2 x 2 pixels, allowed are 3 to 20000");
  refused(write(directory.path / "d.tif", 3, 3, std::vector<double>(9, 1.), {.format = SAMPLEFORMAT_UINT}),
          "samples of 64 bits");
  const std::string cut = write(directory.path / "cut.tif", 37, 21, pattern(37, 21));
  std::filesystem::resize_file(cut, 300);
  refused(cut, "the file is damaged");
  std::ofstream(directory.path / "x.tif", std::ios::binary).write("II*\0abcdefgh", 12);
  refused((directory.path / "x.tif").string(), "the file is damaged");
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace turgor
