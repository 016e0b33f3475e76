#pragma once

/// Media in C; part of opaline/opaline_c.h.

#include "opaline/c/status.h"

OPALINE_C_BEGIN

/// What a body is made of; see opaline/medium.h.
typedef struct OpalineMedium {
  size_t size;                 ///< sizeof(OpalineMedium)
  double sigmaSPrimePerMm[3];  ///< reduced scattering, mm⁻¹, in (0, 1e6]
  double sigmaAPerMm[3];       ///< absorption, mm⁻¹, in [0, 1e6]
  double eta;                  ///< relative index of refraction, in [1.01, 3]
  double g;                    ///< mean cosine of scattering, in [-0.99, 0.99]
} OpalineMedium;

/// Finds a medium by its name, such as "marble", in any case.
OPALINE_API OpalineStatus opalineFindMedium(const char* name, OpalineMedium* medium);

/// How many media have names, and their names, which live for ever; NULL beyond the last.
OPALINE_API size_t opalineMediumCount(void);
OPALINE_API const char* opalineMediumName(size_t index);

/// What the colour of an appearance means; see ColorModel in opaline/medium.h.
typedef enum OpalineColorModel { OpalineColorObserved = 0, OpalineColorKhr = 1 } OpalineColorModel;

/// A medium described by its look; see Appearance in opaline/medium.h.
typedef struct OpalineAppearance {
  size_t size;               ///< sizeof(OpalineAppearance)
  double color[3];           ///< as colorModel says, in [0, 1]
  double meanFreePathMm[3];  ///< in [1e-6, 1e6]
  double g;                  ///< mean cosine of scattering, in [-0.99, 0.99]
  double eta;                ///< index of refraction, in [1.01, 1.6]
  OpalineColorModel colorModel;
  double ballMm;  ///< diameter of the ball that has the color, mm; 0: an infinitely thick body has
                  ///< it
} OpalineAppearance;

/// Fills a struct whose size has been set.
OPALINE_API OpalineStatus opalineDefaultAppearance(OpalineAppearance* appearance);

/// The medium with this appearance.
OPALINE_API OpalineStatus opalineMediumOfAppearance(const OpalineAppearance* appearance,
                                                    OpalineMedium* medium);

/// The inverse: the observed colour of a thick body of the medium.
OPALINE_API OpalineStatus opalineColorOfMedium(const OpalineMedium* medium, float color[3]);

OPALINE_C_END
