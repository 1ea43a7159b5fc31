// The subsection Body of a scene of centre-based cells: a rigid body with a surface of triangles from a file
// (surface_file.h), which cells press against as on a wall (wall_contact.h) and rub along. Held where it is,
// or moved: without inertia, as the cells, drag v = load + what the cells do to it, and the same about its
// centre. Without a file there is none, and nothing of it is made.
//
//   body.declare(prm);  body.check({centres, radius, duration});
//   if (body.is_there()) around = body.surroundings(stiffness);
//
// Columns of growth.csv: see body_outputs(). The body moves where a step of the
// cells has ended, held during it: first order, so that a step lasts a hundredth of drag over the stiffness
// of its contacts at most (a body that pushes one cell along: its speed and the force between them then are
// those of the closed form to a per cent, tests/app/test_body.py), and moves it by at most a quarter of a
// cell's radius.
#pragma once

#include "micro/cells/surroundings.h"
#include "micro/geometry/triangulated_body.h"
#include "run/field_output.h"
#include "run/output_list.h"

#include <optional>
#include <string>
#include <vector>

namespace turgor {
class InputEntries;

enum class BodyMotion { fixed, drag };
constexpr const char *words_of(BodyMotion) { return "fixed|drag"; }

class BodyEntries {
 public:
  void declare(InputEntries &prm);
  bool is_there() const { return file != "none"; }
  /// What a body is checked against.
  struct FirstCells {
    std::vector<Vector<3>> centres;  ///< m
    double radius;                   ///< m, of the largest
    double duration;                 ///< s, until End time
  };
  /// Throws InputError.
  void check(const FirstCells &cells) const;

  /// radius: m, of a newborn cell.
  Surroundings surroundings(const std::optional<LocalStiffness> &stiffness) const;

  static Outputs outputs();
  /// Its surface now; its field "velocity [m/s]".
  static FieldFrame frame(const Obstacles<3> &walls, double time);

 private:
  std::unique_ptr<TriangulatedBody> make() const;
  void check_drag(const FirstCells &cells, const TriangulatedBody &body) const;

  std::string file = "none", position = "0, 0, 0", load = "0, 0, 0";
  double unit = 1e-6;  ///< m
  BodyMotion motion = BodyMotion::fixed;
  double drag = 1., turning_drag = 0.;  ///< N s/m, N m s
  double modulus = 1e9, poisson = 0.3;  ///< Pa
  double friction = 5e10;               ///< N s/m^3
};
}  // namespace turgor
