// The OBJ reader: any text is triangles of its own vertices or is refused with a message.

#include "cs550/mesh_io.hpp"
#include "memory_file.hpp"
#include "promise.hpp"

using namespace cs550;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::MemoryFile file({data, size});
  const SoupResult result = load_obj(file.path());
  if (!result.error.empty()) {
    fuzz::promise(result.soup.vertices.empty(), "a refused mesh is empty");
    fuzz::promise(fuzz::is_printable(result.error), "a message can be printed", result.error);
    return 0;
  }
  for (const Triangle& triangle : result.soup.triangles) {
    for (const Index v : triangle) {
      const bool in_range = v >= 0 && v < static_cast<Index>(result.soup.vertices.size());
      fuzz::promise(in_range, "a triangle names vertices of the file");
    }
  }
  for (const Vec3& vertex : result.soup.vertices) {
    fuzz::promise(vertex.allFinite(), "coordinates are finite");
  }
  return 0;
}
