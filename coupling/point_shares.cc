#include "coupling/point_shares.h"

#include <mpi.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace turgor {
namespace {
// MPI counts are int; a silent overflow would send garbage.
int count(std::size_t n) {
  if (n > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw std::runtime_error(
        "The states of all RVEs exceed 2 GiB in one MPI message: use more ranks or fewer RVEs.");
  return static_cast<int>(n);
}

std::vector<int> offsets(const std::vector<int> &counts) {
  std::vector<int> result(counts.size(), 0);
  std::size_t total = 0;
  for (std::size_t r = 0; r < counts.size(); ++r) {
    result[r] = count(total);
    total += static_cast<std::size_t>(counts[r]);
  }
  (void)count(total);
  return result;
}

int sum_of(const std::vector<int> &counts) { return std::accumulate(counts.begin(), counts.end(), 0); }
}  // namespace

PointShares::PointShares() {
  int initialised = 0, finalised = 0;
  MPI_Initialized(&initialised);
  MPI_Finalized(&finalised);
  if (initialised != 0 && finalised == 0) {
    int r = 0, n = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &r);
    MPI_Comm_size(MPI_COMM_WORLD, &n);
    my_rank = static_cast<unsigned int>(r);
    n_ranks = static_cast<unsigned int>(n);
  }
}

void PointShares::set_points(std::size_t n_points) {
  owner.resize(n_points);
  for (std::size_t p = 0; p < n_points; ++p) owner[p] = static_cast<unsigned int>(p % n_ranks);
  list_mine();
}

void PointShares::list_mine() {
  my_points.clear();
  for (std::size_t p = 0; p < owner.size(); ++p)
    if (owner[p] == my_rank) my_points.push_back(p);
}

void PointShares::gather(std::size_t width, std::vector<double> &records) const {
  std::vector<std::size_t> all(n_ranks == 1 ? 0 : owner.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  gather(width, records, all);
}

void PointShares::gather(std::size_t width, std::vector<double> &records,
                         const std::vector<std::size_t> &points) const {
  if (n_ranks == 1 || points.empty()) return;
  std::vector<int> counts(n_ranks, 0);
  std::vector<double> outgoing, incoming(points.size() * width);
  for (const std::size_t p : points) {
    counts[owner[p]] += static_cast<int>(width);
    if (owner[p] == my_rank)
      outgoing.insert(outgoing.end(), records.begin() + static_cast<std::ptrdiff_t>(p * width),
                      records.begin() + static_cast<std::ptrdiff_t>((p + 1) * width));
  }
  const std::vector<int> starts = offsets(counts);
  MPI_Allgatherv(outgoing.data(), count(outgoing.size()), MPI_DOUBLE, incoming.data(), counts.data(),
                 starts.data(), MPI_DOUBLE, MPI_COMM_WORLD);

  std::vector<std::size_t> next(starts.begin(), starts.end());
  for (const std::size_t p : points) {
    std::size_t &from = next[owner[p]];
    std::copy_n(incoming.begin() + static_cast<std::ptrdiff_t>(from), width,
                records.begin() + static_cast<std::ptrdiff_t>(p * width));
    from += width;
  }
}

void PointShares::gather_texts(std::vector<std::string> &texts) const {
  if (n_ranks == 1) return;
  std::vector<double> lengths(owner.size(), 0.);
  for (const std::size_t p : my_points) lengths[p] = static_cast<double>(texts[p].size());
  gather(1, lengths);

  std::vector<std::size_t> totals(n_ranks, 0);
  for (std::size_t p = 0; p < owner.size(); ++p) totals[owner[p]] += static_cast<std::size_t>(lengths[p]);
  std::vector<int> counts(n_ranks, 0);
  std::transform(totals.begin(), totals.end(), counts.begin(), count);
  const std::vector<int> starts = offsets(counts);

  std::string outgoing;
  for (const std::size_t p : my_points) outgoing += texts[p];
  std::string incoming(static_cast<std::size_t>(sum_of(counts)), '\0');
  MPI_Allgatherv(outgoing.data(), count(outgoing.size()), MPI_CHAR, incoming.data(), counts.data(),
                 starts.data(), MPI_CHAR, MPI_COMM_WORLD);

  std::vector<std::size_t> next(starts.begin(), starts.end());
  for (std::size_t p = 0; p < owner.size(); ++p) {
    std::size_t &from = next[owner[p]];
    const auto length = static_cast<std::size_t>(lengths[p]);
    texts[p] = incoming.substr(from, length);
    from += length;
  }
}

bool PointShares::any(bool mine_says) const {
  if (n_ranks == 1) return mine_says;
  int in = mine_says ? 1 : 0, out = 0;
  MPI_Allreduce(&in, &out, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return out != 0;
}

double PointShares::sum(double mine_has) const {
  if (n_ranks == 1) return mine_has;
  std::vector<double> all(n_ranks, 0.);
  MPI_Allgather(&mine_has, 1, MPI_DOUBLE, all.data(), 1, MPI_DOUBLE, MPI_COMM_WORLD);
  return std::accumulate(all.begin(), all.end(), 0.);
}

std::vector<unsigned int> PointShares::balanced(const std::vector<double> &cost) const {
  std::vector<std::size_t> order(cost.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return cost[a] > cost[b]; });
  std::vector<double> load(n_ranks, 0.);
  std::vector<unsigned int> result(cost.size(), 0);
  for (const std::size_t p : order) {
    const auto least = std::min_element(load.begin(), load.end());
    *least += cost[p];
    result[p] = static_cast<unsigned int>(least - load.begin());
  }
  return result;
}

double PointShares::imbalance(const std::vector<double> &cost,
                              const std::vector<unsigned int> &owners) const {
  std::vector<double> load(n_ranks, 0.);
  for (std::size_t p = 0; p < cost.size(); ++p) load[owners[p]] += cost[p];
  const double total = std::accumulate(load.begin(), load.end(), 0.);
  return total > 0. ? *std::max_element(load.begin(), load.end()) * n_ranks / total : 1.;
}

void PointShares::reassign(const std::vector<unsigned int> &new_owner, std::vector<std::string> &luggage) {
  if (n_ranks == 1 || new_owner == owner) return;
  // Lengths travel first: a rank cannot know how long a state it never owned is.
  std::vector<double> lengths(owner.size(), 0.);
  for (const std::size_t p : my_points) lengths[p] = static_cast<double>(luggage[p].size());
  gather(1, lengths);

  std::vector<std::size_t> out_bytes(n_ranks, 0), in_bytes(n_ranks, 0);
  std::vector<std::string> outgoing(n_ranks);
  for (std::size_t p = 0; p < owner.size(); ++p) {
    if (new_owner[p] == owner[p]) continue;
    if (owner[p] == my_rank) {
      outgoing[new_owner[p]] += luggage[p];
      luggage[p].clear();
    }
    if (new_owner[p] == my_rank) in_bytes[owner[p]] += static_cast<std::size_t>(lengths[p]);
  }
  std::string sent;
  for (unsigned int r = 0; r < n_ranks; ++r) {
    out_bytes[r] = outgoing[r].size();
    sent += outgoing[r];
  }
  std::vector<int> out_counts(n_ranks), in_counts(n_ranks);
  std::transform(out_bytes.begin(), out_bytes.end(), out_counts.begin(), count);
  std::transform(in_bytes.begin(), in_bytes.end(), in_counts.begin(), count);
  const std::vector<int> out_starts = offsets(out_counts), in_starts = offsets(in_counts);
  std::string received(static_cast<std::size_t>(sum_of(in_counts)), '\0');
  MPI_Alltoallv(sent.data(), out_counts.data(), out_starts.data(), MPI_CHAR, received.data(),
                in_counts.data(), in_starts.data(), MPI_CHAR, MPI_COMM_WORLD);

  std::vector<std::size_t> next(in_starts.begin(), in_starts.end());
  for (std::size_t p = 0; p < owner.size(); ++p)
    if (new_owner[p] != owner[p] && new_owner[p] == my_rank) {
      std::size_t &from = next[owner[p]];
      const auto length = static_cast<std::size_t>(lengths[p]);
      luggage[p] = received.substr(from, length);
      from += length;
    }
  owner = new_owner;
  list_mine();
}
}  // namespace turgor
