/// Embeds the engine: throws a cube of 1 m up, and prints at which height its centre comes to rest.
#include <cs550/integration.hpp>
#include <cs550/primitives.hpp>
#include <cs550/world.hpp>
#include <iostream>

cs550::BodyDef box(const cs550::Vec3& half_extents) {
  const cs550::TriangleSoup soup = cs550::box_soup(half_extents);
  cs550::BodyDef def;
  def.shape = cs550::make_shape(soup.vertices, soup.triangles).shape;
  return def;
}

int main() {
  cs550::World world;
  cs550::BodyDef ground = box({10, 10, 1});
  ground.kind = cs550::BodyKind::Static;
  ground.pose.position = {0, 0, -1};
  world.add_body(ground);
  cs550::BodyDef cube = box({0.5F, 0.5F, 0.5F});
  cube.pose.position = {0, 0, 3};
  const cs550::BodyId id = world.add_body(cube);
  apply_impulse(world.body(id), {0, 0, 1000}, cube.pose.position);  // 1 m/s upwards
  for (int step = 0; step < 180; ++step) world.step(1.0F / 60);
  std::cout << world.body(id).pose.position.z() << " m\n";
}
