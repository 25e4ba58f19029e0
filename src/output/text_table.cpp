#include "output/text_table.hpp"

#include <algorithm>

namespace impact {

std::size_t display_width(const std::string& text) {
  constexpr unsigned char kKindBits = 0xc0;
  constexpr unsigned char kContinuation = 0x80;
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char letter) {
    return (static_cast<unsigned char>(letter) & kKindBits) != kContinuation;
  }));
}

std::string aligned(const TextTable& table) {
  std::vector<std::size_t> widths(table[0].size(), 0);
  for (const auto& line : table) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      widths[i] = std::max(widths[i], display_width(line[i]));
    }
  }
  std::string text;
  for (const auto& line : table) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      text += (i == 0 ? "" : "  ") + std::string(widths[i] - display_width(line[i]), ' ') + line[i];
    }
    text += '\n';
  }
  return text;
}

}  // namespace impact
