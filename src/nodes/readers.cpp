#include "nodes/readers.hpp"

#include <fmt/format.h>
#include <lattice_impact/Acknowledged.h>

#include <algorithm>
#include <stdexcept>

#include "nodes/program.hpp"

namespace impact {

Readers::Readers(ros::NodeHandle& node, const std::vector<std::string>& names) : node_(node) {
  for (const std::string& name : names) names_.push_back(node.resolveName(name));
}

ros::Publisher Readers::advertise(ros::AdvertiseOptions options) {
  auto& subscribers = subscribers_[node_.resolveName(options.topic)];
  options.connect_cb = [&subscribers](const ros::SingleSubscriberPublisher& link) {
    subscribers.insert(link.getSubscriberName());
  };
  options.disconnect_cb = [&subscribers](const ros::SingleSubscriberPublisher& link) {
    subscribers.erase(link.getSubscriberName());
  };
  return node_.advertise(options);
}

void Readers::wait(double timeout) {
  const ros::WallTime start = ros::WallTime::now();
  while (!missing().empty() && !asked_to_end()) {
    if ((ros::WallTime::now() - start).toSec() > timeout) {
      throw std::runtime_error(
          fmt::format("no subscription within {} s (timeout): {}", timeout, missing()));
    }
    serve_callbacks();
  }
}

void Readers::check() const {
  if (!all_there()) throw std::runtime_error("gone in mid-run: " + missing());
}

bool Readers::hears(const std::string& name) const {
  return std::any_of(subscribers_.begin(), subscribers_.end(),
                     [&](const auto& topic) { return topic.second.count(name) > 0; });
}

std::set<std::string> Readers::subscribers() const {
  std::set<std::string> all;
  for (const auto& topic : subscribers_) all.insert(topic.second.begin(), topic.second.end());
  return all;
}

bool Readers::all_there() const {
  return std::all_of(names_.begin(), names_.end(), [this](const std::string& name) {
    return std::all_of(subscribers_.begin(), subscribers_.end(),
                       [&](const auto& topic) { return topic.second.count(name) > 0; });
  });
}

std::string Readers::missing() const {
  std::vector<std::string> links;
  for (const auto& topic : subscribers_) {
    for (const std::string& name : names_) {
      if (topic.second.count(name) == 0) links.push_back(name + " to " + topic.first);
    }
  }
  return fmt::format("{}", fmt::join(links, ", "));
}

Pacing::Pacing(ros::NodeHandle& node, const std::vector<std::string>& names) {
  for (const std::string& name : names) acknowledged_[node.resolveName(name)] = {-1, -1};
  if (names.empty()) return;
  subscriber_ = node.subscribe<lattice_impact::Acknowledged>(
      "acknowledged", 0, [this](const lattice_impact::AcknowledgedConstPtr& message) {
        const auto reader = acknowledged_.find(message->reader);
        if (reader == acknowledged_.end()) return;
        reader->second = std::max(reader->second, Position{message->run, message->sequence});
        last_news_ = ros::WallTime::now();
      });
}

void Pacing::wait_for_links(double timeout) {
  const ros::WallTime start = ros::WallTime::now();
  while (!acknowledged_.empty() && subscriber_.getNumPublishers() < acknowledged_.size() &&
         !asked_to_end()) {
    if ((ros::WallTime::now() - start).toSec() > timeout) {
      throw std::runtime_error(fmt::format(
          "{} of {} nodes in acknowledged_by publish on {} within {} s (timeout)",
          subscriber_.getNumPublishers(), acknowledged_.size(), subscriber_.getTopic(), timeout));
    }
    serve_callbacks();
  }
  last_news_ = ros::WallTime::now();
}

bool Pacing::is_acknowledged(std::uint32_t run, std::int64_t sequence) const {
  return std::all_of(acknowledged_.begin(), acknowledged_.end(), [&](const auto& reader) {
    return reader.second >= Position{run, sequence};
  });
}

void Pacing::wait(std::uint32_t run, std::int64_t sequence, double timeout,
                  const std::function<bool(const std::string&)>& is_there) {
  last_news_ = ros::WallTime::now();
  for (const auto& reader : acknowledged_) {
    while (reader.second < Position{run, sequence} && !asked_to_end()) {
      if (is_there(reader.first)) {
        seen_.insert(reader.first);
      } else if (seen_.count(reader.first) > 0) {
        throw std::runtime_error(fmt::format("{} has gone in mid-run", reader.first));
      }
      if ((ros::WallTime::now() - last_news_).toSec() > timeout) {
        throw std::runtime_error(
            fmt::format("{} has acknowledged nothing for {} s (timeout)", reader.first, timeout));
      }
      serve_callbacks();
    }
  }
}

}  // namespace impact
