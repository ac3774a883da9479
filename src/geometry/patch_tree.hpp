// A tree for the nearest of the curved facets of a mesh: boxes that know how far each patch bulges, eight to
// a node, and in the leaves the corners of the flat triangles in single precision, eight at a time.
//
// Built by the surface area heuristic in 16 bins (Wald 2007, "On fast construction of SAH-based bounding
// volume hierarchies"), two children split again until there are eight. A search collects the patches whose
// flat triangle, less its bulge, may be the nearest, and asks the caller for the distances of those only.
// About 50 bytes a triangle.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "hawser/geometry/box.hpp"
#include "hawser/geometry/large_vector.hpp"
#include "hawser/geometry/smooth_patch.hpp"

namespace hawser::detail {

class PatchTree {
 public:
  struct Item {
    int triangle;
    SmoothPatch patch;
  };
  PatchTree() = default;
  explicit PatchTree(const std::vector<Item>& items);

  bool empty() const { return ids_.empty(); }
  const Box& box() const { return box_; }

  // Calls visit(triangle, best) for patches that may be within the distance sqrt(best) [m²] of p, the most
  // promising first; visit may lessen best. None within the final best is left out, nor any just at it.
  template <class Visit>
  void nearest(const Vec3& p, double& best, Visit&& visit) const {
    if (empty()) return;
    Search s(*this, p, best);
    bool more = true;
    while (more) {
      more = collect(s);
      // The nearest first; then most of the others are out of reach.
      for (int first = 0; first < s.waiting; ++first) {
        int next = first;
        for (int i = first + 1; i < s.waiting; ++i)
          if (s.candidates[i].at_least < s.candidates[next].at_least) next = i;
        std::swap(s.candidates[first], s.candidates[next]);
        if (s.candidates[first].at_least > s.reach) break;
        const double before = best;
        visit(s.candidates[first].triangle, best);
        if (best < before) s.bring_in(std::sqrt(best) * (1 + 1e-12));
      }
      s.waiting = 0;
    }
  }

  template <class Self, class P>
  static void pack(Self& self, P& p) {
    p.value(self.box_), p.value(self.centre_), p.value(self.size_);
    p.array(self.nodes_), p.array(self.ids_), p.array(self.corners_), p.array(self.bulges_);
  }

 private:
  static constexpr int kWide = 8, kDeepest = 64, kBits = 3, kMostInLeaf = 1 << kBits;
  struct Node {
    float lo[3][kWide], hi[3][kWide];
    std::int32_t child[kWide];  // node, or ~(first << kBits | count - 1) of ids_
    std::int32_t count;
  };
  struct Range {
    int from, to, depth;
    Box box;
  };
  struct Search {
    Search(const PatchTree& tree, const Vec3& p, double best);
    void bring_in(double r);
    struct Waiting {
      float squared;
      std::int32_t child;
    };
    struct Candidate {
      double at_least;  // m
      int triangle;
    };
    static constexpr int kMostCandidates = 64;
    float x[3];
    double rounding, reach;  // m
    float limit = 0;         // m², boxes farther than this are farther than reach
    int depth = 0, waiting = 0;
    Waiting stack[kDeepest * kWide + 1];
    Candidate candidates[kMostCandidates];
  };
  // Goes on until nothing is left (false) or many candidates wait (true).
  bool collect(Search& s) const;
  void bound(Search& s, std::size_t first, std::size_t count) const;
  std::int32_t build(const std::vector<Box>& boxes, const Range& range);
  int split(const std::vector<Box>& boxes, const Range& range);
  Range range(const std::vector<Box>& boxes, int from, int to, int depth) const;

  Box box_;
  Vec3 centre_ = Vec3::Zero();
  double size_ = 0;  // m
  LargeVector<Node> nodes_;
  LargeVector<int> ids_;        // triangles, leaf by leaf; while building, indices of items
  LargeVector<float> corners_;  // m, of each leaf: first x of all its triangles, first y, ... third z
  LargeVector<float> bulges_;   // m, of each triangle in the order of ids_
};

}  // namespace hawser::detail
