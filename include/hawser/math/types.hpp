// Small fixed-size algebra: the names every other room uses.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace hawser {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

}  // namespace hawser
