// A series of two impacts whose messages are changed, left out, doubled and put elsewhere as the
// bytes say: no number of a run may differ from the true one without a flag.

#include <ros/serialization.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>

#include "input.hpp"
#include "nodes/checksum.hpp"
#include "nodes/series_analysis.hpp"
#include "small_series.hpp"

namespace impact {
namespace {

using Series = std::vector<Message>;

std::uint64_t sum_of(const Series& messages) {
  std::uint64_t sum = 0;
  for (const Message& message : messages) {
    if (!std::holds_alternative<lattice_impact::RunStatus>(message)) {
      sum += std::visit([](const auto& m) { return checksum_of(m); }, message);
    }
  }
  return sum;
}

Series make_series() {
  Series series;
  for (const std::uint32_t number : {0U, 1U}) {
    Scene scene = small_scene(SceneKind::kCollision);
    scene.disk.recipe.points = 3;
    scene.output.period = 5.0;
    scene.impact.velocity *= 1.0 + number;
    Series run = messages_of(scene, number);
    for (Message& message : run) {  // short, so that most of the time is not that of YAML
      auto* const status = std::get_if<lattice_impact::RunStatus>(&message);
      if (status == nullptr) continue;
      status->scene =
          "{scene: collision, disk: {points: 3}, output: {period: 5.0}, impact: {velocity: " +
          std::to_string(scene.impact.velocity) + "}}";
    }
    auto& end = std::get<lattice_impact::RunStatus>(run.back());
    end.checksum = checksum_with(sum_of(run), end);
    series.insert(series.end(), run.begin(), run.end());
  }
  return series;
}

/// The last result of each run.
std::map<std::uint32_t, lattice_impact::Restitution> results_of(const Series& series) {
  std::map<std::uint32_t, lattice_impact::Restitution> results;
  SeriesAnalysis analysis({[](const auto&) {},
                           [&](const lattice_impact::Restitution& r) { results[r.run] = r; },
                           [](const auto&) {}, [](std::uint32_t, std::uint32_t) {},
                           [](const std::string& problem) {
                             if (problem.find('\n') != std::string::npos) std::abort();
                           }});
  for (const Message& message : series) {
    std::visit([&](const auto& m) { analysis.add(m); }, message);
  }
  analysis.close();
  return results;
}

/// Refuses lengths of arrays that no message here has; roscpp would ask for the memory first.
class LimitedStream : public ros::serialization::IStream {
 public:
  using IStream::IStream;

  template <class T>
  void next(T& value) {
    ros::serialization::deserialize(*this, value);
  }
  void next(std::uint32_t& value) {
    constexpr std::uint32_t kMost = 1U << 20U;
    IStream::next(value);
    if (value > kMost) throw std::length_error("an array");
  }
};

/// Leaves a message as it is whose bytes would not make one any more: ROS does not hand it over.
template <class M>
void change_byte(M& message, std::size_t place, std::uint8_t value) {
  const ros::SerializedMessage bytes = ros::serialization::serializeMessage(message);
  const std::size_t size = bytes.num_bytes - 4;  // behind the length
  bytes.message_start[place % size] ^= value;
  try {
    LimitedStream stream(bytes.message_start, static_cast<std::uint32_t>(size));
    M changed;
    ros::serialization::deserialize(stream, changed);
    message = changed;
  } catch (const std::exception&) {
  }
}

/// Four bytes a change.
void change(Series& series, const std::uint8_t* edit) {
  if (series.empty()) return;
  const std::size_t place = edit[1] % series.size();
  switch (edit[0] % 8) {
    case 0:
      series.erase(series.begin() + static_cast<std::ptrdiff_t>(place));
      break;
    case 1:
      series.insert(series.begin() + static_cast<std::ptrdiff_t>(place), series[place]);
      break;
    case 2:
      std::swap(series[place], series[edit[2] % series.size()]);
      break;
    default:
      std::visit([&](auto& m) { change_byte(m, edit[2] + 256U * (edit[0] / 8), edit[3]); },
                 series[place]);
  }
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Whether it says that it is not all there.
bool is_told(const lattice_impact::Restitution& result) {
  return result.complete == 0 || std::isnan(result.restitution);
}

}  // namespace
}  // namespace impact

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace impact;
  static const Series whole = make_series();
  static const auto truth = results_of(whole);
  Series series = whole;
  for (std::size_t at = 0; at + 4 <= size; at += 4) change(series, data + at);
  for (const auto& [run, result] : results_of(series)) {
    if (is_told(result)) continue;
    const auto found = truth.find(run);
    if (found == truth.end() || !same(found->second.restitution, result.restitution) ||
        !same(found->second.impulse, result.impulse) ||
        !same(found->second.contact_begin, result.contact_begin)) {
      std::abort();
    }
  }
  return 0;
}
