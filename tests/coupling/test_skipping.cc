// Certified skipping (coupling/skipping.h): records, symmetry, audits and their bounds, history; the same
// bits on threads, ranks and after a resume are tested here with an RVE on paper and in
// test_tissue_gravity.cc by the program.
#include "coupling/rve_law.h"
#include "rve/make_rve.h"
#include "run/archive.h"
#include "tests/coupling/smooth_rve.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>

using namespace turgor;
using turgor::test::SmoothRve;

namespace {
using Deformation = std::vector<dealii::Tensor<2, 2>>;

Tensor2<2> rotation(const double angle) {
  Tensor2<2> R;
  R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return R;
}

dealii::Tensor<2, 2> to_tensor_of_dealii(const Tensor2<2> &a) {
  dealii::Tensor<2, 2> b;
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j) b[i][j] = a(i, j);
  return b;
}

// Strains of a few per cent that drift and turn, different for every point.
Tensor2<2> deformation(const std::size_t point, const double t) {
  const double a = 0.03 * std::sin(2. * t + 0.1 * double(point)),
               b = 0.02 * std::sin(3. * t + 0.07 * double(point)),
               c = 0.02 * std::sin(t + 0.2 * double(point));
  Tensor2<2> U;
  U << 1. + a, c, c, 1. + b;
  return rotation(0.3 * std::sin(t + double(point))) * U;
}

Deformation batch(const std::size_t n, const double t) {
  Deformation F;
  for (std::size_t p = 0; p < n; ++p) F.push_back(to_tensor_of_dealii(deformation(p, t)));
  return F;
}

SkippingSettings certified(const double tolerance, const double audits = 0.02) {
  SkippingSettings s;
  s.certified = true;
  s.tolerance = tolerance;
  s.audit_share = audits;
  return s;
}

LawRequest step(const double time) {
  LawRequest r;
  r.time = time;
  r.time_since_commit = 1e-6;
  return r;
}

RveLawSettings law_settings(const SkippingSettings &skipping, const unsigned int threads = 1) {
  RveLawSettings s;
  s.threads = threads;
  s.skipping = skipping;
  return s;
}

double difference(const dealii::Tensor<2, 2> &a, const Tensor2<2> &b) {
  double sum = 0.;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) sum += (a[i][j] - b(i, j)) * (a[i][j] - b(i, j));
  return std::sqrt(sum);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(skipping)

BOOST_AUTO_TEST_CASE(images_of_a_strain) {
  Tensor2<2> mirror, swap;
  mirror << 1., 0., 0., -1.;
  swap << 0., 1., 1., 0.;
  const StrainFolding<2> none({}), square({mirror, swap, swap * mirror});
  std::vector<Tensor2<2>> twelve;
  for (int k = 0; k < 6; ++k)
    for (const Tensor2<2> &m : {Tensor2<2>(Tensor2<2>::Identity()), mirror})
      twelve.push_back(rotation(k * std::numbers::pi / 3.) * m);
  const StrainFolding<2> hexagon(twelve);
  BOOST_TEST(none.size() == 1u);
  BOOST_TEST(square.size() == 4u);  // the eight of the square, Q and -Q alike
  BOOST_TEST(hexagon.size() == 6u);
  BOOST_CHECK_THROW(StrainFolding<2>({Tensor2<2>(2. * mirror)}), std::invalid_argument);
  for (const StrainFolding<2> *folding : {&square, &hexagon})
    for (const Tensor2<2> &Q : folding == &square ? std::vector<Tensor2<2>>{mirror, swap} : twelve) {
      const Tensor2<2> F = deformation(3, 0.4);
      StrainVector<2> e = green_strain<2>(F), image = green_strain<2>(F * Q);
      const StrainVector<2> before = e;
      const std::size_t k = folding->fold(e);
      folding->fold(image);
      BOOST_TEST((e - image).norm() < 1e-15);
      BOOST_TEST((folding->image(k) * before - e).norm() < 1e-15);
      BOOST_TEST((folding->image(k).transpose() * e - before).norm() < 1e-15);
    }
}

// The network itself: its symmetries, and a record's error that falls as |dE|^2.
BOOST_AUTO_TEST_CASE(record_of_a_network) {
  RveParameters parameters;
  parameters.cell.nodes_per_side = 8;
  parameters.tolerance = 1e-10;
  parameters.structure.rotation = 20.;
  const auto rve = make_rve(parameters);
  const auto workspace = rve->make_workspace();
  const auto at = [&](const Tensor2<2> &F, const Tensor2<2> &F_dot) {
    RveRequest request;
    request.tangent = true;
    return rve->evaluate(rve->initial_state(), F, F_dot, request, *workspace);
  };
  const double mu = rve->flow_viscosity();
  const std::optional<CellContent> content = SkippingSettings().with(parameters).content;
  const Tensor2<2> shape = deformation(5, 0.7),
                   F = 0.995 / std::sqrt(shape.determinant()) * shape;  // the fluid does not cavitate
  Tensor2<2> F_dot;
  F_dot << 30., 10., -20., 5.;
  const RveAnswer<2> here = at(F, F_dot);
  for (const Tensor2<2> &Q : rve->symmetries())
    BOOST_TEST((at(Q.transpose() * F * Q, Q.transpose() * F_dot * Q).P - Q.transpose() * here.P * Q).norm() <
               1e-6 * here.P.norm());

  const StrainFolding<2> folding(rve->symmetries());
  const AffineFlow<2> flow(mu, F, F_dot);
  const auto record = AnswerRecord<2>::from(F, here.P - flow.P(), here.tangent - flow.tangent(), here.energy,
                                            here.pressure, folding, content);
  const auto error = [&](const AnswerRecord<2> &from, const std::optional<CellContent> &known,
                         const double size, double &energy_error) {
    Tensor2<2> change;
    change << 1., 0.5, -0.3, 0.7;
    const Tensor2<2> there = rotation(0.4) * (F + size * change);
    StrainVector<2> E = green_strain<2>(there);
    const std::size_t k = folding.fold(E);
    const RveAnswer<2> truth = at(there, Tensor2<2>::Zero());
    const VolumeLaw<2> water(known, E);
    energy_error = std::abs(from.energy_at(E, water) - truth.energy);
    return (there * to_tensor<2>(folding.image(k).transpose() * from.stress_at(E, water)) - truth.P).norm();
  };
  double energy_far = 0., energy_near = 0., energy_here = 0.;
  const double far = error(record, content, 4e-3, energy_far),
               near = error(record, content, 2e-3, energy_near);
  BOOST_TEST(error(record, content, 0., energy_here) < 1e-6 * here.P.norm());
  // What the water does is most of what a linear stress misses.
  const auto linear = AnswerRecord<2>::from(F, here.P - flow.P(), here.tangent - flow.tangent(), here.energy,
                                            here.pressure, folding, {});
  double linear_energy = 0.;
  BOOST_TEST_MESSAGE("error of the stress: " << near << " Pa, linear "
                                             << error(linear, {}, 2e-3, linear_energy));
  BOOST_TEST(error(linear, {}, 2e-3, linear_energy) > 5. * near);
  BOOST_TEST(linear_energy > 5. * energy_near);
  BOOST_TEST(std::log2(far / near) > 1.8);
  BOOST_TEST(std::log2(energy_far / energy_near) > 2.7);

  // The tangent of the record at its own strain, the flow's part included, is the RVE's.
  StrainVector<2> E = green_strain<2>(F);
  const StrainMatrix<2> image = folding.image(folding.fold(E));
  const VolumeLaw<2> water(content, E);
  const Tensor4<2> again = elastic_tangent<2>(F, image.transpose() * record.stress_at(E, water),
                                              image.transpose() * (record.C + water.tangent()) * image) +
                           flow.tangent();
  BOOST_TEST((again - here.tangent).norm() < 1e-6 * here.tangent.norm());
}

// Liquid and cavitated.
template <int dim>
void check_volume_law(const double shift) {
  const EquationOfState fluid(1000., 6e6, -1e5);
  const CellContent content{fluid, fluid.density_at(2e5)};
  const double K = 4.2e7, h = 1e-6;
  StrainVector<dim> E;
  for (int k = 0; k < E.size(); ++k) E[k] = 0.02 * std::sin(1. + 2.3 * k) + (k < dim ? shift : 0.);
  const VolumeLaw<dim> here(content, E);
  const StrainMatrix<dim> tangent = here.tangent();
  BOOST_TEST((here.pressure() < -1e5) == (shift > 0.));
  for (int k = 0; k < E.size(); ++k) {
    const StrainVector<dim> step = h * StrainVector<dim>::Unit(k);
    const VolumeLaw<dim> up(content, E + step), down(content, E - step);
    BOOST_TEST(std::abs((up.energy() - down.energy()) / (2. * h) - here.stress()[k]) < 1e-6 * K);
    BOOST_TEST(((up.stress() - down.stress()) / (2. * h) - tangent.col(k)).norm() < 1e-6 * K);
  }
  BOOST_TEST((tangent - tangent.transpose()).norm() < 1e-12 * K);
  // Stretched alike in all directions: S = -p J/lambda^2.
  const double lambda = 0.99, J = std::pow(lambda, dim), p = fluid.pressure(content.density / J);
  const VolumeLaw<dim> pressed(content,
                               to_vector<dim>(0.5 * (lambda * lambda - 1.) * Tensor2<dim>::Identity()));
  BOOST_TEST(pressed.pressure() == p, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(pressed.stress()[0] == -p * J / (lambda * lambda), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(VolumeLaw<dim>({}, E).tangent().norm() == 0.);
}

BOOST_AUTO_TEST_CASE(fluid_against_differences) {
  for (const double shift : {-0.03, 0.03}) {
    check_volume_law<2>(shift);
    check_volume_law<3>(shift);
  }
}

BOOST_AUTO_TEST_CASE(within_the_tolerance_and_far_fewer_calls) {
  const auto rve = std::make_shared<SmoothRve>();
  const std::size_t n = 60;
  RveLaw<2> law(rve, law_settings(certified(100.)));
  law.set_points(std::vector<dealii::Point<2>>(n));
  LawAnswer<2> answer;
  double worst = 0., square = 0., largest = 0.;
  std::vector<double> work(n), first(n), last_energy(n);
  Deformation before;
  std::vector<dealii::Tensor<2, 2>> P_before;
  std::size_t asks = 0;
  for (int k = 0; k <= 600; ++k) {
    const Deformation F = batch(n, 0.005 * k);
    Deformation F_dot(n);
    law.evaluate(F, F_dot, step(k), answer);
    law.commit();
    for (std::size_t p = 0; p < n; ++p, ++asks) {
      const double error = difference(answer.P[p], rve->elastic_P(deformation(p, 0.005 * k)));
      worst = std::max(worst, error);
      largest = std::max(largest, answer.P[p].norm());
      square += error * error;
      if (k == 0)
        first[p] = answer.energy[p];
      else
        work[p] += 0.5 * dealii::scalar_product(answer.P[p] + P_before[p], F[p] - before[p]);
      last_energy[p] = answer.energy[p];
    }
    before = F;
    P_before = answer.P;
  }
  BOOST_TEST(asks > 8u * std::size_t(rve->calls));
  BOOST_TEST(worst < 200.);
  BOOST_TEST(std::sqrt(square / double(asks)) < 60.);
  for (std::size_t p = 0; p < n;
       ++p)  // energy and stress of one record: the balance closes but for the jumps between records
    BOOST_TEST(std::abs(work[p] - (last_energy[p] - first[p])) < 2.);
  const Skipping<2> &skipping = *law.skipping();
  BOOST_TEST(skipping.statistics().asks == asks);
  BOOST_TEST(skipping.worthwhile());
  BOOST_TEST(skipping.audit().rms_bound() < 100.);
  BOOST_TEST(law.statistics().largest_stress == largest, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(an_error_is_told_beside_turgor_and_the_largest_stress) {
  BOOST_TEST(
      beside(90., 200e3, 30e3) ==
      "90 Pa are 0.045 % of turgor (200 kPa) and 0.3 % of the run's largest stress (30 kPa, norm of P)");
  BOOST_TEST(beside(90., 0., 30e3) == "90 Pa are 0.3 % of the run's largest stress (30 kPa, norm of P)");
  BOOST_TEST(beside(90., 0., 0.).empty());
}

BOOST_AUTO_TEST_CASE(turns_with_the_tissue_and_knows_the_flow_exactly) {
  const auto rve = std::make_shared<SmoothRve>();
  rve->mu = 1e3;
  RveLaw<2> law(rve, law_settings(certified(1000., 0.)));
  law.set_points(std::vector<dealii::Point<2>>(1));
  LawAnswer<2> answer;
  const Deformation F0 = {to_tensor_of_dealii(deformation(1, 0.2))};
  law.evaluate(F0, Deformation(1), step(0.), answer);
  law.commit();
  const int calls = rve->calls;
  const Tensor2<2> F = deformation(1, 0.2) * (Tensor2<2>() << 1.001, 2e-4, 0., 0.9993).finished(),
                   R = rotation(1.2);
  Tensor2<2> F_dot;
  F_dot << 3., -1., 2., 0.5;
  LawRequest request = step(1.);
  request.tangents = true;
  LawAnswer<2> turned;
  law.evaluate({to_tensor_of_dealii(F)}, {to_tensor_of_dealii(F_dot)}, request, answer);
  law.evaluate({to_tensor_of_dealii(R * F)}, {to_tensor_of_dealii(R * F_dot)}, request, turned);
  BOOST_TEST(rve->calls == calls);
  Tensor2<2> P;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) P(i, j) = answer.P[0][i][j];
  BOOST_TEST(difference(turned.P[0], R * P) < 1e-12 * P.norm());
  BOOST_TEST(difference(answer.viscous[0], AffineFlow<2>(1e3, F, F_dot).P()) == 0.);
  // dP/dF by differences of the answers themselves
  const double h = 1e-6;
  for (unsigned int c = 0; c < 2; ++c)
    for (unsigned int d = 0; d < 2; ++d) {
      LawAnswer<2> up, down;
      Tensor2<2> more = F, less = F;
      more(c, d) += h;
      less(c, d) -= h;
      law.evaluate({to_tensor_of_dealii(more)}, {to_tensor_of_dealii(F_dot)}, request, up);
      law.evaluate({to_tensor_of_dealii(less)}, {to_tensor_of_dealii(F_dot)}, request, down);
      for (unsigned int a = 0; a < 2; ++a)
        for (unsigned int b = 0; b < 2; ++b)
          BOOST_TEST(std::abs((up.P[0][a][b] - down.P[0][a][b]) / (2. * h) - answer.tangent[0][a][b][c][d]) <
                     10.);
    }
}

// Bounds from a sample against all errors, which are known here.
BOOST_AUTO_TEST_CASE(bounds_hold_in_95_of_100) {
  const auto rve = std::make_shared<SmoothRve>();
  const std::size_t n = 20;
  int rms_holds = 0, percentile_holds = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SkippingSettings settings = certified(100., 0.03);
    settings.seed = seed;
    Skipping<2> skipping(*rve, settings);
    skipping.set_points(n);
    std::vector<double> errors;
    auto workspace = rve->make_workspace();
    for (int k = 0; k < 700; ++k) {
      const Deformation F = batch(n, 0.005 * k), F_dot(n);
      LawRequest columns;
      columns.tangents = true;
      AnswerTable<2> table(n, columns);
      for (skipping.begin(F, step(k)); !skipping.calls().empty(); skipping.learn(F_dot, table))
        for (const std::size_t p : skipping.calls()) {
          RveRequest request;
          request.tangent = true;
          table.put(p, rve->evaluate(rve->initial_state(), deformation(p, 0.005 * k), Tensor2<2>::Zero(),
                                     request, *workspace));
        }
      for (std::size_t p = 0; p < n; ++p)
        if (skipping.from_table(p))
          errors.push_back(
              (skipping.answer(p, Tensor2<2>::Zero(), step(k)).P - rve->elastic_P(deformation(p, 0.005 * k)))
                  .norm());
      skipping.end();
      skipping.commit();
    }
    double square = 0.;
    for (const double e : errors) square += e * e;
    const auto rank = errors.begin() + std::ptrdiff_t(std::ceil(0.99 * double(errors.size()))) - 1;
    std::nth_element(errors.begin(), rank, errors.end());
    BOOST_TEST_REQUIRE(skipping.audit().count() >= SkippingAudit::enough);
    rms_holds += std::sqrt(square / double(errors.size())) <= skipping.audit().rms_bound();
    percentile_holds += *rank <= skipping.audit().percentile_bound();
  }
  BOOST_TEST_MESSAGE("bounds of rms and percentile hold in " << rms_holds << " and " << percentile_holds
                                                             << " of 100 runs");
  BOOST_TEST(rms_holds >= 91);
  BOOST_TEST(percentile_holds >= 91);
}

// Errors with an exponential tail, and of known percentile: the sample alone.
BOOST_AUTO_TEST_CASE(bounds_of_heavy_tails) {
  int rms_holds = 0, percentile_holds = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SkippingAudit audit;
    for (std::uint64_t k = 0; k < 60000; ++k)
      if (skipping_drawn(seed, k, 0.01)) {
        const double u = (double(k) + 0.5) / 60000.;
        audit.add(std::pow(-std::log(1. - u), 1.));  // exponential: rms sqrt(2), percentile ln 100
      }
    rms_holds += audit.rms_bound() >= std::sqrt(2.);
    percentile_holds += audit.percentile_bound() >= std::log(100.);
  }
  BOOST_TEST(rms_holds >= 368);  // 92 %, two standard deviations below 95 % of 400
  BOOST_TEST(percentile_holds >= 368);
}

BOOST_AUTO_TEST_CASE(too_few_audits_give_no_bound) {
  SkippingAudit audit;
  BOOST_TEST(std::isinf(audit.rms_bound()));
  for (int k = 0; k < 298; ++k) audit.add(1. + k);
  BOOST_TEST(std::isfinite(audit.rms_bound()));
  BOOST_TEST(std::isinf(audit.percentile_bound()));
  audit.add(1000.);
  BOOST_TEST(audit.percentile_bound() == 1000.);
  BOOST_TEST(audit.worst() == 1000.);
}

BOOST_AUTO_TEST_CASE(a_refuted_record_shrinks) {
  AnswerRecords<2> records(100., 1e7);
  AnswerRecord<2> record;
  record.E = StrainVector<2>::Zero();
  record.S = StrainVector<2>::Zero();
  record.C = 1e6 * StrainMatrix<2>::Identity();
  const std::size_t k = records.add(record, 1.);
  const double before = records[k].radius;
  StrainVector<2> E = StrainVector<2>::Zero();
  E[0] = 0.9 * before;
  BOOST_TEST(records.find(E) == k);
  records.refute(k, 250., E.norm());
  BOOST_TEST(records[k].radius < 0.8 * E.norm());
  BOOST_TEST((records.find(E) == records.none));
  BOOST_TEST((records.find(E, k) == records.none));
  BOOST_TEST(records.find(StrainVector<2>::Zero()) == k);
  records.refute(k, 1., E.norm());  // never grows
  BOOST_TEST(records[k].radius < 0.8 * E.norm());

  // What a second record shows of the first, and a reach that is bounded.
  AnswerRecords<2> two(100., 1e7);
  two.add(record, 1.);
  AnswerRecord<2> other = record;
  other.E[0] = 2. * before;
  other.S[0] = 1e6 * 2. * before + 0.5 * 4e7 * 4. * before * before;
  other.C(0, 0) = 1e6 + 4e7 * 2. * before;
  two.add(other, 1e-5);
  BOOST_TEST(two[1].radius == 1e-5);
  BOOST_TEST(two[1].curvature == 4e7, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(two[0].radius == before);
  two.learn(1);
  BOOST_TEST(two[0].radius == 0.5 * before, boost::test_tools::tolerance(1e-9));
  two.truncate(1);
  BOOST_TEST((two.find(other.E) == two.none));
  BOOST_TEST(two.size() == 1u);
}

BOOST_AUTO_TEST_CASE(history_is_called_in_full) {
  const auto rve = std::make_shared<SmoothRve>();
  rve->limit = 0.02;
  const std::size_t n = 20;
  RveLaw<2> law(rve, law_settings(certified(1000., 0.))), full(rve, {});
  for (RveLaw<2> *l : {&law, &full}) l->set_points(std::vector<dealii::Point<2>>(n));
  LawAnswer<2> answer, truth;
  bool some = false;
  for (int k = 0; k < 300; ++k) {
    law.evaluate(batch(n, 0.01 * k), Deformation(n), step(k), answer);
    full.evaluate(batch(n, 0.01 * k), Deformation(n), step(k), truth);
    law.commit();
    full.commit();
    std::vector<std::size_t> all(n);
    for (std::size_t p = 0; p < n; ++p) all[p] = p;
    const auto states = law.states(all), true_states = full.states(all);
    for (std::size_t p = 0; p < n; ++p) {
      // Where something happens, it happens in the same step and for good: no record reaches over the limit.
      BOOST_TEST(states[p].history[0] == true_states[p].history[0]);
      BOOST_TEST((states[p].F == true_states[p].F));  // brought up to date
      if (states[p].history[0] > 0.) {
        some = true;
        BOOST_TEST((answer.P[p] == truth.P[p]));
      }
    }
  }
  BOOST_TEST(some);
  BOOST_TEST(law.skipping()->statistics().with_history > 0u);
  BOOST_TEST(law.skipping()->statistics().answered > 0u);
}

BOOST_AUTO_TEST_CASE(cheap_calls_are_all_made) {
  const auto rve = std::make_shared<SmoothRve>();
  rve->size = 2;
  RveLaw<2> law(rve, law_settings(certified(100.)));
  law.set_points(std::vector<dealii::Point<2>>(150));
  LawAnswer<2> answer;
  for (int k = 0; k < 200; ++k) {
    law.evaluate(batch(150, 0.02 * k), Deformation(150), step(k), answer);
    law.commit();
  }
  BOOST_TEST(!law.skipping()->worthwhile());
  const int before = rve->calls;
  law.evaluate(batch(150, 1.), Deformation(150), step(1.), answer);
  BOOST_TEST(rve->calls == before + 150);
}

BOOST_AUTO_TEST_CASE(rves_that_it_cannot_serve_are_refused) {
  class Other : public SmoothRve {
   public:
    double flow_viscosity() const override { return -1.; }
  };
  BOOST_CHECK_THROW(RveLaw<2>(std::make_shared<Other>(), law_settings(certified(100.))),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
