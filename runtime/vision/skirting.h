#pragma once
#include <vector>

#include "vision/column_scan.h"

namespace mirada::vision {

/// A skirting board in nearly the floor's look is crossed column by column, and the wall behind it stops the
/// scan. What one column cannot tell, many together can: a step in the look that stands equally high below
/// the wall all along it. Columns where there is one end at its foot.
void stop_at_skirting(const PictureGrid& grid, const RowScale& scale, const std::vector<ColumnSpan>& spans,
                      const ColumnScan& scan, std::vector<ColumnResult>& results);

}  // namespace mirada::vision
