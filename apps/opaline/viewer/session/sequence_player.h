#pragma once

#include <memory>
#include <optional>

#include "film/positions_ahead.h"
#include "opaline/renderer.h"
#include "opaline/sequence.h"
#include "viewer/session/session.h"

namespace opaline::app::viewer {

/// Brings a body to where its numbered files have it at the session's time. The next file is read
/// on another thread meanwhile.
class SequencePlayer {
 public:
  explicit SequencePlayer(Renderer& renderer) : renderer_(renderer) {}

  /// Does nothing where the body is there already or has no files. Throws Error where a file cannot
  /// be read; the body then stays where it is.
  void place(Session& session);
  /// Somebody else has moved the body.
  void forget() { shown_.reset(); }

 private:
  Renderer& renderer_;
  std::shared_ptr<const MeshSequence> sequence_;
  std::optional<PositionsAhead> positions_;  // after what it reads from, so that it goes first
  std::optional<int> shown_;
};

}  // namespace opaline::app::viewer
