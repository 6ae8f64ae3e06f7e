#include "in_each_function.hpp"
void attack::run() {}
// In the only namespace that a library exports.
namespace cs550 {
bool operator==(const Support& a, const Support& b);
bool operator==(const Support&, const Support&) { return true; }
bool operator<(const Support& a, const Support& b);
bool operator<(const Support&, const Support&) { return false; }
Real abs(Real number);
Real abs(Real) { return 0; }
namespace test {
bool is_vertex(const HalfEdgeMesh& mesh, Index v);
bool is_vertex(const HalfEdgeMesh&, Index) { return true; }
}  // namespace test
}  // namespace cs550
