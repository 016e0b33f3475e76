#pragma once

#include "bssrdf/profile.h"
#include "opaline/renderer.h"

namespace opaline::reference {

inline bssrdf::Model modelOf(Transport transport) {
  return transport == Transport::Dipole ? bssrdf::Model::Dipole : bssrdf::Model::BetterDipole;
}

}  // namespace opaline::reference
