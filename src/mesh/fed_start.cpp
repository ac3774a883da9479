// First node outside the feeder of a fed line, from the length of its stock.
#include "hawser/mesh/fed_start.hpp"

namespace hawser {

FedStart fed_start(const Mesh& mesh, const LineSpan& span, LineEnd line_end, double stock) {
  const auto length = [&](int i) {
    return mesh.element(span.first_element + (line_end == LineEnd::B ? span.elements - 1 - i : i)).length;
  };
  FedStart out;
  double inside = 0;
  while (out.inside + 1 < span.elements && length(out.inside) < 2 * (stock - inside))
    inside += length(out.inside++);
  out.length = length(out.inside) - (stock - inside);
  return out;
}

}  // namespace hawser
