// Fixed-size types of small vectors and matrices.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace hawser {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

// Forces on the ends of a cable (6) or a beam (12), or on a body (6), and derivatives, row-major.
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
using Mat12 = Eigen::Matrix<double, 12, 12, Eigen::RowMajor>;

}  // namespace hawser
