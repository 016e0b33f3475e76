#pragma once

#include <cstddef>
#include <string_view>

namespace opaline::gpu {

/// What drivers take of the host's memory, Mesa's software device most of all, with room to spare.
inline constexpr std::size_t roomToOpenDevice = std::size_t{400} << 20U;
inline constexpr std::size_t roomToCompile = std::size_t{128} << 20U;

/// Asks for memory of the host before a driver does, which may crash where there is none. Throws
/// Error; `attempt` completes "Vulkan could not …".
void requireHostRoom(std::size_t bytes, std::string_view attempt);

}  // namespace opaline::gpu
