// Plain numbers and vectors of them to and from a checkpoint's stream, bit by bit.
#pragma once

#include "run/number_text.h"

#include <cstdint>
#include <istream>
#include <ostream>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace turgor
{
/// Apart from the functions of the same name in run/binary.h, which let a vector change its size.
inline namespace tissue_binary
{
template <typename T>
void write_binary(std::ostream &out, const T &value)
{
  static_assert(std::is_trivially_copyable_v<T>);
  out.write(reinterpret_cast<const char *>(&value), sizeof(T));
}

template <typename T>
void read_binary(std::istream &in, T &value)
{
  static_assert(std::is_trivially_copyable_v<T>);
  if (!in.read(reinterpret_cast<char *>(&value), sizeof(T)))
    throw std::runtime_error("The checkpoint ends too early: it is damaged.");
}

/// The vector's size must be known to the reader: a different one means another mesh.
template <typename T>
void write_binary(std::ostream &out, const std::vector<T> &values)
{
  write_binary(out, static_cast<std::uint64_t>(values.size()));
  for (const T &value : values)
    write_binary(out, value);
}

template <typename T>
void read_binary(std::istream &in, std::vector<T> &values)
{
  std::uint64_t size = 0;
  read_binary(in, size);
  if (size != values.size())
    throw std::runtime_error("The checkpoint belongs to another mesh: it holds " + number_text(size) +
                             " entries where this run has " + number_text(values.size()) + ".");
  for (T &value : values)
    read_binary(in, value);
}
} // namespace tissue_binary
} // namespace turgor
