// What is measured on an aggregate between plates: where cells are flattened, how far walls are stretched,
// what has failed and how deep; and from the history of a run: modulus, oscillation, the strains at which
// cells fail.
#pragma once

#include "micro/cells/brick_tissue.h"

#include <cstdint>
#include <vector>

namespace turgor {
/// The tissue when the plates touch it.
struct TissueStart {
  double low = 0., high = 0., width = 0.;  ///< m, extremes of the walls in y; largest extent in x
  std::vector<double> cell_height,
      depth;  ///< m, per cell; its centre below `high`, over the height of the tissue

  static TissueStart of(const BrickTissue &tissue);
  double height() const { return high - low; }
};

/// One row of the history; plain data, so that a checkpoint keeps it.
struct TissueSample {
  double time = 0., strain = 0.;  ///< s since the plate moves; way of the plate over the height
  double top = 0., bottom = 0.;   ///< N, on the plates
  double centre = 0.;    ///< mean depth of the flattening: 0 at the moving plate, 1 at the other, 0.5 even
  double flattest = 0.;  ///< largest 1 - height / height at the start of a cell
  double stretch_near = 0.,
         stretch = 0.;  ///< mean stretch of the walls of the cells in the first fifth below the plate; of all
  double largest_stretch = 0.;  ///< of a bond that holds
  double failed_cells = 0., broken_bonds = 0., broken_ties = 0.;
  double failed_depth = 0.;  ///< mean depth of the failed cells; 0 where there are none
};

/// Everything but time, strain and plates.
TissueSample measure(const BrickTissue &tissue, const TissueStart &start);

/// Flattening 1 - height / height at the start, mean of every row of cells (the lowest first).
std::vector<double> flattening_of_rows(const BrickTissue &tissue, const TissueStart &start,
                                       unsigned int rows);

/// Slope of the mean force on both plates (waves between them cancel) against strain between two strains (N),
/// least squares; 0 with less than two samples.
double slope_between(const std::vector<TissueSample> &history, double from, double to);

/// Value of a member at a strain, linear between samples; the last one beyond them.
double at_strain(const std::vector<TissueSample> &history, double TissueSample::*member, double strain);

/// Mean of a member over strains within `half` of one, as far as the history goes. For the plates' forces:
/// they ring, at 5 m/s and 5 % between half and one and a half of their mean.
double mean_around(const std::vector<TissueSample> &history, double TissueSample::*member, double strain,
                   double half);

/// Oscillation of the transmitted force: how much it falls on its way, sum of falls of its mean over `window`
/// samples, over its range.
double oscillation(const std::vector<TissueSample> &history, std::size_t window);

/// A logistic curve through a growing count, least squares: count = height/(1 + exp(-(strain -
/// centre)/width)).
struct Sigmoid {
  double height = 0., centre = 0., width = 0.;
  double explained = 0.;  ///< share of the variance
};
/// Centre and width on a grid of 1/200 of the largest strain and of 10 %.
Sigmoid fit_sigmoid(const std::vector<TissueSample> &history, double TissueSample::*count);

/// First strain at which a growing count reaches `value`; -1 if it never does.
double strain_reaching(const std::vector<TissueSample> &history, double TissueSample::*count, double value);
}  // namespace turgor
