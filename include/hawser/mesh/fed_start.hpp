// Where a feeder's feed point is in the elements of its line at the start.
#pragma once

#include "hawser/mesh/mesh.hpp"

namespace hawser {

struct FedStart {
  int inside = 0;  // whole elements in the stock, counted from the fed end; the next one is at the feed point
  double length = 0;  // m, unstretched, of the part of that one that is outside
};

// For a stock [m] of a line of several elements: the feed point is the element that has then between half of
// its own length and that and a half outside, or the last one of the line.
FedStart fed_start(const Mesh& mesh, const LineSpan& span, bool at_b, double stock);

}  // namespace hawser
