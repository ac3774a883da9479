// How a body of a case moves when its motion is prescribed.
#pragma once

#include <vector>

#include "hawser/kernels/motion.hpp"
#include "hawser/model/case.hpp"

namespace hawser::model {

// std::invalid_argument for a motion that makes no sense (check() and the reader have refused it before).
RigidMotion rigid_motion(const Body& body);
// What that has at t = 0, without all rows of long tables.
RigidPose pose_at_start(const Body& body);
DriftLaw drift_law(const Drift& drift);
TableLaw table_law(const TableMotion& table);
// rad from +x, of its bow at t = 0; and of its bow where the files of its hydrodynamics hold.
double heading(const Body& body);
double hydrodynamic_heading(const Body& body);

// When a body's velocity jumps: times of the rows of tables with straight lines between them, s, increasing.
std::vector<double> velocity_jumps(const std::vector<Body>& bodies);

}  // namespace hawser::model
