// The operator of the boundary's equation on a fluence:
//   c_i φ_i + S_ii φ_i / 2A + Σ_j [S_ij / 2A + K_ij] φ_j,  S = e^{-σr} / 4πDr,
//   K_ij φ_j = -(1 + σr) e^{-σr} (x_j - x_i)·A_j φ_j / 4πr³, single clusters covering what a disc does.
// With its inner products, weighted by area: with each vector of the basis so far, then with itself, one
// sum a tile. The first step, 0, takes the right side instead: the sources, less what c and K give of
// light that has entered at the surface. The work group that is the last to have its sums ends the step.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_TILES 2
#define BINDING_CLUSTER_NODES 4
#define BINDING_CLUSTER_PAINTS 15
#define BINDING_OPAQUE_SHARES 16
#define BINDING_NODE_OBJECTS 17
#define CONSTANT_SEVERAL_MEDIA 2
#include "lib/cluster_walk.glsl"
#include "lib/texels.glsl"
#include "lib/way_between.glsl"
#define LININGS
#include "lib/painted_cluster.glsl"
#include "lib/tile_sum.glsl"

layout(std430, set = 0, binding = 5) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 6) readonly buffer Ranges { ClusterRange ranges[]; };

ClusterRange rangeOf(uint cluster) {
  return ranges[cluster];
}

layout(std430, set = 0, binding = 7) readonly buffer Lists { uint lists[]; };
TEXELS(8, densities);  // DensityNode, of each vector of the basis
layout(std430, set = 0, binding = 9) readonly buffer Sources { vec4 sources[]; };
layout(std430, set = 0, binding = 10) readonly buffer Basis { vec4 basis[]; };
layout(std430, set = 0, binding = 11) writeonly buffer Products { vec4 products[]; };
layout(std430, set = 0, binding = 12) coherent buffer Sums { vec4 sums[]; };  // of each tile
layout(std430, set = 0, binding = 13) buffer States { SolverState states[]; };
layout(std430, set = 0, binding = 14) readonly buffer Entered { vec4 entered[]; };

layout(push_constant) uniform Push {
  uint tileCount;
  uint clusterCount;
  float openingAngle;
  float tolerance;  // of the residual, relative to the sources and to what entered at the surface
  uint step;
  uint solution;
  uint atSurface;      // 1: light has entered there
  uint nodeCount;
  uint densityGroups;  // of the dispatch before the next product
  uint roomOfList;
};

#include "lib/solver_step.glsl"

// Clusters that lie upon each other might give any share of the solid angle.
const float leastShare = 0.05;

shared vec3 tileProducts[maxClustersOfTile];
shared vec3 innerTerms[maxSolverSteps + 1u][maxClustersOfTile];  // of inner products

// A node, as every cluster of the tile needs it.
struct ActingNode {
  vec3 place;
  bool leaf;
  float radius;       // of all below it
  float area;
  vec3 second;        // from afar, how much more its single layer gives than from its middle
  uint cluster;       // of a leaf
  mat3 dipoles;       // a column for each channel
  vec3 density;       // Σ a φ / 2AD
  vec3 mean;          // φ where its areas cancel: of a sheet's two sides
  Moment moment;
};

vec3 weightS;  // 1 / 2AD

ActingNode actingNode(uint at) {
  vec4 centroidLink = centroidLinkOf(at);
  vec4 spread = spreadOf(at);
  uint link = floatBitsToUint(centroidLink.w);
  int first = 3 * int((max(step, 1u) - 1u) * nodeCount + at);
  vec4 red = texelOf(densities, first);
  vec4 green = texelOf(densities, first + 1);
  vec4 blue = texelOf(densities, first + 2);
  vec3 density = vec3(red.w, green.w, blue.w);
  vec3 mean = isLeaf(link) ? vec3(0.0) : density / max(spread.w, 1e-30);
  takeWayFrom(at);
  vec3 second = 1.0 + way.sigma * way.sigma * (spread.y / 6.0);
  return ActingNode(centroidLink.xyz, isLeaf(link), spread.x, spread.w, second, firstSurfelOf(link),
                    mat3(red.xyz, green.xyz, blue.xyz), weightS * way.overDiffusion * density, mean, momentOf(at));
}

// From a single layer as from its middle, and from a double one of that dipole.
vec3 actionOf(ActingNode node, vec4 target) {
  vec3 sigma = way.sigma;
  vec3 offset = node.place - target.xyz;
  float squared = dot(offset, offset);
  if (squared <= leastSquaredMm2) return vec3(0.0);
  float over = inversesqrt(squared);
  float over2 = over * over;
  vec3 x = sigma * (squared * over);
  vec3 e = exp(-x) * over2 * over;
  float smoothed = squared + smoothingOf(target.w, node.leaf ? node.area : 0.0);
  float overAway = inversesqrt(smoothed);
  vec3 single = exp(-sigma * (smoothed * overAway)) * overAway * node.density;
  vec3 along = (1.0 + x) * (offset * node.dipoles);
  if (node.leaf) {
    // An expansion about the middle, for places outside alone.
    if (isFar(squared, node.radius, leastSigma, openingAngle)) single *= node.second;
    return single - e * (coverageOfDisc(squared, node.area) * along);
  }
  // Both sides of a sheet, whose areas cancel, by the moment.
  vec3 sheet = (3.0 + x * (3.0 + x)) * (over2 * alongTwice(node.moment, offset)) -
               (1.0 + x) * traceOf(node.moment);
  return single * node.second + e * (node.mean * sheet - along);
}

// What acts on each cluster of the tile, for sumOfTile().
void sumActions() {
  weightS = step > 0u ? singleLayerWeight(medium) : vec3(0.0);
  takeWayOfTile();
  vec3 sums[maxClustersOfTile];
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) sums[t] = vec3(0.0);
  uint list = tileIndex * roomOfList;
  uint count = lists[list];
  bool listed = count < roomOfList;
  uint next = listed ? gl_LocalInvocationIndex : body.clusters.x;
  while (true) {
    uint at = noNode;
    if (!listed) {
      at = nextOnWalk(next, openingAngle);
    } else if (next < count) {
      at = lists[list + 1u + next];
      next += invocationsOfTile;
    }
    if (at == noNode) break;
    ActingNode node = actingNode(at);
    [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) {
      bool itself = node.leaf && node.cluster == tile.firstCluster + t;
      if (!itself) sums[t] += actionOf(node, targets[t]);
    }
  }
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) addToTile(t, sums[t]);
}

// Of all that act on a cluster, and of itself.
vec3 productOf(uint i, vec3 sum) {
  if (!boundsDiffusion(ranges[i].kind)) return vec3(0.0);  // there is no equation
  Cluster cluster = clusters[i];
  vec3 own = 0.5 * absorbedLength(medium.sigma.rgb, vec3(cluster.normal.w)) / medium.diffusion.rgb;
  vec3 fluence = basis[(step - 1u) * clusterCount + i].rgb;
  float share = clamp(cluster.vectorArea.w, leastShare, 1.0);
  return sum / (4.0 * pi) + fluence * (share + layerOf(i) * own / (2.0 * medium.diffusion.w));
}

vec3 enteredFluence(uint i) {
  return fluenceEntered(i, entered[i].rgb, clusters[i].start.w, medium);
}

// α' times the sources, less (c + K) on what has entered. That is nothing where this is even and nothing
// is absorbed, since c comes from the same sums as K.
vec3 rightSideOf(uint i, vec3 sum) {
  if (!boundsDiffusion(ranges[i].kind)) return vec3(0.0);
  vec3 right = medium.scatters.rgb * sources[i].rgb;
  if (atSurface != 0u) right -= sum / (4.0 * pi) + enteredFluence(i) * clusters[i].vectorArea.w;
  return right;
}

// Of light at the surface, over its fluence: the right side may be as good as nothing though much light has
// entered, so that it does not tell which residual is small. With this, bounces of a bunny of marble are
// within 1 %, as they are where the same light is followed to its first collisions.
const float sizeOfEntered = 4.0;

// With the k-th vector of the basis, and then with itself. The first step also has the size of what has
// entered at the surface.
vec3 innerTerm(uint k, uint t, uint cluster) {
  float area = clusters[cluster].centroidArea.w;
  if (k < step) return area * basis[k * clusterCount + cluster].rgb * tileProducts[t];
  if (k == step) return area * tileProducts[t] * tileProducts[t];
  vec3 entering = atSurface != 0u ? sizeOfEntered * enteredFluence(cluster) : vec3(0.0);
  return area * entering * entering;
}

// Of the tile's clusters, an invocation for each and each vector.
void putInnerProducts() {
  uint last = max(step, 1u);
  uint t = gl_LocalInvocationIndex % maxClustersOfTile;
  bool there = tile.firstCluster + t < tile.endCluster;
  const uint atOnce = invocationsOfTile / maxClustersOfTile;
  for (uint k = gl_LocalInvocationIndex / maxClustersOfTile; k <= last; k += atOnce)
    innerTerms[k][t] = there ? innerTerm(k, t, tile.firstCluster + t) : vec3(0.0);
  barrier();
  if (gl_SubgroupID != 0u) return;
  for (uint k = gl_SubgroupInvocationID; k <= last; k += gl_SubgroupSize) {
    vec3 sum = vec3(0.0);
    [[unroll]] for (uint i = 0u; i < maxClustersOfTile; ++i) sum += innerTerms[k][i];
    sums[tileIndex * (maxSolverSteps + 1u) + k] = vec4(sum, 0.0);
  }
}

// Of the subgroup that has put them: whether all other tiles have their inner products already.
bool isLastOfTiles() {
  subgroupMemoryBarrierBuffer();
  memoryBarrierBuffer();
  subgroupBarrier();
  uint before = 0u;
  if (subgroupElect()) before = atomicAdd(states[solution].tilesDone, 1u);
  bool isLast = subgroupMax(before) + 1u == tileCount;
  memoryBarrierBuffer();
  return isLast;
}

void main() {
  if (!enterTile(tileCount)) return;
  uint target = gl_LocalInvocationIndex;
  uint i = tile.firstCluster + target;
  vec3 sum = vec3(0.0);
  if (step > 0u || atSurface != 0u) {
    sumActions();
    sum = sumOfTile(target);
  }
  vec3 product = vec3(0.0);
  if (i < tile.endCluster) {
    product = step > 0u ? productOf(i, sum) : rightSideOf(i, sum);
    products[i] = vec4(product, 0.0);
  }
  if (target < maxClustersOfTile) tileProducts[target] = product;
  barrier();
  putInnerProducts();
  if (gl_SubgroupID == 0u && isLastOfTiles()) endStep();
}
