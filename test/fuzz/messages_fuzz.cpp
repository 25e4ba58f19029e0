// A series of two impacts whose messages are changed, left out, doubled and put elsewhere as the
// bytes say: no number of a run may differ from the true one without a flag.

#include <cmath>
#include <map>
#include <variant>

#include "input.hpp"
#include "nodes/series_analysis.hpp"
#include "recording.hpp"

namespace impact {
namespace {

using Message = std::variant<lattice_impact::Lattice, lattice_impact::ParticleStates,
                             lattice_impact::ContactForces, lattice_impact::RunStatus>;
using Series = std::vector<Message>;

template <class... Messages>
Series series_of(const std::vector<Record>& records, std::variant<Messages...>*) {
  Series series;
  const auto take = [&](const Record& record, auto message) {
    if (is_a<decltype(message)>(record)) {
      series.emplace_back(message_of<decltype(message)>(record));
    }
  };
  for (const Record& record : records) {
    if (record.topic.rfind("/collision/", 0) == 0) (take(record, Messages()), ...);
  }
  return series;
}

/// The last result of each run.
std::map<std::uint32_t, lattice_impact::Restitution> results_of(const Series& series) {
  std::map<std::uint32_t, lattice_impact::Restitution> results;
  SeriesAnalysis analysis({[](const auto&) {},
                           [&](const lattice_impact::Restitution& r) { results[r.run] = r; },
                           [](const auto&) {}, [](std::uint32_t, std::uint32_t) {},
                           [](const std::string& problem) {
                             if (problem.find('\n') != std::string::npos) std::abort();
                           }});
  for (const Message& message : series) {
    std::visit([&](const auto& m) { analysis.add(m); }, message);
  }
  analysis.close();
  return results;
}

/// Leaves a message as it is whose bytes would not make one any more: ROS does not hand it over.
template <class M>
void change_byte(M& message, std::size_t place, std::uint8_t value) {
  Record record;
  put(message, record);
  record.bytes[place % record.bytes.size()] ^= value;
  try {
    message = message_of<M>(record);
  } catch (const std::exception&) {
  }
}

/// Four bytes a change.
void change(Series& series, const std::uint8_t* edit) {
  if (series.empty()) return;
  const std::size_t place = edit[1] % series.size();
  switch (edit[0] % 8) {
    case 0:
      series.erase(series.begin() + static_cast<std::ptrdiff_t>(place));
      break;
    case 1:
      series.insert(series.begin() + static_cast<std::ptrdiff_t>(place), series[place]);
      break;
    case 2:
      std::swap(series[place], series[edit[2] % series.size()]);
      break;
    default:
      std::visit([&](auto& m) { change_byte(m, edit[2] + 256U * (edit[0] / 8), edit[3]); },
                 series[place]);
  }
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Whether it says that it is not all there.
bool is_told(const lattice_impact::Restitution& result) {
  return result.complete == 0 || std::isnan(result.restitution);
}

}  // namespace
}  // namespace impact

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace impact;
  static const Series whole = series_of(recording(), static_cast<Message*>(nullptr));
  static const auto truth = results_of(whole);
  if (truth.size() != 2 || is_told(truth.begin()->second)) {
    std::fputs("recorded.bag is not of these messages: test/fuzz/record.py\n", stderr);
    std::abort();
  }
  Series series = whole;
  for (std::size_t at = 0; at + 4 <= size; at += 4) change(series, data + at);
  for (const auto& [run, result] : results_of(series)) {
    if (is_told(result)) continue;
    const auto found = truth.find(run);
    if (found == truth.end() || !same(found->second.restitution, result.restitution) ||
        !same(found->second.impulse, result.impulse) ||
        !same(found->second.contact_begin, result.contact_begin)) {
      std::abort();
    }
  }
  return 0;
}
