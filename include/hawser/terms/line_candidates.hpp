// Pairs of elements that may touch before the list is rebuilt: a Verlet list over all ranks.
//
// An element is represented by the convex hull of the Bézier points of its axis, at present and at the end of
// its predicted path some steps later. A pair is in the list if the hulls, swept along their paths, come
// nearer than the sum of both radii and both skins. The list is valid as long as every axis is within its
// skin of its predicted position, whatever the elements' shape. See docs/theory/line-candidates.md.
//
// Use by a term:
//   refresh_couplings(k, h):  candidates.update(k, h), collective; true: the pairs have changed
//   list_couplings(c):        candidates.list_couplings(c); then ghosts and matrix are made
//   renumber():               candidates.locate(): segments() now have local nodes
//   check_step(k):            candidates.covers(k): the step missed no pair
// Terms must keep history by ContactSegment::global, because indices of segments change with the list.
#pragma once

#include <mpi.h>

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "hawser/geometry/box.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/system/couplings.hpp"
#include "hawser/terms/contact_radii.hpp"
#include "hawser/terms/shared_places.hpp"

namespace hawser {

// An element that can touch others.
struct ContactSegment {
  int first = 0, second = 0;  // local nodes, owned or ghosts
  int global = 0;             // index into Mesh::elements
  double radius = 0;          // m
  Element element;            // copy of the mesh's; its nodes are those of the mesh
};

// Indices into segments(); the element of a comes before that of b.
struct CandidatePair {
  int a = 0, b = 0;
  bool counted = false;  // this rank counts it in sums: it owns the first node of a
};

struct CandidateSettings {
  // Two elements of one line that are closer along it than this many diameters (mean of both) are not a pair;
  // neither are elements that share a node.
  double exclusion_diameters = 2;
  // Skin: allowed distance of an axis from its predicted position before the list is rebuilt. It is the
  // larger of `skin_diameters` diameters and `skin_lengths` lengths of the element.
  double skin_diameters = 0.1, skin_lengths = 0.05;
  // Largest number of steps for which paths are predicted; fewer if a path would bend out of a skin.
  double steps = 4;
  // Pairs of lines without contact (indices in any order; also a line with itself).
  std::vector<std::pair<int, int>> excluded;
  // Arc lengths continue through shared places, so that the exclusion along a line applies there as well.
  // Pairs that lie within the length without contact of a shared place are excluded. Must outlive this
  // object.
  const SharedPlaces* shared = nullptr;
};

// Axis of an element as four Bézier points, at present and at the end of the predicted path, with all data
// that the search reads. The struct fills whole cache lines.
struct alignas(64) SweptAxis {
  int element = 0;            // index into Mesh::elements
  int line = 0;               // line of the element
  int first = 0, second = 0;  // nodes of the mesh
  double arc[2] = {0, 0};     // m, arc lengths of the two nodes
  // m; the skin is about the straight path and includes the curvature of the real path
  double radius = 0, skin = 0;
  std::array<Vec3, 4> from, to;
};
// Bounding box of the axis anywhere on its straight path, enlarged by radius and skin.
Box swept_box(const SweptAxis& s);

class LineCandidates {
 public:
  LineCandidates(MPI_Comm comm, const LocalMesh& mesh, ContactRadii radii, CandidateSettings settings = {});

  // Sets the number of elements of each line inside feeders at its ends A and B. They have no contact, and
  // distances along lines from shared places count from the feeders. Returns true if the numbers have
  // changed: update() will then change the pairs.
  bool set_elements_in_feeders(std::vector<std::array<int, 2>> inside);
  // True if an element is inside a feeder.
  bool is_in_feeder(int element) const;

  // Rebuilds the list if it is not valid for the next step h [s] from the committed motion (h = 0: no motion
  // is predicted). Returns true if the pairs of this rank have changed; locate() must then be called.
  // Collective.
  bool update(const Kinematics& committed, double h);
  void list_couplings(Couplings& to) const;
  // Finds the local nodes of the segments. Throws std::logic_error if one is not on this rank.
  void locate();
  // True if the list is valid for this motion of this rank's elements, so that no pair is missed. Local.
  bool covers(const Kinematics& trial) const;
  // Makes the next update() rebuild the list.
  void forget() { outdated_ = true; }

  // This rank's elements with a radius outside feeders, in the order of LocalMesh::elements, followed by
  // elements of other ranks that occur in pairs.
  const std::vector<ContactSegment>& segments() const { return segments_; }
  // Pairs of which this rank owns a node, sorted by the global elements (a, b). The set over all ranks does
  // not depend on the number of ranks.
  const std::vector<CandidatePair>& pairs() const { return pairs_; }
  // The pairs as indices into Mesh::elements; available before locate().
  const std::vector<std::pair<int, int>>& elements() const { return list_; }
  // Number of lists built.
  long builds() const { return builds_; }

 private:
  void gather();
  std::array<int, 2> outside(int line) const;
  bool at_feeder(int element) const;
  std::array<Vec3, 4> axis(const LocalElement& e, const Kinematics& state, double h) const;
  bool holds(const Kinematics& state, double h, double tau) const;
  double part(double time) const;
  void predict(const Kinematics& committed, double h);
  double skin(int element) const;
  SweptAxis at_rest(int element) const;
  bool never(const SweptAxis& p, const SweptAxis& q) const;
  bool excluded(const SweptAxis& p, const SweptAxis& q) const;
  // boxes: swept boxes of this rank's axes.
  std::vector<SweptAxis> from_others(std::span<const Box> boxes) const;
  std::vector<std::pair<int, int>> search() const;
  bool shares_less() const;
  double radius(int element) const { return radii_.of(mesh_.mesh->element(element)); }

  MPI_Comm comm_;
  const LocalMesh& mesh_;
  ContactRadii radii_;
  CandidateSettings settings_;
  std::vector<std::array<int, 2>>
      inside_;                       // for each line, see set_elements_in_feeders(); empty: no line is fed
  std::vector<LocalElement> local_;  // elements of this rank with a radius, outside feeders
  // By element of local_: lower bound of the number of successors without contact with it.
  std::vector<std::uint8_t> excluded_after_;
  std::vector<SweptAxis> built_;  // of local_, at the time of the last build
  // By element of local_: offset of the path's midpoint in time from that of the straight path.
  std::vector<std::array<Vec3, 4>> bend_;
  std::vector<double> free_length_;        // m, by shared place: length within which the list excludes pairs
  double built_at_ = 0, span_ = 0;         // s, time of the last build; duration of the predicted paths
  std::vector<std::pair<int, int>> list_;  // pairs of Mesh::elements, sorted
  std::vector<ContactSegment> segments_;
  std::vector<CandidatePair> pairs_;
  long builds_ = 0;
  mutable bool outdated_ = false;  // the list is invalid; only a cache flag, without influence on results
};

}  // namespace hawser
