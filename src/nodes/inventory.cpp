#include "nodes/inventory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "nodes/body_topics.hpp"

namespace impact {
namespace {

using lattice_impact::RunStatus;

constexpr const char* kStatus = "run_status";
constexpr const char* kLattice = "lattice";
constexpr const char* kScalars = "scalars";

bool is_lattice(const std::string& topic) { return topic.substr(topic.rfind('/') + 1) == kLattice; }

}  // namespace

bool has_ended(const std::optional<RunStatus>& status) {
  return status && status->phase != RunStatus::RUNNING;
}

void Inventory::add(const std::string& topic, std::uint32_t run) { ++runs_[run].counts[topic]; }

void Inventory::add(const RunStatus& status) {
  add(kStatus, status.run);
  runs_[status.run].status = status;
}

std::vector<std::string> Inventory::topics(const RunStatus& status) {
  std::vector<std::string> topics;
  for (std::size_t body = 0; body < bodies_said(status.bodies); ++body) {
    for (const char* const topic : {kLattice, "particle_states", "contact_forces"}) {
      topics.push_back(topics_of_body(body) + topic);
    }
  }
  topics.insert(topics.end(), {kScalars, kStatus});
  return topics;
}

std::uint32_t Inventory::promised(const Run& run, const std::string& topic) {
  if (!run.status) return 0;
  const auto all = topics(*run.status);
  if (std::find(all.begin(), all.end(), topic) == all.end()) return 0;
  if (topic == kStatus) return run.status->sequence + 1;
  if (topic == kScalars && count(run, topic) == 0) return 0;
  return is_lattice(topic) ? 1 : run.status->states;
}

std::uint64_t Inventory::published(const std::string& topic) const {
  std::uint64_t sum = 0;
  for (const auto& run : runs_) {
    const std::uint32_t found = count(run.second, topic);
    const std::uint32_t said = promised(run.second, topic);
    sum += has_ended(run.second.status) ? said : std::max(said, found);
  }
  return sum;
}

std::uint32_t Inventory::count(const Run& run, const std::string& topic) {
  const auto found = run.counts.find(topic);
  return found == run.counts.end() ? 0 : found->second;
}

std::uint32_t Inventory::states(std::uint32_t number) const {
  const auto run = runs_.find(number);
  if (run == runs_.end() || !run->second.status) return 0;
  std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
  for (const std::string& topic : topics(*run->second.status)) {
    if (topic == kStatus || topic == kScalars || is_lattice(topic)) continue;
    least = std::min(least, count(run->second, topic));
  }
  return least;
}

bool Inventory::has_all(const Run& run) {
  if (!has_ended(run.status)) return false;
  const auto all = topics(*run.status);
  return std::all_of(all.begin(), all.end(), [&](const std::string& topic) {
    return count(run, topic) >= promised(run, topic);
  });
}

bool Inventory::has_all_of(std::uint32_t number) const {
  const auto run = runs_.find(number);
  return run != runs_.end() && has_all(run->second);
}

std::uint32_t Inventory::last_run() const {
  for (const auto& [number, run] : runs_) {
    if (!run.status) continue;
    const bool finished = !has_ended(run.status) || run.status->phase == RunStatus::FINISHED;
    if (!finished || run.status->runs == number + 1) return number;
  }
  return std::numeric_limits<std::uint32_t>::max();
}

void Inventory::add_problems(std::uint32_t number, const Run& run,
                             std::vector<std::string>& lines) {
  if (!run.status) {
    lines.push_back(fmt::format("run {}: run_status is missing", number));
    return;
  }
  if (!has_ended(run.status)) {
    lines.push_back(fmt::format("run {}: its end was not announced", number));
    return;
  }
  for (const std::string& topic : topics(*run.status)) {
    const std::uint32_t expected = promised(run, topic);
    const std::uint32_t found = count(run, topic);
    if (found == expected) continue;
    lines.push_back(
        fmt::format("run {}: {}: {} of {} messages published", number, topic, found, expected));
  }
  if (run.status->phase == RunStatus::INTERRUPTED) {
    lines.push_back(fmt::format("run {}: interrupted", number));
  } else if (run.status->phase == RunStatus::FAILED) {
    lines.push_back(fmt::format("run {}: {}", number, run.status->error));
  }
}

std::vector<std::string> Inventory::problems() const {
  std::uint32_t runs = 0;
  for (const auto& run : runs_) {
    runs = std::max({runs, run.first + 1, run.second.status ? run.second.status->runs : 0});
  }
  std::vector<std::string> lines;
  if (runs == 0) lines.emplace_back("there is no run");
  constexpr std::size_t kMostLines = 20;
  for (std::uint32_t number = 0; number < runs; ++number) {
    const auto run = runs_.find(number);
    if (run == runs_.end()) {
      lines.push_back(fmt::format("run {} of {} is missing", number, runs));
    } else {
      add_problems(number, run->second, lines);
    }
    if (lines.size() > kMostLines) {
      lines.emplace_back("and more");
      break;
    }
  }
  return lines;
}

}  // namespace impact
