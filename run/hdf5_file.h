// One HDF5 file being written: datasets of doubles or indices, and attributes. Thin cover
// of the C API: every failure is an OutputFailed that names the file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace turgor {
class Hdf5Writer {
 public:
  explicit Hdf5Writer(const std::filesystem::path &path);  ///< an existing file is replaced
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer &) = delete;
  Hdf5Writer &operator=(const Hdf5Writer &) = delete;

  void root_attribute(const std::string &name, double value);

  /// rows x columns values; one column of doubles gives a one-dimensional dataset. title becomes the
  /// attribute "name".
  void dataset(const std::string &name, const std::vector<double> &values, std::size_t columns,
               const std::string &title);
  void dataset(const std::string &name, const std::vector<std::uint32_t> &values, std::size_t columns,
               const std::string &title);

  void close();  ///< everything is in the file; a full disk shows here at the latest

 private:
  void write(const std::string &name, const void *values, std::size_t count, std::size_t columns,
             const std::string &title, bool is_double);
  std::int64_t checked(std::int64_t result) const;

  std::filesystem::path path;
  std::int64_t file = -1;  ///< hid_t
};
}  // namespace turgor
