#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace impact {

inline std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Fails unless the part `name` of a page in doc/, from the line `<!-- NAME: … -->` to the next
/// `<!-- end -->`, is `part`. With LATTICE_IMPACT_WRITE_DOCUMENTS=1 it is written there instead.
inline void expect_document_has(const std::string& page, const std::string& name,
                                const std::string& part) {
  const std::string path = std::string(SOURCE_DIR "/doc/") + page;
  std::string text = content_of(path);
  const std::size_t comment = text.find("<!-- " + name + ": ");
  ASSERT_NE(comment, std::string::npos) << page << " has no part " << name;
  const std::size_t begin = text.find('\n', comment) + 1;
  const std::size_t end = text.find("<!-- end -->", begin);
  ASSERT_NE(end, std::string::npos) << page << ": the part " << name << " does not end";
  const std::string wanted = "\n" + part + "\n";
  if (std::getenv("LATTICE_IMPACT_WRITE_DOCUMENTS") != nullptr) {
    text.replace(begin, end - begin, wanted);
    std::ofstream(path, std::ios::binary) << text;
    return;
  }
  EXPECT_EQ(text.substr(begin, end - begin), wanted)
      << "doc/" << page << " is stale; to write it anew, run this test with "
      << "LATTICE_IMPACT_WRITE_DOCUMENTS=1";
}

}  // namespace impact
