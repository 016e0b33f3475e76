#pragma once

#include <cstddef>

namespace opaline::test {

/// How often this thread has asked for memory.
std::size_t allocations();

}  // namespace opaline::test
