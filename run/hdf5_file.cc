#include "run/hdf5_file.h"

#include "run/output_failed.h"

#include <hdf5.h>

namespace turgor {
std::int64_t Hdf5Writer::checked(const std::int64_t result) const {
  if (result < 0)
    throw OutputFailed("cannot write " + path.string() +
                       ": HDF5 refused (disk full, no permission, or its place is taken).");
  return result;
}

Hdf5Writer::Hdf5Writer(const std::filesystem::path &path_) : path(path_) {
  // Before anything else of HDF5: at exit it would flush once more what a full disk has refused, and crash.
  // Every file is closed here.
  [[maybe_unused]] static const herr_t no_exit_handler = H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // our sentences instead of HDF5's stack on stderr
  const hid_t without_times = checked(H5Pcreate(H5P_FILE_CREATE));
  H5Pset_obj_track_times(without_times, false);  // of the root group: equal runs leave equal files
  const hid_t opened = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, without_times, H5P_DEFAULT);
  H5Pclose(without_times);
  file = checked(opened);
}

Hdf5Writer::~Hdf5Writer() {
  if (file >= 0) H5Fclose(file);
}

void Hdf5Writer::close() {
  const herr_t result = H5Fclose(file);
  file = -1;
  checked(result);
}

void Hdf5Writer::root_attribute(const std::string &name, const double value) {
  const hid_t space = checked(H5Screate(H5S_SCALAR));
  const hid_t attribute =
      checked(H5Acreate2(file, name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT));
  checked(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value));
  H5Aclose(attribute);
  H5Sclose(space);
}

void Hdf5Writer::dataset(const std::string &name, const std::vector<double> &values,
                         const std::size_t columns, const std::string &title) {
  write(name, values.data(), values.size(), columns, title, true);
}

void Hdf5Writer::dataset(const std::string &name, const std::vector<std::uint32_t> &values,
                         const std::size_t columns, const std::string &title) {
  write(name, values.data(), values.size(), columns, title, false);
}

void Hdf5Writer::write(const std::string &name, const void *values, const std::size_t count,
                       const std::size_t columns, const std::string &title, const bool is_double) {
  const hid_t type = is_double ? H5T_NATIVE_DOUBLE : H5T_NATIVE_UINT32;
  const hsize_t shape[2] = {count / columns, columns};
  const hid_t space = checked(H5Screate_simple(is_double && columns == 1 ? 1 : 2, shape, nullptr));
  const hid_t without_times = checked(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_obj_track_times(without_times, false);
  const hid_t made = H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, without_times, H5P_DEFAULT);
  H5Pclose(without_times);
  const hid_t set = checked(made);
  if (count > 0) checked(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
  if (!title.empty()) {
    const hid_t text = checked(H5Tcopy(H5T_C_S1));
    checked(H5Tset_size(text, title.size()));
    H5Tset_cset(text, H5T_CSET_UTF8);
    const hid_t scalar = checked(H5Screate(H5S_SCALAR));
    const hid_t attribute = checked(H5Acreate2(set, "name", text, scalar, H5P_DEFAULT, H5P_DEFAULT));
    checked(H5Awrite(attribute, text, title.data()));
    H5Aclose(attribute);
    H5Sclose(scalar);
    H5Tclose(text);
  }
  H5Dclose(set);
  H5Sclose(space);
}
}  // namespace turgor
