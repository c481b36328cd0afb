#pragma once
#include <vector>

#include "vision/column_scan.h"

namespace mirada::vision {

/// What was crossed as shade, light or a tile but has upright sides stands on the floor: there the columns
/// end after all. A patch on the floor gets narrower towards its sides; a thing's sides are lines of the
/// grid.
void stop_at_upright(const ColumnScan& scan, const std::vector<ColumnSpan>& spans,
                     std::vector<ColumnResult>& results);

}  // namespace mirada::vision
