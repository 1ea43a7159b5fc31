#include "micro/geometry/surface_file.h"

#include "micro/geometry/closed_surface.h"
#include "micro/geometry/surface_crossing.h"
#include "micro/geometry/surface_nesting.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/user_text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

namespace turgor {
namespace {
constexpr std::size_t most_nodes = 65535;

/// Triangles as they are read.
class Surface {
 public:
  explicit Surface(const std::filesystem::path &file_) : file(file_) {}

  [[noreturn]] void fail(const std::string &sentence, const std::size_t line = 0) const {
    throw InputError(file.string() + (line > 0 ? ":" + number_text(line) : "") + ": " + sentence);
  }

  void node(const Vector<3> &x, const std::size_t line = 0) {
    if (!x.allFinite()) fail("a coordinate is no finite number.", line);
    if (read.nodes.size() == most_nodes)
      fail("the surface has more than " + number_text(most_nodes) + " nodes: make it coarser.", line);
    read.nodes.push_back(x);
  }
  /// A corner by its place: the node that is there already, or a new one.
  std::uint16_t corner(const Vector<3> &x, const std::size_t line = 0) {
    const std::array<double, 3> place{x[0] + 0., x[1] + 0., x[2] + 0.};  // -0 is 0
    const auto [known, is_new] = at.try_emplace(place, std::uint16_t(read.nodes.size()));
    if (is_new) node(x, line);
    return known->second;
  }
  /// By numbers from 0.
  void face(const std::vector<long> &corners, const std::size_t line) {
    if (corners.size() != 3)
      fail("a face has " + number_text(corners.size()) +
               " corners, but only triangles are read: let the program that wrote the file triangulate it.",
           line);
    std::array<std::uint16_t, 3> f;
    for (int k = 0; k < 3; ++k) {
      if (corners[k] < 0 || corners[k] >= long(read.nodes.size()))
        fail("a triangle names a node that is not there; there are " + number_text(read.nodes.size()) + ".",
             line);
      f[std::size_t(k)] = std::uint16_t(corners[k]);
    }
    face(f);
  }
  void face(const std::array<std::uint16_t, 3> &f) { read.mesh.faces.push_back(f); }

  SurfaceOfTriangles finished(const double unit) {
    if (read.mesh.faces.empty()) fail("there are no triangles in it.");
    for (Vector<3> &x : read.nodes) x *= unit;
    try {
      complete_closed_surface(read.mesh, read.nodes, "the surface");
    } catch (const std::invalid_argument &wrong) {
      fail(wrong.what());
    }
    if (const auto crossing = find_crossing(read.mesh, read.nodes))
      fail("the surface goes through itself: triangles " + number_text(crossing->first) + " and " +
           number_text(crossing->second) + " (counted from 0) cross. Mend it where it was drawn.");
    if (const auto wrong = find_wrong_nesting(read.mesh, read.nodes))
      fail("it has " + number_text(wrong->parts) + " closed surfaces, and that of triangle " +
           number_text(wrong->triangle) + " (counted from 0) lies " +
           (wrong->outwards
                ? "inside another that faces outwards as it does: a hollow has to face inwards, a "
                  "body has to lie beside the others."
                : "in none that it could hollow out, but faces inwards: turn the order of its "
                  "corners round."));
    return std::move(read);
  }

 private:
  std::filesystem::path file;
  SurfaceOfTriangles read;
  std::map<std::array<double, 3>, std::uint16_t> at;
};

/// Lines of a text with their numbers, comments after # taken off.
class Lines {
 public:
  explicit Lines(const std::string &text_) : text(text_) {}
  /// The next line that is not empty, as words.
  bool next(std::vector<std::string> &words) {
    std::string line;
    while (std::getline(text, line)) {
      ++number;
      std::istringstream in(line.substr(0, line.find('#')));
      words.assign(std::istream_iterator<std::string>(in), {});
      if (!words.empty()) return true;
    }
    return false;
  }
  std::size_t number = 0;

 private:
  std::istringstream text;
};

/// A number but for its size: read_number() takes none that is not finite.
bool is_out_of_range(const std::string &word) {
  char *end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  return *end == '\0' && std::isinf(value) && word.find_first_of("0123456789") != std::string::npos;
}

Vector<3> place_in(const std::vector<std::string> &words, const std::size_t from, const Surface &surface,
                   const std::size_t line) {
  Vector<3> x;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto value = from + k < words.size() ? read_number(words[from + k]) : std::nullopt;
    if (!value && from + k < words.size() && is_out_of_range(words[from + k]))
      surface.fail("'" + shortened(words[from + k]) + "' is out of the range of numbers.", line);
    if (!value) surface.fail("three coordinates are wanted here.", line);
    x[Eigen::Index(k)] = *value;
  }
  return x;
}

long whole_in(const std::string &word, const Surface &surface, const std::size_t line) {
  const std::optional<double> value = read_number(word);
  if (!value || *value != std::floor(*value) || std::abs(*value) > 1e9)
    surface.fail("'" + shortened(word) + "' is no number of a node or of corners.", line);
  return long(*value);
}

void read_binary_stl(const std::string &bytes, Surface &surface) {
  for (std::size_t at = 84; at < bytes.size(); at += 50) {
    std::array<float, 12> numbers;  // normal, three corners: least significant byte first
    std::memcpy(numbers.data(), bytes.data() + at, sizeof numbers);
    std::array<std::uint16_t, 3> f;
    for (std::size_t k = 0; k < 3; ++k)
      f[k] = surface.corner(Vector<3>(numbers[3 * k + 3], numbers[3 * k + 4], numbers[3 * k + 5]));
    surface.face(f);
  }
}

void read_ascii_stl(const std::string &text, Surface &surface) {
  Lines lines(text);
  std::vector<std::string> words;
  std::vector<std::uint16_t> corners;
  while (lines.next(words))
    if (words[0] == "vertex")
      corners.push_back(surface.corner(place_in(words, 1, surface, lines.number), lines.number));
    else if (words[0] == "endloop") {
      if (corners.size() != 3)
        surface.fail("a facet has " + number_text(corners.size()) + " corners, but three are wanted.",
                     lines.number);
      surface.face(std::array<std::uint16_t, 3>{corners[0], corners[1], corners[2]});
      corners.clear();
    }
  if (!corners.empty()) surface.fail("the last facet is cut off.");
}

void read_off(const std::string &text, Surface &surface) {
  Lines lines(text);
  std::vector<std::string> words;
  if (!lines.next(words) || words[0] != "OFF") surface.fail("the first word has to be OFF.");
  words.erase(words.begin());
  if (words.empty() && !lines.next(words)) surface.fail("the numbers of nodes and faces are missing.");
  if (words.size() < 2) surface.fail("the numbers of nodes, faces and edges are wanted here.", lines.number);
  const long nodes = whole_in(words[0], surface, lines.number),
             faces = whole_in(words[1], surface, lines.number);
  if (nodes < 0 || faces < 0)
    surface.fail("the numbers of nodes and faces cannot be negative (" + number_text(nodes) + " and " +
                     number_text(faces) + ").",
                 lines.number);
  for (long k = 0; k < nodes; ++k) {
    if (!lines.next(words))
      surface.fail("it ends after " + number_text(k) + " of " + number_text(nodes) + " nodes.");
    surface.node(place_in(words, 0, surface, lines.number), lines.number);
  }
  for (long k = 0; k < faces; ++k) {
    if (!lines.next(words))
      surface.fail("it ends after " + number_text(k) + " of " + number_text(faces) + " faces.");
    const long count = whole_in(words[0], surface, lines.number);
    if (count < 0 || std::size_t(count) + 1 > words.size())
      surface.fail("fewer corners than announced.", lines.number);
    std::vector<long> corners;
    for (long c = 1; c <= count; ++c)
      corners.push_back(whole_in(words[std::size_t(c)], surface, lines.number));
    surface.face(corners, lines.number);
  }
}

void read_obj(const std::string &text, Surface &surface) {
  Lines lines(text);
  std::vector<std::string> words;
  long nodes = 0;
  while (lines.next(words))
    if (words[0] == "v") {
      surface.node(place_in(words, 1, surface, lines.number), lines.number);
      ++nodes;
    } else if (words[0] == "f") {
      std::vector<long> corners;  // "7", "7/1", "7/1/2", "7//2"; from 1, or back from the last: -1
      for (std::size_t k = 1; k < words.size(); ++k) {
        const long n = whole_in(words[k].substr(0, words[k].find('/')), surface, lines.number);
        corners.push_back(n < 0 ? nodes + n : n - 1);
      }
      surface.face(corners, lines.number);
    }
}

std::string bytes_of(const std::filesystem::path &file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file))
    throw InputError(file.string() + ": the file cannot be read.");
  return {std::istreambuf_iterator<char>(in), {}};
}

void read_stl(const std::filesystem::path &file, Surface &surface) {
  const std::string bytes = bytes_of(file);
  std::uint32_t triangles = 0;
  static_assert(std::endian::native == std::endian::little);
  if (bytes.size() >= 84) std::memcpy(&triangles, bytes.data() + 80, 4);
  if (bytes.size() >= 84 && bytes.size() == 84 + 50 * std::size_t(triangles))
    read_binary_stl(bytes, surface);
  else if (bytes.starts_with("solid") && bytes.find('\0') == std::string::npos)
    read_ascii_stl(read_text(file), surface);
  else
    surface.fail(bytes.size() < 84
                     ? std::string("it is too short for a binary STL file and does not begin with 'solid'.")
                     : "a binary STL file of " + number_text(triangles) + " triangles has " +
                           number_text(84 + 50 * std::size_t(triangles)) + " bytes, this one has " +
                           number_text(bytes.size()) + ": it may be cut off.");
}
}  // namespace

SurfaceOfTriangles read_surface(const std::filesystem::path &file, const double unit) {
  Surface surface(file);
  if (!(unit > 0.)) surface.fail("metres to a unit have to be positive.");
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](const unsigned char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : char(c); });
  if (ending == ".stl")
    read_stl(file, surface);
  else if (ending == ".off")
    read_off(read_text(file), surface);
  else if (ending == ".obj")
    read_obj(read_text(file), surface);
  else
    surface.fail("surfaces are read from files that end in .stl, .off or .obj.");
  return surface.finished(unit);
}
}  // namespace turgor
