#pragma once

#include <opaline/opaline.h>

/// The engine's camera: looks from `eye` at `target`, y up, reversed depth without a far plane.
/// `focal` is the focal length over half the picture's height.
struct Camera {
  opaline::CameraMatrices matrices;
  opaline::Matrix worldToClip;  ///< product of both, for shaders
};
Camera lookAt(const opaline::Vec3& eye, const opaline::Vec3& target, float focal, float aspect,
              float nearMm);
