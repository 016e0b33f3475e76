#include "faults/fault_layer.h"

#include <dlfcn.h>

#include <cstdlib>
#include <stdexcept>

#include "opaline/renderer.h"

namespace opaline::test {

namespace {

template <typename Function>
void find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function == nullptr) throw std::runtime_error(std::string("the layer lacks ") + name);
}

}  // namespace

FaultLayer::FaultLayer() {
  setenv("VK_ADD_LAYER_PATH", OPALINE_FAULT_LAYER_FOLDER, 1);
  setenv("VK_INSTANCE_LAYERS", "VK_LAYER_OPALINE_faults", 1);
  void* library = dlopen(OPALINE_FAULT_LAYER, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw std::runtime_error(dlerror());
  find(library, "opalineArmFault", arm_);
  find(library, "opalineHideFunction", hide_);
  find(library, "opalineHideExtension", hideExtension_);
  find(library, "opalineClaimHardware", claimHardware_);
  find(library, "opalineClaimTexels", claimTexels_);
  find(library, "opalineFaultedFunction", faulted_);
  find(library, "opalineLivingObjects", living_);
  find(library, "opalineDescribeLivingObjects", describe_);
  listDevices();
  kept_ = living_();
}

std::string FaultLayer::faulted() const {
  const char* name = faulted_();
  return name == nullptr ? "" : name;
}

FaultLayer& faultLayer() {
  static FaultLayer layer;
  return layer;
}

}  // namespace opaline::test
