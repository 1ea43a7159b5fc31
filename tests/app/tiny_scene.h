// A scene for the tests of the machinery: x' = -rate x by explicit Euler, with a series, a
// field-free checkpoint every ten steps and, if asked, a wish to stop or a divergence.
#pragma once

#include "app/input.h"
#include "run/entry_marks.h"
#include "run/input_entries.h"
#include "run/run_context.h"
#include "run/stop_flag.h"
#include "run/word_or_file.h"
#include "run/archive.h"

#include <fstream>
#include <limits>

namespace turgor::test {
class TinyScene : public Scenario {
 public:
  static inline int stop_at_step = -1;  ///< what a person at the keyboard would do

  void declare_parameters(InputEntries &prm) override {
    using namespace Patterns;
    prm.add_parameter("Steps", steps, end_of_run("Number of steps."), Integer(1, 100000));
    prm.add_parameter("Remark", remark, free_to_change("For people."), Anything());
    prm.add_parameter("Table", table, "Something to read.", WordOrFile("none|all"));
    prm.add_parameter("Mode", mode, "What happens in the middle.", Selection("decay|diverge|refuse"));
    prm.enter_subsection("Law");
    prm.add_parameter("Rate", rate, "Decay rate. Units: 1/s.", Double(0., 1e3));
    prm.add_parameter("Weights", weights, "Weights.", List(Double(0., 1.), 1, 3));
    prm.leave_subsection();
    prm.rename("Decay/Speed", "Law/Rate");
  }

  Outputs outputs() const override {
    Outputs all;
    all.results({{"x", "1", "The number at the end of the run."}})
        .table("series", "One row a step.",
               {{"time", "s", "Time since the start of the run."}, {"x", "", "The number at this time."}});
    return all;
  }

  void check() const override {
    if (rate * 1e-3 > 0.5)
      throw InputError("'Law/Rate' = " + std::to_string(rate) +
                       " is too fast for the step; allowed: up to 500.");
  }

  void run(RunContext &context) override {
    if (mode == "refuse") throw InputError("'Mode' = refuse is refused.");
    if (table != "none" && !std::ifstream(table)) throw InputError("'Table' = " + table + " cannot be read.");
    double x = 1.;
    unsigned int step = 0;
    const auto lasting = [&](Archive &a) { a(x, step); };
    context.load_checkpoint(lasting);
    const auto save = [&] { context.save_checkpoint(lasting); };
    context.active({"decay"}, {"x"});
    const auto series = context.series("series", {{"time", "s"}, {"x", ""}});
    for (; step < steps; ++step) {
      if (static_cast<int>(step) == stop_at_step) request_stop();
      if (context.stop_requested()) {
        save();
        throw RunStopped("Stopped at step " + std::to_string(step) + ".");
      }
      if (mode == "diverge" && step == steps / 2) x = std::numeric_limits<double>::quiet_NaN();
      x -= 1e-3 * rate * x;
      series->add_row({1e-3 * (step + 1.), x});
      context.progress((step + 1.) / steps, "decay");
      if (step % 10 == 9) {
        ++step;
        save();
        --step;
      }
    }
    context.result("x", x, "1");
    context.note("scheme", "explicit Euler");
  }

 private:
  unsigned int steps = 25;
  std::string mode = "decay", remark = "none", table = "none";
  double rate = 100.;
  std::vector<double> weights = {0.5};
};

inline ScenarioRegistry tiny_registry() {
  return {{{"tiny", "Decay of one number."}}, [](const std::string &name) -> std::unique_ptr<Scenario> {
            return name == "tiny" ? std::make_unique<TinyScene>() : nullptr;
          }};
}
}  // namespace turgor::test
