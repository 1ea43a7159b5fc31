#include "coupling/rve_law.h"
#include "run/run_context.h"
#include "run/stop_flag.h"
#include "run/archive.h"
#include "tests/coupling/fake_rve.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <tuple>

using namespace turgor;
using turgor::test::FakeRve;

namespace {
template <int dim>
struct Batch {
  std::vector<dealii::Point<dim>> points;
  std::vector<dealii::Tensor<2, dim>> F, F_dot;

  explicit Batch(std::size_t n) {
    for (std::size_t p = 0; p < n; ++p) {
      dealii::Point<dim> x;
      dealii::Tensor<2, dim> f, g;
      for (int i = 0; i < dim; ++i) {
        x[i] = 1e-4 * static_cast<double>(p + 1);
        for (int j = 0; j < dim; ++j) {
          f[i][j] = (i == j ? 1. : 0.) + 0.05 * std::sin(1. + static_cast<double>(p) + 3. * i + 7. * j);
          g[i][j] = 1e3 * std::cos(2. + static_cast<double>(p) + 5. * i + 11. * j);
        }
      }
      points.push_back(x);
      F.push_back(f);
      F_dot.push_back(g);
    }
  }
};

std::vector<std::size_t> all(std::size_t n) {
  std::vector<std::size_t> result(n);
  for (std::size_t p = 0; p < n; ++p) result[p] = p;
  return result;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(rve_law)

BOOST_AUTO_TEST_CASE_TEMPLATE(
    equals_the_closed_form, Dim,
    decltype(std::tuple<std::integral_constant<int, 2>, std::integral_constant<int, 3>>())) {
  constexpr int dim = Dim::value;
  const auto rve = std::make_shared<FakeRve<dim>>();
  RveLaw<dim> law(rve, {});
  const Batch<dim> batch(7);
  law.set_points(batch.points);
  LawAnswer<dim> answer;
  LawRequest request;
  law.evaluate(batch.F, batch.F_dot, request, answer);
  BOOST_TEST((answer.tangent.empty() && answer.rate_tangent.empty()));
  request.tangents = request.rate_tangents = true;
  law.evaluate(batch.F, batch.F_dot, request, answer);
  BOOST_TEST(answer.failed.empty());
  for (std::size_t p = 0; p < 7; ++p) {
    double square = 0.;
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) {
        const double E = batch.F[p][a][b] - (a == b ? 1. : 0.);
        square += E * E;
        BOOST_TEST(answer.P[p][a][b] ==
                   2. * 1e6 * E + 10. * batch.F_dot[p][a][b]);  // same operations: same bits
        for (int c = 0; c < dim; ++c)
          for (int d = 0; d < dim; ++d) {
            BOOST_TEST(answer.tangent[p][a][b][c][d] == (a == c && b == d ? 2e6 : 0.));
            BOOST_TEST(answer.rate_tangent[p][a][b][c][d] == (a == c && b == d ? 10. : 0.));
          }
      }
    BOOST_TEST(answer.energy[p] == 1e6 * square, boost::test_tools::tolerance(1e-14));
  }
  BOOST_TEST(law.density() == 1000.);
  BOOST_TEST(law.stiffness_bound() == 2e6);
  BOOST_TEST(law.viscosity_bound() == 10.);
  BOOST_TEST(law.statistics().calls == 14u);
  BOOST_TEST(law.statistics().iterations == 42u);
}

BOOST_AUTO_TEST_CASE(evaluate_changes_no_history_and_commit_takes_the_last) {
  RveLaw<2> law(std::make_shared<FakeRve<2>>(), {});
  Batch<2> batch(5);
  law.set_points(batch.points);
  LawAnswer<2> first, again, other;
  law.evaluate(batch.F, batch.F_dot, {}, first);
  for (int k = 0; k < 3; ++k) law.evaluate(batch.F, batch.F_dot, {}, again);
  BOOST_TEST((first.P == again.P));
  for (const RveState<2> &s : law.states(all(5))) BOOST_TEST(s.unknowns[0] == 0.);  // nothing committed

  Batch<2> last = batch;
  last.F[2][0][0] = 1.125;
  law.evaluate(last.F, last.F_dot, {}, other);
  law.commit();
  law.commit();  // no batch since: nothing happens
  const auto states = law.states(all(5));
  for (const RveState<2> &s : states) BOOST_TEST(s.unknowns[0] == 1.);  // one commit, not five evaluations
  BOOST_TEST(states[2].unknowns[1] == 1.125);
  BOOST_TEST(states[2].F(0, 0) == 1.125);
}

BOOST_AUTO_TEST_CASE(failures_are_answers_with_place_and_reason) {
  const auto rve = std::make_shared<FakeRve<2>>();
  rve->fails_above = 1.2;
  rve->throws_above = 1.4;
  rve->nan_above = 1.1;
  Batch<2> batch(6);
  batch.F[1][0][0] = 1.3;   // does not converge
  batch.F[3][0][0] = 1.5;   // throws
  batch.F[4][0][0] = 1.15;  // NaN
  for (const unsigned int threads : {1u, 2u}) {
    RveLawSettings settings;
    settings.threads = threads;
    RveLaw<2> law(rve, settings);
    law.set_points(batch.points);
    LawAnswer<2> answer;
    law.evaluate(batch.F, batch.F_dot, {}, answer);
    BOOST_TEST_REQUIRE(answer.failed.size() == 3u);
    BOOST_TEST(answer.failed[0].point == 1u);
    BOOST_TEST(answer.failed[1].point == 3u);
    BOOST_TEST(answer.failed[2].point == 4u);
    BOOST_TEST(answer.failed[0].reason ==
               "RVE at quadrature point 1 (x = 0.0002 m, y = 0.0002 m): Newton did not converge.");
    BOOST_TEST(answer.failed[1].reason ==
               "RVE at quadrature point 3 (x = 0.0004 m, y = 0.0004 m): det F is not positive.");
    BOOST_TEST(answer.failed[2].reason.find("non-finite") != std::string::npos);
    BOOST_TEST(law.statistics().failed_calls == 3u);
    BOOST_CHECK_THROW(law.commit(), std::logic_error);
    for (const RveState<2> &s : law.states(all(6))) BOOST_TEST(s.unknowns[0] == 0.);

    batch.F[1][0][0] = 1.;  // a shorter step: the law goes on
    batch.F[3][0][0] = 1.;
    batch.F[4][0][0] = 1.;
    law.evaluate(batch.F, batch.F_dot, {}, answer);
    BOOST_TEST(answer.failed.empty());
    law.commit();
    BOOST_TEST(law.states({3})[0].unknowns[0] == 1.);
    batch.F[1][0][0] = 1.3;
    batch.F[3][0][0] = 1.5;
    batch.F[4][0][0] = 1.15;
  }
}

// Who throws a batch away as a whole does not wait for the rest of it, and hears of every call.
BOOST_AUTO_TEST_CASE(the_first_failure_may_end_a_batch) {
  const auto rve = std::make_shared<FakeRve<2>>();
  rve->fails_above = 1.2;
  Batch<2> batch(6);
  batch.F[1][0][0] = batch.F[4][0][0] = 1.3;
  RveLawSettings settings;
  settings.first_failure_ends = true;
  int told = 0;
  settings.each_call = [&] { ++told; };
  RveLaw<2> law(rve, settings);
  law.set_points(batch.points);
  LawAnswer<2> answer;
  law.evaluate(batch.F, batch.F_dot, {}, answer);
  BOOST_TEST(rve->calls == 2);
  BOOST_TEST(told == 2);
  BOOST_TEST_REQUIRE(answer.failed.size() == 1u);
  BOOST_TEST(answer.failed[0].point == 1u);
  BOOST_CHECK_THROW(law.commit(), std::logic_error);
  batch.F[1][0][0] = batch.F[4][0][0] = 1.;
  law.evaluate(batch.F, batch.F_dot, {}, answer);
  BOOST_TEST(answer.failed.empty());
  BOOST_TEST(told == 8);
  law.commit();
}

// Answers that drag has helped to are counted by themselves, and so is what they leave out of balance.
BOOST_AUTO_TEST_CASE(answers_under_drag_are_counted) {
  auto rve = std::make_shared<FakeRve<2>>();
  rve->drags_above = 1.25;
  RveLaw<2> law(rve, {});
  Batch<2> batch(5);
  law.set_points(batch.points);
  for (auto &f : batch.F) f[0][0] = 1.;
  LawAnswer<2> answer;
  law.evaluate(batch.F, batch.F_dot, {}, answer);
  BOOST_TEST(law.statistics().dragged_calls == 0u);
  batch.F[1][0][0] = batch.F[4][0][0] = 1.3;
  law.evaluate(batch.F, batch.F_dot, {}, answer);
  BOOST_TEST(law.statistics().dragged_calls == 2u);
  BOOST_TEST(law.statistics().calls == 10u);
  BOOST_TEST(law.statistics().max_dragged_residual == 0.5);
  BOOST_TEST(law.statistics().max_residual == 1e-9);
}

BOOST_AUTO_TEST_CASE(same_bits_on_one_and_two_threads) {
  std::vector<std::string> bytes;
  std::vector<std::vector<dealii::Tensor<2, 2>>> stresses;
  for (const unsigned int threads : {1u, 2u}) {
    RveLawSettings settings;
    settings.threads = threads;
    RveLaw<2> law(std::make_shared<FakeRve<2>>(), settings);
    Batch<2> batch(203);
    law.set_points(batch.points);
    LawAnswer<2> answer;
    for (int step = 0; step < 20; ++step) {
      for (auto &f : batch.F) f[0][0] *= 1.001;
      law.evaluate(batch.F, batch.F_dot, {}, answer);
      law.commit();
    }
    stresses.push_back(answer.P);
    std::string states;
    for (const RveState<2> &s : law.states(all(203)))
      states.append(reinterpret_cast<const char *>(s.unknowns.data()), s.unknowns.size() * sizeof(double));
    bytes.push_back(states);
  }
  BOOST_TEST((stresses[0] == stresses[1]));
  BOOST_TEST((bytes[0] == bytes[1]));
}

BOOST_AUTO_TEST_CASE(save_and_load_bitwise) {
  Batch<2> batch(9);
  RveLaw<2> law(std::make_shared<FakeRve<2>>(), {});
  law.set_points(batch.points);
  LawAnswer<2> answer, resumed_answer;
  for (int step = 0; step < 3; ++step) {
    law.evaluate(batch.F, batch.F_dot, {}, answer);
    law.commit();
  }
  law.evaluate(batch.F, batch.F_dot, {}, answer);  // a trial is no history: not saved
  const std::string text = archived(law);

  RveLaw<2> resumed(std::make_shared<FakeRve<2>>(), {});
  resumed.set_points(batch.points);
  restore(text, resumed);
  BOOST_TEST((archived(resumed) == text));
  law.evaluate(batch.F, batch.F_dot, {}, answer);
  law.commit();
  resumed.evaluate(batch.F, batch.F_dot, {}, resumed_answer);
  resumed.commit();
  BOOST_TEST((answer.P == resumed_answer.P));
  const auto a = law.states(all(9)), b = resumed.states(all(9));
  for (std::size_t p = 0; p < 9; ++p) BOOST_TEST((a[p].unknowns == b[p].unknowns));
}

BOOST_AUTO_TEST_CASE(damaged_checkpoints_are_refused) {
  Batch<2> batch(4);
  RveLaw<2> law(std::make_shared<FakeRve<2>>(), {});
  law.set_points(batch.points);
  const std::string text = archived(law);
  for (std::size_t length = 0; length < text.size(); length += 13)
    BOOST_CHECK_THROW(restore(text.substr(0, length), law), ArchiveError);
  RveLaw<2> other(std::make_shared<FakeRve<2>>(), {});
  other.set_points(Batch<2>(3).points);
  BOOST_CHECK_EXCEPTION(restore(text, other), ArchiveError, [](const ArchiveError &e) {
    return std::string(e.what()) ==
           "The checkpoint belongs to another mesh or scene: it holds 4 entries in its section 'RVEs' where "
           "this run has 3.";
  });
}

// A batch may last for minutes: the wish to stop ends it between two RVEs, and nothing of it stays.
BOOST_AUTO_TEST_CASE(a_wish_to_stop_ends_a_batch) {
  RveLaw<2> law(std::make_shared<FakeRve<2>>(), {});
  const Batch<2> batch(7);
  law.set_points(batch.points);
  LawAnswer<2> answer;
  law.evaluate(batch.F, batch.F_dot, {}, answer);
  law.commit();
  const std::string before = archived(law);
  const std::uint64_t calls = law.statistics().calls;
  request_stop();
  BOOST_CHECK_THROW(law.evaluate(batch.F, batch.F_dot, {}, answer), RunStopped);
  request_stop(false);
  BOOST_TEST(law.statistics().calls == calls);
  BOOST_TEST(archived(law) == before);
  law.evaluate(batch.F, batch.F_dot, {}, answer);
  BOOST_TEST(answer.failed.empty());
}

BOOST_AUTO_TEST_SUITE_END()
