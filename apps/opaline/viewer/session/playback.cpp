#include "viewer/session/playback.h"

#include <cmath>

#include "viewer/picture/orbit.h"

namespace opaline::app::viewer {

void playOn(double seconds, Session& session) {
  Playback& playback = session.playback;
  if (!movesInTime(session)) playback.playing = false;
  if (playback.playing) {
    const double begin = playback.beginSeconds;
    const double end = playback.endSeconds;
    double at = session.time.seconds + static_cast<double>(playback.speed) * seconds;
    if (at >= end && !playback.loop) {
      at = end;
      playback.playing = false;
    }
    session.time.seconds =
        at >= end && playback.loop ? begin + std::fmod(at - begin, end - begin) : at;
    session.edits.picture = true;
  }
  if (playback.turntable) {
    constexpr float radiansPerSecond = 0.5F;
    orbit(session.scene.camera, radiansPerSecond * static_cast<float>(seconds), 0);
    session.edits.camera = true;
  }
}

}  // namespace opaline::app::viewer
