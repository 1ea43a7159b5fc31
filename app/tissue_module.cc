#include "app/tissue_module.h"

#include "app/child_process.h"
#include "run/atomic_file.h"

#include <boost/uuid/detail/sha1.hpp>
#include <dlfcn.h>

#include <cstdio>
#include <filesystem>
#include <stdexcept>

extern const char
    *const tissue_module_hash;  // of the module that this program was built with (write_module_hash.cmake)

namespace turgor {
namespace {
using MakeScenario = Scenario *(*)(const char *);

/// As CMake's file(SHA1).
std::string sha1(const std::string &bytes) {
  boost::uuids::detail::sha1 sum;
  sum.process_bytes(bytes.data(), bytes.size());
  unsigned int words[5];
  sum.get_digest(words);
  char digits[41];
  std::snprintf(digits, sizeof digits, "%08x%08x%08x%08x%08x", words[0], words[1], words[2], words[3],
                words[4]);
  return digits;
}

const char *const advice =
    "Copy turgor and turgor_tissue.so together into a folder 'app', both from one build, or build the "
    "program again.";

/// build/app/turgor and the programs of the tests, build/tests/..., have it in the same place.
MakeScenario load() {
  const std::filesystem::path file =
      std::filesystem::path(this_program()).parent_path().parent_path() / "app" / "turgor_tissue.so";
  const std::string part = "The part of the program with finite elements, " + file.string() + ", ";
  if (!std::filesystem::is_regular_file(file)) throw std::runtime_error(part + "is not there. " + advice);
  if (sha1(read_whole(file)) != tissue_module_hash)
    throw std::runtime_error(part + "is from another build than this program. " + advice);
  void *const module = ::dlopen(
      file.c_str(),
      RTLD_LAZY |
          RTLD_LOCAL);  // stays until the program ends; most of what its 200 libraries call is never called
  void *const symbol = module != nullptr ? ::dlsym(module, "turgor_make_tissue_scenario") : nullptr;
  if (symbol == nullptr) {
    const char *reason = ::dlerror();
    throw std::runtime_error(part + "cannot be loaded: " + (reason ? reason : "no reason is known") +
                             ". Install the libraries it was built with, or build the program again.");
  }
  return reinterpret_cast<MakeScenario>(symbol);
}
}  // namespace

std::unique_ptr<Scenario> make_tissue_scenario(const std::string &name) {
  static const MakeScenario make = load();
  std::unique_ptr<Scenario> scene(make(name.c_str()));
  if (scene == nullptr)
    throw std::runtime_error("The part of the program with finite elements has no scene '" + name +
                             "'. Build the program again.");
  return scene;
}
}  // namespace turgor
