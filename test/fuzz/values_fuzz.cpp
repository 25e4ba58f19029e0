// Any bytes as a line of key=values, for impact and for sweep: scenes, or one line of error.

#include "input.hpp"
#include "scene/keys.hpp"
#include "scene/scene_parameters.hpp"
#include "scene/short_keys.hpp"
#include "series/sweep_values.hpp"

namespace impact {
namespace {

constexpr std::size_t kEnough = 50;  // scenes; more only take longer

void sweep(const FlatTree& scene, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) return;
  const auto values = sweep_values(assignment.substr(0, equals), assignment.substr(equals + 1));
  if (values.size() <= kEnough) parse_sweep(scene, {assignment});
}

void replace(FlatTree scene, const std::string& assignment) {
  override_keys(scene, {assignment});
  for (const auto& [key, values] : lists_of(scene)) {
    if (values.size() > kEnough) return;
  }
  parse_series(scene);
}

}  // namespace
}  // namespace impact

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string assignment = impact::text_of(data, size);
  const impact::FlatTree collision{{"scene", YAML::Node("collision")}};
  impact::must_be_one_line([&] { impact::replace(collision, assignment); });
  impact::must_be_one_line([&] { impact::sweep(collision, assignment); });
  return 0;
}
