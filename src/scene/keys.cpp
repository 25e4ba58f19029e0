#include "scene/keys.hpp"

#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <sstream>

namespace impact {
namespace {

/// Counts the documents of a YAML text as far as to the second. (YAML::LoadAll() never ends where
/// one begins with a comma.)
class DocumentCounter : public YAML::EventHandler {
 public:
  explicit DocumentCounter(const std::string& yaml) {
    std::istringstream text(yaml);
    YAML::Parser parser(text);
    while (count_ < 2 && parser.HandleNextDocument(*this)) ++count_;
  }
  int count() const { return count_; }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}

 private:
  int count_ = 0;
};

/// @throw InputError when the text has more than one, or a character at which yaml-cpp would stop
/// to read; YAML::Exception when it is no YAML.
YAML::Node only_document(const std::string& yaml, const std::string& name) {
  const auto forbidden = std::find_if(yaml.begin(), yaml.end(), [](char letter) {
    return std::iscntrl(static_cast<unsigned char>(letter)) != 0 &&
           std::string("\t\n\r").find(letter) == std::string::npos;
  });
  if (forbidden != yaml.end()) {
    throw InputError(fmt::format("{}: got the control character {}, which YAML does not allow",
                                 name, std::string(1, *forbidden)));
  }
  if (DocumentCounter(yaml).count() > 1) {
    throw InputError(name + ": allowed: one YAML document");
  }
  return YAML::Load(yaml);
}

}  // namespace

FlatTree parse_keys(const std::string& yaml, const std::string& name) {
  try {
    return flatten(only_document(yaml, name));
  } catch (const YAML::Exception& error) {
    throw InputError(fmt::format("{}:{}: {}", name, error.mark.line + 1, error.msg));
  }
}

FlatTree load_keys(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(path) || !file) {
    throw InputError(fmt::format("{}: cannot be read", path.string()));
  }
  return parse_keys({std::istreambuf_iterator<char>(file), {}}, path.string());
}

YAML::Node parse_value(const std::string& key, const std::string& text) {
  try {
    return only_document(text, shown(key));
  } catch (const YAML::Exception& error) {
    throw InputError(fmt::format("{}: {}", shown(key), error.msg));
  }
}

}  // namespace impact
