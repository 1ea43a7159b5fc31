// What makes an even stress sigma be in balance beside a wall.
// Over V it pushes at body i with
//   F_i = sigma [sum_j w (c_i S_i^-1 + c_j S_j^-1) r_ij + c_i S_i^-1 f_i sum_q w_q r_q],
// c a factor of theta, f of all rays of a body. With c_i = n.S_i.n/kappa, n towards the wall, a flat wall is
// left with F_i = (sigma n/kappa) . [2 sum_j w r_ij + f_i sum_q w_q r_q], which f_i makes vanish: rays stand
// for a wall that fills the half plane evenly, the particles for rows. An affine flow beside it then is the
// discrete solution, and what a curved one misses there is of second order. Without (c = f = 1) the two rows
// beside a wall slip by 0.0024 spacings of the shear, an error of first order.
//
// kappa is the mean of n.S.n beside walls, so that the whole fluid dissipates what an affine flow does; c = 1
// away from them. Both factors are scalars >= 0 of where everything is: the friction stays symmetric, takes
// energy from every flow but rigid motions, and keeps both momenta. What else was tried: doc/validation.md.
#include "micro/terms/sph_drag_rows.h"

#include <algorithm>

namespace turgor {
using namespace drag_rows;

namespace {
constexpr double most_of_rays = 2., least_of_rays = 0.5;   // f; hardly seen walls may vanish
constexpr double most_of_body = 1.5, least_of_body = 0.5;  // c
}  // namespace

template <int dim>
void SphDrag<dim>::weigh_rays(const std::size_t i) {
  Body<DoubleRow> &me = exact.body[i];
  const double square = dot<dim>(me.wall, me.wall);
  if (!(square > 0.)) return;
  const double share = me.wall_w / (me.wall_w + me.w),
               factor = std::clamp(-2. * dot<dim>(me.pairs, me.wall) / square, std::min(least_of_rays, share),
                                   most_of_rays);
  me.wall *= factor;
  me.wall_w *= factor;
  for (DoubleRow &column : me.central) column *= factor;
  for (std::uint32_t q = first_ray[i]; q < first_ray[i + 1]; ++q) rays[q].w *= factor;
}

/// Those that see a wall: theta by c.
template <int dim>
void SphDrag<dim>::weigh_bodies() {
  std::vector<std::size_t> beside;
  std::vector<double> c;  // n.S.n, then over its mean
  double sum = 0.;
  for (std::size_t i = 0; i < bodies(); ++i) {
    const Body<DoubleRow> &me = exact.body[i];
    const double square = dot<dim>(me.wall, me.wall);
    if (!(square > 0.)) continue;
    beside.push_back(i);
    c.push_back(square / dot<dim>(me.wall, times<dim>(me.inverse, me.wall)));
    sum += c.back();
  }
  const double n = double(beside.size()), mean = sum / n;
  sum = 0.;
  for (double &one : c) sum += one = std::clamp(one / mean, least_of_body, most_of_body);
  for (std::size_t k = 0; k < beside.size(); ++k) exact.body[beside[k]].theta *= n * c[k] / sum;
}

template void SphDrag<2>::weigh_rays(std::size_t);
template void SphDrag<3>::weigh_rays(std::size_t);
template void SphDrag<2>::weigh_bodies();
template void SphDrag<3>::weigh_bodies();
}  // namespace turgor
