// Trees of points of light: of sources of fluence and, where some is followed to its second collision, of light
// that scatters once; these are the kinds. First come those of what comes from everywhere as the shape alone has
// them, then those of each light as it is.
#ifndef OPALINE_LIB_BEAM_TREES
#define OPALINE_LIB_BEAM_TREES

struct BeamTree {
  bool ofShape;
  bool scattersOnce;
  uint light;
};

BeamTree beamTree(uint index, uint kinds, uint lights) {
  bool ofShape = index < kinds;
  uint ofLights = ofShape ? index * lights : index - kinds;
  return BeamTree(ofShape, ofLights >= lights, ofLights % lights);
}

#endif
