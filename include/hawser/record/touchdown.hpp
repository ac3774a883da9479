// Touchdown points and lengths on the seabed, from the positions of the nodes.
#pragma once

#include <mpi.h>

#include <array>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "hawser/mesh/local_mesh.hpp"
#include "hawser/mesh/per_line.hpp"
#include "hawser/model/case.hpp"
#include "hawser/record/touchdown_place.hpp"
#include "hawser/state/kinematics.hpp"

namespace hawser::record {

struct TouchdownPoint {
  double arc = 0;  // m, unstretched arc length from end A
  Vec3 position = Vec3::Zero();
};

struct Touchdown {
  int line = 0;  // index in the case
  // First places from end A and from end B where contact with the bed begins or ends, that is where the bed
  // force begins. Equal for a mooring line that lies from its anchor on. Empty: the line lies completely, or
  // not at all.
  std::optional<TouchdownPoint> from_a, from_b;
  double laid = 0;  // m, unstretched length on the bed or below it
};

// Gaps are heights of the axis minus the height at which the bed force begins (model/bed_touch.hpp): half the
// contact diameter plus the smooth start of the force. Between beam nodes the gap is the cubic through gaps
// and slopes. The chords of a freely hanging cable have a slope that grows linearly with unstretched arc
// length (dz/dx = w (s - s0) / H); the first two hanging elements determine its zero s0, the end of contact
// on a rigid bed. A yielding bed carries the line further: a string on an elastic foundation joins the
// hanging parabola there (docs/theory/seabed.md, "Touchdown points").
class Touchdowns {
 public:
  // Case and mesh must outlive the object.
  Touchdowns(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh);

  // Touchdowns of the lines that this rank owns or that the partition cuts, in the order of the case; empty
  // without a seabed. state: an accepted one of local nodes. Collective: a few numbers per cut line.
  std::vector<Touchdown> find(const Kinematics& state) const;
  // Touchdowns of all lines in order, the same on all ranks. Collective.
  std::vector<Touchdown> of_all_lines(const Kinematics& state) const;

 private:
  struct Height {
    double touching = 0;  // m, axis above the bed where contact begins
    bool end = false;     // an end of a line
  };
  // Gap of a local node [m], and the normal of the bed there.
  struct Above {
    double gap = 0;
    Vec3 normal;
  };
  Above above(size_t node, const Kinematics& state) const;

  // By place of slot_: the first element from A with a change of contact, and minus the first from B; length
  // on the bed [m] with gaps linear between nodes.
  struct Changes {
    static constexpr int kNone = std::numeric_limits<int>::max();
    std::vector<int> element;  // two per line
    std::vector<double> laid;
  };
  // Gaps of the nodes around such an element, beginning kFirst nodes from its first node.
  struct Surrounding {
    static constexpr int kNodes = 2 * NodesAtChange::kNodes, kFirst = 1 - NodesAtChange::kNodes;
    std::array<Gap, kNodes> gap;
  };
  Changes changes(const std::vector<double>& gap) const;  // by local node; collective, as the next function
  std::vector<Surrounding> surroundings(const Changes& changes, const std::vector<double>& gap,
                                        const Kinematics& state) const;
  std::pair<TouchdownPoint, double> point(int element, const Surrounding& around) const;
  template <class T>
  void join(MPI_Op op, std::vector<T>& values, size_t numbers) const;

  MPI_Comm comm_;
  const model::Seabed& bed_;
  Vec3 normal_;  // of a plane bed
  const LocalMesh& local_;
  std::vector<Height> heights_;  // of local nodes before element_ghosts_end; unset for bodies
  size_t cut_ = 0;               // number of lines that the partition cuts
  std::vector<int> lines_;       // these and the lines of this rank, ascending
  PerLine<size_t> slot_;         // place of a line in the order with cut lines first
};

}  // namespace hawser::record
