#include "viewer/session/sequence_player.h"

#include "film/sequence_frames.h"

namespace opaline::app::viewer {

void SequencePlayer::place(Session& session) {
  if (sequence_ != session.sequence) {
    positions_.reset();
    shown_.reset();
    sequence_ = session.sequence;
    if (sequence_) positions_.emplace(positionsOf(sequence_, sequence_->lastNumber()));
  }
  if (!sequence_) return;
  const int number = nearestNumber(*sequence_, session.time.seconds);
  if (shown_ == number) return;
  shown_ = number;  // set even if the file cannot be read, so that the error is shown once
  const std::vector<Vec3>& positionsMm = positions_->of(number);
  renderer_.replacePositions(0, positionsMm);
  session.positionsMm[0] = positionsMm;
}

}  // namespace opaline::app::viewer
