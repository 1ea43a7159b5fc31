// One list for saving and loading: every bit comes back, whatever is cut or laid out otherwise is told with
// the section's name.
#include "run/archive.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <memory>

using namespace turgor;

namespace {
struct Inner {
  double x = 0.;
  std::string name;
  void archive(Archive &a) {
    a.section("inner");
    a(x, name);
  }
};

struct Outer {
  struct Counts {
    std::uint64_t steps = 0;
    double time = 0.;
  };
  Counts counts;
  bool ready = false;
  std::vector<double> free;
  std::vector<std::vector<float>> rows;
  std::array<std::vector<int>, 2> parts;
  std::optional<double> maybe;
  std::unique_ptr<Inner> there = std::make_unique<Inner>(), absent;
  Inner inner;
  std::vector<double> of_three = {0., 0., 0.};
  std::string reader = "outer";
  double doubled = 0.;  // follows

  void archive(Archive &a) {
    a.section(reader);
    a(counts, ready, free, rows, parts, maybe, there, absent, inner);
    a.section("sizes");
    a.fixed(of_three);
    if (a.loading()) doubled = 2. * counts.time;
  }
};

Outer full() {
  Outer one;
  one.counts = {7, 0.1};
  one.ready = true;
  one.free = {1., std::nextafter(2., 3.), -0.};
  one.rows = {{1.f}, {}, {2.f, 3.f}};
  one.parts = {std::vector<int>{4}, std::vector<int>{5, 6}};
  one.maybe = 8.;
  one.there->name = "nine";
  one.inner.x = 10.;
  one.of_three = {1., 2., 3.};
  return one;
}

auto says(const std::string &what) {
  return [what](const ArchiveError &e) {
    BOOST_TEST_MESSAGE(e.what());
    return std::string(e.what()).find(what) != std::string::npos;
  };
}
}  // namespace

BOOST_AUTO_TEST_SUITE(archive)

BOOST_AUTO_TEST_CASE(everything_comes_back) {
  Outer one = full(), other;
  other.rows = {{9.f}};
  other.there->x = 99.;
  const std::string bytes = archived(one);
  restore(bytes, other);
  BOOST_TEST(other.counts.steps == 7u);
  BOOST_TEST(other.ready);
  BOOST_CHECK(other.free == one.free && std::signbit(other.free[2]));
  BOOST_CHECK(other.rows == one.rows && other.parts == one.parts && other.maybe == one.maybe);
  BOOST_TEST(other.there->name == "nine");
  BOOST_TEST(other.there->x == 0.);
  BOOST_TEST(!other.absent);
  BOOST_TEST(other.inner.x == 10.);
  BOOST_CHECK(other.of_three == one.of_three);
  BOOST_TEST(other.doubled == 0.2);
  BOOST_TEST(one.doubled == 0.);  // nothing follows from saving
  BOOST_CHECK(archived(other) == bytes);
}

BOOST_AUTO_TEST_CASE(cut_anywhere_it_says_so) {
  Outer one = full();
  const std::string bytes = archived(one);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    Outer other;
    BOOST_CHECK_EXCEPTION(restore(bytes.substr(0, length), other), ArchiveError, says("ends too early"));
  }
  Outer other;
  BOOST_CHECK_EXCEPTION(restore(bytes + "x", other), ArchiveError, says("holds more"));
}

BOOST_AUTO_TEST_CASE(a_false_byte_neither_crashes_nor_takes_memory) {
  Outer one = full();
  const std::string bytes = archived(one);
  for (std::size_t at = 0; at < bytes.size(); ++at)
    for (const char wrong : {'\x7f', '\xff'}) {
      std::string damaged = bytes;
      damaged[at] = wrong;
      Outer other;
      try {
        restore(damaged, other);  // a number that is only another number passes
      } catch (const ArchiveError &) {
      }
      BOOST_TEST(other.free.capacity() + other.rows.capacity() < 1000u);
    }
}

BOOST_AUTO_TEST_CASE(another_layout_is_named) {
  Outer one = full(), other;
  other.reader = "walls";
  BOOST_CHECK_EXCEPTION(restore(archived(one), other), ArchiveError,
                        says("a section 'outer' where this program reads 'walls'"));

  Outer four;
  four.of_three.resize(4);
  BOOST_CHECK_EXCEPTION(restore(archived(one), four), ArchiveError,
                        says("3 entries in its section 'sizes' where this run has 4"));

  // A list that has grown or shrunk since: within the section, not in what follows.
  double a = 1., b = 2., c = 3.;
  const auto two = [&](Archive &x) { x.section("two"), x(a, b), x.section("next"), x(c); };
  const auto three = [&](Archive &x) { x.section("two"), x(a, b, c), x.section("next"), x(c); };
  BOOST_CHECK_EXCEPTION(restore(archived(two), three), ArchiveError, says("too early in its section 'two'"));
  BOOST_CHECK_EXCEPTION(restore(archived(three), two), ArchiveError, says("more in its section 'two'"));
}

BOOST_AUTO_TEST_CASE(what_was_saved_before_is_appended_as_it_is) {
  Outer one = full(), other;
  const std::string good = archived(one);
  const auto list = [&](Archive &a) { a.append(good); };
  BOOST_CHECK(archived(list) == good);
  restore(archived(list), other);
  BOOST_TEST(other.counts.steps == 7u);
}

BOOST_AUTO_TEST_SUITE_END()
