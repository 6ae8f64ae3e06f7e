#pragma once
/// @file common_expressions.hpp
/// Formulas that labs are made of, for the precompiled header of the labs and for nothing else.
///
/// Eigen gives every expression a type of its own, and making these types is most of the time that a
/// lab takes to compile. Those that are named here are made once, with the precompiled header.
/// Nothing is computed and nothing is linked: decltype only asks for the type.

#include "cs550/math.hpp"

namespace cs550::common_expressions {

extern Real s;
extern Vec2 p, t;
extern Vec3 a, b, c, d, e, f;
extern Quat q, r;
extern Mat2 k;
extern Mat3 m;

template <class... Types>
inline constexpr bool are_known = (... && (sizeof(Types) > 0));

static_assert(
    are_known<decltype(Vec3(a + b)), decltype(Vec3(a - b)), decltype(Vec3(-a)),
              decltype(Vec3(s * a)), decltype(Vec3(a / s)), decltype(Vec3(a + b + c)),
              decltype(Vec3(a + s * b)), decltype(Vec3(s * a + s * b)),
              decltype(Vec3(s * a + s * b + s * c)), decltype(Vec3(a.cross(b))),
              decltype(Vec3((a - b).cross(c))), decltype(Vec3(a + b.cross(c) - d - e.cross(f)))>);
static_assert(are_known<decltype(a = b + c), decltype(a = b - c), decltype(a = s * b),
                        decltype(a = b.cross(c)), decltype(a += b), decltype(a -= b),
                        decltype(a += s * b), decltype(a -= s * b), decltype(a += b.cross(c)),
                        decltype(a += (b - c).cross(d)), decltype(a += m * b)>);
static_assert(are_known<decltype(a.dot(b)), decltype(a.dot(b - c)), decltype((a - b).dot(c)),
                        decltype(a.dot(b.cross(c))), decltype(a.cross(b).dot(c)),
                        decltype(a.norm()), decltype(a.squaredNorm()), decltype(a.normalized()),
                        decltype((a - b).norm()), decltype((a - b).squaredNorm()),
                        decltype(a.cross(b).norm()), decltype(a.allFinite())>);
static_assert(
    are_known<decltype(Vec3(q * a)), decltype(Vec3(q.conjugate() * a)), decltype(Quat(q * r)),
              decltype(Quat(q.coeffs() + s * r.coeffs())), decltype(q = q.normalized())>);
static_assert(are_known<decltype(Vec3(m * a)), decltype(a = m * b), decltype(a.dot(m * b)),
                        decltype(Mat3(m * m * m.transpose())), decltype(Mat3(a * b.transpose()))>);
static_assert(
    are_known<decltype(Vec2(p - t)), decltype(Vec2(s * p)), decltype(Vec2(p - s * t)),
              decltype(Vec2(k * p)), decltype(Vec2(p - k * t)), decltype(p.norm()),
              decltype(p.dot(t)), decltype(Mat2(k / s)), decltype(k << s, s, s, s),
              decltype(k.trace()), decltype(k.determinant()), decltype(Mat2(k.inverse()))>);

}  // namespace cs550::common_expressions
