#pragma once

/// How frames were made, in C; part of opaline/opaline_c.h.

#include "opaline/c/rendering.h"
#include "opaline/c/status.h"

OPALINE_C_BEGIN

/// A Vulkan device; see DeviceDescription in opaline/view.h. Names are truncated if they have no
/// room.
typedef struct OpalineDeviceFacts {
  size_t size;  ///< sizeof(OpalineDeviceFacts)
  char name[256];
  char type[16];  ///< discrete, integrated, virtual or software
  char driver[256];
  int32_t rayQueries;  ///< 1 or 0
} OpalineDeviceFacts;

/// Facts about one of the machine's opalineDeviceCount() devices.
OPALINE_API OpalineStatus opalineDeviceFacts(size_t device, OpalineDeviceFacts* facts);

/// What is known of the frame that opalineCollect() returned last; see Frame in opaline/view.h.
typedef struct OpalineFrameReport {
  size_t size;           ///< sizeof(OpalineFrameReport)
  double milliseconds;   ///< of the device
  int32_t provisional;   ///< 1: the surface was still divided for the old media
  size_t passCount;      ///< for opalineFramePass()
  size_t solutionCount;  ///< for opalineFrameSolution()
} OpalineFrameReport;

/// Time of one pass on the device.
typedef struct OpalinePassTime {
  size_t size;       ///< sizeof(OpalinePassTime)
  const char* name;  ///< lives until the next call with the view
  double milliseconds;
} OpalinePassTime;

/// How the boundary's equation was solved: first for direct light, then for each bounce.
typedef struct OpalineSolution {
  size_t size;  ///< sizeof(OpalineSolution)
  int32_t steps;
  float residual[3];  ///< relative to the sources of fluence
} OpalineSolution;

/// A pass or solution that does not exist is OpalineBadUse.
OPALINE_API OpalineStatus opalineFrameReport(const OpalineView* view, OpalineFrameReport* report);
OPALINE_API OpalineStatus opalineFramePass(const OpalineView* view, size_t pass,
                                           OpalinePassTime* time);
OPALINE_API OpalineStatus opalineFrameSolution(const OpalineView* view, size_t index,
                                               OpalineSolution* solution);

/// How a view's last opalineRender() and the frames of this scene collected since then were made;
/// see RenderReport in opaline/view.h.
typedef struct OpalineViewReport {
  size_t size;  ///< sizeof(OpalineViewReport)
  OpalineTransport transport;
  OpalineSum sum;
  OpalineSite site;
  uint64_t triangles;
  uint64_t vertices;
  uint64_t sources;
  uint64_t clusters;
  double frameMilliseconds;  ///< of the device, median over the frames after the first
  uint32_t dispatches;       ///< of the last frame, like barriers and recordings
  uint32_t barriers;
  uint32_t recordings;
  double peakMemoryMegabytes;
  size_t passCount;  ///< for opalineViewPass()
} OpalineViewReport;

/// OpalineBadUse before the first frame. The time of a pass is its median over the frames after the
/// first. opalineViewPass() and opalineViewDevice() read the last report, or a new one if another
/// frame has been made.
OPALINE_API OpalineStatus opalineViewReport(OpalineView* view, OpalineViewReport* report);
OPALINE_API OpalineStatus opalineViewPass(OpalineView* view, size_t pass, OpalinePassTime* time);
/// The device that the view's frames were made on.
OPALINE_API OpalineStatus opalineViewDevice(OpalineView* view, OpalineDeviceFacts* facts);

OPALINE_C_END
