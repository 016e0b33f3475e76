// Trees of points of light. Their kinds are sources of fluence and, where some light is followed to its second
// collision, light that scatters once. First come the trees of light from everywhere as the shape alone has
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
