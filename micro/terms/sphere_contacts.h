// Contacts between the cells of a population of spheres: which pairs touch, and force, stiffness and area of
// each (sphere_contact.h has the laws). The forces go into a sum over each cell's own pairs; friction between
// the cells (sphere_links.h) goes into the matrix of motion from the same pairs.
//
// Fields read: radius (m), modulus (Pa, E/(1 - nu^2) of each cell), with a local stiffness reference_volume
// (m^3) where there is one. Written: f (N).
//
// Local stiffness (local_stiffness.h), by the compression
//   of each cell      before the pairs each cell's modulus is multiplied by g of its mean compression d_i
//                     over the cells it overlaps. The forces then depend on all neighbours, and are no longer
//                     the slope of an energy; the stiffness of a pair counts what its own compression alone
//                     would do to both moduli: that of uniform compression, an upper bound for implicit steps
//   of each contact   both moduli of a pair are multiplied by g(d_ij): F is a function of the distance and
//                     conservative. The same as the first where a cell is equally compressed by all
//                     neighbours, which is where C.9 is calibrated
// energy() is that of the pairs at the present moduli.
//
// For speed: what the pairs read of a cell is packed into one cache line first; a pair is computed once, in
// parallel over pairs. The stress of a cell from its contacts: cell_stress.h. Bodies that the cells touch are
// in the same list (contact_list.h, obstacles.h).
#pragma once

#include "micro/engine/contact_list.h"
#include "micro/engine/term.h"
#include "micro/laws/local_stiffness.h"
#include "micro/laws/contact_law.h"
#include "micro/solve/links.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

namespace turgor {
class Archive;

/// What one pair does; all zero where it does not touch. One cache line.
struct alignas(64) PairContact {
  double e[3]{};          ///< unit vector from i to j
  double force = 0.;      ///< N, positive apart
  double stiffness = 0.;  ///< N/m, along e
  double area = 0.;       ///< m^2
  double energy = 0.;     ///< J
  double distance = 0.;   ///< m, between the centres
};

/// Friction of a pair along its line and across it, N s/m.
struct PairFriction {
  double normal = 0., tangential = 0.,  ///< N s/m^3
      step = 0.;                        ///< h, s; 0: explicit
  struct Coefficients {
    double normal, tangential;
  };
  /// Not the same in all directions.
  bool directed() const { return normal != tangential || step > 0.; }
  bool none() const { return normal == 0. && tangential == 0. && step == 0.; }
  /// Zero where there is no area.
  Coefficients operator()(const PairContact &c) const {
    Coefficients result{normal * c.area, tangential * c.area};
    if (step > 0.) {  // only what keeps the matrix positive definite; repulsion turned sideways is left
                      // explicit. max(0, not a number) is 0
      const double h = c.area > 0. ? step : 0.;
      result.normal += h * std::max(0., c.stiffness);
      result.tangential += h * std::max(0., -c.force / c.distance);
    }
    return result;
  }
};

/// Whose compression the local stiffness goes by.
enum class CompressionOf { cell, contact };
constexpr const char *words_of(CompressionOf) { return "cell|contact"; }

class SphereContacts final : public Term<3> {
 public:
  /// skin: m, of the pair list. stiffness: none, moduli stay what they are.
  SphereContacts(const ContactLaw &law, double skin, std::optional<LocalStiffness> stiffness = {},
                 CompressionOf compression = CompressionOf::cell);

  PairFriction friction;  ///< between the cells

  static std::string name(const ContactLaw &law);
  std::string name() const override { return name(law); }
  void declare(Particles<3> &particles) override;
  /// Pairs, lists brought up to date. Throws StepTooLong naming two cells whose centres coincide. trial:
  /// which pairs touch is not remembered.
  void prepare(const Particles<3> &particles, const Box<3> &box, unsigned int threads, bool trial) override;
  void accept() override;  ///< which pairs touch
  void add_forces(Particles<3> &particles, const Box<3> &box, std::size_t group) override;
  void add_forces_of(Particles<3> &particles, const Box<3> &box, std::size_t begin, std::size_t end) override;
  /// Of the pairs whose first cell is the group's.
  double energy(const Particles<3> &particles, const Box<3> &box, std::size_t group) const override;
  void collect(MotionMatrix &matrix, const Particles<3> &particles, double h) override;
  /// What touched goes on touching. contacts() is empty until the next prepare().
  void gather(const Rearrangement &places) override;
  /// The history: which pairs touch.
  void archive(Archive &a, Particles<3> &particles) override;

  /// Pairs, then f += forces of all contacts, without a system.
  void add_forces(Particles<3> &particles, unsigned int threads, bool trial = false);

  double energy() const;  ///< J

  /// A cell as its contacts see it.
  struct Sphere {
    double radius, reference;  ///< m, now and uncompressed
    double modulus;            ///< Pa
  };
  /// Pa, of a cell at the last add_forces: with the stiffness by its mean compression, if that is how it
  /// goes.
  double modulus(const std::size_t i) const { return cells[i].modulus; }
  /// J, of two cells at a distance (m) that touch where they overlap: what a division chooses its place by.
  double pair_energy(const Sphere &i, const Sphere &j, double distance) const;

  const PairList<3> &list() const { return pairs; }
  /// With what else touches spheres: bodies may be added to it.
  const std::shared_ptr<ContactList<3>> &contact_list() const { return all; }
  const std::vector<PairContact> &contacts() const { return contact; }

  std::size_t memory_bytes() const;

 private:
  struct alignas(64) Cell  ///< what pairs read
  {
    double x[3], radius, modulus;
    double slope = 0., reference = 0.;  ///< Pa: modulus over the compression; m: R_ref
  };
  void pack(const Particles<3> &particles, unsigned int threads);
  /// f += forces on the cells [begin, end).
  void gather_forces(Particles<3> &particles, std::size_t begin, std::size_t end) const;
  struct Touch;
  void store(const Touch &touch, const SphereContact &does);
  template <class Law>
  void compute_pairs(const Law &law, unsigned int threads, bool trial);

  ContactLaw law;
  std::optional<LocalStiffness> stiffness;
  CompressionOf compression;
  std::vector<Cell> cells;
  std::shared_ptr<ContactList<3>> all;
  PairList<3> &pairs;
  std::vector<unsigned char> &touching;
  std::vector<PairContact> contact;
  std::vector<std::unique_ptr<LinkSource>> links;  ///< collected since the last prepare()
};
}  // namespace turgor
