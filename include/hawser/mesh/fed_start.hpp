// Position of a feeder's feed point in the elements of its line at the start.
#pragma once

#include "hawser/mesh/mesh.hpp"

namespace hawser {

struct FedStart {
  int inside = 0;     // full elements in the stock, from the fed end; the next one is at the feed point
  double length = 0;  // m, unstretched, of the part of that element outside the feeder
};

// For a stock [m] of a line of several elements: the feed point is in the element of which between 0.5 and
// 1.5 of its length is then outside, or in the last one of the line.
FedStart fed_start(const Mesh& mesh, const LineSpan& span, LineEnd line_end, double stock);

}  // namespace hawser
