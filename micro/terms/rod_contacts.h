// What rods touch: other rods, and the nodes of a fibre network, which are small spheres (thesis 2.3.3: Hertz
// or JKR along the normal of the rods). A nucleus in the middle of each rod pushes nodes that come so deep.
//
//   delta = R_i + R_j - d,  d the least distance of the two centre lines (closest_segments.h), n along it
//   U(delta, R_ij, E_ij) of two spheres (laws/contact_law.h), R_ij and E_ij as thesis 2.6
//
// R_i follows from L_i (laws/rod_shape.h), so that whoever presses on a rod's side makes it longer: the force
// on R_i is -(F + dU/dR_ij (R_ij/R_i)^2), and acts on both ends along the rod by R'(L). Forces are slopes of
// the energy; those of a pair are equal and opposite along n, and no pair has a torque. A node gets the
// opposite of what it does to the rod (errata of 2.36 and 2.37).
//
// Friction of a pair is area of contact times `normal` along n and `tangential` across, of the two centre
// lines where they are nearest, as between spheres (2.4). A rod of no length is a sphere; squeezed from two
// sides it stays one until something gives it a direction. Lines are seen blunted (blunt_line.h): without
// that the energy of a rod pressed round has a tip at L = 0, about which it chatters.
//
// One list of who is near (contact_list.h), of spheres around each rod and the nodes. Parallel rods beside
// each other touch in the middle of what they share, as two spheres do: a contact along a line is stiffer.
#pragma once

#include "micro/engine/contact_list.h"
#include "micro/laws/contact_law.h"
#include "micro/terms/blunt_line.h"
#include "micro/terms/rods.h"

#include <optional>

namespace turgor {
struct RodContactParameters {
  ContactLaw law = HertzContact();
  double skin = 1e-6;                   ///< m, of the list
  double modulus = 0.;                  ///< Pa, E/(1 - nu^2) of a rod
  double nucleus_radius = 0.;           ///< m; 0: none
  double nucleus_modulus = 0.;          ///< Pa, E/(1 - nu^2)
  std::uint32_t nodes = 0;              ///< particles 0 to nodes - 1 are nodes
  double node_radius = 0.;              ///< m
  double node_modulus = HUGE_VAL;       ///< Pa, E/(1 - nu^2)
  double normal = 0., tangential = 0.;  ///< N s/m^3, friction
};

/// What one pair does; all zero where it does not touch.
struct RodContact {
  Vector<3> n = Vector<3>::Zero();        ///< unit vector from i to j
  double s = 0., t = 0.;                  ///< where on i and j, 0 at A
  double force = 0., overlap = 0.;        ///< N, positive apart; m
  double squeeze_i = 0., squeeze_j = 0.;  ///< N, on R_i and R_j, positive where it makes them less
  double stiffness = 0.;                  ///< N/m
  double area = 0.;                       ///< m^2
  double energy = 0.;                     ///< J
  Vector<3> nucleus = Vector<3>::Zero();  ///< N, on the middle of rod j by node i, beside all this
  double nucleus_stiffness = 0.;          ///< N/m
};

class RodContacts final : public Term<3> {
 public:
  RodContacts(std::shared_ptr<RodSet> rods, const RodContactParameters &parameters);

  std::string name() const override { return "rod_contacts+" + name_of(parameters.law); }
  void declare(Particles<3> &particles) override;
  /// Throws StepTooLong where two centre lines cross.
  void prepare(const Particles<3> &particles, const Box<3> &box, unsigned int threads, bool trial) override;
  void accept() override;
  void add_forces(Particles<3> &particles, const Box<3> &box, std::size_t group) override;
  void collect(MotionMatrix &matrix, const Particles<3> &particles, double h) override;
  /// Half of each pair at each of its two.
  double energy(const Particles<3> &particles, const Box<3> &box, std::size_t group) const override;
  /// The history: which pairs touch.
  void archive(Archive &a, Particles<3> &particles) override;

  const std::vector<Pair> &pairs() const { return list.pairs().pairs(); }  ///< nodes, then rods, as bodies
  const std::vector<RodContact> &contacts() const { return contact; }
  std::uint32_t body_of(const std::size_t rod) const { return parameters.nodes + std::uint32_t(rod); }
  std::size_t memory_bytes() const;

 private:
  struct Body  ///< a rod, or a node, which is a rod of no length that nothing squeezes
  {
    BluntLine line;
    double radius, slope;
    Vector<3> longer() const { return slope * line.seen.u; }  ///< change of the radius with w of blunt_line.h
  };
  bool is_node(const std::size_t body) const { return body < parameters.nodes; }
  void pack(const Particles<3> &particles, unsigned int threads);
  template <class Law>
  RodContact touch(const Law &law, const Pair &pair, unsigned char &touches) const;
  /// Of node i and the nucleus in rod j.
  void press_nucleus(const Body &i, const Body &j, RodContact &c) const;
  /// N, on a body by a pair of which it is the first or the second: on A (of a node all) and on B, the ends
  /// of the line that it sees.
  std::array<Vector<3>, 2> push(const RodContact &c, std::uint32_t body, bool first) const;
  void rub(MotionMatrix &matrix, const Pair &pair, const RodContact &c, double h) const;
  /// What contacts that press along short rods are worth as springs: the bowl of blunt_line.h.
  void hold_short_rods(MotionMatrix &matrix, double h) const;
  /// The bodies of a group, as visit(number, particle A).
  template <class Visit>
  void for_bodies_of(const Particles<3> &particles, std::size_t group, const Visit &visit) const;

  std::shared_ptr<RodSet> rods;
  RodContactParameters parameters;
  Particles<3> spheres;  ///< around each body
  ContactList<3> list;
  std::vector<Body> bodies;
  std::vector<RodContact> contact;
  std::vector<unsigned char> touching_now;
};
}  // namespace turgor
