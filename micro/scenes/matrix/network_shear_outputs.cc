#include "micro/scenes/matrix/network_shear.h"

namespace turgor {
Outputs NetworkShear::outputs() const {
  const char *sheared = "with a Largest strain above 0", *whole = "with Nodes = sixfold and no anchors",
             *diluted = "with Kept bonds below 1 and no anchors";
  Outputs all;
  all.results(
         {{"samples", "", "Number of networks whose moduli were measured."},
          {"shear_over_affine", "1",
           "Shear modulus over that of the affine limit of the same network, mean of all networks."},
          {"young_over_relation", "1",
           "Young's modulus times Depth over 2/sqrt(3) k_ECM, the relation of a sixfold lattice, mean of all "
           "networks."},
          {"poisson_ratio", "1", "Poisson's ratio in the plane, pulled along x, mean of all networks."},
          {"reference_error", "1",
           "Largest difference of a shear or Young's modulus from that of the exact linear response of the "
           "same network, over that of its affine limit."},
          {"lattice_error", "1",
           "Largest deviation of a shear or Young's modulus from sqrt(3)/4 k_ECM and 2/sqrt(3) k_ECM over "
           "Depth, relative.",
           whole},
          {"effective_medium_error", "1",
           "Shear modulus over that of the same network before fibres were taken away, less the effective "
           "medium's (p - 2/3)/(1 - 2/3), mean of all networks that are short of fibres.",
           diluted},
          {"energy_balance", "1",
           "Elastic energy of the sheared network less the work of its stress since rest, over that energy.",
           sheared}})
      .table("moduli", "One row a network.",
             {{"pore_size", "m", "Mean length of the fibres."},
              {"stiffness", "N/m", "Spring constant k_ECM of the fibres."},
              {"kept_bonds", "1", "Share of the fibres that were left where they are taken away at random."},
              {"seed", "", "Seed of the random places of the network."},
              {"nodes", "", "Number of nodes of the periodic piece."},
              {"bonds_per_node", "", "Mean number of fibres at a node, those to anchors not counted."},
              {"shear_modulus", "Pa", "Shear modulus G in the plane, at rest."},
              {"young_modulus", "Pa", "Young's modulus E of a pull along x, free across, at rest."},
              {"poisson_ratio", "1", "Poisson's ratio of that pull, in the plane."},
              {"affine_shear_modulus", "Pa", "Shear modulus if all nodes went with the strain."},
              {"affine_young_modulus", "Pa", "Young's modulus if all nodes went with the strain."},
              {"reference_shear_modulus", "Pa", "Shear modulus by the exact linear response."},
              {"reference_young_modulus", "Pa", "Young's modulus by the exact linear response."}})
      .table("shear", "One row a step of the sheared network, the first at rest.",
             {{"strain", "1", "Shear: shift along x over the height along y.", sheared},
              {"shear_stress", "Pa", "Shear stress at rest under that strain.", sheared},
              {"affine_shear_stress", "Pa", "Shear stress if all nodes had gone with the strain.", sheared},
              {"normal_stress_x", "Pa", "Normal stress along the shift, positive in tension.", sheared},
              {"normal_stress_y", "Pa", "Normal stress across the shift, positive in tension.", sheared},
              {"energy", "J", "Elastic energy of the piece of network.", sheared},
              {"work", "J", "Work of the shear stress since rest, by trapezoids.", sheared}})
      .fields("network",
              "The fibres of the sheared network as lines, at rest and on the way; the time is its strain.",
              {{"tension", "N", "Tension of each fibre, positive where it is stretched.",
                "with Frames above 0"}});
  return all;
}
}  // namespace turgor
