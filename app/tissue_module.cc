#include "app/tissue_module.h"

#include "app/child_process.h"

#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>

namespace turgor
{
namespace
{
using MakeScenario = Scenario *(*)(const char *);

/// build/app/turgor and the programs of the tests, build/tests/..., have it in the same place.
MakeScenario load()
{
  const std::filesystem::path file = std::filesystem::path(this_program()).parent_path().parent_path() / "app" / "turgor_tissue.so";
  void *const module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL); // stays until the program ends
  void *const symbol = module != nullptr ? ::dlsym(module, "turgor_make_tissue_scenario") : nullptr;
  if (symbol == nullptr)
    {
      const char *reason = ::dlerror();
      throw std::runtime_error("The part of the program with finite elements cannot be loaded: " + std::string(reason ? reason : file.string()) +
                               ". Build the program again.");
    }
  return reinterpret_cast<MakeScenario>(symbol);
}
} // namespace

std::unique_ptr<Scenario> make_tissue_scenario(const std::string &name)
{
  static const MakeScenario make = load();
  std::unique_ptr<Scenario> scene(make(name.c_str()));
  if (scene == nullptr)
    throw std::runtime_error("The part of the program with finite elements has no scene '" + name + "'. Build the program again.");
  return scene;
}
} // namespace turgor
