// A population whose number changes: contacts held by adhesion, velocities and fields follow their cells;
// save and load.
#include "micro/cells/cell_population.h"
#include "micro/laws/counter_random.h"
#include "micro/engine/overdamped.h"
#include "micro/engine/system_motion.h"
#include "micro/terms/sphere_contacts.h"
#include "run/archive.h"

#include <boost/test/unit_test.hpp>

#include <map>
#include <set>

using namespace turgor;

namespace {
constexpr double radius_0 = 7e-6;

CellPopulation crowd(const std::uint32_t n, const double spacing) {
  CellPopulation cells;
  const double side = std::cbrt(double(n)) * spacing * radius_0;
  for (std::uint32_t i = 0; i < n; ++i)
    cells.add(side * Vector<3>(random_uniform(3, 4 * i), random_uniform(3, 4 * i + 1),
                               random_uniform(3, 4 * i + 2)),
              radius_0 * (0.9 + 0.2 * random_uniform(3, 4 * i + 3)), 400.);
  return cells;
}

/// Forces of all contacts by cell id.
std::map<std::uint64_t, Vector<3>> forces(CellPopulation &cells, SphereContacts &contacts) {
  for (auto &f : cells.particles.f) std::fill(f.begin(), f.end(), 0.);
  contacts.add_forces(cells.particles, 1);
  std::map<std::uint64_t, Vector<3>> result;
  for (std::size_t i = 0; i < cells.size(); ++i)
    result[cells.id()[i]] =
        Vector<3>(cells.particles.f[0][i], cells.particles.f[1][i], cells.particles.f[2][i]);
  return result;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(cell_population)

// Cells pressed together, then drawn apart a little: many are held by adhesion over a gap, which only their
// past tells.
BOOST_AUTO_TEST_CASE(contacts_held_by_adhesion_follow_their_cells) {
  CellPopulation cells = crowd(120, 1.7);
  SphereContacts contacts(JkrContact{1e-4}, 0.3 * radius_0);
  forces(cells, contacts);
  for (int d = 0; d < 3; ++d)
    for (double &x : cells.particles.x[d]) x *= 1.08;
  const auto before = forces(cells, contacts);
  SphereContacts without_past(JkrContact{1e-4}, 0.3 * radius_0);
  const auto fresh = forces(cells, without_past);
  std::size_t held = 0;
  for (const auto &[id, f] : before) held += (f - fresh.at(id)).norm() > 1e-3 * f.norm();
  BOOST_TEST(held > 20u);

  // sorted backwards: the same forces but for the order of the sums
  std::vector<std::uint32_t> source(cells.size());
  for (std::uint32_t k = 0; k < source.size(); ++k) source[k] = std::uint32_t(source.size()) - 1 - k;
  cells.gather({source});
  contacts.gather({source});
  for (const auto &[id, f] : forces(cells, contacts))
    BOOST_CHECK_SMALL((f - before.at(id)).norm(), 1e-12 * before.at(id).norm());

  // far cells taken out: what the others do to each other stays, to the bit
  CellPopulation few = crowd(120, 1.7);
  SphereContacts few_contacts(JkrContact{1e-4}, 0.3 * radius_0);
  forces(few, few_contacts);
  for (int d = 0; d < 3; ++d)
    for (double &x : few.particles.x[d]) x *= 1.08;
  few.add(Vector<3>(1., 1., 1.), radius_0, 400.);
  source.clear();
  for (std::uint32_t k = 0; k < 120; ++k) source.push_back(k);
  few_contacts.gather({source});  // before the far cell is seen
  few.gather({source});
  BOOST_TEST(few.size() == 120u);
  BOOST_CHECK(forces(few, few_contacts) == before);
}

BOOST_AUTO_TEST_CASE(a_divided_cell_leaves_its_contacts_to_both) {
  CellPopulation cells;
  const JkrContact law{1e-4};
  const double off = law.release(0.5 * radius_0, 200.);
  cells.add(Vector<3>(0., 0., 0.), radius_0, 400.);
  cells.add(Vector<3>(1.9 * radius_0, 0., 0.), radius_0, 400.);
  SphereContacts contacts(law, 0.3 * radius_0);
  forces(cells, contacts);
  cells.particles.x[0][1] = 2. * radius_0 - 0.5 * off;
  const double pull = forces(cells, contacts)[0][0];
  BOOST_TEST(pull > 0.);
  contacts.gather({{0, 1, 0}});
  cells.gather({{0, 1, 0}});
  cells.id()[2] = cells.next_id++;
  cells.particles.x[1][0] = 0.2 * radius_0;
  cells.particles.x[1][2] = -0.2 * radius_0;
  cells.particles.x[0][1] = 1.98 * radius_0 - 0.5 * off;  // both about as far from it as the mother was
  const auto f = forces(cells, contacts);
  BOOST_TEST(f.at(0)[0] > 0.);
  BOOST_TEST(f.at(0)[0] == f.at(2)[0], boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(the_engine_goes_on_with_other_cells) {
  // Two pairs far from each other: one taken away, the other must move as if it had been alone.
  const auto step_of = [&](const bool with_others) {
    CellPopulation cells;
    if (with_others)
      for (const double x : {1e-3, 1e-3 + 1.5 * radius_0}) cells.add(Vector<3>(x, 0., 0.), radius_0, 400.);
    for (const double x : {0., 1.5 * radius_0}) cells.add(Vector<3>(x, 0., 0.), radius_0, 400.);
    cells.add(std::make_unique<SphereContacts>(HertzContact(), 0.2 * radius_0));
    SystemMotion<3> motion(cells, {});
    Overdamped<3> stepper(
        {.method = OverdampedMethod::euler, .tolerance = 1., .first_step = 1., .longest_step = 1.}, motion,
        1);
    motion.medium.assign(cells.size(), 0.1);
    stepper.step(cells.particles, 1.);
    std::size_t last = cells.size() - 1;
    if (with_others) {
      cells.gather({{2, 3}});
      stepper.gather({{2, 3}});
      motion.medium.resize(2);
      last = 1;
    }
    for (int k = 0; k < 5; ++k) stepper.step(cells.particles, 1.);
    return cells.particles.x[0][last];
  };
  BOOST_TEST(step_of(true) == step_of(false), boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(save_and_load_keep_every_bit_and_refuse_other_fields) {
  CellPopulation cells = crowd(20, 2.);
  cells.particles.cells.declare("strain");
  cells.particles.cells.column("strain")[3] = 0.25;
  cells.set_state(4, CellState::necrotic);
  cells.gather({{4, 3, 3}});
  cells.id()[2] = cells.next_id++;
  const std::string bytes = archived(cells);
  CellPopulation same;
  same.particles.cells.declare("strain");
  restore(bytes, same);
  BOOST_TEST(same.next_id == 21u);
  BOOST_CHECK(same.id() == cells.id() && same.id()[2] == 20u);
  BOOST_TEST((same.state()[0] == CellState::necrotic && same.state()[1] == CellState::proliferating));
  BOOST_CHECK(same.particles.x == cells.particles.x);
  BOOST_TEST(same.particles.cells.column("strain")[2] == 0.25);
  BOOST_TEST(same.particles.field("radius")[1] == cells.particles.field("radius")[1]);
  BOOST_TEST(same.count(CellState::necrotic) == 1u);
  CellPopulation other;
  other.particles.cells.declare("volume");
  BOOST_CHECK_EXCEPTION(restore(bytes, other), std::runtime_error, [](const std::runtime_error &e) {
    return std::string(e.what()) == "The checkpoint does not belong to this scene: its fields are others.";
  });
}

// A cell from nowhere among others: the next id, zero in every column, no contact that was held and no
// velocity; the others go on.
BOOST_AUTO_TEST_CASE(what_was_nothing_before_begins_empty) {
  CellPopulation cells = crowd(30, 1.7);
  cells.particles.cells.declare("strain");
  cells.particles.cells.column("strain").assign(30, 0.5);
  SphereContacts contacts(JkrContact{1e-4}, 0.3 * radius_0);
  forces(cells, contacts);
  for (int d = 0; d < 3; ++d)
    for (double &x : cells.particles.x[d]) x *= 1.08;
  const auto before = forces(cells, contacts);
  Rearrangement places;
  for (std::uint32_t k = 0; k < 30; ++k) places.source.push_back(29 - k);
  places.source.insert(places.source.begin() + 7, Rearrangement::fresh);
  cells.gather(places);
  contacts.gather(places);
  BOOST_TEST(cells.size() == 31u);
  BOOST_TEST(cells.id()[7] == 30u);
  BOOST_TEST(cells.particles.cells.column("strain")[7] == 0.);
  BOOST_TEST(cells.particles.cells.column("strain")[8] == 0.5);
  cells.particles.x[0][7] = 1.;  // far away
  cells.particles.field("radius")[7] = radius_0;
  cells.particles.field("modulus")[7] = 400.;
  for (const auto &[id, f] : forces(cells, contacts))
    if (id == 30)
      BOOST_TEST(f.norm() == 0.);
    else
      BOOST_CHECK_SMALL((f - before.at(id)).norm(), 1e-12 * before.at(id).norm());
}

BOOST_AUTO_TEST_CASE(a_column_of_another_type_is_refused) {
  Table table;
  table.declare<std::uint64_t>("id");
  table.declare<std::uint64_t>("id");
  BOOST_CHECK_THROW(table.declare("id"), std::logic_error);
  BOOST_CHECK_THROW(table.column("phase"), std::logic_error);
  table.resize(3);
  BOOST_TEST(table.column<std::uint64_t>("id").size() == 3u);
}

BOOST_AUTO_TEST_SUITE_END()
