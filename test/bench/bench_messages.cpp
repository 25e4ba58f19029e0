// What the nodes do with the messages of a state beside roscpp and rosbag: from the engine to the
// bytes for the socket, and from the bytes of the socket into the bag. Each beside the copy of
// these bytes and what the library takes alone.

#include <benchmark/benchmark.h>
#include <rosbag/bag.h>
#include <topic_tools/shape_shifter.h>

#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "nodes/checksum.hpp"
#include "nodes/conversions.hpp"
#include "nodes/raw_message.hpp"
#include "nodes/states_of_body.hpp"
#include "run/run.hpp"

namespace impact {
namespace {

using lattice_impact::ContactForces;
using lattice_impact::ParticleStates;

/// A state of the default disk in contact with the wall.
struct Sample {
  Body disk;
  State state;
  ContactReport report;
};

const Sample& sample() {
  static const Sample in_contact = [] {
    Scene scene;
    scene.kind = SceneKind::kCollision;
    Run run(scene);
    Sample result;
    while (result.report.points.empty() && !run.finished()) {
      run.advance([] { return false; });
      result = {run.system().field().first_body(), run.disk_state(),
                run.take_contact_reports().on_first};
    }
    return result;
  }();
  return in_contact;
}

struct Messages {
  ParticleStates states = to_message(sample().state);
  ContactForces forces = to_message(sample().report);
};

template <class Message>
std::vector<std::uint8_t> bytes_of(const Message& message) {
  const ros::SerializedMessage wire = ros::serialization::serializeMessage(message);
  return {wire.message_start, wire.buf.get() + wire.num_bytes};
}

void memcpy_of_the_bytes(benchmark::State& state) {
  const Messages messages;
  std::vector<std::uint8_t> from = bytes_of(messages.states);
  for (const std::uint8_t byte : bytes_of(messages.forces)) from.push_back(byte);
  std::vector<std::uint8_t> to(from.size());
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), from.size());
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(from.size()));
}
BENCHMARK(memcpy_of_the_bytes);

/// All that roscpp does with a message in the thread that publishes it, but for the queue.
void roscpp_serializes_prepared_messages(benchmark::State& state) {
  const Messages messages;
  for (auto _ : state) {
    benchmark::DoNotOptimize(ros::serialization::serializeMessage(messages.states));
    benchmark::DoNotOptimize(ros::serialization::serializeMessage(messages.forces));
  }
}
BENCHMARK(roscpp_serializes_prepared_messages);

/// As SimulationNode::send().
void engine_to_bytes(benchmark::State& state) {
  Messages messages;
  std::uint64_t sum = 0;
  for (auto _ : state) {
    to_message(sample().report, messages.forces);
    const RawMessage<ParticleStates> states(
        StatesOfBody{messages.forces.header, 0, 0, sample().state, sample().disk});
    const RawMessage<ContactForces> forces(messages.forces);
    sum += checksum_of(states) + checksum_of(forces);
    benchmark::DoNotOptimize(ros::serialization::serializeMessage(states));
    benchmark::DoNotOptimize(ros::serialization::serializeMessage(forces));
  }
  benchmark::DoNotOptimize(sum);
}
BENCHMARK(engine_to_bytes);

void checksums(benchmark::State& state) {
  const Messages messages;
  const RawMessage<ParticleStates> states(messages.states);
  const RawMessage<ContactForces> forces(messages.forces);
  std::uint64_t sum = 0;
  for (auto _ : state) sum += checksum_of(states) + checksum_of(forces);
  benchmark::DoNotOptimize(sum);
}
BENCHMARK(checksums);

/// The bytes of both, as they come from the socket.
struct Received {
  std::vector<std::uint8_t> states = bytes_of(Messages().states);
  std::vector<std::uint8_t> forces = bytes_of(Messages().forces);
};

template <class Message>
Message read(std::vector<std::uint8_t>& bytes) {
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  Message message;
  ros::serialization::deserialize(stream, message);
  return message;
}

/// Reads bytes as messages of these types, and writes those into a bag.
template <class States, class Forces>
void write_bag(benchmark::State& state) {
  std::string folder = (std::filesystem::temp_directory_path() / "bench_messages.XXXXXX").string();
  folder = mkdtemp(folder.data());
  {
    Received received;
    rosbag::Bag bag(folder + "/states.bag", rosbag::bagmode::Write);
    std::uint32_t count = 0;
    for (auto _ : state) {
      const ros::Time time(1, ++count);
      bag.write("/particle_states", time, read<States>(received.states));
      bag.write("/contact_forces", time, read<Forces>(received.forces));
    }
  }
  std::filesystem::remove_all(folder);
}

void rosbag_writes_bytes(benchmark::State& state) {
  write_bag<topic_tools::ShapeShifter, topic_tools::ShapeShifter>(state);
}
void bytes_to_bag(benchmark::State& state) {
  write_bag<RawMessage<ParticleStates>, RawMessage<ContactForces>>(state);
}
void messages_to_bag(benchmark::State& state) { write_bag<ParticleStates, ContactForces>(state); }
constexpr int kBagged = 2000;  // states: a bag of 70 MB
BENCHMARK(rosbag_writes_bytes)->Iterations(kBagged);
BENCHMARK(bytes_to_bag)->Iterations(kBagged);
BENCHMARK(messages_to_bag)->Iterations(kBagged);

}  // namespace
}  // namespace impact

BENCHMARK_MAIN();
