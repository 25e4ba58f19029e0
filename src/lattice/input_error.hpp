#pragma once

#include <boost/locale/utf.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

namespace impact {

/// The text with what no terminal can show as \xNN: control characters, and bytes that are not of a
/// character of UTF-8.
inline std::string printable(std::string_view text) {
  namespace utf = boost::locale::utf;
  constexpr utf::code_point kFirst = 0x20;
  constexpr utf::code_point kDelete = 0x7f;  // and then more control characters
  constexpr utf::code_point kFirstAgain = 0xa0;
  constexpr const char* kDigits = "0123456789abcdef";
  std::string escaped;
  for (const char* at = text.data(); at != text.data() + text.size();) {
    const char* const begin = at;
    const utf::code_point letter = utf::utf_traits<char>::decode(at, text.data() + text.size());
    if (utf::is_valid_codepoint(letter) && letter >= kFirst &&
        (letter < kDelete || letter >= kFirstAgain)) {
      escaped.append(begin, at);
    } else {
      at = begin + 1;
      const auto code = static_cast<unsigned char>(*begin);
      escaped += {'\\', 'x', kDigits[code / 16], kDigits[code % 16]};
    }
  }
  return escaped;
}

/// A text from outside as part of a line: printable, a long one cut and followed by its length.
inline std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 100;
  if (text.size() <= kLongest) return printable(text);
  constexpr unsigned char kKindBits = 0xc0;
  constexpr unsigned char kContinuation = 0x80;  // of a character of UTF-8
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & kKindBits) == kContinuation) --end;
  return printable(text.substr(0, end)) + "… (" + std::to_string(text.size()) + " bytes)";
}

/// Input that cannot be used. `what()` is one line: which key or file line, what it was, what is
/// allowed. Programs print it and exit with code 2, before anything has run.
class InputError : public std::runtime_error {
 public:
  /// `line` is made printable().
  explicit InputError(const std::string& line) : std::runtime_error(printable(line)) {}
};

}  // namespace impact
