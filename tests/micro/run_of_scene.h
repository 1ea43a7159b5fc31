// Runs a scene in memory: one of its tables (of growing cells growth.csv) and its results, at once or with a
// stop and a resumed run.
#pragma once

#include "run/input_entries.h"
#include "tests/memory_context.h"

#include <boost/test/unit_test.hpp>

#include <map>
#include <string>
#include <vector>

namespace turgor::test {
struct Outcome {
  std::vector<std::vector<double>> rows;
  std::map<std::string, double> results;
  std::map<std::string, std::string> notes;
};

template <class Scene>
void read(Scene &scene, const std::string &text) {
  InputEntries prm;
  scene.declare_parameters(prm);
  prm.read(text);
  scene.check();
}

template <class Scene>
Outcome run(const std::string &text, const unsigned int threads = 1, const unsigned long stop_at = 0,
            const std::string &table = "growth") {
  Disk disk;
  for (bool resume = false;; resume = true) {
    Scene scene;
    read(scene, text);
    MemoryContext context(disk, resume);
    context.use_threads = threads;
    context.stop_at = resume ? 0 : stop_at;
    try {
      scene.run(context);
      return {disk.series.at(table), context.results, context.notes};
    } catch (const RunStopped &) {
      BOOST_REQUIRE(!resume);
    }
  }
}
}  // namespace turgor::test
