#include "micro/cells/tissue_block.h"

namespace turgor {
TissueBlock make_tissue_block(const CellLayout &periodic, const SphParameters &sph,
                              const std::vector<CellContents> &contents, const Surfaces surfaces,
                              const BlockLoad &load) {
  const CutBlock cut = cut_out(periodic, periodic, surfaces);
  TissueBlock block;
  block.cells = make_sph_patch(cut.layout, sph, contents);
  block.width = cut.width;
  block.density = block.cells->density();
  ParticleSystem<2> &system = block.cells->system;
  Particles<2> &particles = system.particles;

  std::vector<DeadForce<2>::Entry> forces;
  for (const CutBlock::Pull &pull :
       cut.pulls([&](const std::uint32_t node) { return particles.position(block.cells->particle(node)); }))
    forces.push_back({block.cells->particle(pull.node), pull.force});
  if (!forces.empty()) system.add(std::make_unique<DeadForce<2>>(std::move(forces)));
  block.body_force = &system.add(std::make_unique<BodyForce<2>>(Vector<2>::Zero()));
  block.acceleration = load.acceleration(block.density, block.width);
  if (load.traction.norm() > 0.) {
    std::vector<DeadForce<2>::Entry> side;
    for (const CutBlock::Pull &pull : cut.carrying(load.traction))
      side.push_back({block.cells->particle(pull.node), pull.force});
    block.traction = &system.add(std::make_unique<DeadForce<2>>(std::move(side), "traction"));
    block.traction->set_share(0.);
  }
  for (const std::uint32_t node : cut.clamped) particles.inverse_mass[block.cells->particle(node)] = 0.;
  for (const std::uint32_t node : cut.probe) block.probe.push_back(block.cells->particle(node));
  return block;
}

void TissueBlock::put_on_load() {
  body_force->set(acceleration);
  if (traction != nullptr) traction->set_share(1.);
}
}  // namespace turgor
