// Plain data <-> bytes, for checkpoints and for messages between ranks of one machine type.
// An RveState is written as F, F_dot, number of unknowns, unknowns: doubles as they are, so
// that what is read back has the same bits. Where it has a history, the top bit of the number is set and the number and the
// numbers of the history follow. A short or overlong text throws std::runtime_error.
#pragma once

#include "rve/rve.h"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace turgor
{
class ByteWriter
{
public:
  template <typename T>
  void put(const T &value)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    put(&value, 1);
  }

  template <typename T>
  void put(const T *values, std::size_t n)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char *>(values), n * sizeof(T));
  }

  template <int dim>
  void put_state(const RveState<dim> &state)
  {
    put(state.F.data(), dim * dim);
    put(state.F_dot.data(), dim * dim);
    put(static_cast<std::uint64_t>(state.unknowns.size()) | (state.history.empty() ? 0 : history_follows));
    put(state.unknowns.data(), state.unknowns.size());
    if (!state.history.empty())
      {
        put(static_cast<std::uint64_t>(state.history.size()));
        put(state.history.data(), state.history.size());
      }
  }

  static constexpr std::uint64_t history_follows = std::uint64_t(1) << 63;

  std::string bytes;
};

class ByteReader
{
public:
  explicit ByteReader(const std::string &text)
    : bytes(text)
  {}

  template <typename T>
  T get()
  {
    T value;
    get(&value, 1);
    return value;
  }

  template <typename T>
  void get(T *values, std::size_t n)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    if (n > (bytes.size() - at) / sizeof(T))
      throw std::runtime_error("The saved state of an RVE ends too early: the checkpoint is damaged.");
    if (n > 0)
      std::memcpy(values, bytes.data() + at, n * sizeof(T));
    at += n * sizeof(T);
  }

  template <int dim>
  RveState<dim> get_state()
  {
    RveState<dim> state;
    get(state.F.data(), dim * dim);
    get(state.F_dot.data(), dim * dim);
    const auto n = get<std::uint64_t>();
    get_numbers(n & ~ByteWriter::history_follows, state.unknowns);
    if (n & ByteWriter::history_follows)
      get_numbers(get<std::uint64_t>(), state.history);
    return state;
  }

  bool at_end() const { return at == bytes.size(); }

private:
  void get_numbers(const std::uint64_t n, std::vector<double> &numbers)
  {
    if (n > (bytes.size() - at) / sizeof(double))
      throw std::runtime_error("The saved state of an RVE ends too early: the checkpoint is damaged.");
    numbers.resize(n);
    get(numbers.data(), n);
  }

  const std::string &bytes;
  std::size_t at = 0;
};
} // namespace turgor
