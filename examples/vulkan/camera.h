#pragma once

#include <opaline/opaline.h>

/// The engine's camera: looks from `eye` at `target`, y up, reversed depth without a far plane.
/// `focal`: over half the height of the picture.
struct Camera {
  opaline::CameraMatrices matrices;
  opaline::Matrix worldToClip;  ///< both, for shaders
};
Camera lookAt(const opaline::Vec3& eye, const opaline::Vec3& target, float focal, float aspect,
              float nearMm);
