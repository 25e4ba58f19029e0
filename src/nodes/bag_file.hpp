#pragma once

#include <ros/time.h>
#include <rosbag/bag.h>

#include <boost/shared_ptr.hpp>
#include <cerrno>
#include <memory>
#include <stdexcept>
#include <string>

namespace impact {

/// A bag that is written beside its final name, NAME.active, and takes it when it is whole. What
/// was there before under that name stays until then.
class BagFile {
 public:
  /// Names what an earlier recording that was cut off has left, in the log.
  /// @throw InputError when the file cannot be made.
  explicit BagFile(std::string name);
  /// An unfinished file is closed, as well as that goes, and stays as NAME.active.
  ~BagFile();
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  /// `header`: of the connection by which the message came; null: none.
  /// @throw std::runtime_error, naming the file, when the disk does not take it.
  template <class Message>
  void write(const std::string& topic, const ros::Time& time, const Message& message,
             const boost::shared_ptr<ros::M_string>& header = nullptr) {
    attempt([&] { bag_->write(topic, time, message, header); });
  }

  /// Closes it. A complete bag takes its name, in place of one that is there; another one is named
  /// NAME.incomplete.bag, with a number where that is there already. Returns the name.
  /// @throw std::runtime_error as write().
  std::string finish(bool complete);

  /// Takes the file away.
  void discard();

 private:
  template <class Action>
  void attempt(const Action& action) {
    errno = 0;
    try {
      action();
    } catch (const std::exception& error) {
      fail(error.what());
    }
  }
  [[noreturn]] void fail(const std::string& cause);

  std::string name_;
  std::string active_;
  std::unique_ptr<rosbag::Bag> bag_;
};

}  // namespace impact
