#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lights/spot.h"
#include "reference/geometry.h"
#include "reference/path/far_ground.h"
#include "reference/path/sky_pixels.h"
#include "reference/path/walk.h"

namespace opaline::reference {

/// All light sources of a scene in one channel, emitting particles of equal flux. Directional
/// lights and the environment shine on a disc that covers the ball around the scene. Point lights
/// shine into the cone that holds the ball, spot and area lights into the part of it that they
/// light. Constant ambient light comes through the ball's whole surface. Where the scene has a
/// ground, the ball is some times larger, and light from the ground beyond comes through the
/// surface of the smaller ball. Emissive surfaces emit to both sides.
class Emitter {
 public:
  /// The geometry must outlive it.
  Emitter(const Geometry& geometry, int channel);

  /// The flux of all particles together.
  double flux() const { return flux_; }
  /// Emits one particle; many miss the scene. Requires flux above 0.
  Flight emit(Random& random) const;

 private:
  enum class Kind { Directional, Point, Area, Ambient, Environment, Surface, Ground };
  struct Source {
    Kind kind = Kind::Directional;
    Vector place{};        ///< direction to the light, or its position
    double cosine = -1;    ///< of the cone to the scene, or of the disc seen from it
    double fluxSoFar = 0;  ///< of this light and all before it
    bool lightsFarGround = false;
    Vector axis{};  ///< the direction of a spot light
    SpotFalloff falloff{};
    std::size_t area = 0;  ///< index of the area light or surface
  };

  /// The triangles of a body that emits light.
  struct Surface {
    std::uint32_t body = 0;
    std::vector<double> areasSoFarMm2;
  };

  void add(Source source, double flux);
  void addArea(std::size_t index, std::size_t channel);
  /// The cosine of the cone from a position that contains the scene.
  double cosineOfScene(const Vector& position, double reachMm = 0) const;
  void addSurface(std::uint32_t body);
  Flight throughDisc(const Vector& toLight, Random& random) const;
  static Vector fromCone(const Source& source, Random& random);
  Flight fromPoint(const Source& source, Random& random) const;
  Flight fromArea(const Source& source, Random& random) const;
  /// A flight that starts behind the scene and leaves it.
  Flight nowhere() const;
  Flight fromAround(double radiusMm, Random& random) const;
  Flight fromGround(Random& random) const;
  static bool isInfinitelyFar(const Source& source);
  Flight startedBy(const Source& source, Random& random) const;
  Flight fromSurface(const Surface& surface, Random& random) const;

  const Geometry& geometry_;
  std::size_t channel_;
  Vector centre_{};
  double radiusMm_ = 0;
  double radiusOfBodiesMm_ = 0;
  std::optional<FarGround> farGround_;
  double flux_ = 0;
  std::vector<Source> sources_;
  std::vector<AreaLight> areas_;
  std::vector<Surface> surfaces_;
  std::optional<SkyPixels> environment_;
};

}  // namespace opaline::reference
