// Any bytes as a scene file: a scene, or one line of error; what is written of a scene reads back
// to the same.

#include <cstdlib>

#include "input.hpp"
#include "scene/keys.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

constexpr std::size_t kEnough = 50;  // scenes; more only take longer

void read(const std::string& text) {
  const FlatTree keys = parse_keys(text, "scene.yaml");
  std::size_t count = 1;
  for (const auto& [key, values] : lists_of(keys)) count *= 1 + values.size();
  if (count > kEnough) return;
  for (const Scene& scene : parse_series(keys)) {
    const std::string yaml = to_yaml(scene);
    if (to_yaml(parse_scene(parse_keys(yaml, "again"))) != yaml) std::abort();
  }
}

}  // namespace
}  // namespace impact

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  impact::must_be_one_line([&] { impact::read(impact::text_of(data, size)); });
  return 0;
}
