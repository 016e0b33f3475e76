// Every file of the corpus, which holds what fuzzing has ever found, goes through its target.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/temporary_folder.h"

using Target = int (*)(const std::uint8_t*, std::size_t);

#define OPALINE_TARGET(name) extern "C" int fuzz_##name(const std::uint8_t*, std::size_t);
OPALINE_TARGETS
#undef OPALINE_TARGET

namespace opaline {
namespace {

struct Named {
  const char* name;
  Target target;
};

#define OPALINE_TARGET(name) Named{#name, fuzz_##name},
const std::vector<Named> targets{OPALINE_TARGETS};
#undef OPALINE_TARGET

class Corpus : public testing::TestWithParam<Named> {};

TEST_P(Corpus, PassesItsTarget) {
  const std::filesystem::path folder =
      std::filesystem::path(OPALINE_SOURCE_DIR) / "tests/fuzz/corpus" / GetParam().name;
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string bytes = test::readBytes(entry.path());
    SCOPED_TRACE(entry.path().filename().string());
    GetParam().target(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    ++files;
  }
  EXPECT_GT(files, 0U);
}

INSTANTIATE_TEST_SUITE_P(Targets, Corpus, testing::ValuesIn(targets),
                         [](const auto& named) { return std::string(named.param.name); });

}  // namespace
}  // namespace opaline
