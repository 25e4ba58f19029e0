#include "mechanics/disk_contact.hpp"

#include <algorithm>
#include <map>

namespace impact {
namespace {

std::vector<std::int32_t> points_of(const std::vector<std::int32_t>& outline) {
  return {outline.begin(), outline.end() - 1};
}

}  // namespace

std::vector<PointForce> sum_of(const std::vector<PointForce>& a, const std::vector<PointForce>& b) {
  std::map<std::int32_t, Eigen::Array2d> sums;
  for (const auto* forces : {&a, &b}) {
    for (const auto& [point, force] : *forces) {
      sums.try_emplace(point, Eigen::Array2d::Zero()).first->second += force;
    }
  }
  std::vector<PointForce> all;
  all.reserve(sums.size());
  for (const auto& [point, force] : sums) all.push_back({point, force});
  return all;
}

DiskContact::DiskContact(const Repulsion& law, double threshold,
                         const std::vector<std::int32_t>& first,
                         const std::vector<std::int32_t>& second, const ConstPoints& position)
    : Contact(law),
      on_first_(law, threshold, GapMeasure::kNearest, points_of(first), second, position),
      on_second_(law, threshold, GapMeasure::kNearest, points_of(second), first, position) {}

void DiskContact::add_forces(const ConstPoints& position, const Points& force) {
  on_first_.add_forces(position, force);
  on_second_.add_forces(position, force);
  take_in(on_first_.total_force() - on_second_.total_force(),
          std::max(on_first_.largest_force(), on_second_.largest_force()));
}

void DiskContact::enter(const PointArray& position, EnergyLedger& ledger) const {
  on_first_.enter(position, ledger);
  on_second_.enter(position, ledger);
}

double DiskContact::potential_energy(const ConstPoints& position) const {
  return on_first_.potential_energy(position) + on_second_.potential_energy(position);
}

std::vector<PointForce> DiskContact::contacts(const ConstPoints& position,
                                              double least_force) const {
  return sum_of(on_first_.contacts(position, least_force),
                on_second_.reactions(position, least_force));
}

std::vector<PointForce> DiskContact::reactions(const ConstPoints& position,
                                               double least_force) const {
  return sum_of(on_first_.reactions(position, least_force),
                on_second_.contacts(position, least_force));
}

void DiskContact::count_hops(const ConstPoints& position) {
  on_first_.count_hops(position);
  on_second_.count_hops(position);
}

}  // namespace impact
