// Generalised winding number of a mesh that need not be closed: 1 inside, 0 outside, in between near its
// holes.
//
// w(p) = 1/(4 pi) sum of solid angles (Jacobson, Kavan & Sorkine-Hornung 2013, "Robust inside-outside
// segmentation using generalized winding numbers", ACM Trans. Graph. 32(4)); the inside is where it exceeds
// 1/2. Distant clusters of triangles are approximated by a dipole with its first moment (Barill, Dickson,
// Schmidt, Levin & Jacobson 2018, "Fast winding numbers for soups and clouds", ACM Trans. Graph. 37(4)), near
// ones are exact. The clusters are the nodes of a BoxTree.
#pragma once

#include "hawser/geometry/box_tree.hpp"
#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

class WindingTree {
 public:
  WindingTree() = default;
  explicit WindingTree(const MeshView& mesh);

  // Clusters farther than `accuracy` times their radius are dipoles: the error is up to 0.13 for 1.5, 0.03
  // for 3, 1e-3 for 10 (measured on a hull and a sphere). Triangle `without` is excluded.
  double winding_number(const MeshView& mesh, const Vec3& p, double accuracy = 3, int without = -1) const;

  // True if the winding number exceeds 1/2; evaluated more accurately the nearer it is to 1/2.
  bool inside(const MeshView& mesh, const Vec3& p) const;

  // Number of triangles that the ray from p along u intersects, excluding `without`.
  int crossings(const MeshView& mesh, const Vec3& p, const Vec3& u, int without) const;

  bool empty() const { return tree_.empty(); }

  template <class Self, class P>
  static void pack(Self& self, P& p) {
    BoxTree::pack(self.tree_, p);
    p.array(self.clusters_);
  }

 private:
  // Data of a node of the tree.
  struct Cluster {
    Vec3 centre = Vec3::Zero();  // m, area centroid
    double radius = 0;           // m, of a ball about the centre that contains the triangles
    Vec3 area = Vec3::Zero();    // m², sum of area normals
    Mat3 moment = Mat3::Zero();  // m³, sum of area normal times (centroid - centre)'
  };
  static Cluster cluster(const MeshView& mesh, std::span<const int> triangles);

  BoxTree tree_;
  ConstArray<Cluster> clusters_;
};

}  // namespace hawser
