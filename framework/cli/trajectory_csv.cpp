#include "trajectory_csv.hpp"

#include <limits>
#include <stdexcept>
#include <system_error>

namespace cs550::cli {
namespace {

/// In quotes, so that a name may hold a comma (RFC 4180).
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

void write(std::ostream& stream, const Vec3& vector) {
  for (int i = 0; i < 3; ++i) stream << ',' << vector[i];
}

void write(std::ostream& stream, const Quat& q) {
  stream << ',' << q.w() << ',' << q.x() << ',' << q.y() << ',' << q.z();
}

}  // namespace

TrajectoryCsv::TrajectoryCsv(std::filesystem::path file)
    : file_(std::move(file)), unfinished_(file_.string() + ".unfinished"), stream_(unfinished_) {
  if (std::filesystem::is_directory(file_)) stream_.setstate(std::ios::failbit);
  if (!stream_) throw std::runtime_error("cannot write " + file_.string());
  stream_.precision(std::numeric_limits<Real>::max_digits10);
  stream_ << "step,time_s,body,name,x_m,y_m,z_m,qw,qx,qy,qz,"
             "vx_mps,vy_mps,vz_mps,wx_radps,wy_radps,wz_radps\n";
}

TrajectoryCsv::~TrajectoryCsv() {
  std::error_code gone_already;
  std::filesystem::remove(unfinished_, gone_already);
}

void TrajectoryCsv::add(const World& world, const Scene& scene) {
  for (std::size_t i = 0; i < world.bodies().size(); ++i) {
    const RigidBody& body = world.bodies()[i];
    if (body.kind == BodyKind::Static) continue;
    stream_ << world.step_count() << ',' << world.time() << ',' << i << ','
            << quoted(scene.body_names[i]);
    write(stream_, body.pose.position);
    write(stream_, body.pose.orientation);
    write(stream_, body.linear_velocity);
    write(stream_, body.angular_velocity);
    stream_ << '\n';
  }
}

void TrajectoryCsv::commit() {
  stream_.close();
  if (!stream_) throw std::runtime_error("cannot write all of " + file_.string());
  std::filesystem::rename(unfinished_, file_);
}

}  // namespace cs550::cli
