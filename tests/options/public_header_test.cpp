#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "opaline/options/picture.h"

namespace opaline::options {
namespace {

std::string memberOfKey(std::string_view key) {
  std::string member;
  for (std::size_t i = 0; i < key.size(); ++i) {
    if (key[i] == '_') {
      member += static_cast<char>(std::toupper(static_cast<unsigned char>(key[++i])));
    } else {
      member += key[i];
    }
  }
  return member;
}

double number(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), '\''), text.end());
  return std::strtod(text.c_str(), nullptr);
}

// The headers are the library's reference, so they repeat range and default beside each member.
TEST(PublicHeader, GivesTheRangesAndDefaultsOfTheTable) {
  std::string header;
  for (const char* name : {"render_options.h", "motion.h"}) {
    std::ifstream file(std::string(OPALINE_SOURCE_DIR "/include/opaline/") + name);
    header.append(std::istreambuf_iterator<char>(file), {});
  }
  int found = 0;
  for (const Field<PictureSettings>& field : fieldsOf<PictureSettings>()) {
    const std::regex line(
        fmt::format(R"(\b{} = ([^;]+);[^;]*?in \[([^,]+), ([^\]]+)\])", memberOfKey(field.key)));
    std::smatch match;
    if (!std::regex_search(header, match, line)) continue;
    ++found;
    EXPECT_EQ(number(match[2]), field.allowed.range.least) << field.key;
    EXPECT_EQ(number(match[3]), field.allowed.range.most) << field.key;
    const std::optional<Value> standard = field.get({});
    EXPECT_NEAR(number(match[1]), number(textOf(*standard)), 1e-9) << field.key;
  }
  EXPECT_EQ(found, 11);
}

}  // namespace
}  // namespace opaline::options
