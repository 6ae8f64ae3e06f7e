#include "autograder/grader/order.hpp"

#include <cstdlib>
#include <nlohmann/json.hpp>

namespace cs550::grader {
namespace {

constexpr const char* variable = "CS550_JUDGE";

}  // namespace

std::string Order::to_environment() const {
  std::vector<std::string> submission;
  for (const std::filesystem::path& library : libraries) submission.push_back(library.string());
  const nlohmann::json order{{"lab", lab},
                             {"submission", submission},
                             {"bubblewrap", isolation == Isolation::Bubblewrap},
                             {"cpu", limits.cpu.count()},
                             {"memory", limits.memory},
                             {"processes", limits.processes},
                             {"wall", wall.count()},
                             {"deadline", deadline.time_since_epoch().count()}};
  return std::string(variable) + '=' + order.dump();
}

std::optional<Order> Order::from_environment() {
  const char* text = std::getenv(variable);
  if (text == nullptr) return {};
  const auto values = nlohmann::json::parse(text);
  Order order;
  order.lab = values.at("lab");
  for (const std::string library : values.at("submission")) order.libraries.emplace_back(library);
  order.isolation = values.at("bubblewrap") ? Isolation::Bubblewrap : Isolation::Plain;
  order.limits.cpu = std::chrono::seconds(values.at("cpu").get<int>());
  order.limits.memory = values.at("memory");
  order.limits.processes = values.at("processes");
  order.wall = std::chrono::seconds(values.at("wall").get<int>());
  // The clock of another process of this machine is the same.
  using Clock = std::chrono::steady_clock;
  order.deadline = Clock::time_point(Clock::duration(values.at("deadline").get<Clock::rep>()));
  return order;
}

}  // namespace cs550::grader
