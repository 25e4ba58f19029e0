// A bag of two impacts, or of two contacts, whose messages are changed, cut, left out, doubled and
// put elsewhere as the bytes say, through the file and the reader of analyse_bag: one line of
// error, or numbers of which none differs from the true one without a word. Any bytes as a bag
// would mostly try rosbag, which asks for gigabytes or reads where nothing is on some of them (so
// analyse_bag reads in a process of its own); test/faults/faults.py does that.

#include <console_bridge/console.h>
#include <sys/mman.h>

#include <algorithm>
#include <exception>
#include <map>
#include <set>

#include "input.hpp"
#include "nodes/bag_pipeline.hpp"
#include "recording.hpp"

namespace ros {
namespace message_traits {

template <>
struct MD5Sum<impact::Record> {
  static const char* value(const impact::Record& record) { return record.md5sum.c_str(); }
};
template <>
struct DataType<impact::Record> {
  static const char* value(const impact::Record& record) { return record.type.c_str(); }
};
template <>
struct Definition<impact::Record> {
  static const char* value(const impact::Record&) { return ""; }
};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<impact::Record> {
  template <class Stream>
  static void write(Stream& stream, const impact::Record& record) {
    const auto size = static_cast<std::uint32_t>(record.bytes.size());
    std::copy(record.bytes.begin(), record.bytes.end(), stream.advance(size));
  }
  static std::uint32_t serializedLength(const impact::Record& record) {
    return static_cast<std::uint32_t>(record.bytes.size());
  }
};

}  // namespace serialization
}  // namespace ros

namespace impact {
namespace {

using Records = std::vector<Record>;

template <class... Messages>
bool is_too_long(const Record& record) {
  const auto is = [&](auto message) {
    using Message = decltype(message);
    if (!is_a<Message>(record)) return false;
    try {
      message_of<Message>(record);
    } catch (const std::length_error&) {
      return true;
    } catch (const ros::serialization::StreamOverrunException&) {
    }
    return false;
  };
  return (is(Messages()) || ...);
}

/// Leaves out changes after which roscpp would ask for gigabytes.
template <class Change>
void change_bytes(Record& record, const Change& change) {
  Record changed = record;
  change(changed.bytes);
  if (!is_too_long<lattice_impact::Lattice, lattice_impact::ParticleStates,
                   lattice_impact::ContactForces, lattice_impact::RunStatus,
                   lattice_impact::Scalars, lattice_impact::Strain, lattice_impact::Restitution,
                   lattice_impact::LawFit>(changed)) {
    record = changed;
  }
}

/// Four bytes a change.
void change(Records& records, const std::uint8_t* edit) {
  if (records.empty()) return;
  const auto place = records.begin() + edit[1] % static_cast<std::ptrdiff_t>(records.size());
  const Record other = records[edit[2] % records.size()];
  const std::size_t byte = edit[2] + 256U * (edit[0] / 8U);
  switch (edit[0] % 8) {
    case 0:
      records.erase(place);
      break;
    case 1:
      records.insert(place, Record(*place));
      break;
    case 2:
      place->time = other.time;
      break;
    case 3:
      place->topic = other.topic;
      break;
    case 4:
      change_bytes(*place, [&](auto& bytes) { bytes.resize(1 + byte % bytes.size()); });
      break;
    default:
      change_bytes(*place, [&](auto& bytes) { bytes[byte % bytes.size()] ^= edit[3]; });
  }
}

void write(const Records& records, const std::string& path) {
  static rosbag::Bag bag;  // a new one would load its plugins anew
  bag.open(path, rosbag::bagmode::Write);
  for (const Record& record : records) {
    const auto header = boost::make_shared<ros::M_string>(
        ros::M_string{{"topic", record.topic},
                      {"type", record.type},
                      {"md5sum", record.md5sum},
                      {"message_definition", ""}});  // one connection for each topic and type
    bag.write(record.topic, record.time, record, header);
  }
  bag.close();
}

void must_be_one_line(const std::string& text) {
  if (text.empty() || text.find('\n') != std::string::npos) std::abort();
}

/// What analyse_bag says.
struct Reading {
  std::map<std::string, YAML::Node> documents;  ///< by namespace
  std::vector<std::string> problems;
};

/// Nothing when it says that the bag is damaged.
Reading read(const std::string& path) {
  Reading reading;
  try {
    const auto pipelines = read_bag(path, {}, [&](const std::string& problem) {
      must_be_one_line(problem);
      reading.problems.push_back(problem);
    });
    for (const auto& [name_space, pipeline] : pipelines) {
      pipeline.text();
      reading.documents[name_space] = pipeline.document();
      if (pipeline.complete() != reading.problems.empty()) std::abort();
    }
  } catch (const std::exception& error) {
    must_be_one_line(error.what());
    return {};
  }
  return reading;
}

/// Of all but the order of the runs: they may end in another one, and a fit then says that it came
/// after another one.
std::string without_order(const YAML::Node& document) {
  std::multiset<std::string> parts{YAML::Dump(document["topics"])};
  for (const YAML::Node& run : document["runs"]) parts.insert(YAML::Dump(run));
  for (const YAML::Node& law : document["law_fits"]) {
    YAML::Node fit = YAML::Clone(law);
    fit.remove("run");
    parts.insert(YAML::Dump(fit));
  }
  std::string text;
  for (const std::string& part : parts) text += part + "\n";
  return text;
}

/// Whether the results are the true ones. Scalars are published only while somebody listens, so
/// that a run may lack all of them; and results are recorded only where somebody computed them.
bool are_the_same(const YAML::Node& results, const YAML::Node& true_results,
                  const std::string& name_space) {
  YAML::Node found = YAML::Clone(results);
  YAML::Node truth = YAML::Clone(true_results);
  const YAML::Node& recorded = results["topics"];
  for (const char* topic : {"/strain", "/restitution", "/law_fit"}) {
    if (!recorded[name_space + topic]) truth["topics"].remove(name_space + topic);
  }
  found["topics"].remove(name_space + "/scalars");
  truth["topics"].remove(name_space + "/scalars");
  return without_order(found) == without_order(truth);
}

/// The numbers of each run.
using Numbers = std::map<std::string, std::map<std::string, std::string>>;

Numbers numbers_of(const YAML::Node& document) {
  Numbers numbers;
  for (const YAML::Node& run : document["runs"]) {
    for (const auto& entry : run) {
      const auto key = entry.first.as<std::string>();
      if (key == "run" || key == "complete" || !entry.second.IsScalar()) continue;
      numbers[run["run"].as<std::string>()][key] = entry.second.as<std::string>();
    }
  }
  return numbers;
}

[[noreturn]] void fail(const std::string& what) {
  fmt::print(stderr, "{}\n", what);
  std::abort();
}

/// Fails where a number is not the true one and nothing was said of its run.
void judge(const Reading& reading, const std::string& name_space, const YAML::Node& truth) {
  const auto found = reading.documents.find(name_space);
  if (found == reading.documents.end()) return;
  if (reading.problems.empty() && !are_the_same(found->second, truth, name_space)) {
    fail(fmt::format("not a word, and not the true results:\n{}", YAML::Dump(found->second)));
  }
  Numbers true_numbers = numbers_of(truth);
  for (const auto& [run, numbers] : numbers_of(found->second)) {
    const std::string told = fmt::format("{}: run {}:", name_space, run);
    const bool is_told = std::any_of(
        reading.problems.begin(), reading.problems.end(),
        [&](const auto& problem) { return problem.compare(0, told.size(), told) == 0; });
    if (is_told) continue;
    for (const auto& [key, number] : numbers) {
      const std::string true_number = true_numbers[run][key];
      if (number != ".nan" && number != true_number) {
        fail(fmt::format("run {}: {} {} for {}", run, key, number, true_number));
      }
    }
  }
}

/// What was recorded in one namespace.
struct Original {
  explicit Original(const std::string& its_name_space) : name_space(its_name_space) {
    for (const Record& record : recording()) {
      if (record.topic.rfind(name_space + "/", 0) == 0) records.push_back(record);
    }
    write(records, path());
    const Reading reading = read(path());
    if (reading.documents.count(name_space) == 0 || !reading.problems.empty()) {
      fail("recorded.bag is not of these messages: test/fuzz/record.py");
    }
    truth = reading.documents.at(name_space);
  }

  static const std::string& path() {
    static const std::string in_memory =
        fmt::format("/proc/self/fd/{}", memfd_create("recorded.bag", 0));
    return in_memory;
  }

  std::string name_space;
  Records records;
  YAML::Node truth;
};

}  // namespace
}  // namespace impact

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace impact;
  console_bridge::noOutputHandler();
  static const Original impacts("/collision");
  static const Original contacts("/contact");
  if (size == 0) return 0;
  const Original& original = data[0] % 2 == 0 ? impacts : contacts;
  Records records = original.records;
  for (std::size_t at = 1; at + 4 <= size; at += 4) change(records, data + at);
  write(records, Original::path());
  judge(read(Original::path()), original.name_space, original.truth);
  return 0;
}
