#pragma once
#include <vector>

#include "vision/column_scan.h"

namespace mirada::vision {

/// Of the rows of a side, how many must differ from what is beside for it to be seen.
inline constexpr double kSideSeenShare = 0.65;

/// Narrow things that turn out to have no sides give way to what stands beside them; near by only single
/// ones, for a thing in the floor's colour may show no more.
void drop_specks(const ColumnScan& scan, std::vector<ColumnResult>& results);

}  // namespace mirada::vision
