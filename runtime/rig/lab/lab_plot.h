#pragma once
#include <string>
#include <vector>

#include "rig/lab/lab_score.h"

namespace mirada::rig {

/// The tables as one SVG picture, a panel a table (the first, "all", is left out): for each group the median
/// of the error's size (bar), its 90th percentile (whisker) and the paper's median beside it, in percent.
/// Groups without an error are left empty. Text only, a few kB; the same tables give the same bytes.
std::string svg_plot(const std::vector<LabTable>& tables);

}  // namespace mirada::rig
