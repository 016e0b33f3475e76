#pragma once

namespace opaline::test::boundary {

/// A medium in one channel.
struct Channel {
  double sigmaSPerMm = 0;  ///< reduced scattering
  double sigmaAPerMm = 0;
  double eta = 1.3;
};

/// What the diffusion equation needs of it (Grosjean 1956, d'Eon 2012). The moments of Fresnel's
/// reflectance are integrated anew.
struct Diffusion {
  explicit Diffusion(const Channel& channel);

  double extinctionPerMm;
  double albedo;
  double diffusionMm;        ///< D
  double attenuationPerMm;   ///< σ
  double boundary;           ///< A
  double meanTransmittance;  ///< F̄_t
  double slantCosine;        ///< μ̄, of diffuse light that has entered
  double eta;
};

/// Exact unpolarised reflectance of a dielectric, from outside and from inside. Fresnel 1823.
double reflectanceOutside(double eta, double cosine);
double reflectanceInside(double eta, double cosine);

}  // namespace opaline::test::boundary
