#pragma once

#include <vector>

#include "lights/spot.h"
#include "reference/geometry.h"
#include "reference/path/walk.h"

namespace opaline::reference {

/// All lights of a scene in one channel, as a source of particles of equal flux. Directional lights
/// and the environment shine on a disc that hides the ball around the scene, point lights into the
/// cone that holds it, spot and area lights into that part of it which they shine on, constant
/// ambient light through its whole surface.
class Emitter {
 public:
  Emitter(const Scene& scene, int channel);

  /// Flux of all particles together.
  double flux() const { return flux_; }
  /// One particle; many miss the scene. There must be flux.
  Flight emit(Random& random) const;

 private:
  enum class Kind { Directional, Point, Area, Ambient, Environment };
  struct Source {
    Kind kind = Kind::Directional;
    Vector place{};        ///< direction to the light, or its position
    double cosine = -1;    ///< of the cone around the direction to the scene
    double fluxSoFar = 0;  ///< of this and all before
    Vector axis{};         ///< where a spot light shines to
    SpotFalloff falloff{};
    std::size_t area = 0;  ///< which area light
  };

  void add(Source source, double flux);
  void addArea(std::size_t index, std::size_t channel);
  /// The cone from there that holds the scene.
  double cosineOfScene(const Vector& position) const;
  void addEnvironment(const Image& image, int channel);
  Flight throughDisc(const Vector& toLight, Random& random) const;
  Flight fromPoint(const Source& source, Random& random) const;
  Flight fromArea(const Source& source, Random& random) const;
  /// Starts behind the scene and leaves it.
  Flight nowhere() const;
  Flight fromAround(Random& random) const;
  Vector environmentDirection(Random& random) const;

  Vector centre_{};
  double radiusMm_ = 0;
  double flux_ = 0;
  std::vector<Source> sources_;
  std::vector<AreaLight> areas_;
  std::vector<double> pixelsSoFar_;  ///< of the environment: integral of radiance up to each pixel
  int environmentWidth_ = 0;
  int environmentHeight_ = 0;
};

}  // namespace opaline::reference
