// Which pairs of elements may touch before the list is made again: a Verlet list over all ranks.
//
// An element is the convex hull of the Bézier points of its axis, now and where its rates take it within a
// few steps. A pair is in the list when the hulls, swept along that path, come nearer than both radii and
// both skins. The list holds as long as every axis is within its skin of where it was predicted to be at that
// time, whatever the elements' shape. See docs/theory/line-candidates.md.
//
// How a term uses it:
//   recouple(k, h):   candidates.update(k, h), collective; true: the pairs have changed
//   couple(c):        candidates.couple(c); then ghosts and matrix are made
//   update_ghosts():  candidates.locate(): now segments() know their local nodes
//   check_step(k):    candidates.covers(k): no pair was missed by the step
// History is to be kept by ContactSegment::global: indices of segments change with the list.
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
#include "hawser/system/shared_places.hpp"

namespace hawser {

// An element that can touch others.
struct ContactSegment {
  int first = 0, second = 0;  // local nodes, owned or ghosts
  int global = 0;             // index into Mesh::elements
  double radius = 0;          // m
};

// Indices into segments(); the element of a comes before that of b.
struct CandidatePair {
  int a = 0, b = 0;
  bool counted = false;  // this rank counts it in sums: it owns the first node of a
};

struct CandidateSettings {
  // Of one line, what is nearer along it than this many diameters (mean of the two) is no contact, nor are
  // elements that share a node.
  double exclusion_diameters = 2;
  // How far an axis may be from its place predicted before the list is made again: the larger of this many of
  // its diameters and this part of its length.
  double skin_diameters = 0.1, skin_lengths = 0.05;
  // How many steps the path is predicted for, at the most: fewer where it would bend out of a skin.
  double steps = 4;
  // Pairs of lines (indices, any order; a line with itself too) that do not see each other.
  std::vector<std::pair<int, int>> excluded;
  // Arc lengths go on through places that lines share, so that the same holds there; what is wholly within
  // them is no pair. It outlives this.
  const SharedPlaces* shared = nullptr;
};

// An element's axis as four Bézier points, now and at the end of the path predicted, together with all that
// is asked of an element when it may be half of a pair: one place in memory, in whole lines of the cache.
struct alignas(64) SweptAxis {
  int element = 0;              // index into Mesh::elements
  int line = 0;                 // what follows is that element's
  int first = 0, second = 0;    // nodes of the mesh
  double arc[2] = {0, 0};       // m, of the two
  double radius = 0, skin = 0;  // m; here the skin is about the straight way, so it has the path's bend in it
  std::array<Vec3, 4> from, to;
};
// Holds the line along it anywhere on its straight way and as far as its skin off it.
Box swept_box(const SweptAxis& s);

class LineCandidates {
 public:
  // radius: one for each of Mesh::elements, m; 0: takes no part.
  LineCandidates(MPI_Comm comm, const LocalMesh& mesh, std::vector<double> radius,
                 CandidateSettings settings = {});

  // How many elements of each line are inside feeders at its ends A and B: they take no part, and what is
  // near along lines that share a place counts from the feeders. True when this is news: the pairs change
  // with update().
  bool set_elements_in_feeders(std::vector<std::array<int, 2>> inside);
  // Whether an element is inside a feeder.
  bool is_in_feeder(int element) const;

  // Collective. From the committed motion and a coming step h [s] (0: no motion predicted): makes the list
  // anew where it does not hold for that step. True when the pairs of this rank changed: locate() is due.
  bool update(const Kinematics& committed, double h);
  void couple(Couplings& to) const;
  // Local nodes of the segments. std::logic_error where one is not on this rank.
  void locate();
  // Local: whether the list holds for this motion of this rank's elements, so that no pair is missed in it.
  bool covers(const Kinematics& trial) const;
  // update() will make the list anew, whether it holds or not.
  void forget() { outdated_ = true; }

  // The elements of this rank with a radius, outside feeders, in the order of LocalMesh::elements, then those
  // of other ranks that pairs need.
  const std::vector<ContactSegment>& segments() const { return segments_; }
  // Pairs of which this rank owns a node, sorted by (global element of a, of b); the same set on any number
  // of ranks.
  const std::vector<CandidatePair>& pairs() const { return pairs_; }
  // The same as pairs of Mesh::elements, known before locate().
  const std::vector<std::pair<int, int>>& elements() const { return list_; }
  // How often the list was made.
  long builds() const { return builds_; }

 private:
  void gather();
  std::array<int, 2> outside(int line) const;
  bool at_feeder(int element) const;
  std::array<Vec3, 4> axis(const LocalElement& e, const Kinematics& at, double h) const;
  bool holds(const Kinematics& at, double h, double tau) const;
  double part(double time) const;
  void predict(const Kinematics& committed, double h);
  double skin(int element) const;
  SweptAxis at_rest(int element) const;
  bool never(const SweptAxis& p, const SweptAxis& q) const;
  bool excluded(const SweptAxis& p, const SweptAxis& q) const;
  // boxes: of this rank's axes.
  std::vector<SweptAxis> from_others(std::span<const Box> boxes) const;
  std::vector<std::pair<int, int>> search() const;
  bool shares_less() const;

  MPI_Comm comm_;
  const LocalMesh& mesh_;
  std::vector<double> radius_;
  CandidateSettings settings_;
  std::vector<std::array<int, 2>>
      inside_;                       // of each line, as in set_elements_in_feeders(); empty: nothing is fed
  std::vector<LocalElement> local_;  // elements of this rank with a radius that are outside
  std::vector<std::uint8_t> excluded_after_;  // of local_: how many that follow it are excluded, at the least
  std::vector<SweptAxis> built_;              // of local_, when the list was made
  // Of local_: what half way in time is off the middle of the straight way.
  std::vector<std::array<Vec3, 4>> bend_;
  std::vector<double> within_;             // m, of the shared places, what the list excludes
  double made_ = 0, span_ = 0;             // s, when that was and the time to the end of the paths
  std::vector<std::pair<int, int>> list_;  // pairs of Mesh::elements, sorted
  std::vector<ContactSegment> segments_;
  std::vector<CandidatePair> pairs_;
  long builds_ = 0;
  mutable bool outdated_ = false;  // a cache's flag: it changes the time and never the answer
};

}  // namespace hawser
