// Start shape of a line before statics.
#pragma once

#include <vector>

#include "hawser/mesh/mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/terms/bodies.hpp"

namespace hawser {

struct LineStart {
  std::vector<Vec3> x, tangent;  // m, unit vectors, by node; a tangent is zero if the shape has none there
  std::vector<Quat> q;           // if known, else empty
};

// The pose at t = 0 of the body that holds this end; identity if there is none.
RigidPose start_pose(const model::Case& c, const Bodies& bodies, const model::End& e);

// Start shape of a line that is not buried, as the case specifies. Throws InputError if the case gives no
// start shape and both ends are free.
LineStart line_start(const model::Case& c, const model::Line& line, const Bodies& bodies, const Mesh& mesh,
                     const LineSpan& span);

// Start shape of a line that is fed at one end or both; only the part outside the feeders is spread out.
LineStart line_start_fed(const model::Case& c, const model::Line& line, const Bodies& bodies,
                         const Mesh& mesh, const LineSpan& span);

// Start shape of a line with ends in the soil: straight in the soil, and between the exit points that of a
// line that starts on the bed. Buried stretches must end at nodes.
LineStart line_start_from_soil(const model::Case& c, const model::Line& line, const Bodies& bodies,
                               const Mesh& mesh, const LineSpan& span);

// Moves nodes under a measured bed onto it. This is only a start for statics.
void lift(const model::Seabed& bed, LineStart& s);

}  // namespace hawser
