#include "micro/scenes/matrix/network_shear.h"

#include "run/archive.h"
#include "run/field_output.h"
#include "run/judged.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/run_failed_by.h"
#include "run/step_loop.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace turgor {
class NetworkShear::Run {
 public:
  Run(const NetworkShear &scene_, RunContext &context_)
      : scene(scene_),
        context(context_),
        sheared(scene.sample(0), context.threads()),
        straight(scene.sample(0), context.threads()) {}

  void go();

 private:
  struct Sums {
    double shear_over_affine = 0., young_over_relation = 0., poisson = 0., reference_error = 0.,
           lattice_error = 0., effective_medium_error = 0., diluted = 0.;
  };

  std::uint64_t curve() const { return scene.largest_strain > 0. ? scene.steps : 0; }
  std::uint64_t last() const { return scene.samples() + curve(); }
  double strain_of(const std::uint64_t k) const {
    return scene.largest_strain * double(k) / double(scene.steps);
  }
  void advance();
  void measure(std::size_t number);
  void add_row(double strain);
  void frame(std::uint64_t k);
  void report();

  const NetworkShear &scene;
  RunContext &context;
  NetworkSample sheared, straight;
  std::uint64_t step = 0;
  Sums sums;
  double work = 0., stress_before = 0.;  ///< J, Pa
  std::unique_ptr<Series> moduli, shear;
  std::optional<FieldOutput> fields;
};

void NetworkShear::Run::measure(const std::size_t number) {
  const NetworkParameters p = scene.sample(number);
  NetworkSample sample(p, context.threads());
  const NetworkModuli affine = sample.affine(), exact = sample.relaxed(),
                      m = sample.moduli(scene.small_strain, scene.tolerance);
  const double count = double(sample.network->nodes()), h = p.depth;
  moduli->add_row({p.pore, p.stiffness, p.kept, double(p.seed), count,
                   2. * double(sample.network->bonds.size()) / count, m.shear(), m.young(), m.poisson(),
                   affine.shear(), affine.young(), exact.shear(), exact.young()});
  sums.shear_over_affine += m.shear() / affine.shear();
  sums.young_over_relation += m.young() * h / (2. / std::sqrt(3.) * p.stiffness);
  sums.poisson += m.poisson();
  sums.reference_error = std::max({sums.reference_error, std::abs(m.shear() - exact.shear()) / affine.shear(),
                                   std::abs(m.young() - exact.young()) / affine.young()});
  sums.lattice_error =
      std::max({sums.lattice_error, std::abs(m.shear() * h / (0.25 * std::sqrt(3.) * p.stiffness) - 1.),
                std::abs(m.young() * h / (2. / std::sqrt(3.) * p.stiffness) - 1.)});
  if (p.kept == 1.) return;
  NetworkParameters undiluted = p;
  undiluted.kept = 1.;
  sums.effective_medium_error +=
      m.shear() / NetworkSample(undiluted, 1).relaxed().shear() - effective_medium(p.kept);
  ++sums.diluted;
}

void NetworkShear::Run::add_row(const double strain) {
  sheared.system.compute_forces();
  straight.system.compute_forces();
  const Tensor2<2> s = sheared.stress();
  shear->add_row({strain, s(0, 1), straight.stress()(0, 1), s(0, 0), s(1, 1), sheared.energy(), work});
}

/// Of the steps of the curve, Frames in all.
void NetworkShear::Run::frame(const std::uint64_t k) {
  if (!fields) return;
  const std::uint64_t apart = std::max(1u, scene.frames - 1);
  if (k == 0 || k * apart / scene.steps > (k - 1) * apart / scene.steps) fields->write();
}

void NetworkShear::Run::advance() {
  if (step < scene.samples()) return measure(step);
  const std::uint64_t k = step - scene.samples() + 1;
  const double by = strain_of(k) - strain_of(k - 1);
  Tensor2<2> F = Tensor2<2>::Identity();
  F(0, 1) = by;
  sheared.deform(F);
  straight.deform(F);
  sheared.relax(scene.tolerance, by);
  const double stress = sheared.stress()(0, 1);
  work += 0.5 * (stress + stress_before) * by * sheared.volume();
  stress_before = stress;
  add_row(strain_of(k));
  frame(k);
}

void NetworkShear::Run::go() {
  context.active(sheared.system.term_names(), sheared.system.particles.field_names());
  StepLoop loop(context, step);
  loop.lasting = [this](Archive &a) {
    a.section("run");
    a(step, sums, work, stress_before, sheared, straight);
  };
  const bool resumed = context.load_checkpoint(loop.lasting);
  moduli = context.series("moduli", {{"pore_size", "m"},
                                     {"stiffness", "N/m"},
                                     {"kept_bonds", "1"},
                                     {"seed", ""},
                                     {"nodes", ""},
                                     {"bonds_per_node", ""},
                                     {"shear_modulus", "Pa"},
                                     {"young_modulus", "Pa"},
                                     {"poisson_ratio", "1"},
                                     {"affine_shear_modulus", "Pa"},
                                     {"affine_young_modulus", "Pa"},
                                     {"reference_shear_modulus", "Pa"},
                                     {"reference_young_modulus", "Pa"}});
  if (curve() > 0)
    shear = context.series("shear", {{"strain", "1"},
                                     {"shear_stress", "Pa"},
                                     {"affine_shear_stress", "Pa"},
                                     {"normal_stress_x", "Pa"},
                                     {"normal_stress_y", "Pa"},
                                     {"energy", "J"},
                                     {"work", "J"}});
  if (scene.frames > 0)
    fields.emplace(context, "network", resumed, [this] {
      return sheared.frame(step < scene.samples() ? 0. : strain_of(step - scene.samples() + 1));
    });
  loop.more = [this] { return step < last(); };
  loop.advance = [this] { run_failed_by([this] { advance(); }); };
  loop.checkpoint_due = [] { return true; };
  loop.tell_every = 1;
  loop.tell = [this] { context.progress(double(step) / double(last()), "straining networks"); };
  loop.reached = [this] {
    return "after " + number_text(step) + " of " + number_text(last()) + " networks and steps";
  };
  loop.share = [this] { return double(step) / double(last()); };
  loop.advice = "A smaller Side, fewer Seeds or a larger Tolerance make it shorter.";
  if (!resumed) {
    if (shear) add_row(0.);
    frame(0);
  }
  loop.run();
  report();
}

void NetworkShear::Run::report() {
  const double n = double(scene.samples());
  context.result("samples", n, "");
  context.result("shear_over_affine", sums.shear_over_affine / n, "1");
  context.result("young_over_relation", sums.young_over_relation / n, "1");
  context.result("poisson_ratio", sums.poisson / n, "1");
  context.result("reference_error", sums.reference_error, "1");
  if (!scene.anchors) {
    if (scene.nodes == NetworkNodes::sixfold) context.result("lattice_error", sums.lattice_error, "1");
    if (sums.diluted > 0.)
      context.result("effective_medium_error", sums.effective_medium_error / sums.diluted, "1");
  }
  judged(context, "reference_error", sums.reference_error, {1e-3, 0.1},
         "a modulus differs by " + number_text(100. * sums.reference_error) +
             " % of its affine limit from the exact linear response (a smaller Small strain or Tolerance)");
  if (!shear) return;
  const double energy = sheared.energy(), balance = energy > 0. ? (energy - work) / energy : 0.;
  context.result("energy_balance", balance, "1");
  judged(
      context, "energy_balance", balance, {0.02, 0.2},
      number_text(100. * balance) + " % of the network's energy is not the work of its stress (more Steps)");
}

void NetworkShear::run(RunContext &context) { Run(*this, context).go(); }

std::unique_ptr<Scenario> make_network_shear() { return std::make_unique<NetworkShear>(); }
}  // namespace turgor
