// Convex features of a volume (points, balls and edges) with which it can touch the surface of another
// volume.
#pragma once

#include <vector>

#include "hawser/geometry/box_tree.hpp"
#include "hawser/geometry/triangle_mesh.hpp"
#include "hawser/model/case.hpp"

namespace hawser {

// An edge or a round bar between two points [m, frame of the shape]. If the points coincide: a corner, a
// ball, or a point of a face.
struct SkeletonPart {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  double radius = 0;  // m, of a bar or a ball; 0: sharp
  double weight = 1;  // 1, or of a point of a face its share of the area, m²

  Vec3 place(double xi) const { return from + xi * (to - from); }
  static SkeletonPart point(const Vec3& at, double radius = 0, double weight = 1) {
    return {at, at, radius, weight};
  }
};

// Parts in a bounding-box tree, so that most of them are excluded many at a time.
class SkeletonParts {
 public:
  SkeletonParts() = default;
  explicit SkeletonParts(std::vector<SkeletonPart> parts);

  bool empty() const { return parts_.empty(); }
  // Index of a part that walk() visits.
  int index(const SkeletonPart& part) const { return static_cast<int>(&part - parts_.data()); }
  const SkeletonPart& operator[](int index) const { return parts_[index]; }
  Vec3 centre() const { return tree_.box().centre(); }
  double radius() const { return 0.5 * tree_.box().diagonal(); }  // m, ball about centre() with all parts
  // Calls visit(part) for the parts in balls for which near(centre, radius) is true.
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
  SkeletonParts features;  // parts that may touch
  SkeletonParts faces;     // points on all faces at which the penetration is monitored
};

// Sides of the pieces of faces [m] of a volume of this size [m] whose contact with a volume of the size
// `other` [m] they resolve: a twenty-fifth of its size or a fifth of `other`, but at least a hundredth of its
// size, so that the number of points is limited.
double face_piece(double size, double other);
// Features by the basis of the stiffness. per_point: corners of a mesh or box, balls (sphere). per_length:
// edges that are neither smooth nor flat, bars (capsule, ring of a torus, rims of a tube). per_area: three
// points in each piece of the faces, whose sides are at most `piece` [m]; 0: as without other volumes.
// `mesh`: triangles of the mesh or of an exact shape; `active`: one flag per triangle, empty for all. A plane
// has no features.
BodySkeleton body_skeleton(const model::Volume& volume, const MeshView& mesh, const std::vector<bool>& active,
                           double piece = 0);
// Adds the points at which penetration is monitored: about 4000, regardless of the number of triangles.
void watch_faces(const MeshView& mesh, const std::vector<bool>& active, BodySkeleton& skeleton);

}  // namespace hawser
