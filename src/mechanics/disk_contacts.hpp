#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mechanics/contact_names.hpp"
#include "mechanics/disk_contact.hpp"
#include "mechanics/force_term.hpp"

namespace impact {

/// What several disks do to each other: a DiskContact between every two. Bodies are numbered from
/// 0, the first.
class DiskContacts : public ForceTerm, public Contact {
 public:
  static constexpr const char* kName = kDiskContactName;
  static constexpr bool kInLanes = true;

  /// Outlines: of each body, as for DiskContact.
  DiskContacts(const Repulsion& law, double threshold,
               const std::vector<std::vector<std::int32_t>>& outlines, const ConstPoints& position);

  void add_forces(const ConstPoints& position, const Points& force);
  void enter(const PointArray& position, EnergyLedger& ledger) const;

  double moving_ends() const override { return DiskContact::kMovingEnds; }
  double threshold() const override { return pairs_.front().contact.threshold(); }
  double potential_energy(const ConstPoints& position) const override;
  /// Of the contact of these two bodies.
  double potential_energy(std::size_t body, std::size_t other, const ConstPoints& position) const;
  Eigen::Array2d total_force_on(std::size_t body) const override;
  std::vector<PointForce> contacts(const ConstPoints& position, double least_force) const override {
    return forces_on(0, position, least_force);
  }
  std::vector<PointForce> forces_on(std::size_t body, const ConstPoints& position,
                                    double least_force) const override;
  void count_hops(const ConstPoints& position) override;
  double hops_size() const override;
  double turned() const override;

 private:
  struct Pair {
    std::size_t first = 0;
    std::size_t second = 0;
    DiskContact contact;
  };
  template <class Of>
  double sum(const Of& of) const;

  std::vector<Pair> pairs_;
};

}  // namespace impact
