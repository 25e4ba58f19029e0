#pragma once

#include <lattice_impact/LawFit.h>

#include <string>
#include <vector>

#include "scene/parameter_table.hpp"

namespace impact {

inline YAML::Node element(double value) { return exact(value); }
template <class T>
YAML::Node element(const T& value) {
  return YAML::Node(value);
}

/// On one line, numbers to the last bit.
template <class T>
YAML::Node one_line_list(const std::vector<T>& values) {
  YAML::Node list(YAML::NodeType::Sequence);
  list.SetStyle(YAML::EmitterStyle::Flow);
  for (const T& value : values) list.push_back(element(value));
  return list;
}

/// A fit by the names of its message's fields, to the last bit.
inline YAML::Node to_yaml(const lattice_impact::LawFit& law) {
  YAML::Node node;
  node["run"] = law.run;
  node["law"] = law.law;
  node["scene"] = YAML::Load(law.scene);
  node["scene"].SetStyle(YAML::EmitterStyle::Flow);
  node["left_out"] = law.left_out;
  node["x"] = one_line_list(law.x);
  node["y"] = one_line_list(law.y);
  node["y_standard_error"] = one_line_list(law.y_standard_error);
  node["runs"] = one_line_list(law.runs);
  node["y_theory"] = one_line_list(law.y_theory);
  node["y_inertial_load"] = one_line_list(law.y_inertial_load);
  node["names"] = one_line_list(law.names);
  node["values"] = one_line_list(law.values);
  node["standard_errors"] = one_line_list(law.standard_errors);
  node["paper_values"] = one_line_list(law.paper_values);
  node["residual"] = exact(law.residual);
  node["x_low"] = exact(law.x_low);
  node["x_high"] = exact(law.x_high);
  node["declined"] = law.declined;
  node["young_modulus"] = exact(law.young_modulus);
  node["young_modulus_origin"] = law.young_modulus_origin;
  node["poisson_ratio"] = exact(law.poisson_ratio);
  node["poisson_ratio_origin"] = law.poisson_ratio_origin;
  node["sound_speed"] = exact(law.sound_speed);
  node["dissipation_time"] = exact(law.dissipation_time);
  node["dissipation_time_origin"] = law.dissipation_time_origin;
  return node;
}

}  // namespace impact
