#include "attack.hpp"
bool attack::succeeds() { return true; }
