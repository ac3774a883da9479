// Signed distances at the cell centres of a coarse grid over a mesh. As distance grows no faster than
// the way (Lipschitz constant 1) they bound it at every point: most points outside are known to be so
// without a search, and a point that may be inside knows how far to search at most.
#pragma once

#include <functional>
#include <vector>

#include "hawser/geometry/box.hpp"
#include "hawser/geometry/const_array.hpp"

namespace hawser::detail {

class CoarseDistance {
 public:
  struct Sample {
    int triangle;   // nearest active, hint for the next
    double active;  // m, to the active part, >= 0
    double whole;   // m, signed, to the whole mesh
    double closed;  // m, to where the body begins without an active facet; infinite: nowhere
  };
  struct About {
    bool outside;              // certainly
    double at_least, at_most;  // m, bounds of the distance to the active part
  };

  CoarseDistance() = default;
  CoarseDistance(const Box& box, std::size_t triangles,
                 const std::function<Sample(const Vec3&, int hint)>& sample);
  About about(const Vec3& y) const;
  // m: the body begins nowhere nearer to y than that without an active facet.
  double closed_within(const Vec3& y) const;
  template <class Self, class P>
  static void pack(Self& self, P& p) {
    p.value(self.box_), p.value(self.side_), p.value(self.rounding_), p.value(self.n_);
    p.array(self.cells_), p.array(self.closed_);
  }

 private:
  struct Cell {
    float active, whole;
  };
  Box box_;
  double side_ = 1, rounding_ = 0;
  int n_[3] = {1, 1, 1};
  // The cell nearest to y, and how far y is from its centre, m.
  std::size_t cell(const Vec3& y, double& way) const;
  ConstArray<Cell> cells_;
  ConstArray<float> closed_;  // m, of the cells; empty: infinite
};

}  // namespace hawser::detail
