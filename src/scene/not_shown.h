#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "opaline/scene.h"

namespace opaline::scene {

/// Counts one more thing of a kind. Its name may be empty, and may have been counted before.
void addNotShown(std::vector<NotShown>& to, std::string_view what, std::string_view name);

/// Counts together with what another file holds.
void addNotShown(std::vector<NotShown>& to, const std::vector<NotShown>& more);

/// "base-colour textures (2: skin, hair), vertex colours (1: body)".
std::string textOf(const std::vector<NotShown>& kinds);

}  // namespace opaline::scene
