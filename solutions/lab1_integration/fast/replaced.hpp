#pragma once
/// @file replaced.hpp
/// The functions of the reference that have a faster form here: none. The kernels replace the sweeps
/// of given code (engine/body_sweeps.hpp), which call the functions of the lab.
