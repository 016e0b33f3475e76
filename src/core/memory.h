#pragma once

#include <cstddef>

namespace opaline::core {

/// Whether this process can allocate that many more bytes now, by its limits (setrlimit(2)) and the
/// system's overcommit policy. Keeps nothing.
bool hasRoomFor(std::size_t bytes);

}  // namespace opaline::core
