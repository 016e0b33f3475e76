#pragma once

#include <cstddef>
#include <string_view>

namespace opaline::gpu {

/// Generous estimates of the host's memory that drivers take, Mesa's software device most of all.
inline constexpr std::size_t roomToOpenDevice = std::size_t{400} << 20U;
inline constexpr std::size_t roomToCompile = std::size_t{128} << 20U;

/// Throws Error unless the host has that much memory, because drivers may crash without it.
/// `attempt` completes "Vulkan could not …".
void requireHostRoom(std::size_t bytes, std::string_view attempt);

}  // namespace opaline::gpu
