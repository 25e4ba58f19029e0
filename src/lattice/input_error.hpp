#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace impact {

/// The text with its control characters as \xNN.
inline std::string without_control_characters(std::string_view text) {
  constexpr unsigned char kFirstPrintable = 0x20;
  constexpr unsigned char kDelete = 0x7f;
  constexpr const char* kDigits = "0123456789abcdef";
  std::string escaped;
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (code >= kFirstPrintable && code != kDelete) {
      escaped += letter;
    } else {
      escaped += {'\\', 'x', kDigits[code / 16], kDigits[code % 16]};
    }
  }
  return escaped;
}

/// A text from outside as part of a line: without control characters, a long one cut and followed
/// by its length.
inline std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 100;
  if (text.size() <= kLongest) return without_control_characters(text);
  constexpr unsigned char kKindBits = 0xc0;
  constexpr unsigned char kContinuation = 0x80;  // of a character of UTF-8
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & kKindBits) == kContinuation) --end;
  return without_control_characters(text.substr(0, end)) + "… (" + std::to_string(text.size()) +
         " bytes)";
}

/// Input that cannot be used. `what()` is one line: which key or file line, what it was, what is
/// allowed. Programs print it and exit with code 2, before anything has run.
class InputError : public std::runtime_error {
 public:
  /// Control characters of `line` are escaped.
  explicit InputError(const std::string& line)
      : std::runtime_error(without_control_characters(line)) {}
};

}  // namespace impact
