#include "micro/scenes/matrix/network_shear.h"

#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"

#include <algorithm>
#include <cmath>

namespace turgor {
void NetworkShear::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter(
      "Nodes", nodes,
      "Places of the nodes: random: random places made even, each joined to its neighbours, 6 in "
      "the mean; sixfold: a triangular lattice. Units: none.");
  prm.add_parameter("Pore sizes", pores,
                    "Mean lengths of the fibres between two nodes, a network for each. Units: m.",
                    List(Double(1e-9, 1e-2), 1, 50));
  prm.add_parameter("Stiffnesses", stiffnesses,
                    "Spring constants k_ECM of the fibres (2.38), a network for each. Units: N/m.",
                    List(Double(1e-12, 1e6), 1, 50));
  prm.add_parameter("Kept bonds", kept,
                    "Shares of the fibres that are there, the others taken away at random, a network for "
                    "each; below 2/3 nothing but anchors holds a network. Units: none.",
                    List(Double(0.3, 1.), 1, 50));
  prm.add_parameter("Seeds", seeds, "Number of networks of each kind. Units: none.", Integer(1, 1000));
  prm.add_parameter("First seed", first_seed, "Seed of the first of them. Units: none.", Integer(1, 1000000));
  prm.add_parameter("Side", side,
                    "Side of the periodic piece of network, to which whole pores are fitted. Units: m.",
                    Double(1e-8, 1.));
  prm.add_parameter("Anchors", anchors,
                    "Whether each node is tied to three fixed places above and three below it, which go with "
                    "the strain. Units: none.",
                    Bool());
  prm.add_parameter("Layer height", height,
                    "Distance of the anchors from the plane of the nodes; 0: the pore size. Units: m.",
                    Double(0., 1e-2));
  prm.add_parameter("Depth", depth,
                    "Thickness of the layer of matrix that the plane network stands for: forces per length "
                    "over it are stresses; 0: the pore size. Units: m.",
                    Double(0., 1e-2));
  prm.add_parameter("Small strain", small_strain,
                    "Strain of which moduli are measured, by differences of both signs. Units: none.",
                    Double(1e-7, 0.05));
  prm.add_parameter("Largest strain", largest_strain,
                    "Shear to which the first network is taken in the end; 0: it is not. Units: none.",
                    Double(0., 2.));
  prm.add_parameter("Steps", steps, "Number of equal steps of strain on that way. Units: none.",
                    Integer(1, 10000));
  prm.add_parameter(
      "Frames", frames,
      "Number of pictures of that network for ParaView, one at the start; 0: none. Units: none.",
      Integer(0, 1000));
  prm.add_parameter("Tolerance", tolerance,
                    "Force left on a node at rest over k_ECM times pore size times strain. Units: none.",
                    Double(1e-11, 1e-2));
}

unsigned int NetworkShear::columns(const double pore) const {
  return unsigned(std::lround(std::min(side / pore, 1e6)));
}

unsigned int NetworkShear::rows(const double pore) const {
  return 2 * unsigned(std::lround(std::min(side / (std::sqrt(3.) * pore), 1e6)));
}

void NetworkShear::check() const {
  // the tessellation that makes random nodes even costs the cube of their number
  const unsigned int most = nodes == NetworkNodes::random ? 30 : 200;
  for (const double pore : pores)
    if (columns(pore) < 4 || rows(pore) < 4 || columns(pore) > most)
      throw InputError("Side = " + number_text(side) + " m holds " + number_text(side / pore) + " pores of " +
                       number_text(pore) + " m, but with Nodes = " + word_of(nodes) + " 4 to " +
                       number_text(most) + " are allowed: give a Side from 4 times the largest to " +
                       number_text(most) + " times the smallest of Pore sizes.");
  if (height > 0. && !anchors)
    throw InputError(
        "Layer height is " + number_text(height) +
        " m, but without anchors there are no layers: give Anchors = true, or Layer height = 0.");
  if (nodes == NetworkNodes::sixfold && *std::min_element(kept.begin(), kept.end()) < 1. && !anchors)
    throw InputError(
        "Kept bonds below 1 leave fibres of a sixfold lattice in line with nothing beside them, which buckle "
        "under any strain: give Nodes = random, Anchors = true or Kept bonds = 1.");
  if (frames > 0 && largest_strain == 0. && frames > 1)
    throw InputError("Frames = " + number_text(frames) +
                     " needs a Largest strain above 0; without it Frames = 1 draws the network at rest.");
}

NetworkParameters NetworkShear::sample(std::size_t number) const {
  NetworkParameters p;
  const auto next = [&number](const std::size_t count) {
    const std::size_t k = number % count;
    number /= count;
    return k;
  };
  p.seed = first_seed + next(seeds);
  p.kept = kept[next(kept.size())];
  p.stiffness = stiffnesses[next(stiffnesses.size())];
  p.pore = pores[next(pores.size())];
  p.nodes = nodes;
  p.columns = columns(p.pore);
  p.rows = rows(p.pore);
  p.height = !anchors ? 0. : height > 0. ? height : p.pore;
  p.depth = depth > 0. ? depth : p.pore;
  return p;
}
}  // namespace turgor
