#include "micro/geometry/label_files.h"
#include "run/number_text.h"

#include <dlfcn.h>
#include <tiffio.h>

#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace turgor {
namespace {
/// libtiff brings nine libraries with it: they are loaded when a TIFF is read, and no other run pays for
/// them.
class Libtiff {
 public:
  Libtiff() : library(::dlopen("libtiff.so.6", RTLD_LAZY | RTLD_LOCAL)) {
    if (library == nullptr)
      throw InputError(
          "TIFF pictures need libtiff.so.6, which cannot be loaded: install Debian's libtiff6, or save the "
          "picture as PNG.");
    find("TIFFOpen", open);
    find("TIFFClose", close);
    find("TIFFGetFieldDefaulted", get_or_default);
    find("TIFFGetField", get);
    find("TIFFNumberOfDirectories", pictures);
    find("TIFFScanlineSize", row_size);
    find("TIFFReadScanline", read_row);
    find("TIFFIsTiled", is_tiled);
    find("TIFFTileSize", tile_size);
    find("TIFFReadTile", read_tile);
    find("TIFFSetErrorHandler", on_error);
    find("TIFFSetWarningHandler", on_warning);
    on_error(nullptr);  // what is wrong is said in a sentence of ours
    on_warning(nullptr);
  }

  decltype(&::TIFFOpen) open = nullptr;
  decltype(&::TIFFClose) close = nullptr;
  decltype(&::TIFFGetFieldDefaulted) get_or_default = nullptr;
  decltype(&::TIFFGetField) get = nullptr;
  decltype(&::TIFFNumberOfDirectories) pictures = nullptr;
  decltype(&::TIFFScanlineSize) row_size = nullptr;
  decltype(&::TIFFReadScanline) read_row = nullptr;
  decltype(&::TIFFIsTiled) is_tiled = nullptr;
  decltype(&::TIFFTileSize) tile_size = nullptr;
  decltype(&::TIFFReadTile) read_tile = nullptr;
  decltype(&::TIFFSetErrorHandler) on_error = nullptr;
  decltype(&::TIFFSetWarningHandler) on_warning = nullptr;

 private:
  template <class Function>
  void find(const char *name, Function &function) {
    function = reinterpret_cast<Function>(::dlsym(library, name));
    if (function == nullptr) throw InputError(std::string("libtiff.so.6 has no ") + name + ".");
  }
  void *library;
};

struct Format {
  std::uint32_t width = 0, height = 0;
  std::uint16_t bits = 1, samples = 1, sample_format = SAMPLEFORMAT_UINT, planar = PLANARCONFIG_CONTIG,
                orientation = ORIENTATION_TOPLEFT, photometric = PHOTOMETRIC_MINISBLACK;

  bool colour() const { return photometric == PHOTOMETRIC_RGB; }
  int bytes() const { return bits / 8 * samples; }
  /// Empty, or why labels cannot be read from it.
  std::string why_not() const {
    const std::string save = ": save labels as whole numbers of 8, 16 or 32 bits, or as colours of 8 bits";
    if (sample_format != SAMPLEFORMAT_UINT && sample_format != SAMPLEFORMAT_INT)
      return "its pixels are no whole numbers" + save;
    if (colour() ? bits != 8 || samples < 3 : (bits != 8 && bits != 16 && bits != 32) || samples != 1)
      return "its pixels have " + number_text(int(samples)) + " samples of " + number_text(int(bits)) +
             " bits" + save;
    if (colour() && planar != PLANARCONFIG_CONTIG)
      return "its colours lie in planes of their own" + save + ", pixel by pixel";
    if (photometric != PHOTOMETRIC_MINISBLACK && photometric != PHOTOMETRIC_PALETTE && !colour())
      return "its colours are coded in a way that is not read" + save;
    if (orientation != ORIENTATION_TOPLEFT) return "its first row is not the upper one: save it upright";
    return "";
  }
};

/// The label of a pixel; libtiff gives numbers of several bytes in the order of this machine.
std::uint32_t label_at(const Format &format, const unsigned char *pixel) {
  if (format.colour()) return number_of(pixel, 3);  // a fourth sample is transparency
  if (format.bits == 8) return *pixel;
  if (format.bits == 16) {
    std::uint16_t number = 0;
    std::memcpy(&number, pixel, sizeof number);
    return number;
  }
  std::uint32_t number = 0;
  std::memcpy(&number, pixel, sizeof number);
  return number;
}

/// False: a part of the file cannot be read.
bool read_rows(const Libtiff &tiff, TIFF *file, const Format &format, LabelImage &image) {
  std::vector<unsigned char> row(std::size_t(tiff.row_size(file)));
  for (std::uint32_t y = 0; y < format.height; ++y) {
    if (tiff.read_row(file, row.data(), y, 0) != 1) return false;
    for (std::uint32_t x = 0; x < format.width; ++x)
      image.at(int(x), int(format.height - 1 - y)) =
          label_at(format, row.data() + std::size_t(x) * format.bytes());
  }
  return true;
}

bool read_tiles(const Libtiff &tiff, TIFF *file, const Format &format, LabelImage &image) {
  std::uint32_t across = 0, down = 0;
  if (tiff.get(file, TIFFTAG_TILEWIDTH, &across) != 1 || tiff.get(file, TIFFTAG_TILELENGTH, &down) != 1)
    return false;
  std::vector<unsigned char> tile(std::size_t(tiff.tile_size(file)));
  for (std::uint32_t top = 0; top < format.height; top += down)
    for (std::uint32_t left = 0; left < format.width; left += across) {
      if (tiff.read_tile(file, tile.data(), left, top, 0, 0) < 0) return false;
      for (std::uint32_t y = top; y < std::min(top + down, format.height); ++y)
        for (std::uint32_t x = left; x < std::min(left + across, format.width); ++x)
          image.at(int(x), int(format.height - 1 - y)) =
              label_at(format, tile.data() + (std::size_t(y - top) * across + (x - left)) * format.bytes());
    }
  return true;
}
}  // namespace

LabelImage labels_of_tiff(const std::filesystem::path &file) {
  static const Libtiff tiff;
  const std::unique_ptr<TIFF, decltype(tiff.close)> open(tiff.open(file.c_str(), "r"), tiff.close);
  const std::string cannot = file.string() + " cannot be read as a label image";
  if (!open) throw InputError(cannot + ": the file is damaged.");
  if (const int pictures = tiff.pictures(open.get()); pictures != 1)
    throw InputError(cannot + ": it holds " + number_text(pictures) + " pictures; save one by itself.");
  Format format;
  tiff.get(open.get(), TIFFTAG_IMAGEWIDTH, &format.width);
  tiff.get(open.get(), TIFFTAG_IMAGELENGTH, &format.height);
  tiff.get(open.get(), TIFFTAG_PHOTOMETRIC, &format.photometric);
  tiff.get_or_default(open.get(), TIFFTAG_BITSPERSAMPLE, &format.bits);
  tiff.get_or_default(open.get(), TIFFTAG_SAMPLESPERPIXEL, &format.samples);
  tiff.get_or_default(open.get(), TIFFTAG_SAMPLEFORMAT, &format.sample_format);
  tiff.get_or_default(open.get(), TIFFTAG_PLANARCONFIG, &format.planar);
  tiff.get_or_default(open.get(), TIFFTAG_ORIENTATION, &format.orientation);
  if (!allowed_size(format.width, format.height)) throw wrong_size(file, format.width, format.height);
  if (const std::string why = format.why_not(); !why.empty()) throw InputError(cannot + ": " + why + ".");
  LabelImage image{int(format.width), int(format.height),
                   std::vector<std::uint32_t>(std::size_t(format.width) * format.height)};
  if (!(tiff.is_tiled(open.get()) ? read_tiles : read_rows)(tiff, open.get(), format, image))
    throw InputError(cannot + ": a part of it is damaged or missing.");
  return image;
}
}  // namespace turgor
