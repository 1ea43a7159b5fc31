#include "run/input_entries.h"
#include "run/archive.h"
#include "tests/macro/tissue_fixture.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(tissue)

namespace {
const std::vector<std::string> integrators = {"central_differences", "dormand_prince"};

bool contains(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

double relative(const std::vector<double> &a, const std::vector<double> &b) {
  double difference = 0., norm = 0.;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference += (a[i] - b[i]) * (a[i] - b[i]);
    norm += b[i] * b[i];
  }
  return std::sqrt(difference / norm);
}
}  // namespace

BOOST_AUTO_TEST_CASE(saved_and_loaded_run_gives_the_same_bits) {
  for (const std::string &integrator : integrators) {
    TissueParameters<2> p = gravity(3);
    p.integrator = choice_of<TimeIntegration>(integrator);
    p.estimate_every = 7;
    const double end = 2e-5;
    FailingLaw whole_law(mu, lambda, 1., rho), first_law(mu, lambda, 1., rho),
        second_law(mu, lambda, 1., rho);
    whole_law.fail_from = first_law.fail_from = 4;  // halved steps are part of what is carried over
    whole_law.fail_to = first_law.fail_to = 6;

    Tissue<2> whole(p, whole_law), first(p, first_law), second(p, second_law);
    whole.start();
    whole.advance_to(end);
    first.start();
    BOOST_TEST(!first.advance_to(end, [](double, unsigned long step) { return step < 5; }));
    BOOST_TEST(first.time() < end);
    restore(archived(first), second);
    BOOST_TEST(second.time() == first.time());
    second.advance_to(end);
    BOOST_TEST(second.steps() == whole.steps());
    BOOST_TEST(whole.counters().failures > 0u);
    BOOST_TEST((second.state().u == whole.state().u));
    BOOST_TEST((second.state().v == whole.state().v));
    BOOST_TEST((second.fields().stress == whole.fields().stress));
  }
}

BOOST_AUTO_TEST_CASE(checkpoint_of_another_mesh_or_cut_short_is_refused) {
  NeoHookeanLaw<2> law(mu, lambda, 0., rho);
  Tissue<2> small(gravity(2), law), large(gravity(3), law);
  small.start();
  const std::string bytes = archived(small);
  BOOST_CHECK_EXCEPTION(restore(bytes, large), ArchiveError,
                        [](const auto &e) { return contains(e.what(), "another mesh"); });
  BOOST_CHECK_EXCEPTION(restore(bytes.substr(0, 100), small), ArchiveError,
                        [](const auto &e) { return contains(e.what(), "damaged"); });
}

BOOST_AUTO_TEST_CASE(law_that_fails_once_shortens_the_step) {
  for (const std::string &integrator : integrators) {
    TissueParameters<2> p = gravity(3);
    p.integrator = choice_of<TimeIntegration>(integrator);
    p.estimate_every = 0;
    FailingLaw law(mu, lambda, 0., rho);
    law.fail_from = 1;
    law.fail_to = 2;
    Tissue<2> tissue(p, law);
    tissue.start();
    const double planned = tissue.stable_step();
    tissue.step(1e-3);
    BOOST_TEST(tissue.last_step() < 0.51 * planned);
    BOOST_TEST(tissue.counters().failures == 1u);
    BOOST_TEST(law.commits == 1u);
    for (int i = 0; i < 40; ++i) tissue.step(1e-3);
    BOOST_TEST(tissue.last_step() > 0.8 * planned);
    BOOST_TEST(law.commits == 41u);
  }
}

BOOST_AUTO_TEST_CASE(law_that_fails_for_ever_ends_the_run_with_the_place) {
  for (const std::string &integrator : integrators) {
    TissueParameters<2> p = gravity(3);
    p.integrator = choice_of<TimeIntegration>(integrator);
    p.estimate_every = 0;
    FailingLaw law(mu, lambda, 0., rho);
    law.fail_from = 100;
    law.fail_to = 100000;
    Tissue<2> tissue(p, law);
    tissue.start();
    std::vector<double> u;
    double time = 0.;
    const auto run = [&] {
      while (true) {
        u = tissue.state().u;
        time = tissue.time();
        tissue.step(1.);
      }
    };
    BOOST_CHECK_EXCEPTION(run(), TissueFailed, [](const TissueFailed &e) {
      return contains(e.what(), "the cell wall cannot be balanced") &&
             contains(e.what(), "element 1, quadrature point 5") && contains(e.what(), "halved 8 times") &&
             e.failure.position[0] > width / 3.;
    });
    BOOST_TEST((tissue.state().u == u));
    BOOST_TEST(tissue.time() == time);
    BOOST_TEST(law.commits == tissue.steps());
  }
}

BOOST_AUTO_TEST_CASE(an_exception_of_the_law_comes_through) {
  struct Throwing : NeoHookeanLaw<2> {
    using NeoHookeanLaw<2>::NeoHookeanLaw;
    int calls = 0;
    void evaluate(const std::vector<dealii::Tensor<2, 2>> &F, const std::vector<dealii::Tensor<2, 2>> &F_dot,
                  const LawRequest &request, LawAnswer<2> &answer) override {
      if (++calls > 5) throw std::logic_error("no more");
      NeoHookeanLaw<2>::evaluate(F, F_dot, request, answer);
    }
  };
  for (const std::string &integrator : integrators) {
    TissueParameters<2> p = gravity(2);
    p.integrator = choice_of<TimeIntegration>(integrator);
    Throwing law(mu, lambda, 0., rho);
    Tissue<2> piece(p, law);
    piece.start();
    BOOST_CHECK_THROW(piece.advance_to(1.), std::logic_error);
  }
}

BOOST_AUTO_TEST_CASE(both_integrators_agree_and_the_clamped_side_stays) {
  std::vector<std::vector<double>> u;
  for (const std::string &integrator : integrators) {
    TissueParameters<2> p = gravity(4);
    p.integrator = choice_of<TimeIntegration>(integrator);
    p.cfl = 0.1;
    p.relative_tolerance = 1e-8;
    p.displacement_tolerance = 1e-14;
    p.velocity_tolerance = 1e-8;
    NeoHookeanLaw<2> law(mu, lambda, 1., rho);
    Tissue<2> tissue(p, law);
    tissue.start();
    tissue.advance_to(5e-5);
    BOOST_TEST(tissue.time() == 5e-5);
    u.push_back(tissue.state().u);
    for (std::size_t i = 0; i < u.back().size(); ++i)
      if (tissue.mesh().node_position[i / 2][0] < 1e-12)
        BOOST_TEST((u.back()[i] == 0. && tissue.state().v[i] == 0.));
  }
  BOOST_TEST(relative(u[0], u[1]) < 1e-3);
}

BOOST_AUTO_TEST_CASE(dormand_prince_is_of_fifth_order_with_six_calls_a_step) {
  const auto run = [](double cfl) {
    TissueParameters<2> p = gravity(2);
    p.integrator = TimeIntegration::dormand_prince;
    p.estimate_every = 0;
    p.cfl = cfl;
    p.relative_tolerance = 1.;  // error control out of the way: the step is the bound
    p.displacement_tolerance = p.velocity_tolerance = 1e6;
    NeoHookeanLaw<2> law(mu, 20. * mu, 0., rho);
    Tissue<2> tissue(p, law);
    tissue.start();
    const double start = tissue.stable_step() / cfl * 8.;
    tissue.advance_to(start);
    BOOST_TEST(tissue.law_calls() == 6 * tissue.steps() + 1);
    return tissue.state().u;
  };
  const auto exact = run(0.0625);
  const double order = std::log2(relative(run(0.5), exact) / relative(run(0.25), exact));
  BOOST_TEST(order > 4.7);
  BOOST_TEST(order < 5.4);
}

// bilinear squares of side h, lumped mass: the stiffest mode of one displacement component is a plane wave of
// length 2h, omega^2 = 4 C / (rho h^2)
BOOST_AUTO_TEST_CASE(bound_of_the_stable_step_by_hand) {
  TissueParameters<2> p = gravity(8);
  p.estimate_every = 0;
  p.lateral = LateralSides::periodic;
  NeoHookeanLaw<2> law(mu, lambda, 0., rho);
  Tissue<2> tissue(p, law);
  const double h = width / 8., expected = 0.9 * h * std::sqrt(rho / law.stiffness_bound());
  BOOST_TEST(tissue.stable_step() < expected);
  BOOST_TEST(tissue.stable_step() > 0.97 * expected);
}

BOOST_AUTO_TEST_CASE(stable_step_from_tangents_is_sharp) {
  const auto worst_balance = [](double cfl, double &step) {
    TissueParameters<2> p = gravity(6);
    p.cfl = cfl;
    p.body_force[1] = -1.;  // linear: the tangent stays
    NeoHookeanLaw<2> law(mu, lambda, 0., rho);
    Tissue<2> tissue(p, law);
    tissue.start();
    step = tissue.stable_step();
    double worst = 0.;
    for (int i = 0; i < 1500 && worst < 1e3; ++i) {
      tissue.step(1.);
      const TissueEnergies e = tissue.energies();
      worst = std::max(worst, std::abs(e.dissipated()) / std::max(1e-30, std::abs(e.work)));
    }
    return worst;
  };
  double stable, unstable, bound;
  BOOST_TEST(worst_balance(0.99, stable) < 1.);
  BOOST_TEST(worst_balance(1.04, unstable) > 1e3);
  TissueParameters<2> p = gravity(6);
  p.cfl = 0.99;
  p.estimate_every = 0;
  NeoHookeanLaw<2> law(mu, lambda, 0., rho);
  bound = Tissue<2>(p, law).stable_step();
  BOOST_TEST_MESSAGE("stable step from tangents " << stable << " s, from the bound " << bound << " s");
  BOOST_TEST(stable > 1.2 * bound);
}

BOOST_AUTO_TEST_CASE(periodic_slab_moves_as_one) {
  TissueParameters<2> p = gravity(4);
  p.lateral = LateralSides::periodic;
  NeoHookeanLaw<2> law(mu, lambda, 0., rho);
  Tissue<2> tissue(p, law);
  tissue.start();
  tissue.advance_to(3e-5);
  std::vector<dealii::Point<2>> column;
  for (const double y : {0., 0.2, 0.55, 1.}) column.emplace_back(0.77 * width, y * width);
  const auto u = tissue.displacement_at(column);
  BOOST_TEST(std::abs(u[0][1]) > 1e-9);
  for (const auto &value : u) BOOST_TEST((value - u[0]).norm() < 1e-12 * u[0].norm());
}

BOOST_AUTO_TEST_CASE(pictures_and_probes) {
  for (const unsigned int degree : {1u, 2u}) {
    NeoHookeanLaw<2> law(mu, lambda, 0., rho);
    Tissue<2> tissue(gravity(3, degree), law);
    tissue.start();
    tissue.advance_to(2e-5);
    const TissueFields fields = tissue.fields();
    const std::size_t points = (3 * degree + 1) * (3 * degree + 1), cells = 9 * degree * degree;
    BOOST_TEST(fields.points.size() == 3 * points);
    BOOST_TEST(fields.cells.size() == 4 * cells);
    BOOST_TEST(fields.stress.size() == 9 * cells);
    double area = 0.;
    for (std::size_t c = 0; c < cells; ++c) {
      const auto x = [&](int k, int d) { return fields.points[3 * fields.cells[4 * c + k] + d]; };
      area += 0.5 * ((x(2, 0) - x(0, 0)) * (x(3, 1) - x(1, 1)) - (x(3, 0) - x(1, 0)) * (x(2, 1) - x(0, 1)));
    }
    BOOST_TEST(area == width * width, boost::test_tools::tolerance(1e-12));
    for (std::size_t i = 0; i < points; i += 5) {
      const auto u = tissue.displacement_at(dealii::Point<2>(fields.points[3 * i], fields.points[3 * i + 1]));
      BOOST_TEST(std::abs(u[1] - fields.displacement[3 * i + 1]) < 1e-18);
    }
    BOOST_CHECK_EXCEPTION(
        tissue.displacement_at(dealii::Point<2>(2. * width, 0.)), std::invalid_argument,
        [](const auto &e) { return contains(e.what(), "is not inside the piece of tissue"); });
  }
}

BOOST_AUTO_TEST_CASE(traction_pulls_with_its_resultant) {
  TissueParameters<2> p;
  p.traction[0] = 1e4;
  p.degree = 2;
  NeoHookeanLaw<2> law(mu, lambda, 0., rho);
  TissueMesh<2> mesh(p);
  TissueOperator<2> op(mesh, p, law);
  double sum = 0., mass = 0.;
  for (std::size_t i = 0; i < op.size(); i += 2) {
    sum += op.external_forces()[i];
    mass += op.mass()[i];
    BOOST_TEST(op.mass()[i] > 0.);
  }
  BOOST_TEST(sum == 1e4 * width, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(mass == rho * width * width, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(parameters_from_text_and_bad_ones) {
  TissueParameters<2> p;
  InputEntries prm;
  p.declare(prm);
  prm.read(
      "subsection Tissue\n set Body force = 3, -4.5\n set Elements x = 5\nend\n"
      "subsection Time\n set Integrator = dormand_prince\nend\n");
  BOOST_TEST(p.body_force[1] == -4.5);
  BOOST_TEST(p.elements[0] == 5u);
  BOOST_TEST(word_of(p.integrator) == "dormand_prince");
  p.check();

  prm.enter_subsection("Tissue");
  BOOST_CHECK_THROW(prm.set("Width", "-1"), std::invalid_argument);
  BOOST_CHECK_THROW(prm.set("Degree", "3"), std::invalid_argument);
  BOOST_CHECK_THROW(prm.set("Body force", "1"), std::invalid_argument);
  prm.leave_subsection();

  p.right = RightSide::clamped;
  p.traction[0] = 1.;
  BOOST_CHECK_EXCEPTION(p.check(), std::invalid_argument, [](const auto &e) {
    return contains(e.what(), "Tissue/Traction") && contains(e.what(), "free");
  });
  p.right = RightSide::free;
  p.body_force[0] = std::numeric_limits<double>::infinity();
  BOOST_CHECK_EXCEPTION(p.check(), std::invalid_argument, [](const auto &e) {
    return contains(e.what(), "Tissue/Body force must be 2 finite numbers");
  });
  p.body_force[0] = 0.;
  p.lateral = LateralSides::periodic;
  p.elements[1] = 1;
  BOOST_CHECK_EXCEPTION(p.check(), std::invalid_argument,
                        [](const auto &e) { return contains(e.what(), "Elements y must be at least 2"); });
}

BOOST_AUTO_TEST_SUITE_END()
