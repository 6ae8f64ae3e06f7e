#pragma once
/// @file random_scene.hpp
/// Scenes that nobody would build: the inputs of the scene fuzzer.

#include <cstdint>
#include <nlohmann/json.hpp>

namespace cs550::test {

/// A scene document of a few bodies above a floor. Typical sizes are from 1 mm to 1 km. In a quarter of
/// the scenes the bodies differ in size, to 1 : 1000. Drawn as well: thickness to 1 : 1000, mass ratios
/// to 1e6, spins to 100 rad/s, overlap, μ to 1000, e from 0 to 1, gravity to 1000 m/s², kinematic bodies,
/// sleeping, both qualities, both contact models and both solvers. Equal seeds give equal documents.
nlohmann::json random_scene(std::uint32_t seed);

}  // namespace cs550::test
