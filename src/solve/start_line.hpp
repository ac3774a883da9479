// Where a line is put before statics.
#pragma once

#include <vector>

#include "hawser/mesh/mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/terms/bodies.hpp"

namespace hawser {

struct LineStart {
  std::vector<Vec3> x, tangent;  // m, unit; one a node; a tangent of zero where the shape has none
  std::vector<Quat> q;           // where known, else empty
};

// The pose at t = 0 of what holds this end.
RigidPose start_pose(const model::Case& c, const Bodies& bodies, const model::End& e);

// A line none of which is buried, by what the case says of its start. InputError when it says nothing and
// nothing holds the line.
LineStart line_start(const model::Case& c, const model::Line& line, const Bodies& bodies, const Mesh& mesh,
                     const LineSpan& span);

// The nodes from `first` to `last` of a line, as a line of its own with the same ends.
struct LineStretch {
  model::Line line;
  Mesh mesh;
  LineSpan span;
};
LineStretch stretch_of(const model::Line& line, const Mesh& mesh, const LineSpan& span, int first, int last);

// A line that is fed at an end or at both, and is no longer than what is outside.
LineStart line_start_fed(const model::Case& c, const model::Line& line, const Bodies& bodies,
                         const Mesh& mesh, const LineSpan& span);

// Ends in the soil go straight out of it; between them the line is one that starts on the bed. What is buried
// ends at a node here.
LineStart line_start_from_soil(const model::Case& c, const model::Line& line, const Bodies& bodies,
                               const Mesh& mesh, const LineSpan& span);

// What is under a bed that is no plane is put on it: the start of statics, not its answer.
void lift(const model::Seabed& bed, LineStart& s);

}  // namespace hawser
