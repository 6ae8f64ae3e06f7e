// How few vertices a climb visits.
#include <cs550/challenge.hpp>

#include "lab3_hill_climbing/climbing.hpp"

namespace cs550::test {
namespace {

using namespace autograder;

[[maybe_unused]] const bool added =
    add_challenge({"vertices visited by 2000 climbs from the same vertex", Better::Fewer, [] {
                     Random random(33);
                     long visited = 0;
                     for (const char* name : {"icosphere2", "hull128"}) {
                       const HalfEdgeMesh& mesh = fixture_mesh(name);
                       for (int i = 0; i < 1000; ++i)
                         visited += hill_climb(mesh, random.unit_vector(), 0).visited;
                     }
                     return visited;
                   }});

}  // namespace
}  // namespace cs550::test
