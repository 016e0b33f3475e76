#pragma once

#include <filesystem>
#include <functional>

#include "cli/scene_options.h"
#include "viewer/session/loader.h"
#include "viewer/session/session.h"

namespace opaline::app::viewer {

/// Brings what was asked for beside a scene, and what its file says of pictures, into the scene and
/// the session that begins with it. May throw.
using Prepare = std::function<void(LoadedScene&, Session&)>;

/// The session that begins with a loaded scene. Throws Error where the scene and what was asked for
/// do not go together, or its environment cannot be read.
Session opened(Loader::Result result, const Prepare& prepare);

/// The session that goes on with its own model loaded at another size: what was edited stays, and
/// whatever stands in the scene stands at the same place of the body.
Session resized(const Session& edited, Loader::Result result);

/// Whether a file is light for a scene instead of a scene.
bool isEnvironment(const std::filesystem::path& file);
/// Lights the session's scene with such a file. Throws Error where it cannot be read.
void takeEnvironment(const std::filesystem::path& file, Session& session);

}  // namespace opaline::app::viewer
