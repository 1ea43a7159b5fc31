// The same batches on 1, 2 and 3 ranks: this program starts itself under mpirun with one
// (otherwise disabled) test and compares the bytes that every rank wrote.
#include "coupling/rve_law.h"
#include "run/archive.h"
#include "tests/coupling/fake_rve.h"

#include <boost/test/unit_test.hpp>

#include <mpi.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace turgor;
using turgor::test::FakeRve;
namespace fs = std::filesystem;

namespace {
constexpr std::size_t n_points = 37;

// A history of batches whose costs differ and drift, so that the points change hands. Returns the
// stresses, energies and failures of every batch, and the final states, as bytes.
std::string history_bytes(std::uint64_t &rebalances, const std::string &resume_from, std::string *saved) {
  const auto rve = std::make_shared<FakeRve<2>>();
  rve->fails_above = 2.9;
  rve->remembers = true;
  RveLawSettings settings;
  settings.rebalance_every = 2;
  RveLaw<2> law(rve, settings);
  law.set_points(std::vector<dealii::Point<2>>(n_points));
  int first = 0;
  if (!resume_from.empty()) {
    restore(resume_from, law);
    first = 10;
  }
  std::ostringstream out;
  LawAnswer<2> answer;
  std::vector<dealii::Tensor<2, 2>> F(n_points), F_dot(n_points);
  for (int step = first; step < 20; ++step) {
    if (saved != nullptr && step == 10) {
      *saved = archived(law);
      out.str("");
    }
    for (std::size_t p = 0; p < n_points; ++p) {
      const double phase = 0.3 * step + static_cast<double>(p);
      F[p][0][0] = 2. + std::sin(phase);
      F[p][1][1] = 1.1 + std::cos(phase);
      F_dot[p][0][1] = 1e3 * std::sin(2. * phase);
      F[p][1][1] = std::abs(F[p][1][1]) + 0.1;
    }
    LawRequest request;
    request.tangents = step % 3 == 0;
    request.rate_tangents = step % 2 == 0;
    law.evaluate(F, F_dot, request, answer);
    for (const auto *tangent : {&answer.tangent, &answer.rate_tangent})
      out.write(reinterpret_cast<const char *>(tangent->data()),
                static_cast<std::streamsize>(tangent->size() * sizeof((*tangent)[0])));
    for (const FailedPoint &f : answer.failed) out << f.point << f.reason;
    out.write(reinterpret_cast<const char *>(answer.P.data()),
              static_cast<std::streamsize>(n_points * sizeof(answer.P[0])));
    out.write(reinterpret_cast<const char *>(answer.energy.data()), n_points * sizeof(double));
    if (!answer.failed.empty()) {
      for (auto &f : F) f[0][0] = 1.5;
      law.evaluate(F, F_dot, {}, answer);
    }
    law.commit();
  }
  std::vector<std::size_t> all(n_points);
  for (std::size_t p = 0; p < n_points; ++p) all[p] = p;
  for (const RveState<2> &s : law.states(all))
    out.write(reinterpret_cast<const char *>(s.unknowns.data()),
              static_cast<std::streamsize>(s.unknowns.size() * sizeof(double)))
        .write(reinterpret_cast<const char *>(s.history.data()),
               static_cast<std::streamsize>(s.history.size() * sizeof(double)));
  for (const RveCondition &c : law.condition()) out.write(reinterpret_cast<const char *>(&c), sizeof(c));
  rebalances = law.statistics().rebalances;
  BOOST_TEST(law.shares().imbalance(std::vector<double>(n_points, 1.), law.shares().owners()) < 1.5);
  return out.str();
}

std::string read(const fs::path &path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}
}  // namespace

BOOST_AUTO_TEST_SUITE(ranks)

BOOST_AUTO_TEST_CASE(under_mpirun, *boost::unit_test::disabled()) {
  MPI_Init(nullptr, nullptr);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const char *directory = std::getenv("TURGOR_TEST_DIRECTORY");
  BOOST_TEST_REQUIRE(directory != nullptr);
  std::uint64_t rebalances = 0;
  std::string saved;
  const std::string bytes = history_bytes(rebalances, "", &saved);
  BOOST_TEST(rebalances > 0u);  // or the test would test nothing
  BOOST_TEST((history_bytes(rebalances, saved, nullptr) == bytes));
  std::ofstream(fs::path(directory) / ("rank_" + std::to_string(rank)), std::ios::binary) << bytes;
  MPI_Finalize();
}

BOOST_AUTO_TEST_CASE(same_bits_on_any_number_of_ranks) {
  const fs::path directory = fs::temp_directory_path() / ("turgor_ranks_" + std::to_string(::getpid()));
  std::uint64_t rebalances = 0;
  std::string saved;
  const std::string alone = history_bytes(rebalances, "", &saved);
  BOOST_TEST(rebalances == 0u);
  BOOST_TEST((history_bytes(rebalances, saved, nullptr) == alone));
  for (const int ranks : {2, 3}) {
    fs::create_directories(directory);
    const std::string command =
        "TURGOR_TEST_DIRECTORY=" + directory.string() + " mpirun --allow-run-as-root --oversubscribe -n " +
        std::to_string(ranks) + " " + boost::unit_test::framework::master_test_suite().argv[0] +
        " --run_test=ranks/under_mpirun --log_level=error > " + (directory / "log").string() + " 2>&1";
    const int status = std::system(command.c_str());
    BOOST_TEST(status == 0, "mpirun failed: " << read(directory / "log"));
    for (int r = 0; r < ranks; ++r)
      BOOST_TEST((read(directory / ("rank_" + std::to_string(r))) == alone), "rank " << r << " of " << ranks);
    fs::remove_all(directory);
  }
}

BOOST_AUTO_TEST_SUITE_END()
