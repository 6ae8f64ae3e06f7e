#pragma once
/// @file functions.hpp
/// The functions of two fake labs.

namespace cs550 {

int one();      ///< of lab 101
int missing();  ///< of lab 101, which does not define it
int other();    ///< of lab 102

}  // namespace cs550
