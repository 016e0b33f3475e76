// What a ray meets behind thin parts, with two numbers in each word.
#ifndef OPALINE_LIB_MEETING_BEHIND
#define OPALINE_LIB_MEETING_BEHIND
#include "shared/boundary.h"

// The share by channel; w: what is transmitted there.
MeetingBehind meetingBehind(uint cluster, vec4 shareTransmitted) {
  return MeetingBehind(cluster, packHalf2x16(shareTransmitted.rg), packHalf2x16(shareTransmitted.ba));
}

vec4 shareTransmittedOf(MeetingBehind meeting) {
  return vec4(unpackHalf2x16(meeting.redGreen), unpackHalf2x16(meeting.blueTransmitted));
}

#endif
