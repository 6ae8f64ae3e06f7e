#pragma once
/// @file summation_order.hpp
/// One order of summation for all processors. With SSE, Eigen adds four floats in pairs and
/// multiplies quaternions in a register. Without it, the sums have another order, and their last bits
/// differ. Where there is no SSE, these specialisations restore its order. They are written for Eigen
/// 3.4 without vectorisation (EIGEN_DONT_VECTORIZE, or a target that Eigen has no vector code for).
/// math.hpp includes this file.

#include <Eigen/Core>
#include <Eigen/Geometry>

#ifndef EIGEN_VECTORIZE_SSE
#ifdef EIGEN_VECTORIZE
#error "Sums of floats need one order on all processors: define EIGEN_DONT_VECTORIZE"
#endif

/// @cond  Eigen's names are no part of the contract.
namespace Eigen::internal {

/// The sum of four numbers, such as the squares of a quaternion's.
template <class Evaluator>
struct redux_novec_unroller<scalar_sum_op<float, float>, Evaluator, 0, 4> {
  static float run(const Evaluator& numbers, const scalar_sum_op<float, float>& /*sum*/) {
    const auto at = [&](Index i) {
      return numbers.coeffByOuterInner(i / Evaluator::InnerSizeAtCompileTime,
                                       i % Evaluator::InnerSizeAtCompileTime);
    };
    return (at(0) + at(2)) + (at(1) + at(3));
  }
};

/// The sum of nine numbers, such as the squares of a 3 × 3 matrix's.
template <class Evaluator>
struct redux_novec_unroller<scalar_sum_op<float, float>, Evaluator, 0, 9> {
  static float run(const Evaluator& numbers, const scalar_sum_op<float, float>& /*sum*/) {
    const auto at = [&](Index i) {
      return numbers.coeffByOuterInner(i / Evaluator::InnerSizeAtCompileTime,
                                       i % Evaluator::InnerSizeAtCompileTime);
    };
    const auto lane = [&](Index i) { return at(i) + at(i + 4); };
    return (lane(0) + lane(2)) + (lane(1) + lane(3)) + at(8);
  }
};

template <int Architecture, class Left, class Right>
struct quat_product<Architecture, Left, Right, float> {
  static Quaternion<float> run(const QuaternionBase<Left>& a, const QuaternionBase<Right>& b) {
    return {(a.w() * b.w() - a.x() * b.x()) - (a.z() * b.z() + a.y() * b.y()),
            (a.x() * b.w() - a.z() * b.y()) + (a.y() * b.z() + a.w() * b.x()),
            (a.y() * b.w() - a.x() * b.z()) + (a.z() * b.x() + a.w() * b.y()),
            (a.z() * b.w() - a.y() * b.x()) + (a.x() * b.y() + a.w() * b.z())};
  }
};

}  // namespace Eigen::internal
/// @endcond

#endif
