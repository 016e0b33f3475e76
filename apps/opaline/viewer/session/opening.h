#pragma once

#include <filesystem>
#include <functional>

#include "cli/scene_options.h"
#include "viewer/session/loader.h"
#include "viewer/session/session.h"

namespace opaline::app::viewer {

/// Adds to a scene and its new session what the command line asked for and what the file says of
/// pictures. May throw.
using Prepare = std::function<void(LoadedScene&, Session&)>;

/// The session for a newly loaded scene. Throws Error where the scene does not fit what was asked
/// for, or its environment cannot be read.
Session opened(Loader::Result result, const Prepare& prepare);

/// The same session with its model loaded at another size. Edits are kept, and everything in the
/// scene stays at the same place relative to the body.
Session resized(const Session& edited, Loader::Result result);

/// Whether a file is an environment instead of a scene.
bool isEnvironment(const std::filesystem::path& file);
/// Lights the session's scene by such a file. Throws Error where it cannot be read.
void takeEnvironment(const std::filesystem::path& file, Session& session);

}  // namespace opaline::app::viewer
