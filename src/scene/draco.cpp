#include "src/scene/draco.hpp"

#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/mesh/mesh.h>
#include <draco/metadata/metadata_decoder.h>
#include <fmt/format.h>

#include <limits>
#include <new>
#include <stdexcept>
#include <utility>

#include "src/scene/failure.hpp"
#include "src/scene/little_endian.hpp"

namespace provis {
namespace {

draco::DecoderBuffer buffer_over(ByteSpan bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return buffer;
}

/// Leaves the buffer behind the header and the metadata.
draco::DracoHeader read_header(draco::DecoderBuffer& buffer, const std::string& place) {
  draco::DracoHeader header{};
  if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok())
    fail_invalid(place, "the compressed data does not begin as Draco's does");
  if (header.encoder_type != draco::TRIANGULAR_MESH) fail_invalid(place, "the compressed data is no mesh");
  if (header.version_major != 2 || header.version_minor != 2)
    fail_unsupported(place, fmt::format("Draco bitstream {}.{}; the extension is defined for 2.2",
                                        header.version_major, header.version_minor));
  buffer.set_bitstream_version(DRACO_BITSTREAM_VERSION(2, 2));
  draco::GeometryMetadata metadata;
  if ((header.flags & METADATA_FLAG_MASK) != 0 &&
      !draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata))
    fail_invalid(place, "Draco's metadata is broken");
  return header;
}

/// What libdraco takes for the connectivity, from the counts that the data begins with. The sequential method
/// has three bytes for each triangle, which libdraco itself checks. Edgebreaker bounds the vertices by four
/// for each triangle; at most 160 bytes hold a triangle with its corners and so many vertices, 96 the same
/// once more for each attribute with corners of its own.
std::uint64_t connectivity_memory(ByteSpan compressed, const std::string& place) {
  draco::DecoderBuffer buffer = buffer_over(compressed);
  const draco::DracoHeader header = read_header(buffer, place);
  if (header.encoder_method != draco::MESH_EDGEBREAKER_ENCODING) return 0;
  std::uint8_t traversal = 0, attributes = 0;
  std::uint32_t vertices = 0, triangles = 0;
  if (!buffer.Decode(&traversal) || !draco::DecodeVarint(&vertices, &buffer) ||
      !draco::DecodeVarint(&triangles, &buffer) || !buffer.Decode(&attributes))
    fail_invalid(place, "Draco's counts are cut off");
  return triangles * (std::uint64_t{160} + 96 * std::uint64_t{attributes});
}

double number_at(const std::uint8_t* bytes, draco::DataType type) {
  switch (type) {
    case draco::DT_INT8:
      return from_little_endian<std::int8_t>(bytes);
    case draco::DT_UINT8:
      return from_little_endian<std::uint8_t>(bytes);
    case draco::DT_INT16:
      return from_little_endian<std::int16_t>(bytes);
    case draco::DT_UINT16:
      return from_little_endian<std::uint16_t>(bytes);
    case draco::DT_INT32:
      return from_little_endian<std::int32_t>(bytes);
    case draco::DT_UINT32:
      return from_little_endian<std::uint32_t>(bytes);
    case draco::DT_FLOAT32:
      return static_cast<double>(from_little_endian<float>(bytes));
    default:
      return from_little_endian<double>(bytes);
  }
}

bool is_number(draco::DataType type) {
  return (type >= draco::DT_INT8 && type <= draco::DT_UINT32) || type == draco::DT_FLOAT32 ||
         type == draco::DT_FLOAT64;
}

/// The value of that point, or nullptr where libdraco left it none.
const std::uint8_t* value_of(const draco::PointAttribute& attribute, std::uint32_t point) {
  if (!attribute.is_mapping_identity() && point >= attribute.indices_map_size()) return nullptr;
  const draco::AttributeValueIndex value = attribute.mapped_index(draco::PointIndex(point));
  if (value.value() >= attribute.size()) return nullptr;
  const auto end = attribute.byte_offset() + attribute.byte_stride() * (std::int64_t{value.value()} + 1);
  if (end > static_cast<std::int64_t>(attribute.buffer()->data_size())) return nullptr;
  return attribute.GetAddress(value);
}

}  // namespace

/// libdraco's mesh, which is asked before an attribute takes memory.
class DracoMesh::Geometry : public draco::Mesh {
 public:
  Geometry(DracoBudget& budget, std::string place) : budget_(budget), place_(std::move(place)) {}

  /// A value as decoded, once more as integers before that, and its place among the points.
  void SetAttribute(int id, std::unique_ptr<draco::PointAttribute> attribute) override {
    const auto size = static_cast<std::uint64_t>(draco::DataTypeLength(attribute->data_type()));
    budget_.take(num_points() * (attribute->num_components() * (size + 4) + 8), place_);
    draco::Mesh::SetAttribute(id, std::move(attribute));
  }

 private:
  DracoBudget& budget_;
  std::string place_;
};

void DracoBudget::take(std::uint64_t bytes, const std::string& place) {
  if (bytes > left_)
    fail_unsupported(
        place, fmt::format("decoding takes {} bytes of memory, {} more than the file's size allows", bytes,
                           bytes - left_));
  left_ -= bytes;
}

DracoMesh::DracoMesh(ByteSpan compressed, DracoBudget& budget, const std::string& place)
    : geometry_(std::make_unique<Geometry>(budget, place)) {
  budget.grow(compressed.size());
  budget.take(connectivity_memory(compressed, place), place);
  draco::DecoderBuffer buffer = buffer_over(compressed);
  try {
    const draco::Status status = draco::Decoder().DecodeBufferToGeometry(&buffer, geometry_.get());
    if (!status.ok()) fail_invalid(place, fmt::format("libdraco: {}", status.error_msg_string()));
  } catch (const std::bad_array_new_length&) {
    fail_invalid(place, "libdraco: a negative count");
  } catch (const std::length_error&) {
    fail_invalid(place, "libdraco: a negative count");
  }
}

DracoMesh::DracoMesh(DracoMesh&&) noexcept = default;
DracoMesh::~DracoMesh() = default;

std::size_t DracoMesh::point_count() const { return geometry_->num_points(); }
std::size_t DracoMesh::triangle_count() const { return geometry_->num_faces(); }

std::vector<double> DracoMesh::corners() const {
  std::vector<double> corners;
  corners.reserve(3 * triangle_count());
  for (draco::FaceIndex f(0); f < geometry_->num_faces(); ++f)
    for (const draco::PointIndex& corner : geometry_->face(f)) corners.push_back(corner.value());
  return corners;
}

DracoValues DracoMesh::attribute(std::uint64_t unique_id, const std::string& place) const {
  const draco::PointAttribute* attribute = nullptr;
  if (unique_id <= std::numeric_limits<std::uint32_t>::max())
    attribute = geometry_->GetAttributeByUniqueId(static_cast<std::uint32_t>(unique_id));
  if (attribute == nullptr)
    fail_invalid(place, fmt::format("the compressed data has no attribute of id {}", unique_id));
  if (!is_number(attribute->data_type()))
    fail_invalid(place, fmt::format("attribute {} is of Draco's data type {}, which no accessor has",
                                    unique_id, static_cast<int>(attribute->data_type())));
  DracoValues values{attribute->num_components(), attribute->normalized(), {}};
  values.numbers.reserve(values.components * point_count());
  const auto size = static_cast<std::size_t>(draco::DataTypeLength(attribute->data_type()));
  for (std::uint32_t point = 0; point < point_count(); ++point) {
    const std::uint8_t* bytes = value_of(*attribute, point);
    if (bytes == nullptr)
      fail_invalid(place, fmt::format("attribute {} has no value for point {}", unique_id, point));
    for (std::size_t c = 0; c < values.components; ++c)
      values.numbers.push_back(number_at(bytes + c * size, attribute->data_type()));
  }
  return values;
}

}  // namespace provis
