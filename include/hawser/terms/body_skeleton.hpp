// The convex features of a volume: points, balls and edges with which it can touch the surface of another.
#pragma once

#include <vector>

#include "hawser/geometry/box_tree.hpp"
#include "hawser/geometry/triangle_mesh.hpp"
#include "hawser/model/case.hpp"

namespace hawser {

// An edge or a round bar from one place to another [m, frame of the shape]; where they are the same, a
// corner, a ball, or a place that stands for a piece of a face.
struct SkeletonPart {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  double radius = 0;  // m, of a bar or a ball
  double weight = 1;  // 1, or m² of a piece of a face

  Vec3 place(double xi) const { return from + xi * (to - from); }
  static SkeletonPart point(const Vec3& at, double radius = 0, double weight = 1) {
    return {at, at, radius, weight};
  }
};

// Parts in a tree of their boxes: most of a body is excluded many parts at a time.
class SkeletonParts {
 public:
  SkeletonParts() = default;
  explicit SkeletonParts(std::vector<SkeletonPart> parts);

  bool empty() const { return parts_.empty(); }
  // Of a part that walk() visits.
  int index(const SkeletonPart& part) const { return static_cast<int>(&part - parts_.data()); }
  const SkeletonPart& operator[](int index) const { return parts_[index]; }
  Vec3 centre() const { return tree_.box().centre(); }
  double radius() const { return 0.5 * tree_.box().diagonal(); }  // m, of a ball about it that holds all
  // Calls visit(part) for those in balls that near(centre, radius) says come near.
  template <class Near, class Visit>
  void walk(const Near& near, const Visit& visit) const {
    tree_.walk(
        [&](size_t n) {
          const Box& b = tree_.nodes()[n].box;
          return near(b.centre(), 0.5 * b.diagonal());
        },
        [&](int i) { visit(parts_[i]); });
  }

 private:
  std::vector<SkeletonPart> parts_;
  BoxTree tree_;
};

struct BodySkeleton {
  SkeletonParts features;  // what may touch
  SkeletonParts faces;     // places all over them, where they are watched
};

// By the basis of the stiffness: per_point: the corners of a mesh or box, balls (sphere); per_length: edges
// that are no smooth or flat joints, bars (capsule, ring of a torus); per_area: faces, in pieces no larger
// than `piece` [m], 0: a hundredth of the largest side of the box around. `mesh`: triangles of the mesh or of
// an exact shape; `active`: one flag a triangle, empty for all. A plane has none.
BodySkeleton body_skeleton(const model::Volume& volume, const MeshView& mesh, const std::vector<bool>& active,
                           double piece = 0);
// Adds the places to watch: about 4000, of however many triangles.
void watch_faces(const MeshView& mesh, const std::vector<bool>& active, BodySkeleton& skeleton);

}  // namespace hawser
