#pragma once

#include <cstdint>

/// A Vulkan layer that makes one call fail, and counts what has been created and not destroyed. A
/// test in the same process calls the functions below; a program is armed by the environment:
///
///   VK_INSTANCE_LAYERS=VK_LAYER_OPALINE_faults  VK_ADD_LAYER_PATH=<folder of the layer>
///   OPALINE_FAULT=<VkResult as a number>:<n>[:<function>], counted from 1
///   OPALINE_FAULT_REPORT=<file>, which gets a line at the end of the process
///   OPALINE_CLAIM_HARDWARE=1, for opalineClaimHardware(true) from the start
///
/// After VK_ERROR_DEVICE_LOST, every later call fails so that may. All devices of a process must
/// have the same driver.
extern "C" {

/// Of the calls that may return `result`, the n-th from now on does; 0: none does. A name leaves
/// out all other functions.
void opalineArmFault(std::int32_t result, std::uint64_t nth, const char* function);
/// The calls since then that might have returned it.
std::uint64_t opalineCallsSinceArmed();
/// The driver has no such function of devices; null: it has all of them again.
void opalineHideFunction(const char* function);
/// Devices do not list that extension; null: they list all they have again.
void opalineHideExtension(const char* extension);
/// Software devices say that they are hardware.
void opalineClaimHardware(bool claims);
/// Devices say that a buffer has no more texels; 0: as many as it has.
void opalineClaimTexels(std::uint32_t most);
/// The function that failed; null if none has.
const char* opalineFaultedFunction();
/// Objects that have been created and not destroyed, memory and devices among them.
std::int64_t opalineLivingObjects();
/// Their names in Vulkan, with counts.
const char* opalineDescribeLivingObjects();
}
