// A population of spheres in over-damped motion: pair list against all pairs, contact forces and momentum,
// the friction matrix against a dense solution, two cells by hand.
#include "micro/cells/cell_stress.h"
#include "micro/laws/counter_random.h"
#include "micro/engine/overdamped.h"
#include "micro/engine/system_motion.h"
#include "micro/terms/cell_motility.h"
#include "micro/terms/sphere_links.h"
#include "run/archive.h"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <set>

using namespace turgor;

namespace {
constexpr double radius_0 = 7e-6;

/// n cells in a cube in which they overlap by about a tenth of their radius.
Particles<3> crowd(const std::uint32_t n, const unsigned int seed) {
  Particles<3> p;
  p.resize(n);
  p.groups = {{0, 0, n}};
  p.declare("radius");
  p.declare("modulus");
  const double side = std::cbrt(double(n)) * 1.6 * radius_0;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (int d = 0; d < 3; ++d) p.x[d][i] = side * random_uniform(seed, 4 * std::uint64_t(i) + d);
    p.field("radius")[i] = radius_0 * (0.8 + 0.4 * random_uniform(seed, 4 * std::uint64_t(i) + 3));
    p.field("modulus")[i] = 450. * (1. + 0.1 * i / n);
  }
  return p;
}
}  // namespace

namespace {
struct FrictionParameters {
  double normal = 0., tangential = 0., tolerance = 1e-6;
};

/// Velocities of spheres from their forces, by contacts that stand in no system.
struct Friction {
  FrictionParameters parameters;
  MotionMatrix matrix;

  explicit Friction(const FrictionParameters &p) : parameters(p), matrix({.tolerance = p.tolerance}) {}
  void velocities(Particles<3> &p, SphereContacts &contacts, const std::vector<double> &gamma, const double h,
                  const unsigned int threads) {
    matrix.clear(gamma);
    contacts.friction = {.normal = parameters.normal, .tangential = parameters.tangential};
    contacts.collect(matrix, p, h);
    matrix.solve<3>(p.f, p.v, threads);
  }
  void velocities_again(Particles<3> &p, const unsigned int threads) { matrix.again<3>(p.f, p.v, threads); }
  unsigned int iterations() const { return matrix.iterations(); }
};

/// Spheres in a system of their own, each a group.
struct System {
  ParticleSystem<3> system;
  Particles<3> &p = system.particles;
  SystemMotion<3> motion{system, {}};

  System(const Particles<3> &cells, const PairFriction &friction, const double gamma,
         const unsigned int threads) {
    system.threads = threads;
    p = cells;
    p.groups.clear();
    for (std::uint32_t i = 0; i < p.size(); ++i) p.groups.push_back({i, i, i + 1});
    system.add(std::make_unique<SphereContacts>(HertzContact(), 1e-6)).friction = friction;
    motion.medium.assign(p.size(), gamma);
  }

  void move_at_random(const double diffusion, const std::uint64_t seed,
                      const std::vector<std::uint64_t> &id) {
    system.add(std::make_unique<CellMotility>(diffusion, seed));
    p.cells.resize(p.size());
    p.cells.column<std::uint64_t>("id") = id;
  }
};
}  // namespace

BOOST_AUTO_TEST_SUITE(cell_friction)

BOOST_AUTO_TEST_CASE(pair_list_has_all_pairs_and_keeps_their_history) {
  Particles<3> p = crowd(200, 3);
  const std::vector<double> &radius = p.field("radius");
  const double skin = 1e-6;
  PairList<3> list(skin);
  std::vector<unsigned char> touching;
  list.build(p, radius, touching);
  std::set<std::pair<std::uint32_t, std::uint32_t>> found;
  for (const Pair &pair : list.pairs()) found.insert({pair.i, pair.j});
  BOOST_TEST(found.size() == list.pairs().size());  // each once
  std::size_t expected = 0;
  for (std::uint32_t i = 0; i < 200; ++i)
    for (std::uint32_t j = i + 1; j < 200; ++j)
      if ((p.position(j) - p.position(i)).norm() < radius[i] + radius[j] + skin) {
        ++expected;
        BOOST_TEST(found.count({i, j}) == 1u);
      }
  BOOST_TEST(expected == found.size());
  for (std::uint32_t i = 0; i < 200; ++i)
    for (std::uint32_t k = list.first()[i]; k < list.first()[i + 1]; ++k) {
      const Pair pair = list.pairs()[list.own()[k]];
      BOOST_TEST((pair.i == i || pair.j == i));
      BOOST_TEST(list.other()[k] == (pair.i == i ? pair.j : pair.i));
    }
  // marks of some pairs survive a new list, for those that are still in it
  std::set<std::pair<std::uint32_t, std::uint32_t>> marked;
  for (std::size_t k = 0; k < touching.size(); k += 3) {
    touching[k] = 1;
    marked.insert({list.pairs()[k].i, list.pairs()[k].j});
  }
  for (std::uint32_t i = 0; i < 200; ++i) p.x[0][i] += 1e-6 * random_uniform(5, i);
  BOOST_TEST(list.stale(p, radius));
  list.build(p, radius, touching);
  for (std::size_t k = 0; k < touching.size(); ++k)
    BOOST_TEST(bool(touching[k]) == (marked.count({list.pairs()[k].i, list.pairs()[k].j}) == 1));
}

BOOST_AUTO_TEST_CASE(forces_are_minus_the_slope_of_the_energy_and_balance) {
  for (const ContactLaw law :
       {ContactLaw(HertzContact()), ContactLaw(ExtendedHertzContact{1e-4}), ContactLaw(JkrContact{1e-4})}) {
    Particles<3> p = crowd(60, 4);
    SphereContacts contacts(law, 1e-6);
    contacts.add_forces(p, 1);
    const auto f = p.f;
    double size = 0.;
    for (int d = 0; d < 3; ++d) {
      double sum = 0.;
      for (const double value : f[d]) {
        sum += value;
        size = std::max(size, std::abs(value));
      }
      BOOST_CHECK_SMALL(sum, 1e-13 * 60 * size);
    }
    for (std::uint32_t i = 0; i < 60; i += 7)
      for (int d = 0; d < 3; ++d) {
        const double h = 1e-6 * radius_0, x = p.x[d][i];
        double e[2];
        for (int s = 0; s < 2; ++s) {
          p.x[d][i] = x + (s ? h : -h);
          contacts.add_forces(p, 1);
          e[s] = contacts.energy();
        }
        p.x[d][i] = x;
        // round-off: eps times the energy of all pairs over h
        BOOST_CHECK_SMALL((e[1] - e[0]) / (2. * h) + f[d][i],
                          1e-6 * size + 2.2e-16 * 100 * std::abs(e[0]) / h);
      }
  }
}

BOOST_DATA_TEST_CASE(friction_agrees_with_a_dense_solution_on_any_number_of_threads,
                     // more along the line, more across it, the same (no directions stored)
                     boost::unit_test::data::make({5e10, 2e10, 3e10}) ^
                         boost::unit_test::data::make({2e10, 5e10, 3e10}),
                     normal, tangential) {
  const std::uint32_t n = 150;  // no multiple of eight
  Particles<3> p = crowd(n, 6);
  SphereContacts contacts(HertzContact(), 1e-6);
  contacts.add_forces(p, 1);
  const std::vector<double> gamma(n, 1e-2);  // pair friction is about 0.5 N s/m
  FrictionParameters parameters{.normal = normal, .tangential = tangential, .tolerance = 1e-10};
  Friction friction(parameters);
  friction.velocities(p, contacts, gamma, 0., 1);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  Eigen::VectorXd F(3 * n), v(3 * n);
  for (std::size_t k = 0; k < contacts.contacts().size(); ++k) {
    const PairContact &c = contacts.contacts()[k];
    const auto [i, j] = contacts.list().pairs()[k];
    const Eigen::Vector3d e(c.e[0], c.e[1], c.e[2]);
    const Eigen::Matrix3d block =
        c.area * (parameters.normal * e * e.transpose() +
                  parameters.tangential * (Eigen::Matrix3d::Identity() - e * e.transpose()));
    A.block<3, 3>(3 * i, 3 * i) += block;
    A.block<3, 3>(3 * j, 3 * j) += block;
    A.block<3, 3>(3 * i, 3 * j) -= block;
    A.block<3, 3>(3 * j, 3 * i) -= block;
  }
  for (std::uint32_t i = 0; i < n; ++i)
    for (int d = 0; d < 3; ++d) {
      A(3 * i + d, 3 * i + d) += gamma[i];
      F[3 * i + d] = p.f[d][i];
      v[3 * i + d] = p.v[d][i];
    }
  const Eigen::VectorXd exact = A.ldlt().solve(F);
  // The residual is 1e-10 of F; the matrix's condition (pair over medium friction, below 1e4) turns that into
  // at most 1e-6.
  BOOST_CHECK_SMALL((A * v - F).norm() / F.norm(), 1.1e-10);
  BOOST_CHECK_SMALL((v - exact).norm() / exact.norm(), 1e-6);

  Particles<3> q = crowd(n, 6);
  SphereContacts same(HertzContact(), 1e-6);
  same.add_forces(q, 2);
  Friction(parameters).velocities(q, same, gamma, 0., 2);
  for (int d = 0; d < 3; ++d) BOOST_CHECK(p.v[d] == q.v[d]);
}

// What one pass makes of the contacts: the exact residual, the product in single precision, the inverse of
// the diagonal blocks.
BOOST_DATA_TEST_CASE(one_pass_gives_the_matrix_and_the_residual,
                     boost::unit_test::data::make({5e10, 2e10, 3e10, 3e10}) ^
                         boost::unit_test::data::make({2e10, 5e10, 3e10, 0.}) ^
                         boost::unit_test::data::make({0., 0., 0., 100.}),
                     normal, tangential, step) {
  const std::uint32_t n = 150;  // no multiple of eight
  Particles<3> p = crowd(n, 9);
  SphereContacts contacts(JkrContact{1e-4}, 1e-6);  // some pairs pull
  contacts.add_forces(p, 1);
  const PairFriction friction{normal, tangential, step};
  std::vector<double> gamma(n);
  std::vector<BodyVector> v(n), forces(n);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  Eigen::VectorXd F(3 * n), x(3 * n);
  for (std::uint32_t i = 0; i < n; ++i) {
    gamma[i] = 0.01 * (1. + random_uniform(10, i));
    for (int d = 0; d < 3; ++d) {
      v[i].v[d] = x[3 * i + d] = 1e-8 * (random_uniform(11, 3 * i + d) - 0.5);
      F[3 * i + d] = forces[i].v[d] = p.f[d][i];
      A(3 * i + d, 3 * i + d) = gamma[i];
    }
  }
  for (std::size_t k = 0; k < contacts.contacts().size(); ++k) {
    const PairContact &c = contacts.contacts()[k];
    const auto [i, j] = contacts.list().pairs()[k];
    const auto [along, across] = friction(c);
    const Eigen::Vector3d e(c.e[0], c.e[1], c.e[2]);
    const Eigen::Matrix3d block =
        along * e * e.transpose() + across * (Eigen::Matrix3d::Identity() - e * e.transpose());
    A.block<3, 3>(3 * i, 3 * i) += block;
    A.block<3, 3>(3 * j, 3 * j) += block;
    A.block<3, 3>(3 * i, 3 * j) -= block;
    A.block<3, 3>(3 * j, 3 * i) -= block;
  }
  LinkMatrix matrix;
  const SphereLinks links(contacts, friction);
  std::vector<Eight> r, Ax;
  const double square = matrix.assemble({&links}, gamma, nullptr, {{}, forces.data()}, v, r, 1);
  const Eigen::VectorXd rest = F - A * x, product = A * x;
  BOOST_TEST(square == rest.squaredNorm(), boost::test_tools::tolerance(1e-12));
  std::vector<FloatRow> rows(8 * matrix.eights());
  Ax.resize(matrix.eights());
  for (std::uint32_t i = 0; i < n; ++i)
    for (int d = 0; d < 3; ++d) rows[i][d] = float(x[3 * i + d] * 1e8);
  const double xAx = matrix.product(0, matrix.eights(), rows, Ax);
  BOOST_TEST(xAx * 1e-16 == x.dot(product), boost::test_tools::tolerance(1e-5));
  Eigen::VectorXd r_error(3 * n), product_error(3 * n);
  for (std::uint32_t i = 0; i < n; ++i) {
    const Eight unit[3] = {
        {EightFloats{} + 1.f, {}, {}}, {{}, EightFloats{} + 1.f, {}}, {{}, {}, EightFloats{} + 1.f}};
    Eigen::Matrix3d inverse;
    for (int d = 0; d < 3; ++d) {
      const Eight column = matrix.preconditioned(i / 8, unit[d]);
      inverse.col(d) << column.x[i % 8], column.y[i % 8], column.z[i % 8];
    }
    const Eigen::Matrix3d block = A.block<3, 3>(3 * i, 3 * i);
    BOOST_CHECK_SMALL((inverse * block - Eigen::Matrix3d::Identity()).norm(),
                      1e-6 * block.norm() * inverse.norm());
    r_error.segment<3>(3 * i) << r[i / 8].x[i % 8], r[i / 8].y[i % 8], r[i / 8].z[i % 8];
    product_error.segment<3>(3 * i) << Ax[i / 8].x[i % 8], Ax[i / 8].y[i % 8], Ax[i / 8].z[i % 8];
  }
  r_error -= rest;
  product_error -= 1e8 * product;
  BOOST_CHECK_SMALL(r_error.norm(), 1e-7 * rest.norm());
  BOOST_CHECK_SMALL(product_error.norm(), 1e-6 * 1e8 * product.norm());
}

// Several chunks of rows, shared out over threads.
BOOST_AUTO_TEST_CASE(a_large_matrix_gives_the_same_bits_on_two_threads) {
  std::vector<double> ends[2];
  for (const unsigned int threads : {1u, 2u}) {
    Particles<3> p = crowd(3001, 7);
    SphereContacts contacts(HertzContact(), 1e-6);
    contacts.add_forces(p, threads);
    Friction friction({.normal = 5e10, .tangential = 2e10});
    friction.velocities(p, contacts, std::vector<double>(3001, 0.1), 0., threads);
    BOOST_TEST(friction.iterations() > 0u);
    ends[threads - 1] = p.v[2];
  }
  BOOST_CHECK(ends[0] == ends[1]);
}

// Two cells drawn along their line: relative velocity 2 F/(gamma + 2 A normal) each way; across it with the
// tangential one.
BOOST_AUTO_TEST_CASE(two_cells_by_hand) {
  Particles<3> p;
  p.resize(2);
  p.groups = {{0, 0, 2}};
  p.declare("radius");
  p.declare("modulus");
  p.field("radius") = {2., 2.};
  p.field("modulus") = {1., 1.};
  p.x[0] = {0., 3.};
  SphereContacts contacts(HertzContact(), 0.1);
  contacts.add_forces(p, 1);
  // R = 1, E = 1/2, delta = 1: 2/3 N, area pi
  BOOST_TEST(p.f[0][1] == 2. / 3., boost::test_tools::tolerance(1e-14));
  const std::vector<double> gamma = {0.5, 0.5};
  Friction friction({.normal = 3., .tangential = 2., .tolerance = 1e-12});
  p.f[1] = {-1., 1.};
  friction.velocities(p, contacts, gamma, 0., 1);
  const double area = std::numbers::pi;
  BOOST_TEST(p.v[0][1] == 2. / 3. / (0.5 + 2. * area * 3.), boost::test_tools::tolerance(1e-10));
  BOOST_TEST(p.v[1][1] == 1. / (0.5 + 2. * area * 2.), boost::test_tools::tolerance(1e-10));
  BOOST_TEST(p.v[0][0] == -p.v[0][1], boost::test_tools::tolerance(1e-10));
  // stress of a cell: force times the way to the contact plane
  std::vector<Tensor2<3>> virial;
  cell_virials(p, contacts, 1, virial);
  BOOST_TEST(virial[0](0, 0) == -2. / 3. * 1.5, boost::test_tools::tolerance(1e-14));
}

// Cells that go leave nothing behind in the solver (lanes that fill up the last eight once were cells).
BOOST_AUTO_TEST_CASE(a_population_that_shrinks_is_solved_as_a_new_one) {
  for (const std::uint32_t n : {61u, 57u}) {
    Friction used({.normal = 5e10, .tangential = 2e10, .tolerance = 1e-9}),
        fresh({.normal = 5e10, .tangential = 2e10, .tolerance = 1e-9});
    for (const std::uint32_t cells : {64u, n}) {
      Particles<3> p = crowd(cells, 8);
      SphereContacts contacts(HertzContact(), 1e-6);
      contacts.add_forces(p, 1);
      const std::vector<double> gamma(cells, 0.1);
      if (cells == n) {
        Particles<3> q = p;
        fresh.velocities(q, contacts, gamma, 0., 1);
        used.velocities(p, contacts, gamma, 0., 1);
        BOOST_CHECK(p.v == q.v);
      } else
        used.velocities(p, contacts, gamma, 0., 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(forces_that_are_no_numbers_are_refused) {
  Particles<3> p = crowd(20, 8);
  SphereContacts contacts(HertzContact(), 1e-6);
  contacts.add_forces(p, 1);
  p.f[1][3] = NAN;
  Friction friction({.normal = 5e10, .tangential = 2e10});
  BOOST_CHECK_EXCEPTION(
      friction.velocities(p, contacts, std::vector<double>(20, 0.1), 0., 1), std::runtime_error,
      [](const auto &e) { return std::string(e.what()).find("no numbers any more") != std::string::npos; });
}

// The same matrix for other forces: Gamma v = F once more, against its own residual by momentum: sum gamma_i
// v_i = sum F_i.
BOOST_AUTO_TEST_CASE(the_matrix_solves_again_for_other_forces) {
  const std::uint32_t n = 300;
  Particles<3> p = crowd(n, 8);
  SphereContacts contacts(HertzContact(), 1e-6);
  contacts.add_forces(p, 1);
  const std::vector<double> gamma(n, 0.1);
  Friction friction({.normal = 5e10, .tangential = 2e10, .tolerance = 1e-11});
  friction.velocities(p, contacts, gamma, 0., 1);
  const auto first = p.v;
  for (int d = 0; d < 3; ++d)
    for (std::uint32_t i = 0; i < n; ++i) p.f[d][i] *= -3.;
  friction.velocities_again(p, 2);
  double size = 0., worst = 0., momentum = 0., forces = 0.;
  for (int d = 0; d < 3; ++d)
    for (std::uint32_t i = 0; i < n; ++i) {
      size = std::max(size, std::abs(first[d][i]));
      worst = std::max(worst, std::abs(p.v[d][i] + 3. * first[d][i]));
      if (d == 0) {
        p.f[0][i] = i == 0;  // a force that does not sum to zero
        forces += p.f[0][i];
      } else
        p.f[d][i] = 0.;
    }
  BOOST_CHECK_SMALL(worst, 1e-7 * size);  // residual 1e-11 times the condition, below 1e3 here
  friction.velocities_again(p, 1);
  for (std::uint32_t i = 0; i < n; ++i) momentum += gamma[i] * p.v[0][i];
  BOOST_TEST(momentum == forces, boost::test_tools::tolerance(1e-9));
  for (auto &f : p.f) std::fill(f.begin(), f.end(), 0.);
  friction.velocities_again(p, 1);
  BOOST_TEST(p.v[0][0] == 0.);  // no force, no motion, and no search for it
}

// Cells far apart that move by themselves in the engine, every method: <x^2> = 6 D t, same bits on two
// threads.
BOOST_AUTO_TEST_CASE(motility_in_the_engine) {
  constexpr double D = 1e-16;
  const std::uint32_t n = 4000;
  for (const auto method : {OverdampedMethod::euler, OverdampedMethod::heun, OverdampedMethod::implicit}) {
    std::vector<double> ends[2];
    for (const unsigned int threads : {1u, 2u}) {
      Particles<3> p = crowd(n, 2);
      std::vector<std::uint64_t> id(n);
      for (std::uint32_t i = 0; i < n; ++i) {
        id[i] = i;
        for (int d = 0; d < 3; ++d) p.x[d][i] = d == 0 ? 1e-3 * i : 0.;
      }
      System all(p, {.normal = 5e10, .tangential = 5e10}, 0.3, threads);
      Overdamped<3> stepper({.method = method, .first_step = 50., .longest_step = 100.}, all.motion, threads);
      all.move_at_random(D, 4, id);
      double t = 0.;
      while (t < 1000.) t += stepper.step(all.p, 1000. - t);
      double sum = 0.;
      for (std::uint32_t i = 0; i < n; ++i)
        sum += (all.p.position(i) - Vector<3>(1e-3 * i, 0., 0.)).squaredNorm() / n;
      BOOST_CHECK_SMALL(sum / (6. * D * t) - 1., 4. * std::sqrt(2. / (3. * n)));
      ends[threads - 1] = all.p.x[1];
    }
    BOOST_CHECK(ends[0] == ends[1]);
  }
}

// Several chunks of cells, steps taken back among them.
BOOST_AUTO_TEST_CASE(steps_of_a_large_population_have_the_same_bits_on_two_threads) {
  const std::uint32_t n = 9001;
  for (const auto method : {OverdampedMethod::euler, OverdampedMethod::heun, OverdampedMethod::implicit})
    for (const bool mean : {false, true}) {
      Particles<3> ends[2];
      double next[2];
      for (const unsigned int threads : {1u, 2u}) {
        Particles<3> p = crowd(n, 12);
        std::vector<std::uint64_t> id(n);
        for (std::uint32_t i = 0; i < n; ++i) id[i] = i;
        System all(p, {.normal = 5e9, .tangential = 2e9}, 0.3, threads);
        Overdamped<3> stepper({.method = method, .first_step = 100., .mean_error = mean}, all.motion,
                              threads);
        all.move_at_random(1e-16, 4, id);
        for (int k = 0; k < 3; ++k) stepper.step(all.p, 1e3);
        BOOST_TEST(stepper.rejected() > 0u);
        next[threads - 1] = stepper.next_step();
        ends[threads - 1] = all.p;
      }
      BOOST_CHECK(ends[0].x == ends[1].x);
      BOOST_CHECK(ends[0].v == ends[1].v);
      BOOST_TEST(next[0] == next[1]);
    }
}

// One pair deep in each other among many at rest: measured by the mean, steps follow the many, and the pair
// ends at the same place.
BOOST_AUTO_TEST_CASE(steps_by_the_mean_error_are_longer_and_end_alike) {
  const std::uint32_t n = 400;
  double ends[2];
  unsigned int steps[2];
  for (const bool mean : {false, true}) {
    Particles<3> p = crowd(n, 2);
    for (std::uint32_t i = 0; i < n; ++i)
      for (int d = 0; d < 3; ++d) p.x[d][i] = d == 0 ? 1e-4 * i : 0.;
    p.x[0][1] = 0.3 * radius_0;
    System all(p, {.normal = 5e10, .tangential = 5e10}, 0.3, 1);
    Overdamped<3> stepper({.method = OverdampedMethod::implicit, .tolerance = 5e-3, .mean_error = mean},
                          all.motion, 1);
    steps[mean] = 0;
    for (double t = 0.; t < 20000.; ++steps[mean]) t += stepper.step(all.p, 20000. - t);
    ends[mean] = all.p.x[0][1] - all.p.x[0][0];
  }
  BOOST_TEST(steps[1] < steps[0]);
  // the mean of 400 is a twentieth of the pair's own error: what a step may err adds up to some hundredths of
  // a radius
  BOOST_CHECK_SMALL(ends[1] - ends[0], 0.1 * radius_0);
}

BOOST_AUTO_TEST_CASE(contacts_that_hold_on_survive_a_checkpoint) {
  const JkrContact law{1e-4};
  Particles<3> p = crowd(2, 1);
  p.field("radius") = {radius_0, radius_0};
  p.field("modulus") = {400., 400.};
  for (int d = 0; d < 3; ++d) p.x[d] = {0., 0.};
  p.x[0][1] = 1.9 * radius_0;
  SphereContacts contacts(law, 1e-6);
  contacts.add_forces(p, 1);
  const double off = law.release(0.5 * radius_0, 200.);
  p.x[0][1] = 2. * radius_0 - 0.5 * off;  // apart, held by adhesion
  p.f[0] = {0., 0.};
  contacts.add_forces(p, 1);
  BOOST_TEST(p.f[0][1] < 0.);
  SphereContacts resumed(law, 1e-6), fresh(law, 1e-6);
  const auto list_of = [&](SphereContacts &some) { return [&](Archive &a) { some.archive(a, p); }; };
  const auto from = list_of(contacts), to = list_of(resumed);
  restore(archived(from), to);
  Particles<3> q = p, z = p;
  q.f[0] = z.f[0] = {0., 0.};
  resumed.add_forces(q, 1);
  fresh.add_forces(z, 1);
  BOOST_TEST(q.f[0][1] == p.f[0][1]);
  BOOST_TEST(z.f[0][1] == 0.);  // without the past: not touching
}

BOOST_AUTO_TEST_SUITE_END()
