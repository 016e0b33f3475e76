#pragma once

#include <cstddef>

namespace opaline::core {

/// Whether this process may take so many bytes more now, by its limits (setrlimit(2)) and by what
/// the system promises. Takes nothing.
bool hasRoomFor(std::size_t bytes);

}  // namespace opaline::core
