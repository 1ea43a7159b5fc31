// Plain data to and from a binary stream (checkpoints). Reading past the end throws.
#pragma once

#include <cstdint>
#include <istream>
#include <ostream>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace turgor
{
template <class T>
  requires std::is_trivially_copyable_v<T>
void write_binary(std::ostream &out, const T &value)
{
  out.write(reinterpret_cast<const char *>(&value), sizeof(T));
}

template <class T>
  requires std::is_trivially_copyable_v<T>
void read_binary(std::istream &in, T &value)
{
  in.read(reinterpret_cast<char *>(&value), sizeof(T));
  if (!in)
    throw std::runtime_error("the checkpoint ends too early");
}

template <class T>
void write_binary(std::ostream &out, const std::vector<T> &values)
{
  write_binary(out, std::uint64_t(values.size()));
  out.write(reinterpret_cast<const char *>(values.data()), std::streamsize(values.size() * sizeof(T)));
}

template <class T>
void read_binary(std::istream &in, std::vector<T> &values)
{
  std::uint64_t size = 0;
  read_binary(in, size);
  if (size > (std::uint64_t(1) << 36) / sizeof(T))
    throw std::runtime_error("the checkpoint states an impossible length");
  values.resize(size);
  in.read(reinterpret_cast<char *>(values.data()), std::streamsize(size * sizeof(T)));
  if (!in)
    throw std::runtime_error("the checkpoint ends too early");
}
} // namespace turgor
