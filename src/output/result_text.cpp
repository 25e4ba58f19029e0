#include "output/result_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "measure/flags.hpp"
#include "output/text_table.hpp"

namespace impact {
namespace {

/// A number of a result.
struct Entry {
  const char* key;
  const char* label;
  const char* unit;
};

/// What the scene says of a run, which a result repeats.
const std::vector<Entry>& given(SceneKind kind) {
  static const std::map<SceneKind, std::vector<Entry>> entries{
      {SceneKind::kCollision, {{"velocity", "speed", "c"}}},
      {SceneKind::kContact, {{"P", "load", "M c²/R"}}},
      {SceneKind::kStretch, {}}};
  return entries.at(kind);
}

const std::vector<Entry>& found(SceneKind kind) {
  static const std::map<SceneKind, std::vector<Entry>> entries{
      {SceneKind::kCollision,
       {{"restitution", "restitution e", ""},
        {"energy_restitution", "√(E′/E) of motion", ""},
        {"contact_duration", "contact", "R/c"},
        {"peak_force", "peak force", "M c²/R"},
        {"spin_after", "spin after", "c/R"},
        {"tangential_velocity_after", "drift after", "c"},
        {"tangential_restitution", "tangential β", ""},
        {"impulse_ratio", "impulse ratio", ""},
        {"normal_energy", "E′ along y / E", ""},
        {"tangential_energy", "E′ along x / E", ""},
        {"rotation_energy", "E′ of spin / E", ""},
        {"momentum_passed_on", "momentum passed on", ""},
        {"restitution_of_ends", "e of the ends", ""},
        {"wall_velocity_after", "disk 2: v after", "c"},
        {"wall_tangential_velocity_after", "drift", "c"},
        {"wall_spin_after", "spin", "c/R"},
        {"wall2_velocity_after", "disk 3: v after", "c"},
        {"wall2_tangential_velocity_after", "drift", "c"},
        {"wall2_spin_after", "spin", "c/R"},
        {"wall3_velocity_after", "disk 4: v after", "c"},
        {"wall3_tangential_velocity_after", "drift", "c"},
        {"wall3_spin_after", "spin", "c/R"}}},
      {SceneKind::kContact,
       {{"strain", "strain ξ", "R"},
        {"wall_force", "wall force", "M c²/R"},
        {"rotation", "rotation", "rad"},
        {"hold_torque", "torque held", "M c²"}}},
      {SceneKind::kStretch,
       {{"young_modulus", "Young's modulus E", "M c²/R²"},
        {"poisson_ratio", "Poisson's ratio ν", ""},
        {"sound_speed", "sound speed c_s", "c"}}}};
  return entries.at(kind);
}

/// NaN: not known.
double error_of(const Result& result, const std::string& key) {
  const double error = result.number(key + "_error");
  if (!std::isnan(error) || key != "strain") return error;
  return result.number("estimated_error") * std::abs(result.number(key));
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, display_width(text)), ' ');
}

/// Zero but for rounding, as the drift of an impact without friction.
bool is_nothing(const Entry& entry, double value) {
  constexpr double kRounding = 1e-12;
  const std::string key = entry.key;
  return std::abs(value) < kRounding &&
         (key == "tangential_velocity_after" || key == "spin_after" || key == "impulse_ratio" ||
          key == "rotation" || key == "hold_torque");
}

using Cells = std::vector<std::string>;

/// Left-aligned columns.
std::string aligned_left(const std::vector<Cells>& lines) {
  std::vector<std::size_t> widths;
  for (const Cells& line : lines) {
    widths.resize(std::max(widths.size(), line.size()), 0);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      widths[i] = std::max(widths[i], display_width(line[i]));
    }
  }
  std::string text;
  for (const Cells& line : lines) {
    std::string row = " ";
    for (std::size_t i = 0; i < line.size(); ++i)
      row += (i == 1 ? "  " : " ") + padded(line[i], widths[i]);
    text += row.substr(0, row.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

std::string in_si(double value, const char* unit, const std::optional<SiUnits>& si) {
  const auto measure = si ? si->in_si(value, unit) : std::nullopt;
  return measure ? fmt::format("= {:.4g} {}", measure->value, measure->unit) : "";
}

Cells line_of(const Entry& entry, const Result& result, const std::optional<SiUnits>& si) {
  const double value = result.number(entry.key);
  const double error = error_of(result, entry.key);
  return {entry.label, digits(value, error),
          error > 0.0 ? fmt::format("± {:.2g}", error) : std::string(), entry.unit,
          in_si(value, entry.unit, si)};
}

std::string heading(const Entry& entry) {
  return *entry.unit == '\0' ? entry.label : fmt::format("{} [{}]", entry.label, entry.unit);
}

std::string flags_of(const Result& result) {
  std::string text;
  for (const std::string& flag : result.flags()) text += (text.empty() ? "" : ",") + flag;
  return text.empty() ? "-" : text;
}

void emit_json(YAML::Emitter& out, const YAML::Node& node);

void emit_map(YAML::Emitter& out, const YAML::Node& map) {
  out << YAML::Flow << YAML::BeginMap;
  for (const auto& entry : map) {
    out << YAML::Key << YAML::DoubleQuoted << entry.first.Scalar() << YAML::Value;
    emit_json(out, entry.second);
  }
  out << YAML::EndMap;
}

void emit_list(YAML::Emitter& out, const YAML::Node& list) {
  out << YAML::Flow << YAML::BeginSeq;
  for (const YAML::Node& element : list) emit_json(out, element);
  out << YAML::EndSeq;
}

void emit_scalar(YAML::Emitter& out, const YAML::Node& node) {
  const auto value = real_number(node);
  if (value && !std::isfinite(*value)) {
    out << YAML::Null;
  } else if (value || node.Scalar() == "true" || node.Scalar() == "false") {
    out << node.Scalar();
  } else {
    out << YAML::DoubleQuoted << node.Scalar();
  }
}

void emit_json(YAML::Emitter& out, const YAML::Node& node) {
  if (node.IsMap()) {
    emit_map(out, node);
  } else if (node.IsSequence()) {
    emit_list(out, node);
  } else if (node.IsScalar()) {
    emit_scalar(out, node);
  } else {
    out << YAML::Null;
  }
}

}  // namespace

std::string digits(double value, double error) {
  constexpr int kMost = 15;
  if (!std::isfinite(value)) return "not known";
  if (!(error > 0.0) || !std::isfinite(error)) return fmt::format("{:.6g}", value);
  const int last = static_cast<int>(std::floor(std::log10(error)));
  const int first =
      value == 0.0 ? last - 1 : static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (first < last) return "0";
  const int count = std::min(first - last + 1, kMost);
  constexpr int kSmallest = -4;
  const bool plain = first >= kSmallest && count > first;
  return plain ? fmt::format("{:.{}f}", value, count - 1 - first)
               : fmt::format("{:.{}e}", value, count - 1);
}

std::string title(const Scene& scene) {
  const int points = scene.disk.recipe.points;
  const std::string disk = scene.disk.file.empty()
                               ? fmt::format("{} points, seed {}", points, scene.seed)
                               : scene.disk.file;
  if (scene.kind == SceneKind::kStretch) {
    return fmt::format("stretch by {:g}, {}", scene.stretch.strain, disk);
  }
  if (scene.kind == SceneKind::kContact) {
    return fmt::format("contact under P = {:g} M c²/R, {}", scene.load.p, disk);
  }
  std::string throw_text = fmt::format("{:g} c", scene.impact.velocity);
  if (scene.impact.angle != 0.0) throw_text += fmt::format(" and {:g}°", scene.impact.angle);
  if (scene.impact.spin != 0.0) throw_text += fmt::format(", spin {:g} c/R", scene.impact.spin);
  std::string with;
  if (scene.wall.kind == WallKind::kLattice) with = " with an elastic wall";
  if (scene.is_row()) with = fmt::format(" with a row of {} disks", scene.wall.disks);
  return fmt::format("collision at {}{}, {}", throw_text, with, disk);
}

std::string result_block(const Result& result, const Scene& scene,
                         const std::optional<SiUnits>& si) {
  std::vector<Cells> lines;
  if (si) {
    for (const Entry& entry : given(scene.kind)) lines.push_back(line_of(entry, result, si));
  }
  for (const Entry& entry : found(scene.kind)) {
    if (result.has(entry.key) && !is_nothing(entry, result.number(entry.key)))
      lines.push_back(line_of(entry, result, si));
  }
  std::string text = aligned_left(lines);
  std::vector<Cells> flags;
  for (const std::string& flag : result.flags()) {
    const FlagText* const text = text_of_flag(flag);
    flags.push_back({"flag", flag + ":", text == nullptr ? "" : text->meaning});
  }
  return text + aligned_left(flags);
}

std::string result_table(const std::vector<Result>& results, SceneKind kind) {
  constexpr std::size_t kMost = 5;
  std::vector<const Entry*> entries;
  for (const auto* const list : {&given(kind), &found(kind)}) {
    for (const Entry& entry : *list) {
      if (entries.size() < kMost && results.front().has(entry.key)) entries.push_back(&entry);
    }
  }
  const Entry* const answer = &found(kind).front();
  TextTable table{{"run"}};
  for (const Entry* const entry : entries) {
    table[0].push_back(heading(*entry));
    if (entry == answer) table[0].push_back("±");
  }
  table[0].push_back("flags");
  for (const Result& result : results) {
    table.push_back({fmt::format("{}", result.number("run"))});
    for (const Entry* const entry : entries) {
      const double value = result.number(entry->key);
      const double error = error_of(result, entry->key);
      table.back().push_back(std::isfinite(value) ? digits(value, error) : "-");
      if (entry == answer) table.back().push_back(error > 0.0 ? fmt::format("{:.2g}", error) : "-");
    }
    table.back().push_back(flags_of(result));
  }
  return aligned(table);
}

YAML::Node si_values(const Result& result, const Scene& scene, const SiUnits& si) {
  YAML::Node values;
  YAML::Node units;
  for (const auto* const entries : {&given(scene.kind), &found(scene.kind)}) {
    for (const Entry& entry : *entries) {
      const auto measure = si.in_si(result.number(entry.key), entry.unit);
      if (!result.has(entry.key) || !measure) continue;
      values[entry.key] = exact(measure->value);
      units[entry.key] = measure->unit;
    }
  }
  values["units"] = units;
  return values;
}

std::string to_json(const YAML::Node& tree) {
  YAML::Emitter out;
  out.SetOutputCharset(YAML::EscapeAsJson);
  out.SetNullFormat(YAML::LowerNull);
  emit_json(out, tree);
  return out.c_str();
}

}  // namespace impact
