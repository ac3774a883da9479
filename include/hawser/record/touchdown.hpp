// Where lines meet the seabed: touchdown points and what lies, from the positions of the nodes.
#pragma once

#include <mpi.h>

#include <array>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/record/touchdown_place.hpp"
#include "hawser/state/kinematics.hpp"

namespace hawser::record {

struct TouchdownPoint {
  double arc = 0;  // m, unstretched arc length from end A
  Vec3 position = Vec3::Zero();
};

struct Touchdown {
  int line = 0;  // of the case
  // The first place from end A, and the first from end B, where contact of the line with the bed begins or
  // ends: the bed's force on it begins. Of a mooring line that lies from its anchor on
  // both are the same. Empty: the line lies from end to end, or nowhere.
  std::optional<TouchdownPoint> from_a, from_b;
  double laid = 0;  // m, unstretched length that lies on the bed or below it
};

// The gap is that of the axis less the height at which the bed's force begins (model/bed_touch.hpp): half the
// contact diameter, and the smooth start of the force. Between two nodes of a beam it is the cubic of
// their gaps and directions. A cable's elements are chords, whose slope to the bed grows linearly with the
// unstretched arc length where it hangs freely (dz/dx = w (s - s0) / H): the two first elements that hang say
// where it vanishes, s0, which is the end of what lies on rigid ground. Ground that yields carries the
// line further: a string on springs joins the parabola of what hangs there (docs/theory/seabed.md,
// "Touchdown points").
class Touchdowns {
 public:
  // Case and mesh outlive this.
  Touchdowns(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh);

  // Of the lines that this rank owns or that the partition cuts, in the order of the case; none without a
  // seabed. at: an accepted state of local nodes. Collective: a few numbers for each line that is cut.
  std::vector<Touchdown> find(const Kinematics& at) const;
  // Of every line of the case in its order, the same on all ranks. Collective.
  std::vector<Touchdown> of_all_lines(const Kinematics& at) const;

 private:
  struct Height {
    double touching = 0;  // m, of the axis above the bed where it begins to press
    bool end = false;     // of a line
  };
  // Of a local node: its axis above that height [m], and the normal of the bed there.
  struct Above {
    double gap = 0;
    Vec3 normal;
  };
  Above above(size_t node, const Kinematics& at) const;

  // The first element from A in which contact changes, and minus the first from B, of each place in slot_; m
  // that lies, where gaps are linear between nodes.
  struct Changes {
    static constexpr int kNone = std::numeric_limits<int>::max();
    std::vector<int> element;  // two for each line
    std::vector<double> laid;
  };
  // The gaps of the nodes around such an element: from kFirst nodes off its first one on.
  struct Surrounding {
    static constexpr int kNodes = 2 * NodesAtChange::kNodes, kFirst = 1 - NodesAtChange::kNodes;
    std::array<Gap, kNodes> gap;
  };
  Changes changes(const std::vector<double>& gap) const;  // of local nodes; collective, as the next
  std::vector<Surrounding> surroundings(const Changes& changes, const std::vector<double>& gap,
                                        const Kinematics& at) const;
  std::pair<TouchdownPoint, double> point(int element, const Surrounding& around) const;
  template <class T>
  void join(MPI_Op op, std::vector<T>& of, size_t numbers) const;

  MPI_Comm comm_;
  const model::Seabed& bed_;
  Vec3 normal_;  // where it is a plane
  const LocalMesh& local_;
  std::vector<Height> heights_;  // of local nodes before LocalMesh::chain; none of bodies
  size_t cut_ = 0;               // lines that the partition cuts
  std::vector<int> lines_;       // those and the lines of this rank, ascending
  std::vector<int> slot_;        // by line: its place among lines_ with the cut ones first; -1: not there
};

}  // namespace hawser::record
