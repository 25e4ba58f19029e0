#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "measure/strain.hpp"
#include "run/run.hpp"

namespace impact {

/// The course of a run at its output times.
class History {
 public:
  /// `states`: file for the states of all points; empty: they are not kept.
  explicit History(std::filesystem::path states = {}) : states_path_(std::move(states)) {}

  /// Begins anew, for the first run or a finer one.
  void start();

  /// `reports`: those that end with the present state.
  void add(const Run& run, const Strain& strain, const ContactReports& reports);

  /// The content of history.csv: strain, wall force, velocity of the disk's centre of mass, where
  /// the energy is.
  const std::string& csv() const { return csv_; }

  /// To be called at the end.
  /// @throw std::runtime_error when the states could not be written.
  void close();

 private:
  std::string csv_;
  std::filesystem::path states_path_;
  std::ofstream states_;
};

}  // namespace impact
