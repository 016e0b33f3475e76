// What a program of libFuzzer's needs beside its target: a check that fails ends it.

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  GTEST_FLAG_SET(break_on_failure, true);
  // By which GoogleTest breaks, and of which libFuzzer knows nothing: it would not keep the input.
  std::signal(SIGTRAP, [](int) { std::abort(); });
  return 0;
}
