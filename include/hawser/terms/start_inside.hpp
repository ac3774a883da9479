// Finds parts of lines that lie inside volumes at the start of a run; these are excluded from contact.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/terms/bodies.hpp"
#include "hawser/terms/contact_volumes.hpp"

namespace hawser {

class Feeders;

// Interval of a line whose axis is inside a volume, or an end of the line at its surface: nearer than half a
// radius, which is between a fairlead on the plating and a line that lies on it.
struct Inside {
  int line = 0, volume = 0;           // volume: index in the list of volumes
  double from = 0, to = 0;            // m, arc length
  double depth = 0, at = 0;           // m, largest depth of the axis (0: at the surface) and its arc length
  Vec3 place = Vec3::Zero();          // m, position of the deepest point, space axes
  double rise_from = 1, rise_to = 1;  // m/m, slope of the axis relative to the surface at both ends
};

// Searches the elements that this rank counts, with a radius [m, one for each of mesh.elements], outside
// feeders. feeders may be null. Elements of the stock are ignored, because they are at the feed point and
// inside with it. The result is sorted by line, volume and arc length, with adjacent intervals joined.
std::vector<Inside> inside_volumes(const LocalMesh& mesh, const Kinematics& state, const Bodies& bodies,
                                   const std::vector<ContactVolume>& volumes,
                                   const std::vector<double>& radius, const Feeders* feeders);

// Sorts the intervals and joins those that meet.
void join(std::vector<Inside>& intervals, const Mesh& mesh);

// Node that a volume separates from the position where it is expected.
struct OnWrongSide {
  int line = 0, volume = 0;
  double at = 0, distance = 0;  // m, arc length from end A; distance to the volume on the way
  Vec3 place = Vec3::Zero();    // m, position of the node
};

// Expected position of a line's node at x [m, space axes] with respect to a volume; nullopt: none.
using ExpectedPlace = std::function<std::optional<Vec3>(const Node& node, size_t volume, const Vec3& x)>;
// Checks the nodes that this rank owns. Walks towards the expected position in steps of the distance to the
// surface, each at least 1/1000 of the way.
std::vector<OnWrongSide> nodes_on_wrong_side(const LocalMesh& mesh, const Kinematics& state,
                                             const Bodies& bodies, const std::vector<ContactVolume>& volumes,
                                             const ExpectedPlace& expected_place);

}  // namespace hawser
