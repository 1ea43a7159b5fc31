// A Stokes fluid of SPH particles ("NSPH", thesis 2.3.1) in a rectangular box, 2D, as a scene moves it:
// particles, the bulk fluid with its walls, a body force, over-damped steps, and the books of momentum and
// energy.
//
//   StokesFlow flow(parameters, {.lengths = {Lx, Ly}, .periodic = {true, false}, .spacing = dx}, walls,
//   threads); flow.set_body_force({b, 0.}); flow.step(limit);
//
// The same of a viscoelastic solid, whose particles carry elastic stress beside the fluid's friction.
//
// Everything is per metre of depth. Books, J: pressure + kinetic - start + heat = work of the body force, of
// moving walls and of the load on a body + what steps of finite length lose.
#pragma once

#include "micro/engine/overdamped.h"
#include "micro/engine/system_motion.h"
#include "micro/terms/bulk_fluid.h"
#include "micro/terms/external_force.h"
#include "run/field_file.h"

#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace turgor {
class InputEntries;

enum class StokesPacking { lattice, disordered };
constexpr const char *words_of(StokesPacking) { return "lattice|disordered"; }

struct StokesFlowParameters {
  double viscosity = 1e-3;     ///< Pa s
  double density = 1e3;        ///< kg/m^3
  double bulk_modulus = 100.;  ///< Pa
  BulkDensity known_by = BulkDensity::continuity;
  double shifting = 0.3;
  double ordering = 0.1;  ///< Pa
  double support = 2.6;   ///< over the spacing
  DragForm form = DragForm::least_squares;
  bool inertia = false;
  OverdampedMethod method = OverdampedMethod::implicit;
  double tolerance = 0.05;    ///< of a step, over the spacing
  double longest_step = 1.;   ///< s
  double longest_move = 0.1;  ///< over the spacing
  double solve_tolerance = 1e-6;
  StokesPacking packing = StokesPacking::lattice;
  unsigned int seed = 1;
  unsigned int settling = 200;  ///< steps
  HenckySolid solid{};          ///< a viscoelastic solid where its shear modulus is > 0

  /// Subsections Fluid, Motion and Packing.
  void declare(InputEntries &prm);
  void declare_steps(InputEntries &prm);           ///< of Motion, those of any method
  void declare_packing(InputEntries &prm);         ///< Packing
  void check() const;                              ///< throws std::invalid_argument
  double reach() const { return support + skin; }  ///< over the spacing, of a particle in the lists
  static constexpr double skin = 0.3;
};

struct StokesBox {
  Vector<2> lengths = Vector<2>::Zero();  ///< m
  std::array<bool, 2> periodic{true, true};
  double spacing = 0.;  ///< m
  std::function<bool(const Vector<2> &)> holds_fluid = [](const Vector<2> &) { return true; };
  double area = 0.;  ///< m^2, of fluid
};

struct StokesBooks {
  double work = 0., heat = 0., start = 0., stored = 0.;  ///< J/m; stored: pressure and kinetic
};

class StokesFlow {
 public:
  /// body: a rigid one that forces move (BulkFluid::add_body); none: null.
  StokesFlow(const StokesFlowParameters &parameters, const StokesBox &box, std::vector<BulkWall> walls,
             unsigned int threads, std::unique_ptr<RigidChain> body = nullptr);
  StokesFlow(const StokesFlow &) = delete;
  StokesFlow &operator=(const StokesFlow &) = delete;

  void set_body_force(const Vector<2> &acceleration);  ///< m/s^2
  /// Without driving, walls at rest, until the packing has settled: a disordered one. Throws RunFailed.
  void settle();
  /// Throws RunFailed where velocities (fastest: m/s) or places are none: `what` came apart.
  void require_sound(const std::string &what, double fastest = std::numeric_limits<double>::max()) const;
  double step(double limit);  ///< s; throws std::runtime_error

  double time() const { return at; }
  std::size_t size() const { return system.particles.size(); }
  unsigned int iterations() const { return motion.solver().iterations(); }
  /// N/m, of the last step: on wall k.
  Vector<2> wall_force(std::size_t k) const { return on_wall[k]; }
  Vector<2> driving() const { return acceleration * mass * double(size()); }  ///< N/m, the body force on all
  Vector<2> mean_velocity() const;                                            ///< m/s, of the fluid
  Vector<2> momentum_rate() const { return gained; }  ///< N/m, of the last step; 0 without inertia
  /// What the books miss, over the largest of work and heat; 0 where nothing has happened.
  double balance_error() const;
  std::vector<double> von_mises() const;  ///< Pa, of each particle of a solid, of Cauchy's elastic stress
  FieldFrame frame() const;
  void archive(Archive &a);

  ParticleSystem<2> system;
  BulkFluid<2> *fluid = nullptr;
  RigidChain *carried = nullptr;  ///< the body; null: there is none
  StokesBooks books;
  double last_heat = 0., last_work = 0.;  ///< W/m, of the last step

 private:
  void begin_anew();
  void settle_by_steps();
  double kinetic() const;

  StokesFlowParameters parameters;
  double spacing, mass;
  SystemMotion<2> motion;
  BodyForce<2> *body = nullptr;
  std::optional<Overdamped<2>> stepper;
  Vector<2> acceleration = Vector<2>::Zero();
  std::vector<Vector<2>> on_wall;
  Vector<2> gained = Vector<2>::Zero();
  double at = 0., missed = 0.;  ///< s; J/m, by the books
  bool begun = false;
};
}  // namespace turgor
