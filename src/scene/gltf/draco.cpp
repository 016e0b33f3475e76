#include "scene/gltf/draco.h"

#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>
#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "scene/text.h"

namespace opaline::scene {

namespace {

/// A stream may code a regular mesh in almost nothing, so sizes are limited per byte of it. A
/// million equal squares in a plane, the best case, come to 69 faces a byte.
constexpr std::size_t mostFacesOfOneByte = 256;
constexpr std::size_t mostBytesOfOneByte = 16384;

/// A primitive while it is decoded.
struct Stream {
  std::string name;  ///< how messages call it
  std::span<const unsigned char> bytes;
};

draco::DecoderBuffer bufferOf(const Stream& stream) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(stream.bytes.data()), stream.bytes.size());
  return buffer;
}

[[noreturn]] void failDamaged(const Input& input, const Stream& stream) {
  failGltf(input, fmt::format("{} is damaged", stream.name));
}

/// Sizes for which the decoder would allocate before it has read the mesh.
struct Extent {
  bool edgebreaker = false;
  std::uint32_t faces = 0;
  std::uint32_t points = 0;
  std::uint8_t seamed = 0;  ///< attributes with corner tables of their own
};

/// Reads the beginning of a stream (Draco bitstream specification 2.2, sections 3 and 4).
Extent extentOf(const Input& input, const Stream& stream) {
  draco::DecoderBuffer buffer = bufferOf(stream);
  draco::DracoHeader header{};
  if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok()) failDamaged(input, stream);
  if (header.version_major != 2 || header.version_minor != 2) {
    failGltf(input, fmt::format("{} is of bitstream version {}.{}, but glTF has 2.2", stream.name,
                                header.version_major, header.version_minor));
  }
  if (header.encoder_type != draco::TRIANGULAR_MESH ||
      header.encoder_method > draco::MESH_EDGEBREAKER_ENCODING) {
    failGltf(input, fmt::format("{} holds no triangles", stream.name));
  }
  buffer.set_bitstream_version(draco::kDracoMeshBitstreamVersion);
  bool whole = true;
  if ((header.flags & METADATA_FLAG_MASK) != 0) {
    draco::GeometryMetadata metadata;
    whole = draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata);
  }
  Extent extent;
  extent.edgebreaker = header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING;
  if (extent.edgebreaker) {
    std::uint8_t traversal = 0;
    whole = whole && buffer.Decode(&traversal) && draco::DecodeVarint(&extent.points, &buffer) &&
            draco::DecodeVarint(&extent.faces, &buffer) && buffer.Decode(&extent.seamed);
  } else {
    whole = whole && draco::DecodeVarint(&extent.faces, &buffer) &&
            draco::DecodeVarint(&extent.points, &buffer);
  }
  if (!whole) failDamaged(input, stream);
  return extent;
}

/// A decoder that checks the sizes of attributes before it decodes them.
template <typename Decoder>
class Bounded : public Decoder {
 public:
  explicit Bounded(std::size_t mostBytes) : mostBytes_(mostBytes) {}

 protected:
  bool DecodeAllAttributes() override {
    const draco::PointCloud& cloud = *this->point_cloud();
    std::size_t bytes = 0;
    for (int i = 0; i < cloud.num_attributes(); ++i) {
      bytes += static_cast<std::size_t>(cloud.attribute(i)->byte_stride());
    }
    return bytes <= mostBytes_ / std::max<std::size_t>(cloud.num_points(), 1) &&
           Decoder::DecodeAllAttributes();
  }

 private:
  std::size_t mostBytes_;
};

template <typename Decoder>
void decodeBy(const Input& input, const Stream& stream, draco::Mesh& mesh) {
  Bounded<Decoder> decoder(mostBytesOfOneByte * stream.bytes.size());
  draco::DecoderBuffer buffer = bufferOf(stream);
  bool whole = false;
  try {
    whole = decoder.Decode(draco::DecoderOptions(), &buffer, &mesh).ok();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    // The decoder asked for a size that no container can have.
  }
  if (!whole) failDamaged(input, stream);
}

void decodeMesh(GltfDecoded& decoded, const Stream& stream, draco::Mesh& mesh) {
  const Input& input = decoded.input();
  const Extent extent = extentOf(input, stream);
  const std::size_t most = mostFacesOfOneByte * stream.bytes.size();
  if (extent.faces > most || extent.points > most) {
    failGltf(input, fmt::format("{} promises {} triangles and {} vertices in {} bytes", stream.name,
                                extent.faces, extent.points, stream.bytes.size()));
  }
  decoded.reserve(std::size_t{extent.faces} * sizeof(draco::Mesh::Face) * (1U + extent.seamed),
                  stream.name);
  if (extent.edgebreaker) {
    decodeBy<draco::MeshEdgebreakerDecoder>(input, stream, mesh);
  } else {
    decodeBy<draco::MeshSequentialDecoder>(input, stream, mesh);
  }
}

int addAccessor(GltfDecoded& decoded, tinygltf::Accessor accessor, std::size_t count,
                std::vector<unsigned char>&& data) {
  tinygltf::Model& model = decoded.model();
  tinygltf::BufferView view;
  view.byteLength = data.size();
  view.buffer = decoded.addBuffer(std::move(data));
  model.bufferViews.push_back(view);
  accessor.bufferView = static_cast<int>(model.bufferViews.size()) - 1;
  accessor.byteOffset = 0;
  accessor.count = count;
  accessor.sparse = {};
  model.accessors.push_back(std::move(accessor));
  return static_cast<int>(model.accessors.size()) - 1;
}

int addIndices(GltfDecoded& decoded, const draco::Mesh& mesh) {
  std::vector<unsigned char> data(mesh.num_faces() * sizeof(draco::Mesh::Face));
  unsigned char* to = data.data();
  for (draco::FaceIndex f(0); f < mesh.num_faces(); ++f) {
    for (const draco::PointIndex& point : mesh.face(f)) {
      const std::uint32_t index = point.value();
      std::memcpy(to, &index, sizeof(index));
      to += sizeof(index);
    }
  }
  tinygltf::Accessor accessor;
  accessor.type = TINYGLTF_TYPE_SCALAR;
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  const std::size_t count = data.size() / sizeof(std::uint32_t);
  return addAccessor(decoded, std::move(accessor), count, std::move(data));
}

/// Every point's values, one after the other. False where a point has none in the stream.
template <typename T>
bool copyValues(const draco::PointAttribute& from, std::size_t points,
                std::vector<unsigned char>& data) {
  const auto components = static_cast<std::size_t>(from.num_components());
  std::vector<T> values(components);
  data.resize(points * components * sizeof(T));
  for (std::size_t p = 0; p < points; ++p) {
    const auto value = from.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(p)));
    if (value.value() >= from.size()) return false;
    if (!from.ConvertValue<T>(value, values.data())) return false;
    std::memcpy(&data[p * components * sizeof(T)], values.data(), components * sizeof(T));
  }
  return true;
}

/// The same, converted to an accessor's component type.
bool copyAs(int componentType, const draco::PointAttribute& from, std::size_t points,
            std::vector<unsigned char>& data) {
  if (!from.is_mapping_identity() && from.indices_map_size() < points) return false;
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return copyValues<std::int8_t>(from, points, data);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return copyValues<std::uint8_t>(from, points, data);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return copyValues<std::int16_t>(from, points, data);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return copyValues<std::uint16_t>(from, points, data);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return copyValues<std::uint32_t>(from, points, data);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return copyValues<float>(from, points, data);
    default:
      return false;
  }
}

int addAttribute(GltfDecoded& decoded, const Stream& stream, const draco::Mesh& mesh,
                 const std::string& name, int id, int accessorIndex) {
  const tinygltf::Model& model = decoded.model();
  const std::string shown = cleanText(name, 60);
  const draco::PointAttribute* const from =
      id < 0 ? nullptr : mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
  if (from == nullptr) {
    failGltf(decoded.input(), fmt::format("{} does not hold its {}", stream.name, shown));
  }
  if (accessorIndex < 0 || static_cast<std::size_t>(accessorIndex) >= model.accessors.size()) {
    failGltf(decoded.input(), fmt::format("accessor {} does not exist", accessorIndex));
  }
  const tinygltf::Accessor accessor = model.accessors[static_cast<std::size_t>(accessorIndex)];
  const int components = tinygltf::GetNumComponentsInType(static_cast<unsigned>(accessor.type));
  const std::size_t points = mesh.num_points();
  decoded.reserve(points * sizeof(float) * static_cast<std::size_t>(from->num_components()),
                  stream.name);
  std::vector<unsigned char> data;
  if (components != from->num_components() ||
      !copyAs(accessor.componentType, *from, points, data)) {
    failGltf(decoded.input(),
             fmt::format("the {} in {} do not fit accessor {}", shown, stream.name, accessorIndex));
  }
  return addAccessor(decoded, accessor, points, std::move(data));
}

Stream streamOf(const GltfDecoded& decoded, const tinygltf::Value& extension, std::size_t mesh,
                const tinygltf::Model& model) {
  Stream stream;
  stream.name = fmt::format("the Draco stream of mesh {}", mesh);
  const int view = extension.Has("bufferView") && extension.Get("bufferView").IsInt()
                       ? extension.Get("bufferView").GetNumberAsInt()
                       : -1;
  if (view < 0 || static_cast<std::size_t>(view) >= model.bufferViews.size()) {
    failGltf(decoded.input(), fmt::format("{} is in no buffer view", stream.name));
  }
  const tinygltf::BufferView& of = model.bufferViews[static_cast<std::size_t>(view)];
  stream.bytes = decoded.compressed(of.buffer, of.byteOffset, of.byteLength, stream.name);
  return stream;
}

void decodePrimitive(GltfDecoded& decoded, std::size_t meshIndex, tinygltf::Primitive& primitive) {
  const auto found = primitive.extensions.find(dracoExtension);
  if (found == primitive.extensions.end()) return;
  const tinygltf::Value& extension = found->second;
  const Stream stream = streamOf(decoded, extension, meshIndex, decoded.model());
  if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != TINYGLTF_MODE_TRIANGLE_STRIP) {
    failGltf(decoded.input(), fmt::format("{} is for triangles or strips of them only, but its "
                                          "primitive has mode {}",
                                          stream.name, primitive.mode));
  }
  draco::Mesh mesh;
  decodeMesh(decoded, stream, mesh);
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.indices = addIndices(decoded, mesh);
  if (!extension.Has("attributes")) return;
  const tinygltf::Value& attributes = extension.Get("attributes");
  for (auto& [name, accessor] : primitive.attributes) {
    if (!attributes.Has(name)) continue;
    const tinygltf::Value& id = attributes.Get(name);
    accessor =
        addAttribute(decoded, stream, mesh, name, id.IsInt() ? id.GetNumberAsInt() : -1, accessor);
  }
}

}  // namespace

void decodeDraco(GltfDecoded& decoded) {
  std::vector<tinygltf::Mesh>& meshes = decoded.model().meshes;
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    for (tinygltf::Primitive& primitive : meshes[m].primitives) {
      decodePrimitive(decoded, m, primitive);
    }
  }
}

}  // namespace opaline::scene
