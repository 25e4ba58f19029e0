#include "mechanics/disk_contacts.hpp"

#include <algorithm>

namespace impact {

DiskContacts::DiskContacts(const Repulsion& law, double threshold,
                           const std::vector<std::vector<std::int32_t>>& outlines,
                           const ConstPoints& position)
    : Contact(law) {
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    for (std::size_t j = i + 1; j < outlines.size(); ++j) {
      pairs_.push_back({i, j, DiskContact(law, threshold, outlines[i], outlines[j], position)});
    }
  }
}

void DiskContacts::add_forces(const ConstPoints& position, const Points& force) {
  double largest = 0.0;
  for (Pair& pair : pairs_) {
    pair.contact.add_forces(position, force);
    largest = std::max(largest, pair.contact.largest_force());
  }
  take_in(total_force_on(0), largest);
}

void DiskContacts::enter(const PointArray& position, EnergyLedger& ledger) const {
  for (const Pair& pair : pairs_) pair.contact.enter(position, ledger);
}

template <class Of>
double DiskContacts::sum(const Of& of) const {
  double all = 0.0;
  for (const Pair& pair : pairs_) all += of(pair.contact);
  return all;
}

double DiskContacts::potential_energy(const ConstPoints& position) const {
  return sum([&](const DiskContact& contact) { return contact.potential_energy(position); });
}

double DiskContacts::potential_energy(std::size_t body, std::size_t other,
                                      const ConstPoints& position) const {
  const auto [first, second] = std::minmax(body, other);
  const auto pair = std::find_if(pairs_.begin(), pairs_.end(), [&, i = first, j = second](auto& p) {
    return p.first == i && p.second == j;
  });
  return pair->contact.potential_energy(position);
}

Eigen::Array2d DiskContacts::total_force_on(std::size_t body) const {
  Eigen::Array2d total = Eigen::Array2d::Zero();
  for (const Pair& pair : pairs_) {
    if (pair.first == body) total += pair.contact.total_force();
    if (pair.second == body) total -= pair.contact.total_force();
  }
  return total;
}

std::vector<PointForce> DiskContacts::forces_on(std::size_t body, const ConstPoints& position,
                                                double least_force) const {
  std::vector<PointForce> forces;
  for (const Pair& pair : pairs_) {
    if (pair.first == body) forces = sum_of(forces, pair.contact.contacts(position, least_force));
    if (pair.second == body) forces = sum_of(forces, pair.contact.reactions(position, least_force));
  }
  return forces;
}

void DiskContacts::count_hops(const ConstPoints& position) {
  for (Pair& pair : pairs_) pair.contact.count_hops(position);
}

double DiskContacts::hops_size() const {
  return sum([](const DiskContact& contact) { return contact.hops_size(); });
}

double DiskContacts::turned() const {
  return sum([](const DiskContact& contact) { return contact.turned(); });
}

}  // namespace impact
