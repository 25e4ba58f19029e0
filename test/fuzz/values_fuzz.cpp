// Any bytes as a line of key=values, for impact and for sweep: scenes, or one line of error.

#include "input.hpp"
#include "scene/scene_parameters.hpp"
#include "tools/sweep_values.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string assignment = impact::text_of(data, size);
  const impact::FlatTree collision{{"scene", YAML::Node("collision")}};
  impact::must_be_one_line([&] {
    impact::FlatTree keys = collision;
    impact::override_key(keys, assignment);
    impact::parse_series(keys);
  });
  impact::must_be_one_line([&] { impact::parse_sweep(collision, {assignment}); });
  return 0;
}
