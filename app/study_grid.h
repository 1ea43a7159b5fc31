// The runs of a study's Grid and Axes:
//   Grid = A = 1 | 2; B & C = 3 & 4 | 5 & 6      every value of A with every pair of B and C: four runs
//   Axes = A = 1 | 2; B & C = 3 & 4 | 5 & 6      one entry (one group) at a time: four runs
#pragma once

#include "app/study_input.h"

#include <string>
#include <vector>

namespace turgor {
/// The run itself where both are empty, else one for each point, labelled "LABEL 1, 3 & 4" (Grid) and "LABEL
/// B & C 3 & 4" (Axes). Throws InputError; where: what it begins with, "study.prm: 'Run LABEL".
std::vector<StudyRun> points_of(const StudyRun &run, const std::string &grid, const std::string &axes,
                                const std::string &where);
}  // namespace turgor
