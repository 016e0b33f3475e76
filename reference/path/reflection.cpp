#include "reference/path/reflection.h"

#include <algorithm>

#include "bssrdf/fresnel.h"
#include "reference/gloss.h"

namespace opaline::reference {

namespace {

using std::numbers::pi;
constexpr double leastCosine = 1e-4;

double sumOf(const Colour& colour) {
  return colour[0] + colour[1] + colour[2];
}

double schlick(double headOn, double grazing, double cosine) {
  return std::lerp(headOn, grazing, std::pow(std::clamp(1 - cosine, 0.0, 1.0), 5));
}

}  // namespace

EvenMirrored evenMirrored(const OpaqueSurface& surface, double cosine) {
  const MirroredShares shares = mirroredShares(surface.alpha, cosine);
  const auto sentOn = [&](double headOn) {
    return 1 + headOn * (1 / std::max(shares.base + shares.grazing, 1e-3) - 1);
  };
  const auto mirrored = [&](double headOn, double grazing) {
    return std::clamp(sentOn(headOn) * (headOn * shares.base + grazing * shares.grazing), 0.0, 1.0);
  };
  EvenMirrored even;
  for (std::size_t c = 0; c < 3; ++c) {
    even.sentOnByDielectric[c] = sentOn(surface.dielectric[c]);
    even.sentOnByMetal[c] = sentOn(surface.metal[c]);
    const double byDielectric = mirrored(surface.dielectric[c], surface.grazing);
    even.byDielectric = std::max(even.byDielectric, byDielectric);
    even.share[c] = std::lerp(byDielectric, mirrored(surface.metal[c], 1), surface.metallic);
  }
  return even;
}

double facetReflectance(const OpaqueSurface& surface, const EvenMirrored& even, std::size_t channel,
                        double cosine) {
  return std::lerp(even.sentOnByDielectric[channel] *
                       schlick(surface.dielectric[channel], surface.grazing, cosine),
                   even.sentOnByMetal[channel] * schlick(surface.metal[channel], 1, cosine),
                   surface.metallic);
}

MirroredCandidate mirroredCandidate(double alpha, const Vector& toLight, Random& random) {
  const double u = random();
  const Vector facet = visibleFacet(alpha, toLight, u, random());
  MirroredCandidate candidate;
  candidate.cosineHalf = dot(toLight, facet);
  candidate.direction = 2 * candidate.cosineHalf * facet - toLight;
  if (candidate.direction[2] <= leastCosine || candidate.cosineHalf <= 0) return candidate;
  const double hidden = ggxHidden(alpha, std::max(toLight[2], leastCosine));
  candidate.seen = (1 + hidden) / (1 + hidden + ggxHidden(alpha, candidate.direction[2]));
  return candidate;
}

Reflection::Reflection(const Vector& normal, const Vector& outside, const Vector& toEye)
    : normal_(normal), outside_(outside), across_(across(normal)) {
  eye_ = {dot(across_[0], toEye), dot(across_[1], toEye),
          std::max(dot(normal, toEye), leastCosine)};
}

Reflection::Reflection(const OpaqueSurface& surface, const Vector& normal, const Vector& outside,
                       const Vector& toEye)
    : Reflection(normal, outside, toEye) {
  alpha_ = surface.alpha;
  surface_ = surface;
  even_ = evenMirrored(surface, eye_[2]);
  const Colour given = (1 - even_.byDielectric) * surface.diffuse;
  diffuse_ = (1 / pi) * given;
  const Colour through = (1 - even_.byDielectric) * surface.through;
  through_ = (1 / pi) * through;
  const double all = sumOf(given) + sumOf(through) + sumOf(even_.share);
  matt_ = all > 0 ? sumOf(given) / all : 1;
  behind_ = all > 0 ? sumOf(through) / all : 0;
}

Reflection Reflection::ofMedium(double eta, double alpha, const Vector& normal,
                                const Vector& outside, const Vector& toEye) {
  Reflection made(normal, outside, toEye);
  made.eta_ = eta;
  made.alpha_ = alpha;
  return made;
}

Colour Reflection::fresnel(double cosine) const {
  if (eta_ > 0) {
    const double share = bssrdf::fresnelReflectance(eta_, std::clamp(cosine, 0.0, 1.0));
    return {share, share, share};
  }
  Colour share{};
  for (std::size_t c = 0; c < 3; ++c) share[c] = facetReflectance(surface_, even_, c, cosine);
  return share;
}

Colour Reflection::mirrored(const Vector& light) const {
  if (matt_ + behind_ >= 1) return {};
  const Vector half = unitOr(light + eye_, {0, 0, 1});
  const double facets =
      ggxDensity(alpha_, half[2]) /
      (4 * eye_[2] * (1 + ggxHidden(alpha_, eye_[2]) + ggxHidden(alpha_, light[2])));
  return facets * fresnel(dot(light, half));
}

Reflection::Parts Reflection::partsOf(const Vector& toLight) const {
  const Vector light{dot(across_[0], toLight), dot(across_[1], toLight), dot(normal_, toLight)};
  if (light[2] < 0 && dot(outside_, toLight) < 0) return {-light[2] * through_, {}};
  if (light[2] <= 0 || dot(outside_, toLight) <= 0) return {};
  return {light[2] * diffuse_, mirrored(light)};
}

Colour Reflection::ofDiffuse(const Colour& irradiance, const Colour& behind) const {
  Colour sum{};
  for (std::size_t c = 0; c < 3; ++c)
    sum[c] = irradiance[c] * diffuse_[c] + behind[c] * through_[c];
  return sum;
}

Vector Reflection::direction(Random& random) const {
  Vector local;
  const double kind = random();
  if (kind < matt_ + behind_) {
    const double cosine = std::sqrt(random());
    local = around({0, 0, kind < matt_ ? 1.0 : -1.0}, cosine, 2 * pi * random());
  } else {
    const double u = random();
    const Vector facet = visibleFacet(alpha_, unitOr(eye_, {0, 0, 1}), u, random());
    local = unitOr(2 * dot(eye_, facet) * facet - eye_, {0, 0, 1});
  }
  return unitOr(local[0] * across_[0] + local[1] * across_[1] + local[2] * normal_, normal_);
}

double Reflection::density(const Vector& toLight) const {
  const Vector light{dot(across_[0], toLight), dot(across_[1], toLight), dot(normal_, toLight)};
  if (light[2] <= 0) return behind_ * -light[2] / pi;
  double density = matt_ * light[2] / pi;
  if (matt_ + behind_ >= 1) return density;
  const Vector half = unitOr(light + eye_, {0, 0, 1});
  density += (1 - matt_ - behind_) * ggxDensity(alpha_, half[2]) /
             (4 * eye_[2] * (1 + ggxHidden(alpha_, eye_[2])));
  return density;
}

}  // namespace opaline::reference
