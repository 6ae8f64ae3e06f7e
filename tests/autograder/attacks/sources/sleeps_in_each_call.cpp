#include <chrono>
#include <thread>

#include "in_each_function.hpp"
void attack::run() { std::this_thread::sleep_for(std::chrono::seconds(4)); }
