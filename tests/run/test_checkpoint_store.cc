// The checkpoint store: two generations, and what it does with damaged or foreign files.
#include "run/checkpoint_store.h"
#include "run/run_context.h"
#include "tests/temporary_directory.h"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(checkpoint_store)

namespace {
RunIdentity identity(const std::string &rate = "1", const std::string &end = "10",
                     const std::string &program = "aa") {
  RunIdentity made;
  made.deciding = {{"Law/Rate", rate}};
  made.ends = {{"End", end}};
  made.free = {{"Frames", "3"}};
  made.program = program;
  return made;
}

struct TwoGenerations {
  TwoGenerations() {
    CheckpointStore store(directory.path, identity());
    store.write({{"n", 1}}, "first");
    store.write({{"n", 2}}, std::string("sec\0nd", 6));
  }
  // Generation n stands in file n % 2.
  std::filesystem::path newer() const { return directory / "checkpoint.0"; }
  std::filesystem::path older() const { return directory / "checkpoint.1"; }
  std::optional<Checkpoint> read(std::string *damage = nullptr) const {
    return CheckpointStore(directory.path, identity()).read_newest(false, damage);
  }
  TemporaryDirectory directory;
};
}  // namespace

BOOST_AUTO_TEST_CASE(nothing_there_gives_nothing) {
  const TemporaryDirectory directory;
  BOOST_CHECK(!CheckpointStore(directory.path, identity()).read_newest(false));
}

BOOST_FIXTURE_TEST_CASE(newest_is_read_back_to_the_byte, TwoGenerations) {
  std::string damage;
  const auto checkpoint = read(&damage);
  BOOST_REQUIRE(checkpoint.has_value());
  BOOST_TEST(checkpoint->generation == 2u);
  BOOST_TEST(checkpoint->payload == std::string("sec\0nd", 6));
  BOOST_TEST(checkpoint->record == R"({"n":2})");
  BOOST_TEST(damage.empty());
}

BOOST_FIXTURE_TEST_CASE(torn_write_falls_back, TwoGenerations) {
  std::filesystem::resize_file(newer(), std::filesystem::file_size(newer()) - 3);
  std::string damage;
  const auto checkpoint = read(&damage);
  BOOST_REQUIRE(checkpoint.has_value());
  BOOST_TEST(checkpoint->payload == "first");
  BOOST_TEST(damage.find("cut short") != std::string::npos);
}

BOOST_FIXTURE_TEST_CASE(every_single_flipped_byte_is_found, TwoGenerations) {
  const std::string good = content(newer());
  for (std::size_t place = 0; place < good.size(); ++place) {
    std::string bad = good;
    bad[place] = static_cast<char>(bad[place] ^ 0x10);
    set_content(newer(), bad);
    const auto checkpoint = read();
    BOOST_REQUIRE(checkpoint.has_value());
    BOOST_TEST(checkpoint->payload == "first", "byte " << place);
  }
}

BOOST_FIXTURE_TEST_CASE(all_damaged_is_said, TwoGenerations) {
  set_content(newer(), "");
  set_content(older(), "TURGORcp and then something else");
  BOOST_CHECK_EXCEPTION(read(), InputError, Says{"No usable checkpoint is left"});
}

BOOST_FIXTURE_TEST_CASE(other_input_and_other_program_are_refused, TwoGenerations) {
  const auto read_as = [&](const RunIdentity &other) {
    return CheckpointStore(directory.path, other).read_newest(false);
  };
  BOOST_CHECK_EXCEPTION(read_as(identity("2")), InputError,
                        Says{"belongs to another input: 'Law/Rate' was 1 and is 2."});
  BOOST_CHECK_EXCEPTION(read_as(identity("1", "10", "bb")), InputError, Says{"was written by another build"});
  BOOST_CHECK(!CheckpointStore(directory.path, identity("2")).read_newest(true));
}

BOOST_FIXTURE_TEST_CASE(later_end_and_other_output_are_taken_up, TwoGenerations) {
  RunIdentity other = identity("1", "1e1");
  other.free = {{"Frames", "4"}};
  BOOST_CHECK(CheckpointStore(directory.path, other).read_newest(false));
  BOOST_CHECK(CheckpointStore(directory.path, identity("1", "11")).read_newest(false));
  BOOST_CHECK_EXCEPTION(CheckpointStore(directory.path, identity("1", "9")).read_newest(false), InputError,
                        Says{"'End' was 10 and is 9. A resumed run can end later, not earlier."});
}

BOOST_FIXTURE_TEST_CASE(writing_goes_on_in_the_older_file_after_reading, TwoGenerations) {
  CheckpointStore store(directory.path, identity());
  store.read_newest(false);
  const std::string second = content(newer());
  store.write({{"n", 3}}, "third");
  BOOST_TEST(content(newer()) == second);
  BOOST_TEST(read()->payload == "third");
}

BOOST_FIXTURE_TEST_CASE(unfinished_temporary_file_does_not_matter, TwoGenerations) {
  set_content(directory / "checkpoint.1.part", "half");
  BOOST_TEST(read()->generation == 2u);
}

BOOST_AUTO_TEST_SUITE_END()
