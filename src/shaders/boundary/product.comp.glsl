// The operator of the boundary's equation on a fluence:
//   c_i φ_i + S_ii φ_i / 2A_i + Σ_j [S_ij / 2A_j + K_ij] φ_j,  S = e^{-σr} / 4πDr,
//   K_ij φ_j = -(1 + σr) e^{-σr} (x_j - x_i)·A_j φ_j / 4πr³, single clusters covering what a disc does.
// Also its inner products, weighted by area: with each vector of the basis so far, then with itself, one
// sum per tile. The first step, 0, takes the right side instead: the sources, less what c and K give of
// light that has entered at the surface. The last work group to have its sums ends the step.
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
#include "lib/cluster_action.glsl"
#include "lib/cluster_walk.glsl"
#include "lib/halves.glsl"
#include "lib/texels.glsl"
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
TEXELS(18, coefficients);

layout(push_constant) uniform Push {
  uint tileCount;
  uint clusterCount;
  float openingAngle;
  float tolerance;  // of the residual, relative to the sources and to what entered at the surface
  uint step;
  uint solution;
  uint atSurface;      // 1: light has entered at the surface
  uint nodeCount;
  uint densityGroups;  // of the dispatch before the next product
  uint roomOfList;
  uint roomOfCoefficients;
};

#include "lib/solver_step.glsl"

// Clusters that lie upon each other could have any share of the solid angle.
const float leastShare = 0.05;

shared vec3 tileProducts[maxClustersOfTile];
shared vec3 innerTerms[maxSolverSteps + 1u][maxClustersOfTile];  // terms of inner products

// A fluence as it is on a node.
struct NodeDensity {
  mat3 dipoles;  // a column for each channel
  vec3 density;  // Σ a φ
};

NodeDensity densityAt(uint node) {
  int first = 3 * int((max(step, 1u) - 1u) * nodeCount + node);
  vec4 red = texelOf(densities, first);
  vec4 green = texelOf(densities, first + 1);
  vec4 blue = texelOf(densities, first + 2);
  return NodeDensity(mat3(red.xyz, green.xyz, blue.xyz), vec3(red.w, green.w, blue.w));
}

vec3 sumOfActions[maxClustersOfTile];

// Adds a node by the coefficients kept for it.
void addKept(uint k, uint node) {
  NodeDensity there = densityAt(node);
  vec3 place = centroidLinkOf(node).xyz;
  int first = int((tileIndex * roomOfCoefficients + k) * texelsOfActions);
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; t += 4u) {
    vec4 texels[3];
    [[unroll]] for (int i = 0; i < 3; ++i) texels[i] = texelOf(coefficients, first + 3 * int(t / 4u) + i);
    [[unroll]] for (uint u = 0u; u < 4u; ++u) {
      vec2 red = unpacked(texels[3u * u / 4u][3u * u % 4u]);
      vec2 green = unpacked(texels[(3u * u + 1u) / 4u][(3u * u + 1u) % 4u]);
      vec2 blue = unpacked(texels[(3u * u + 2u) / 4u][(3u * u + 2u) % 4u]);
      Action action = Action(vec3(red.x, green.x, blue.x), vec3(red.y, green.y, blue.y));
      sumOfActions[t + u] += fluenceBy(action, place - targets[t + u].xyz, there.dipoles, there.density);
    }
  }
}

void add(uint at, vec3 weightS) {
  ActingNode node = actingNode(at);
  NodeDensity there = densityAt(at);
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t)
    sumOfActions[t] += fluenceBy(actionOn(t, node, weightS, openingAngle), node.place - targets[t].xyz, there.dipoles,
                                 there.density);
}

// Sums what acts on each cluster of the tile, for sumOfTile(). The coefficients of a list's first nodes are kept;
// step 0 has others.
void sumActions() {
  vec3 weightS = step > 0u ? singleLayerWeight(medium) : vec3(0.0);
  takeWayOfTile();
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) sumOfActions[t] = vec3(0.0);
  uint list = tileIndex * roomOfList;
  uint count = lists[list];
  if (count < roomOfList) {
    uint kept = step > 0u ? min(count, roomOfCoefficients) : 0u;
    uint k = gl_LocalInvocationIndex;
    for (; k < kept; k += invocationsOfTile) addKept(k, lists[list + 1u + k]);
    for (; k < count; k += invocationsOfTile) add(lists[list + 1u + k], weightS);
  } else {
    uint next = body.clusters.x;
    for (uint at = nextOnWalk(next, openingAngle); at != noNode; at = nextOnWalk(next, openingAngle))
      add(at, weightS);
  }
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) addToTile(t, sumOfActions[t]);
}

// The product: the sum of all that act on a cluster, and the cluster itself.
vec3 productOf(uint i, vec3 sum) {
  if (!boundsDiffusion(ranges[i].kind)) return vec3(0.0);  // there is no equation
  Cluster cluster = clusters[i];
  vec3 own = 0.5 * absorbedLength(medium.sigma.rgb, vec3(cluster.normal.w)) / medium.diffusion.rgb;
  vec3 fluence = basis[(step - 1u) * clusterCount + i].rgb;
  float share = clamp(cluster.vectorArea.w, leastShare, 1.0);
  return sum / (4.0 * pi) + fluence * (share + layerOf(i) * cluster.escape.rgb * own / (2.0 * medium.diffusion.w));
}

vec3 enteredFluence(uint i) {
  return fluenceEntered(i, entered[i].rgb, clusters[i].start.w, medium);
}

// α' times the sources, less (c + K) on what has entered. The latter is nothing where that is even and
// nothing is absorbed, since c comes from the same sums as K.
vec3 rightSideOf(uint i, vec3 sum) {
  if (!boundsDiffusion(ranges[i].kind)) return vec3(0.0);
  vec3 right = medium.scatters.rgb * sources[i].rgb;
  if (atSurface != 0u) right -= sum / (4.0 * pi) + enteredFluence(i) * clusters[i].vectorArea.w;
  return right;
}

// The size of light at the surface, over its fluence. The right side may be as good as nothing though much
// light has entered, and then does not tell which residual is small. With this, bounces of a bunny of
// marble are within 1 %, as they are where the same light is followed to its first collisions.
const float sizeOfEntered = 4.0;

// A term of the product with the k-th vector of the basis, and then with itself. The first step also
// has the size of what has entered at the surface.
vec3 innerTerm(uint k, uint t, uint cluster) {
  float area = clusters[cluster].centroidArea.w;
  if (k < step) return area * basis[k * clusterCount + cluster].rgb * tileProducts[t];
  if (k == step) return area * tileProducts[t] * tileProducts[t];
  vec3 entering = atSurface != 0u ? sizeOfEntered * enteredFluence(cluster) : vec3(0.0);
  return area * entering * entering;
}

// Inner products over the tile's clusters, by an invocation for each cluster and vector.
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

shared uint tilesBefore;

// Whether all other tiles have put their inner products, after this one's first subgroup has.
bool isLastOfTiles() {
  if (gl_SubgroupID == 0u) {
    subgroupMemoryBarrierBuffer();
    memoryBarrierBuffer();
    subgroupBarrier();
    if (subgroupElect()) tilesBefore = atomicAdd(states[solution].tilesDone, 1u);
    memoryBarrierBuffer();
  }
  barrier();
  memoryBarrierBuffer();
  return tilesBefore + 1u == tileCount;
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
  if (!isLastOfTiles()) return;
  putTotals();
  if (gl_LocalInvocationIndex == 0u) endStep();
}
