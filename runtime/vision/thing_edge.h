#pragma once
#include "vision/picture_grid.h"

namespace mirada::vision {

/// Where between two neighbouring lines the side of a thing lies that stands on `column` at `row` and not on
/// the line `beside` it: 0 on `column`, 1 on the other, a little outside both is possible. In the middle when
/// the picture does not show it.
double thing_edge(const PictureGrid& grid, int column, int beside, double row);

}  // namespace mirada::vision
