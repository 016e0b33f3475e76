#include "opaline/soft_body.h"

#include <fmt/format.h>

#include <cassert>
#include <exception>

#include "opaline/error.h"
#include "opaline/renderer.h"
#include "opaline/vulkan.h"
#include "renderer/context.h"
#include "renderer/motion/soft_body_motion.h"

namespace opaline {

class SoftBody::Implementation {
 public:
  Implementation(Renderer& renderer, std::size_t object, std::span<const Vec3> restMm,
                 std::span<const Triangle> triangles, const SoftBodyOptions& options)
      : context_(renderer.context()),
        scene_(context_.edited.number()),
        object_(object),
        motion_(context_.device, fitting(context_, object, restMm), triangles, options) {
    replacePositions();
  }

  ~Implementation() {
    if (context_.edited.number() != scene_) return;
    try {
      context_.edited.restorePositions(object_);
    } catch (const std::exception&) {
      assert(false && "the scene has the object");
    }
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  void step(double seconds) {
    if (context_.edited.number() != scene_)
      throw UsageError("the scene has been set anew since this soft body was made of its object");
    if (motion_.step(seconds)) replacePositions();
  }

  SoftBodyMotion& motion() { return motion_; }

 private:
  static std::span<const Vec3> fitting(const RendererContext& context, std::size_t object,
                                       std::span<const Vec3> restMm) {
    const std::size_t vertices = context.edited.object(object).mesh.positionsMm.size();
    if (restMm.size() != vertices)
      throw UsageError(fmt::format("object {} has {} vertices, but its soft body {} positions",
                                   object, vertices, restMm.size()));
    return restMm;
  }

  // The body's cage bends the space that it fills, so its parts stay together.
  void replacePositions() {
    context_.edited.replacePositions(
        object_, DevicePositions{.buffer = motion_.state().positions.handle(), .live = false},
        false);
  }

  RendererContext& context_;
  std::uint64_t scene_;
  std::size_t object_;
  SoftBodyMotion motion_;
};

SoftBody::SoftBody(Renderer& renderer, std::size_t object, std::span<const Vec3> restMm,
                   std::span<const Triangle> triangles, const SoftBodyOptions& options)
    : implementation_(
          std::make_unique<Implementation>(renderer, object, restMm, triangles, options)) {}
SoftBody::~SoftBody() = default;
SoftBody::SoftBody(SoftBody&&) noexcept = default;
SoftBody& SoftBody::operator=(SoftBody&&) noexcept = default;

void SoftBody::grab(const Vec3& pointMm, float radiusMm) {
  present(implementation_, "soft body").motion().grab(pointMm, radiusMm);
}

void SoftBody::pull(const Vec3& toMm) {
  present(implementation_, "soft body").motion().pull(toMm);
}

void SoftBody::release() {
  present(implementation_, "soft body").motion().release();
}

void SoftBody::step(double seconds) {
  present(implementation_, "soft body").step(seconds);
}

bool SoftBody::moves() const {
  return present(implementation_, "soft body").motion().moves();
}

}  // namespace opaline
