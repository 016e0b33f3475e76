#include "lights/fresnel_lobes.h"

#include <cmath>

#include "bssrdf/fresnel.h"

namespace opaline {

namespace {

double wideLobe(double stretch, double cosine) {
  const double across = (1 - cosine * cosine) / (stretch * stretch);
  const double squared = cosine * cosine + across;
  return cosine / (stretch * stretch * squared * squared);
}

struct Fit {
  FresnelLobes lobes;
  double error = 0;  // squared
};

// The best plain lobe for a stretch; the wide lobe then follows from the total in even light.
Fit fitWith(double stretch, double eta, double mean) {
  constexpr int steps = 64;
  double products = 0;
  double squares = 0;
  double rest = 0;
  for (int i = 0; i < steps; ++i) {
    const double cosine = (i + 0.5) / steps;
    const double wide = wideLobe(stretch, cosine);
    const double wanted = (1 - bssrdf::fresnelReflectance(eta, cosine)) * cosine - mean * wide;
    const double basis = cosine - wide;
    products += wanted * basis;
    squares += basis * basis;
    rest += wanted * wanted;
  }
  const double plain = products / squares;
  return {{plain, mean - plain, stretch}, rest - plain * products};
}

}  // namespace

double FresnelLobes::operator()(double cosine) const {
  return plain * cosine + wide * wideLobe(stretch, cosine);
}

FresnelLobes fresnelLobesOf(double eta) {
  const double mean = bssrdf::meanTransmittance(eta);
  // The error has one minimum: golden section.
  constexpr double golden = 0.6180339887498949;
  double low = 1.5;
  double high = 40;
  for (int i = 0; i < 40; ++i) {
    const double left = high - golden * (high - low);
    const double right = low + golden * (high - low);
    if (fitWith(left, eta, mean).error < fitWith(right, eta, mean).error)
      high = right;
    else
      low = left;
  }
  return fitWith(0.5 * (low + high), eta, mean).lobes;
}

}  // namespace opaline
