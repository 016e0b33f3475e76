#pragma once

namespace opaline {

/// GGX's reflection as a linearly transformed cosine lobe (Heitz, Dupuy, Hill and Neubelt 2016):
/// its integral over a polygon has a closed form. The lobe's z axis lies in the plane of the view,
/// turned from the mirrored direction by `tilt` radians away from the normal; its x axis lies there
/// too, perpendicular to z. Directions of a cosine lobe are mapped by rows (along, 0, skew), (0,
/// across, 0), (0, 0, 1).
struct ReflectionLobe {
  double tilt = 0;
  double along = 1;
  double across = 1;
  double skew = 0;
};

/// The lobe that best fits GGX's for roughness² = alpha, seen at that cosine to the normal. It has
/// the same power, without Fresnel's reflectance.
ReflectionLobe reflectionLobeOf(double alpha, double cosine);

}  // namespace opaline
