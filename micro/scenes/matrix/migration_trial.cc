#include "micro/scenes/matrix/migration_trial.h"

#include "run/archive.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
/// The tessellation that makes random nodes even costs the cube of their number.
constexpr unsigned int most_columns = 30;
}  // namespace

unsigned int MatrixParameters::columns() const {
  return std::min(most_columns, unsigned(std::lround(std::min(side / pore, 1e6))));
}

unsigned int MatrixParameters::rows() const { return 2 * unsigned(std::lround(columns() / std::sqrt(3.))); }

unsigned int MatrixParameters::pieces() const {
  return repeated ? std::max(1u, unsigned(std::lround(std::min(side / (pore * columns()), 1e3)))) : 1u;
}

std::vector<Vector<3>> colony_places(const unsigned int count, const double apart) {
  const int rings = int(std::ceil(std::sqrt(count / 3.))) + 1;
  std::vector<Vector<3>> all;
  for (int row = -rings; row <= rings; ++row)
    for (int column = -2 * rings; column <= 2 * rings; ++column)
      all.push_back({apart * (column + 0.5 * row), apart * 0.5 * std::sqrt(3.) * row, 0.});
  std::stable_sort(all.begin(), all.end(), [apart](const Vector<3> &a, const Vector<3> &b) {
    return a.squaredNorm() < b.squaredNorm() - 1e-9 * apart * apart;
  });
  all.resize(count);
  return all;
}

MigrationTrial::MigrationTrial(const TrialParameters &parameters, const std::uint64_t seed,
                               const unsigned int threads)
    : cells(parameters.cell, threads), reach(parameters.protruding.reach) {
  const MatrixParameters &matrix = parameters.matrix;
  PlaneNet net = random_net(matrix.pore, matrix.columns(), matrix.rows(), seed);
  if (matrix.pieces() > 1) net = repeated(net, matrix.pieces(), matrix.pieces());
  centre(net);
  half = 0.5 * net.periods.minCoeff();
  const std::vector<Vector<3>> places = colony_places(parameters.cells, 2. * parameters.cell.radius);
  colony = places.back().norm() + parameters.cell.radius;
  // three cells that touch each other leave room within 2/sqrt(3) radii of their middles, where no node stays
  const double alone = parameters.cell.radius + matrix.node_radius;
  std::vector<Vector<2>> covered;
  for (const Vector<3> &place : places) covered.push_back(place.head<2>());
  carve(net, covered, parameters.cells > 1 ? std::max(alone, 1.16 * parameters.cell.radius) : alone);
  cells.add_network(net, {matrix.stiffness, matrix.stiff_side * matrix.stiffness}, matrix.node_friction,
                    matrix.anchors ? matrix.pore : 0., seed);
  cells.add_rods(places, places);
  const RodContacts &contacts = cells.add_contacts(parameters.law, matrix.node_radius);
  Protrusions &arms = cells.add_protrusions(parameters.protrusion, parameters.most);
  ProtrudingParameters search = parameters.protruding;
  search.seed = seed;
  protruding =
      std::make_unique<Protruding>(search, cells.rods, arms, contacts, std::uint32_t(cells.network->nodes()));
  cells.after_step = [this](const double h) { protruding->after_step(cells.system.particles, h); };
  cells.begin(parameters.cell.longest_step);
}

void MigrationTrial::step(const double limit) { cells.step(limit); }

Vector<3> MigrationTrial::middle(const std::size_t rod) const {
  const RodSet::Line line = cells.rods->line(cells.system.particles, rod);
  return 0.5 * (line.a + line.b);
}

double MigrationTrial::length(const std::size_t rod) const {
  return cells.rods->line(cells.system.particles, rod).L;
}

bool MigrationTrial::at_border() const {
  double farthest = 0.;
  for (std::uint32_t end = cells.rods->first; end < cells.system.particles.size(); ++end)
    for (int d = 0; d < 2; ++d) farthest = std::max(farthest, std::abs(cells.system.particles.x[d][end]));
  return farthest + reach > half;
}

FieldFrame MigrationTrial::frame() const {
  const Particles<3> &p = cells.system.particles;
  FieldFrame frame = cells.frame();  // the rods first
  std::vector<double> radius = frame.fields[0].values, tension(radius.size(), 0.), kind(radius.size(), 2.);
  const auto line = [&](const Vector<3> &a, const Vector<3> &b, const double pull, const double what) {
    for (const Vector<3> &end : {a, b}) {
      frame.cells.push_back(std::uint32_t(frame.points.size() / 3));
      frame.points.insert(frame.points.end(), end.data(), end.data() + 3);
    }
    radius.push_back(0.);
    tension.push_back(pull);
    kind.push_back(what);
  };
  const std::vector<double> tensions = cells.springs->tensions(p, cells.system.box);
  for (std::size_t k = 0; k < tensions.size(); ++k) {
    const FibreNetwork::Bond &bond = cells.network->bonds[k];
    const Vector<3> a = p.position(bond.a);
    line(a, a + cells.network->along(bond, p, cells.system.box), tensions[k], 0.);
  }
  for (std::size_t rod = 0; rod < cells.rods->size(); ++rod)
    for (std::uint32_t k = 0; k < cells.protrusions->most(); ++k)
      if (const Protrusions::Arm &arm = cells.protrusions->arm(rod, k); arm.holds())
        line(p.position(cells.rods->a(rod) + arm.end), p.position(arm.node),
             cells.protrusions->tension(p, rod, arm), 1.);
  frame.fields = {
      {"radius [m]", 1, radius, true}, {"tension [N]", 1, tension, true}, {"kind", 1, kind, true}};
  return frame;
}

void MigrationTrial::archive(Archive &a) {
  a.section("migration_trial");
  a(cells, *protruding);
}
}  // namespace turgor
