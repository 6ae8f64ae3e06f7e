#pragma once
/// @file body_motion.hpp

#include <Eigen/Geometry>

namespace cs550::bench {

/// Where a body is and how it moves, world frame. Its origin is its centre of mass.
struct BodyMotion {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();               ///< m
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< body → world
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();               ///< m/s
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();       ///< rad/s
};

}  // namespace cs550::bench
