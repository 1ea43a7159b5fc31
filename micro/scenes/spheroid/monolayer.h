// Scene `monolayer`: cells on a flat substrate that grow and divide in the plane z = 0 (thesis 2.2.2). All
// centres stay there, as every force between them lies in it and they crawl and diffuse in it alone; friction
// with the medium is that of the substrate.
//
// The pressure in the middle of a growing monolayer rises with its size, as the friction of the substrate has
// to be overcome: growth turns from exponential to one of the rim (radius linear in time) where the
// inhibition binds.
#pragma once

#include "micro/scenes/spheroid/spheroid_free.h"

namespace turgor {
class Monolayer final : public SpheroidFree {
 public:
  Monolayer();

 protected:
  void check_more() const override;
};

std::unique_ptr<Scenario> make_monolayer();
}  // namespace turgor
