#include "reading.h"

#include <gtest/gtest.h>

#include "core/temporary_folder.h"
#include "opaline/error.h"

namespace opaline::fuzz {

const std::filesystem::path& folder() {
  static const test::TemporaryFolder own;
  return own.path();
}

std::filesystem::path fileOf(std::string_view name, std::string_view bytes) {
  test::writeBytes(folder() / name, bytes);
  return folder() / name;
}

void expectReadOrRefused(const std::function<void()>& read) {
  try {
    read();
  } catch (const Error& error) {
    EXPECT_FALSE(std::string_view(error.what()).empty());
    EXPECT_LT(std::string_view(error.what()).size(), 4000U);
  }
}

}  // namespace opaline::fuzz
