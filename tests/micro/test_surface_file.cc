// Bodies from files: the same cube in every format, and what is refused with which sentence.
#include "micro/geometry/surface_crossing.h"
#include "micro/geometry/surface_file.h"
#include "micro/geometry/triangulated_body.h"
#include "run/run_context.h"
#include "tests/temporary_directory.h"

#include <boost/test/unit_test.hpp>

#include <cstring>
#include <fstream>
#include <functional>

using namespace turgor;

namespace {
/// A cube |x| < 1/2; node bits: x, y, z.
const std::vector<std::array<int, 3>> cube = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
                                              {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7},
                                              {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
Vector<3> node(const int k) { return {(k & 1) - 0.5, (k >> 1 & 1) - 0.5, (k >> 2 & 1) - 0.5}; }

struct Files {
  test::TemporaryDirectory directory;

  std::filesystem::path write(const std::string &name, const std::string &bytes) const {
    std::ofstream(directory / name, std::ios::binary) << bytes;
    return directory / name;
  }
  void refused(const std::string &name, const std::string &bytes, const std::string &words) const {
    const auto file = write(name, bytes);
    BOOST_CHECK_EXCEPTION(read_surface(file), InputError, [&](const InputError &e) {
      BOOST_TEST_MESSAGE(e.what());
      return std::string(e.what()).find(words) != std::string::npos &&
             std::string(e.what()).find(name) != std::string::npos;
    });
  }
};

std::string text_of(const Vector<3> &x) {
  std::ostringstream out;
  out << x[0] << ' ' << x[1] << ' ' << x[2];
  return out.str();
}

std::string ascii_stl() {
  std::string text = "solid cube\n";
  for (const auto &f : cube) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int k : f) text += "  vertex " + text_of(node(k)) + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid cube\n";
}

std::string binary_stl() {
  std::string bytes(80, ' ');
  const std::uint32_t count = std::uint32_t(cube.size());
  bytes.append(reinterpret_cast<const char *>(&count), 4);
  for (const auto &f : cube) {
    float numbers[12] = {};
    for (int k = 0; k < 3; ++k)
      for (int d = 0; d < 3; ++d) numbers[3 + 3 * k + d] = float(node(f[std::size_t(k)])[d]);
    bytes.append(reinterpret_cast<const char *>(numbers), sizeof numbers).append(2, '\0');
  }
  return bytes;
}

std::string off(const std::function<Vector<3>(int)> &at = node) {
  std::string text = "OFF # a cube\n8 12 0\n";
  for (int k = 0; k < 8; ++k) text += text_of(at(k)) + "\n";
  for (const auto &[a, b, c] : cube)
    text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  return text;
}

std::string obj() {
  std::string text = "# a cube\no cube\n";
  for (int k = 0; k < 8; ++k) text += "v " + text_of(node(k)) + "\n";
  for (const auto &[a, b, c] : cube)  // from 1, with other numbers beside, and back from the last
    text += "f " + std::to_string(a + 1) + "/1/2 " + std::to_string(b + 1) + "//3 " + std::to_string(c - 8) +
            "\n";
  return text;
}

std::string replaced(std::string text, const std::string &what, const std::string &by) {
  return text.replace(text.find(what), what.size(), by);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(surface_file)

BOOST_AUTO_TEST_CASE(the_same_cube_in_every_format) {
  const Files files;
  for (const auto &file : {files.write("a.stl", ascii_stl()), files.write("b.STL", binary_stl()),
                           files.write("c.off", off()), files.write("d.obj", obj())}) {
    const SurfaceOfTriangles read = read_surface(file, 1e-6);
    BOOST_TEST(read.nodes.size() == 8u);
    BOOST_TEST(read.mesh.faces.size() == 12u);
    BOOST_TEST(read.mesh.edges.size() == 18u);
    const TriangulatedBody body(read.mesh, read.nodes, ParticlesAre::outside);
    const auto contact = body.at({0.8e-6, 0.1e-6, 0.2e-6});
    BOOST_TEST(contact.distance == 0.3e-6, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(contact.normal[0] == 1., boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_body_is_refused) {
  const Files files;
  files.refused("open.off", replaced(replaced(off(), "8 12 0", "8 11 0"), "3 3 7 5\n", ""),
                "the triangles are not closed at the edge from node 5 to node 7 (counted from 0)");
  files.refused("turned.off", replaced(off(), "3 3 7 5", "3 3 5 7"),
                "one of them is turned over or there twice.");
  files.refused("inwards.off", off([](const int k) { return Vector<3>(-node(k)); }), "counter-clockwise");
  files.refused("flat.off",
                off([](const int k) { return k == 0 ? Vector<3>(0.5 * (node(1) + node(2))) : node(k); }),
                "has no area");
  files.refused("through.off", off([](const int k) { return k == 0 ? Vector<3>(0.7, 0.1, 0.2) : node(k); }),
                "goes through itself");
  files.refused("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", "only triangles");
  files.refused("lost.off", replaced(off(), "3 3 7 5", "3 3 7 8"), "names a node that is not there");
  files.refused("short.off", replaced(off(), "8 12 0", "8 13 0"), "ends after 12 of 13 faces");
  files.refused("word.obj", "v 0 zero 0\n", "three coordinates");
  files.refused("far.obj", "v 0 1e400 0\n", "'1e400' is out of the range of numbers.");
  files.refused("minus.off", replaced(off(), "8 12 0", "-8 12 0"), "cannot be negative (-8 and 12).");
  files.refused("cut.stl", binary_stl().substr(0, 600), "may be cut off");
  files.refused("cut_text.stl", ascii_stl().substr(0, 120), "");
  files.refused("none.stl", "solid\nendsolid\n", "no triangles");
  files.refused("body.ply", "ply\n", ".stl, .off or .obj");
  BOOST_CHECK_THROW(read_surface(files.directory / "absent.stl"), InputError);
  BOOST_CHECK_THROW(read_surface(files.write("e.off", off()), 0.), InputError);
}

// A small cube beside a large one, in it facing outwards (no body), in it facing inwards (a hollow), and
// beside it facing inwards (nothing that it could hollow out).
BOOST_AUTO_TEST_CASE(bodies_lie_side_by_side_and_hollows_inside) {
  const Files files;
  const auto two = [&](const double shift, const bool inwards) {
    std::string text = "OFF\n16 24 0\n";
    for (int k = 0; k < 8; ++k) text += text_of(Vector<3>(4. * node(k))) + "\n";
    for (int k = 0; k < 8; ++k) text += text_of(Vector<3>(node(k) + Vector<3>(shift, 0.1, 0.2))) + "\n";
    for (const int from : {0, 8})
      for (const auto &[a, b, c] : cube) {
        const bool turned = from == 8 && inwards;
        text += "3 " + std::to_string(a + from) + " " + std::to_string((turned ? c : b) + from) + " " +
                std::to_string((turned ? b : c) + from) + "\n";
      }
    return text;
  };
  BOOST_TEST(read_surface(files.write("beside.off", two(5., false))).nodes.size() == 16u);
  BOOST_TEST(read_surface(files.write("hollow.off", two(0.3, true))).nodes.size() == 16u);
  files.refused("nested.off", two(0.3, false),
                "2 closed surfaces, and that of triangle 12 (counted from 0) lies inside another");
  files.refused("inside_out.off", two(5., true), "in none that it could hollow out, but faces inwards");
}

// Two tetrahedra, one mesh: apart, one through the other.
BOOST_AUTO_TEST_CASE(triangles_that_cross_are_found) {
  const auto crossing = [](const Vector<3> &shift) {
    TriangleMesh mesh;
    std::vector<Vector<3>> x;
    for (const int body : {0, 1}) {
      for (const Vector<3> &corner :
           {Vector<3>(0., 0., 0.), Vector<3>(1., 0., 0.), Vector<3>(0., 1., 0.), Vector<3>(0., 0., 1.)})
        x.push_back(corner + body * shift);
      for (const auto &[a, b, c] : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
        mesh.faces.push_back(
            {std::uint16_t(a + 4 * body), std::uint16_t(b + 4 * body), std::uint16_t(c + 4 * body)});
    }
    mesh.complete();
    return find_crossing(mesh, x).has_value();
  };
  BOOST_TEST(!crossing({1.1, 0., 0.}));
  BOOST_TEST(!crossing({0.4, 0.4, 0.4}));  // boxes overlap
  BOOST_TEST(crossing({0.2, 0.1, 0.15}));
  BOOST_TEST(crossing({-0.1, -0.2, 0.3}));
}

BOOST_AUTO_TEST_SUITE_END()
