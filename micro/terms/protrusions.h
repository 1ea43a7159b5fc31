// Protrusions of rods (rods.h), each from one end of its rod to a node of the matrix: they pull both towards
// each other by the tension of laws/protrusion_law.h (thesis 2.36, 2.37: what pulls the cell pulls the node
// the other way). Between steps the protrusions change by contract(), attach() and release(), which put
// energy in or take it out at places that are held.
//
//   auto &arms = system.add(std::make_unique<Protrusions>(rods, nodes, law, 5));    most of a rod
//   arms.attach(particles, rod, end, node);   arms.contract(particles, h);
//
// Nodes are particles 0 to nodes - 1; of the image that is nearest in no period: a rod near the border of a
// periodic net reaches across it to nothing.
#pragma once

#include "micro/laws/protrusion_law.h"
#include "micro/terms/rods.h"

namespace turgor {
class Protrusions final : public Term<3> {
 public:
  static constexpr std::uint32_t free = ~std::uint32_t(0);
  struct Arm {
    std::uint32_t node = free;  ///< that it has hold of
    std::uint32_t end = 0;      ///< of its rod: 0 A, 1 B
    ProtrusionState state;
    bool holds() const { return node != free; }
  };

  Protrusions(std::shared_ptr<RodSet> rods, std::uint32_t nodes, const ProtrusionLaw &law,
              std::uint32_t most);

  std::string name() const override { return "protrusions"; }
  void declare(Particles<3> &particles) override;
  void add_forces(Particles<3> &particles, const Box<3> &box, std::size_t group) override;
  void collect(MotionMatrix &matrix, const Particles<3> &particles, double h) override;
  /// Half of each at either end.
  double energy(const Particles<3> &particles, const Box<3> &box, std::size_t group) const override;
  void archive(Archive &a, Particles<3> &particles) override;

  std::uint32_t most() const { return most_of_rod; }
  const Arm &arm(const std::size_t rod, const std::uint32_t k) const { return arms[rod * most_of_rod + k]; }
  std::uint32_t count(std::size_t rod) const;  ///< of those that hold
  bool holds(std::size_t rod, std::uint32_t node) const;
  double length(const Particles<3> &particles, std::size_t rod, const Arm &arm) const;          ///< m
  double tension(const Particles<3> &particles, const std::size_t rod, const Arm &arm) const {  ///< N
    return law.tension(arm.state, length(particles, rod, arm));
  }
  /// N, on the rod; zero where it holds nothing.
  Vector<3> force(const Particles<3> &particles, std::size_t rod, const Arm &arm) const;

  /// A free one of the rod takes hold; there has to be one.
  void attach(const Particles<3> &particles, std::size_t rod, std::uint32_t end, std::uint32_t node);
  void release(std::size_t rod, std::uint32_t k);
  void release_all(std::size_t rod);
  /// All by h (s) where particles are; those that are over let go.
  void contract(const Particles<3> &particles, double h);

 private:
  std::uint32_t particle(const std::size_t rod, const Arm &arm) const { return rods->a(rod) + arm.end; }
  void sort();  ///< who holds which node
  template <class Visit>
  void for_arms_of(const Particles<3> &particles, std::size_t group, const Visit &visit) const;

  std::shared_ptr<RodSet> rods;
  std::uint32_t nodes;
  ProtrusionLaw law;
  std::uint32_t most_of_rod;
  std::vector<Arm> arms;                         ///< of rods, most_of_rod each
  std::vector<std::uint32_t> first_of, of_node;  ///< arms by the nodes that they hold
  bool sorted = false;
  void prepare(const Particles<3> &, const Box<3> &, unsigned int, bool) override {
    if (!sorted) sort();
  }
};
}  // namespace turgor
