// Prescribed motion of bodies.
#pragma once

#include <vector>

#include "hawser/kernels/motion.hpp"
#include "hawser/model/case.hpp"

namespace hawser::model {

// Throws std::invalid_argument for an inconsistent motion (the reader and check() refuse it before).
RigidMotion rigid_motion(const Body& body);
// Pose of rigid_motion(body) at t = 0; cheap for long tables.
RigidPose pose_at_start(const Body& body);
DriftLaw drift_law(const Drift& drift);
TableLaw table_law(const TableMotion& table);
// Headings of the bow, rad from +x: at t = 0, and at the position for which the hydrodynamic files hold.
double heading(const Body& body);
double hydrodynamic_heading(const Body& body);
// Position of the body's origin for which the hydrodynamic files hold, m. surface: z of the still water, m.
Vec3 hydrodynamic_place(const Body& body, double surface);

// Times [s, increasing] at which a body's velocity jumps: the rows of motion tables with linear
// interpolation.
std::vector<double> velocity_jumps(const Entries<Body>& bodies);
// The same for one body, by table.
std::vector<double> velocity_jumps(const Body& body);
// True if the motions differ at most in the position of the body.
bool same_motion(const Body& a, const Body& b);

}  // namespace hawser::model
