#include "gpu/host_room.h"

#include <fmt/format.h>

#include "core/memory.h"
#include "opaline/error.h"

namespace opaline::gpu {

void requireHostRoom(std::size_t bytes, std::string_view attempt) {
  if (core::hasRoomFor(bytes)) return;
  throw Error(
      fmt::format("Vulkan could not {}: the driver may need {} MB more than this process may take; "
                  "raise the limit of its memory, or use a smaller image or fewer surfels",
                  attempt, bytes >> 20U));
}

}  // namespace opaline::gpu
