// Label images: made from tilings and traced back, as files, and what is wrong with them.
#include "micro/cells/tissue_structure.h"
#include "micro/geometry/regular_tilings.h"
#include "micro/geometry/tiling_measures.h"
#include "micro/geometry/traced_cells.h"
#include "run/run_context.h"
#include "tests/temporary_directory.h"

#include <boost/test/unit_test.hpp>

#include <png.h>

#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>

using namespace turgor;

namespace {
bool inside(const std::vector<Vector<2>> &outline, const Vector<2> &x) {
  bool in = false;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vector<2> &a = outline[k], &b = outline[(k + 1) % outline.size()];
    if ((a[1] > x[1]) != (b[1] > x[1]) && x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
      in = !in;
  }
  return in;
}

/// Cells of a bounded piece, `size` pixels to a unit of length, in a frame of 3 pixels; label = number
/// from 1.
LabelImage picture_of(const std::vector<std::vector<Vector<2>>> &cells, const double size) {
  Vector<2> low = cells[0][0], high = low;
  for (const auto &cell : cells)
    for (const Vector<2> &x : cell) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
  LabelImage image{
      int(std::ceil((high[0] - low[0]) * size)) + 6, int(std::ceil((high[1] - low[1]) * size)) + 6, {}};
  image.labels.assign(std::size_t(image.width) * image.height, 0);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < cells.size(); ++c)
        if (inside(cells[c], low + Vector<2>(x - 2.5, y - 2.5) / size)) image.at(x, y) = std::uint32_t(c + 1);
  return image;
}

std::vector<std::vector<Vector<2>>> outlines(const Tiling &t) {
  std::vector<std::vector<Vector<2>>> all;
  for (std::size_t c = 0; c < t.cells.size(); ++c) all.push_back(t.outline(c));
  return all;
}

/// Labels 1 of row 0 below.
LabelImage drawn(const std::vector<std::string> &rows) {
  LabelImage image{int(rows[0].size()), int(rows.size()), {}};
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    for (const char c : *row) image.labels.push_back(c == '.' ? 0 : std::uint32_t(c - '0'));
  return image;
}

auto says(const std::string &words) {
  return [words](const std::exception &e) { return std::string(e.what()).find(words) != std::string::npos; };
}
}  // namespace

BOOST_AUTO_TEST_SUITE(traced_cells)

BOOST_AUTO_TEST_CASE(pixels_by_hand) {
  const Tiling piece = trace_cells(drawn({"......", ".1122.", ".1122.", ".3322.", "......"}), 2e-6, 0.1);
  const TilingMeasures measured(piece);  // cells 3, 2, 1
  const auto near = boost::test_tools::tolerance(1e-12);
  BOOST_TEST(measured.areas == (std::vector<double>{2 * 4e-12, 6 * 4e-12, 4 * 4e-12}),
             near << boost::test_tools::per_element());
  BOOST_TEST(measured.aspects == (std::vector<double>{2., 1.5, 1.}),
             near << boost::test_tools::per_element());
  BOOST_TEST(measured.contacts == (std::vector<double>{2., 2., 2.}), boost::test_tools::per_element());
  BOOST_TEST(measured.void_fraction == 0.);
}

BOOST_AUTO_TEST_CASE(a_honeycomb_is_found_again) {
  const Tiling honeycomb = replicated(hexagon_tiling(1.), 5, 4);
  const double size = 40.;
  const Tiling piece = trace_cells(picture_of(outlines(honeycomb), size), 1. / size);
  const TilingMeasures measured(piece), whole(honeycomb);
  BOOST_TEST(piece.cells.size() == 20u);
  BOOST_TEST(measured.mean_area() == 1., boost::test_tools::tolerance(0.005));
  BOOST_TEST(measured.area_scatter() < 0.02);
  BOOST_TEST(measured.void_fraction < 0.001);
  BOOST_TEST(
      (whole.mean_contacts() == 6. && std::abs(whole.void_fraction) < 1e-12 && whole.area_scatter() < 1e-12));
  std::size_t inner = 0;
  for (std::size_t c = 0; c < 20; ++c) {
    BOOST_TEST(measured.aspects[c] == 1., boost::test_tools::tolerance(0.05));
    BOOST_TEST(whole.aspects[c] == 1., boost::test_tools::tolerance(1e-9));
    inner += measured.contacts[c] == 6.;
  }
  BOOST_TEST(inner == 6u);  // 3 of each of the two rows within
}

BOOST_AUTO_TEST_CASE(lines_between_cells_close_and_spaces_stay) {
  LabelImage image = drawn({"...............", "...............", "...111.22222...", "...111.22222...",
                            "...111.22222...", ".......22222...", "...333.22222...", "...333.22222...",
                            "...333.22222...", "...............", "..............."});
  BOOST_TEST(TilingMeasures(trace_cells(image, 1.)).mean_contacts() == 0.);
  close_lines(image, 2);
  BOOST_TEST(TilingMeasures(trace_cells(image, 1.)).contacts == (std::vector<double>{2., 2., 2.}),
             boost::test_tools::per_element());
  LabelImage space =
      drawn({"............", ".1111112222.", ".1111112222.", ".11......22.", ".11......22.", ".11......22.",
             ".11......22.", ".11......22.", ".11......22.", ".3333332222.", ".3333332222.", "............"});
  close_lines(space, 2);
  const TilingMeasures measured(trace_cells(space, 1., 0.1));
  BOOST_TEST(
      measured.void_fraction == 0.32,
      boost::test_tools::tolerance(1e-12));  // 6 x 6 pixels of 10 x 10, but for the corners, which are narrow
  BOOST_TEST(measured.contacts == (std::vector<double>{2., 2., 2.}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(wrong_images_get_a_sentence) {
  const auto refused = [](const std::vector<std::string> &rows, const std::string &words) {
    BOOST_CHECK_EXCEPTION(trace_cells(drawn(rows), 1.), std::invalid_argument, says(words));
  };
  refused({".....", ".1.1.", "....."}, "label 1 (3, 1) lies in two pieces");
  refused({"....", ".11.", "..1."}, "label 1 touches the border");
  refused({".....", ".222.", ".212.", ".222.", "....."}, "label 2 has a hole or another cell in it");
  refused({".....", ".222.", ".2.2.", ".222.", "....."}, "label 2 has a hole");
  refused({"...", "...", "..."}, "no cells");
  // all that is wrong at once
  const std::vector<std::string> bad = {".......", "2.....1", "..444..", "..4.4.1",
                                        "..444..", ".3...3.", "......."};
  refused(
      bad,
      "The cells with the labels 3 (5, 1), 1 (6, 5) lie in two pieces or more (one of them at the pixel in "
      "brackets, from the lower left). The cells with the labels 1, 2 touch the border of the image, so that "
      "their outlines are not known: leave such cells out (label 0). The cell with the label 4 has a hole or "
      "another cell in it.");
  // ten are named, the others counted
  LabelImage many{60, 1, {}};
  for (std::uint32_t x = 0; x < 60; ++x) many.labels.push_back(x % 2 ? 0 : 1 + x / 2);
  BOOST_CHECK_EXCEPTION(trace_cells(many, 1.), std::invalid_argument,
                        says("labels 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 and 20 more touch the border"));
}

BOOST_AUTO_TEST_CASE(files_are_read_as_they_are) {
  const test::TemporaryDirectory directory;
  const auto write = [&](const std::string &name, const png_uint_32 format,
                         const std::vector<std::uint8_t> &bytes) {
    png_image png = {};
    png.version = PNG_IMAGE_VERSION;
    png.width = 3;
    png.height = 3;
    png.format = format;
    const std::string file = (directory.path / name).string();
    BOOST_REQUIRE(png_image_write_to_file(&png, file.c_str(), 0, bytes.data(), 0, nullptr));
    return file;
  };
  const std::string grey = write("grey.png", PNG_FORMAT_GRAY, {1, 2, 3, 4, 5, 6, 7, 8, 200});
  const LabelImage image = read_label_image(grey);
  BOOST_TEST(image.labels == (std::vector<std::uint32_t>{7, 8, 200, 4, 5, 6, 1, 2, 3}),
             boost::test_tools::per_element());
  std::vector<std::uint8_t> colours(27, 0);
  colours[0] = 1;
  colours[26] = 9;
  const LabelImage colour = read_label_image(write("colour.png", PNG_FORMAT_RGB, colours));
  BOOST_TEST((colour.at(0, 2) == 65536u && colour.at(2, 0) == 9u && colour.at(1, 1) == 0u));
  BOOST_CHECK_EXCEPTION(read_label_image(directory.path / "none.png"), InputError, says("cannot be opened"));
  std::ofstream(directory.path / "text.png") << "no picture";
  BOOST_CHECK_EXCEPTION(read_label_image(directory.path / "text.png"), InputError,
                        says("cannot be read as a PNG or TIFF"));
}

BOOST_AUTO_TEST_CASE(cells_smaller_than_their_walls_are_refused_when_checked) {
  const test::TemporaryDirectory directory;
  std::vector<std::uint8_t> bytes(25, 0);  // four cells of a pixel
  for (const int k : {6, 7, 11, 12}) bytes[k] = std::uint8_t(k);
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  png.width = png.height = 5;
  png.format = PNG_FORMAT_GRAY;
  TissueStructure tissue;
  tissue.file = (directory.path / "small.png").string();
  BOOST_REQUIRE(png_image_write_to_file(&png, tissue.file.c_str(), 0, bytes.data(), 0, nullptr));
  tissue.kind = StructureKind::image;
  tissue.line_width = 0;
  tissue.pixel = 1e-6;
  BOOST_CHECK_EXCEPTION(
      tissue.check_file(1e-6), InputError,
      says("pixels, but walls (Cell/Wall thickness = 1e-06 m) "
           "have to be thinner than half of that. Give Structure/Pixel size (now 1e-06 m)"));
  tissue.pixel = 1e-5;  // what it says
  BOOST_CHECK_NO_THROW(tissue.check_file(1e-6));
}

BOOST_AUTO_TEST_SUITE_END()
