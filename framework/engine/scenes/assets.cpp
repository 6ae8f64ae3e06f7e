#include "cs550/assets.hpp"

#include <cstdlib>

namespace cs550 {

std::filesystem::path assets_folder() {
  const char* chosen = std::getenv("CS550_ASSETS");
  return chosen != nullptr && *chosen != '\0' ? chosen : CS550_ASSETS_DIR;
}

}  // namespace cs550
