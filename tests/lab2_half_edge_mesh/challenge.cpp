// How few faces are left of noisy meshes.
#include <cs550/challenge.hpp>

#include "cs550/mesh_io.hpp"
#include "cs550/primitives.hpp"

namespace cs550::test {
namespace {

using namespace autograder;

[[maybe_unused]] const bool added = add_challenge(
    {"faces left of the hulls of bunny and teapot, tolerance 1e-3", Better::Fewer, [] {
       constexpr Real tolerance = Real(1e-3);
       long faces = 0;
       for (const char* name : {"bunny", "teapot"}) {
         const SoupResult scan = load_obj(std::string(CS550_ASSETS "/meshes/") + name + ".obj");
         const TriangleSoup hull = convex_hull(scan.soup.vertices).soup;
         const MeshBuild build = build_half_edge_mesh(hull.vertices, hull.triangles);
         faces += merge_coplanar_faces(build.mesh, tolerance).face_count();
       }
       return faces;
     }});

}  // namespace
}  // namespace cs550::test
