// Shared places of lines: ends held at one point, or closer to each other than the lines' thickness. The two
// branches of lines must overlap near such a place, so contact between them starts only beyond the length at
// which they are first apart. See docs/theory/line-line.md.
#pragma once

#include <mpi.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/terms/contact_radii.hpp"

namespace hawser {

// Part of a line from one of its nodes in one direction.
struct Branch {
  int node = 0;       // of the mesh
  int direction = 1;  // 1: towards end B; -1: towards end A
};

struct SharedPlace {
  Branch one, other;
};

class SharedPlaces {
 public:
  // radii: not 0 along the branches. first_part: for each line, the first part of the
  // given line that it is a part of (model::GivenLine); empty: no line is cut later.
  SharedPlaces(MPI_Comm comm, const LocalMesh& mesh, ContactRadii radii, std::vector<SharedPlace> places,
               std::vector<int> first_part);

  // Sets the number of elements of each line inside feeders at its ends A and B. Branches begin at the
  // feeder.
  void set_elements_in_feeders(std::vector<std::array<int, 2>> inside) { inside_ = std::move(inside); }

  // Updates the length without contact at each place from a committed state. The first call determines it
  // from the state alone. Later it shrinks and, if `in_statics`, also grows. A second call for the
  // same state changes nothing. Collective.
  void update(const Kinematics& state, bool in_statics);

  int size() const { return static_cast<int>(places_.size()); }
  const SharedPlace& place(int k) const { return places_[k].branches; }
  double diameter(int k) const;  // m, mean of the two diameters at place k
  // Length without contact along either branch from place k, m.
  double free_length(int k) const { return places_[k].step * std::max(places_[k].free_steps, 0); }
  // Checkpoint record of a place, stored by the rank with its first node.
  struct Kept {
    int place = 0, steps = 0;
    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      each("place", "", self.place);
      each("steps", "", self.steps);
    }
  };
  Kept kept(int k) const { return {k, places_[k].free_steps}; }
  // forget() marks the lengths of all places as unknown; restore() sets those that this rank has. The next
  // update() distributes them.
  void forget();
  void restore(const Kept& kept);

  // Places between branches of two lines, in any order, or of a line with itself.
  const std::vector<int>& between(int line, int other) const;
  // Distances [m] along a branch from its place to the first and the second node of an element; nullopt if
  // the element is not on the branch.
  std::optional<std::array<double, 2>> along(const Branch& branch, int element) const;
  // Two elements on the two branches from a place: distances [m] from the place to the nearer and the
  // farther end of each, in the order of the branches.
  struct Found {
    int place = 0;
    std::array<double, 2> one, other;
  };
  // True if visit(found) is true for any place between two elements.
  template <class Visit>
  bool any_between(int element, int second, const Visit& visit) const;
  // Shortens the ranges [from, to] in xi of two elements by their lengths without contact with each other.
  void clip(int element, int second, std::array<double, 2>& range, std::array<double, 2>& second_range) const;

 private:
  static constexpr int kUnknown = -1;
  // Lengths along the branches are counted in steps, so that the same state gives the same result.
  struct PlaceState {
    SharedPlace branches;
    double step = 0;            // m
    double limit = 0;           // m, largest length along either branch
    int free_steps = kUnknown;  // length without contact
    // in statics: length up to which the branches were clearly apart beyond `free_steps`
    int clear_steps = 0;
  };
  // Branch as a polyline.
  struct BranchPath {
    std::vector<double> s;  // m, from the place
    std::vector<Vec3> x;
    std::vector<double> radius;  // radius of the segment after each point
  };
  struct Gaps;

  double arc(int node) const;
  std::array<int, 2> nodes_outside_feeders(int line) const;
  double start_arc(const Branch& branch) const;
  std::vector<int> nodes_to(const Branch& branch, double reach) const;
  BranchPath branch_path(const Branch& branch, const std::vector<int>& nodes,
                         const std::vector<Vec3>& x) const;
  std::vector<Vec3> gather(const std::vector<int>& nodes, const Kinematics& state) const;
  void update(PlaceState& place, const BranchPath& one, const BranchPath& other, bool in_statics) const;

  MPI_Comm comm_;
  const LocalMesh& mesh_;
  ContactRadii radii_;
  int first_part_of(int line) const { return first_part_.empty() ? line : first_part_[line]; }

  std::vector<int> first_part_;  // of each line, see the constructor
  std::vector<double> offset_;   // m, of each line, its start along its given line; empty: no line is cut
  std::vector<std::array<int, 2>> inside_;
  std::vector<PlaceState> places_;
  bool agreed_ = true;                                       // all ranks have the same lengths
  std::map<std::pair<int, int>, std::vector<int>> between_;  // by first parts
};

template <class Visit>
bool SharedPlaces::any_between(int element, int second, const Visit& visit) const {
  if (places_.empty()) return false;
  const Mesh& mesh = *mesh_.mesh;
  for (const int k : between(mesh.element(element).line, mesh.element(second).line))
    for (const bool swapped : {false, true}) {
      auto one = along(place(k).one, swapped ? second : element);
      auto other = along(place(k).other, swapped ? element : second);
      if (!one || !other) continue;
      std::sort(one->begin(), one->end());
      std::sort(other->begin(), other->end());
      if (visit(Found{k, *one, *other})) return true;
    }
  return false;
}

}  // namespace hawser
