#pragma once
// Accessors: typed elements out of buffers, every offset checked in 64 bits, integers dequantised.

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "provis/vec3.hpp"
#include "src/scene/gltf_buffers.hpp"
#include "src/scene/gltf_model.hpp"

namespace provis {

/// Reads whole accessors of one document. The arithmetic of R1: an integer becomes its value, or
/// value / largest (signed ones not below -1) where the accessor is normalised; one division, float64.
class AccessorReader {
 public:
  /// file_size bounds the zeros that an accessor without a buffer view may ask for.
  AccessorReader(const tinygltf::Model& model, GltfBuffers& buffers, std::size_t file_size)
      : model_(model), buffers_(buffers), file_size_(file_size) {}

  /// Whether there is any data behind it: a buffer view or a sparse substitution.
  bool has_data(int accessor, const std::string& wanted_by) const;

  /// VEC3 of any component type. Kept, since primitives often share one; the reference stays valid.
  ///
  /// Throws:     Error::invalid_input naming accessor and element: type, range, or a coordinate that is
  ///             not finite; Error::unsupported for absurd numbers of zeros
  const std::vector<Vec3d>& positions(int accessor, const std::string& wanted_by);

  /// SCALAR of an unsigned type; none of them the largest value of its type, which glTF forbids.
  ///
  /// Throws:     Error::invalid_input naming accessor and element
  std::vector<std::uint32_t> indices(int accessor, const std::string& wanted_by);

 private:
  /// Equally spaced elements.
  struct Elements {
    const std::uint8_t* first = nullptr;  ///< nullptr stands for zeros
    std::size_t stride = 0;
    std::size_t count = 0;
  };

  std::vector<Vec3d> read_positions(const tinygltf::Accessor& accessor, const std::string& place);
  const tinygltf::Accessor& at(int accessor, const std::string& wanted_by) const;
  void check_zeros(const tinygltf::Accessor& accessor, const std::string& place) const;
  Elements base(const tinygltf::Accessor& accessor, const std::string& place);
  Elements elements(int view, std::uint64_t offset, std::uint64_t count, std::size_t size,
                    const std::string& place, bool tightly_packed);
  std::vector<std::uint32_t> sparse_targets(const tinygltf::Accessor& accessor, const std::string& place);
  Elements sparse_values(const tinygltf::Accessor& accessor, std::size_t size, const std::string& place);

  const tinygltf::Model& model_;
  GltfBuffers& buffers_;
  std::size_t file_size_;
  std::unordered_map<int, std::vector<Vec3d>> positions_;  ///< by accessor
};

}  // namespace provis
