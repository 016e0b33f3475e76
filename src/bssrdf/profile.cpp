#include "bssrdf/profile.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "bssrdf/fresnel.h"

namespace opaline::bssrdf {

namespace {

constexpr double pi = std::numbers::pi;

/// z (1 + σ d) e^{-σ d} / d³, the flux of a point source through the surface.
double fluxKernel(double z, double d, double sigma) {
  return z * (1.0 + sigma * d) * std::exp(-sigma * d) / (d * d * d);
}

/// The kernel's integral over a disc, divided by 2π: e^{-σ z} - z e^{-σ d}/d, without cancellation.
double fluxDisc(double z, double radius, double sigma) {
  if (std::isinf(radius)) return std::exp(-sigma * z);
  const double d = std::hypot(radius, z);
  const double longer = radius * (radius / (d + z));  // d - z
  return std::exp(-sigma * z) * (longer - z * std::expm1(-sigma * longer)) / d;
}

/// ∫ e^{-σ t} dt over [from, from + length].
double exponentialIntegral(double from, double length, double sigma) {
  const double x = sigma * length;
  const double mean = x == 0.0 ? 1.0 : -std::expm1(-x) / x;
  return std::exp(-sigma * from) * length * mean;
}

/// Distances from the real and the virtual source, and the excess of the second.
struct Distances {
  double real;
  double virtualSource;
  double difference;
};

Distances distances(const Profile& profile, double radius) {
  const double zr = profile.zRealMm;
  const double zv = profile.zVirtualMm;
  const double real = std::hypot(radius, zr);
  const double virtualSource = std::hypot(radius, zv);
  return {real, virtualSource, (zv - zr) * ((zv + zr) / (virtualSource + real))};
}

/// e^{-σ d_r}/d_r - e^{-σ d_v}/d_v as a sum of positive terms.
double fluenceKernel(const Profile& profile, double radius) {
  const Distances d = distances(profile, radius);
  const double sigma = profile.sigmaTrPerMm;
  return std::exp(-sigma * d.real) * (d.difference / d.real - std::expm1(-sigma * d.difference)) /
         d.virtualSource;
}

/// The kernel's integral over a disc, divided by 2π.
double fluenceDisc(const Profile& profile, double radius) {
  const double zr = profile.zRealMm;
  const double zv = profile.zVirtualMm;
  const double sigma = profile.sigmaTrPerMm;
  const double total = exponentialIntegral(zr, zv - zr, sigma);
  if (std::isinf(radius)) return total;
  const Distances d = distances(profile, radius);
  // Two forms of the same number: the second cancels for large discs, the first for small ones.
  if (radius > zr) return total - exponentialIntegral(d.real, d.difference, sigma);
  const double longerReal = radius * (radius / (d.real + zr));
  const double longerVirtual = radius * (radius / (d.virtualSource + zv));
  return exponentialIntegral(zr, longerReal, sigma) - exponentialIntegral(zv, longerVirtual, sigma);
}

}  // namespace

Coefficients coefficients(const Medium& medium, int channel) {
  const auto c = static_cast<std::size_t>(channel);
  assert(c < 3);
  Coefficients result;
  result.sigmaSPrimePerMm = medium.sigmaSPrimePerMm[c];
  result.sigmaAPerMm = medium.sigmaAPerMm[c];
  result.sigmaTPrimePerMm = result.sigmaSPrimePerMm + result.sigmaAPerMm;
  assert(result.sigmaTPrimePerMm > 0);
  result.albedo = result.sigmaSPrimePerMm / result.sigmaTPrimePerMm;
  result.meanFreePathMm = 1.0 / result.sigmaTPrimePerMm;
  result.eta = medium.eta;
  return result;
}

ScaledScattering scaledScattering(const Medium& medium, int channel) {
  const Coefficients reduced = coefficients(medium, channel);
  const double g = medium.g > 0 ? medium.g / (1 + medium.g) : medium.g;
  const double scattering = reduced.sigmaSPrimePerMm / (1 - g);
  const double extinction = scattering + reduced.sigmaAPerMm;
  return {extinction, scattering / extinction, g};
}

bool isSameInside(const Medium& a, const Medium& b) {
  Medium named = a;
  named.name = b.name;
  return named == b;
}

double shortestMeanFreePathMm(const Medium& medium) {
  double shortest = coefficients(medium, 0).meanFreePathMm;
  for (int channel = 1; channel < 3; ++channel)
    shortest = std::min(shortest, coefficients(medium, channel).meanFreePathMm);
  return shortest;
}

Model modelOf(Transport transport) {
  return transport == Transport::Dipole ? Model::Dipole : Model::BetterDipole;
}

Profile makeProfile(Model model, const Coefficients& coefficients) {
  const double sigmaA = coefficients.sigmaAPerMm;
  const double sigmaTPrime = coefficients.sigmaTPrimePerMm;
  Profile profile;
  profile.model = model;
  profile.albedo = coefficients.albedo;
  profile.zRealMm = coefficients.meanFreePathMm;
  if (model == Model::Dipole) {
    // Jensen et al. 2001, Section 2: A, σ_tr, z_v.
    const double fdr = diffuseReflectanceInside(coefficients.eta);
    const double a = (1.0 + fdr) / (1.0 - fdr);
    profile.sigmaTrPerMm = std::sqrt(3.0 * sigmaA * sigmaTPrime);
    profile.zVirtualMm = profile.zRealMm * (1.0 + 4.0 * a / 3.0);
    return profile;
  }
  // d'Eon 2012, "A better dipole": Grosjean's D, A, C_φ, C_E.
  const double c1 = twoC1(coefficients.eta);
  const double c2 = threeC2(coefficients.eta);
  const double a = (1.0 + c2) / (1.0 - c1);
  const double d =
      (2.0 * sigmaA + coefficients.sigmaSPrimePerMm) / (3.0 * sigmaTPrime * sigmaTPrime);
  profile.sigmaTrPerMm = std::sqrt(sigmaA / d);
  profile.zVirtualMm = profile.zRealMm + 4.0 * a * d;
  profile.diffusionMm = d;
  profile.cPhi = (1.0 - c1) / 4.0;
  profile.cE = (1.0 - c2) / 2.0;
  return profile;
}

std::array<Profile, 3> makeProfiles(Model model, const Medium& medium) {
  return {makeProfile(model, coefficients(medium, 0)), makeProfile(model, coefficients(medium, 1)),
          makeProfile(model, coefficients(medium, 2))};
}

double exitFactor(Model model, double eta) {
  const double passing = model == Model::Dipole ? 1.0 : meanTransmittance(eta);
  return std::numbers::inv_pi / passing;
}

double Profile::operator()(double radiusMm) const {
  assert(radiusMm >= 0);
  if (std::isinf(radiusMm)) return 0.0;
  const double flux = (fluxKernel(zRealMm, std::hypot(radiusMm, zRealMm), sigmaTrPerMm) +
                       fluxKernel(zVirtualMm, std::hypot(radiusMm, zVirtualMm), sigmaTrPerMm)) /
                      (4.0 * pi);
  if (model == Model::Dipole) return albedo * flux;
  const double fluence = fluenceKernel(*this, radiusMm) / (4.0 * pi * diffusionMm);
  return albedo * (cPhi * fluence + cE * flux);
}

double Profile::disc(double radiusMm) const {
  assert(radiusMm >= 0);
  const double flux = 0.5 * (fluxDisc(zRealMm, radiusMm, sigmaTrPerMm) +
                             fluxDisc(zVirtualMm, radiusMm, sigmaTrPerMm));
  if (model == Model::Dipole) return albedo * flux;
  const double fluence = fluenceDisc(*this, radiusMm) / (2.0 * diffusionMm);
  return albedo * (cPhi * fluence + cE * flux);
}

double Profile::totalReflectance() const {
  return disc(std::numeric_limits<double>::infinity());
}

}  // namespace opaline::bssrdf
