// Finds parts of lines that lie inside volumes where a run starts, and excludes them from contact.
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

// An interval of a line whose axis is inside a volume, or an end of the line that lies at its surface: nearer
// than half a radius, which is half way between a fairlead on the plating and a line that lies on it.
struct Inside {
  int line = 0, volume = 0;   // volume: index into what was asked about
  double from = 0, to = 0;    // m, arc length
  double depth = 0, at = 0;   // m, of the axis where it is deepest (0: at the surface), and its arc length
  Vec3 place = Vec3::Zero();  // m, there, in space
  double rise_from = 1, rise_to = 1;  // m/m, how fast the axis comes out along the line at either end
};

// Of the elements this rank counts, those with a radius [m, one for each of mesh.elements], outside of
// feeders (null: there are none): the stock is at the feed point, and inside with it. Sorted by line, volume
// and arc length, intervals that meet put together.
std::vector<Inside> inside_volumes(const LocalMesh& mesh, const Kinematics& at, const Bodies& bodies,
                                   const std::vector<ContactVolume>& volumes,
                                   const std::vector<double>& radius, const Feeders* feeders);

// Sorts, and puts intervals together that meet.
void join(std::vector<Inside>& intervals, const Mesh& mesh);

// A node that is separated by a volume from the place where it is expected.
struct OnWrongSide {
  int line = 0, volume = 0;
  double at = 0, distance = 0;  // m: arc length from end A, how far it is to the volume that way
  Vec3 place = Vec3::Zero();    // m
};

// Where a node of a line at x, m in space, is expected beside a volume; nullopt: no place is.
using ExpectedPlace = std::function<std::optional<Vec3>(const Node& node, size_t volume, const Vec3& x)>;
// For the nodes this rank owns: walks to the expected place in steps of the distance, at least 1/1000 of it.
std::vector<OnWrongSide> nodes_on_wrong_side(const LocalMesh& mesh, const Kinematics& at,
                                             const Bodies& bodies, const std::vector<ContactVolume>& volumes,
                                             const ExpectedPlace& expected_place);

}  // namespace hawser
