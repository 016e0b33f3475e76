#pragma once

#include <memory>
#include <optional>

#include "film/positions_ahead.h"
#include "opaline/renderer.h"
#include "opaline/sequence.h"
#include "viewer/session/session.h"

namespace opaline::app::viewer {

/// Moves a body to where its numbered files have it at the session's time. Another thread reads the
/// next file meanwhile.
class SequencePlayer {
 public:
  explicit SequencePlayer(Renderer& renderer) : renderer_(renderer) {}

  /// Does nothing where the body is in place already or has no files. Throws Error where a file
  /// cannot be read; the body then stays where it was.
  void place(Session& session);
  /// To be called when somebody else has moved the body.
  void forget() { shown_.reset(); }

 private:
  Renderer& renderer_;
  std::shared_ptr<const MeshSequence> sequence_;
  std::optional<PositionsAhead> positions_;  // destroyed before what it reads from
  std::optional<int> shown_;
};

}  // namespace opaline::app::viewer
