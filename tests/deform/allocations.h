#pragma once

#include <cstddef>

namespace opaline::test {

/// How often this program has asked for memory.
std::size_t allocations();

}  // namespace opaline::test
