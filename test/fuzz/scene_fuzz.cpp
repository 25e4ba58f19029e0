// Any bytes as a scene file: a scene, or one line of error; what is written of a scene reads back
// to the same.

#include <fmt/format.h>

#include <cstdlib>

#include "input.hpp"
#include "scene/scene_parameters.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  impact::must_be_one_line([&] {
    for (const impact::Scene& scene :
         impact::parse_series(impact::parse_keys(impact::text_of(data, size), "scene.yaml"))) {
      const std::string yaml = impact::to_yaml(scene);
      const impact::Scene again = impact::parse_scene(impact::parse_keys(yaml, "again"));
      if (impact::to_yaml(again) != yaml) std::abort();
    }
  });
  return 0;
}
