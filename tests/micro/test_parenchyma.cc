// Geometry and topology of the turgid patch.
#include "micro/cells/parenchyma.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <stdexcept>

using namespace turgor;

BOOST_AUTO_TEST_SUITE(parenchyma)

BOOST_AUTO_TEST_CASE(ties_join_facing_nodes_once) {
  struct Case {
    unsigned int columns, rows;
    bool px, py;
  };
  for (const Case c :
       {Case{1, 1, true, true}, Case{3, 2, true, true}, Case{4, 4, false, false}, Case{2, 3, false, true}}) {
    ParenchymaParameters parameters;
    parameters.nodes_per_side = 7;
    const CellLayout patch = make_parenchyma(parameters, c.columns, c.rows, c.px, c.py);
    BOOST_TEST(patch.nodes.size() == c.columns * c.rows * 28u);
    const unsigned int vertical_faces = (c.px ? c.columns : c.columns - 1) * c.rows;
    const unsigned int horizontal_faces = (c.py ? c.rows : c.rows - 1) * c.columns;
    BOOST_TEST(patch.ties.size() == 8u * (vertical_faces + horizontal_faces));
    for (const LamellaTie &tie : patch.ties) {
      const Vector<2> d =
          patch.nodes[tie.b] - patch.nodes[tie.a] + patch.lattice * Vector<2>(tie.shift[0], tie.shift[1]);
      BOOST_TEST(d.norm() < 1e-18);  // the reference: facing nodes coincide
      BOOST_TEST(tie.a != tie.b);
    }
  }
}

BOOST_AUTO_TEST_CASE(rings_are_counter_clockwise_squares) {
  const CellLayout patch = make_parenchyma({}, 2, 2, true, true);
  for (const WallRing &ring : patch.rings) {
    double area = 0.;
    for (unsigned int k = 0; k < ring.count; ++k) {
      const Vector<2> a = patch.nodes[ring.first + k], b = patch.nodes[ring.first + (k + 1) % ring.count];
      area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
      BOOST_TEST((b - a).norm() == patch.spacing, boost::test_tools::tolerance(1e-12));
    }
    BOOST_TEST(area == 1e-8, boost::test_tools::tolerance(1e-12));
  }
  // by hand: 1300 kg/m^3 x 1 um x 50 um x 4 um; E t0^3 z0/12 with E t0 = 400 N/m; 5 x 4 G t0 z0 / rest length
  BOOST_TEST(patch.node_mass[7] == 1300. * 1e-6 * 50e-6 * 4e-6, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(patch.hinge[7] == 400. * 1e-12 * 50e-6 / 12. / 4e-6, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(patch.ties[7].stiffness == 5. * 0.02 / patch.rest_length[7],
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(patch.spacing / patch.rest_length[7] - 1.02575) < 5e-6);
}

BOOST_AUTO_TEST_CASE(wrong_parameters_are_named) {
  const auto says = [](const std::string &word) {
    return [word](const std::invalid_argument &e) {
      return std::string(e.what()).find(word) != std::string::npos;
    };
  };
  ParenchymaParameters p;
  p.wall_stiffness = -1.;
  BOOST_CHECK_EXCEPTION(make_parenchyma(p, 1, 1, true, true), std::invalid_argument,
                        says("Wall stiffness is -1"));
  p = {};
  p.wall_beta = 1.5;
  BOOST_CHECK_EXCEPTION(make_parenchyma(p, 1, 1, true, true), std::invalid_argument, says("between 0 and 1"));
  p = {};
  p.turgor = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_EXCEPTION(make_parenchyma(p, 1, 1, true, true), std::invalid_argument, says("Turgor"));
  p = {};
  BOOST_CHECK_EXCEPTION(make_parenchyma(p, 0, 1, true, true), std::invalid_argument, says("Columns"));
}

BOOST_AUTO_TEST_SUITE_END()
