#pragma once
// Accessors: typed elements out of buffers, every offset checked in 64 bits, integers dequantised.

#include <cstdint>
#include <deque>
#include <string>
#include <unordered_map>
#include <vector>

#include "provis/vec3.hpp"
#include "src/scene/gltf_model.hpp"
#include "src/scene/gltf_views.hpp"

namespace provis {

/// Component types that an accessor may have, as bits.
enum ComponentSet : unsigned {
  float_components = 1,
  normalized_signed = 2,    ///< byte and short
  normalized_unsigned = 4,  ///< unsigned byte and unsigned short
  plain_signed = 8,
  plain_unsigned = 16,
  long_integers = 32,  ///< 32 bits, which glTF allows to indices only
  any_component = 63,
};

/// What the elements of an accessor must be.
struct ElementKind {
  const char* what;     ///< for messages: "key times"
  int type;             ///< TINYGLTF_TYPE_VEC3 and so on
  unsigned components;  ///< a union of ComponentSet
};

/// Reads whole accessors of one document. The arithmetic of R1: an integer becomes its value, or
/// value / largest (signed ones not below -1) where the accessor is normalised; one division, float64.
class AccessorReader {
 public:
  /// file_size bounds the zeros that an accessor without a buffer view may ask for.
  AccessorReader(const tinygltf::Model& model, GltfViews& views, std::size_t file_size)
      : model_(model), views_(views), file_size_(file_size) {}

  /// Another accessor, which is that one but for its elements: they are so many, tightly packed in that view.
  /// Sparse elements of the file still replace them. The result names it from then on.
  int supply(int accessor, int view, std::size_t count, const std::string& wanted_by);

  /// For messages: "accessors[3]", the one in the file also for a supplied one.
  std::string place_of(int accessor) const;

  /// The accessor itself.
  ///
  /// Throws:     Error::invalid_input at wanted_by: it does not exist
  const tinygltf::Accessor& at(int accessor, const std::string& wanted_by) const;

  /// VEC3 of any component type. Kept, since primitives often share one; the reference stays valid.
  ///
  /// Throws:     Error::invalid_input naming accessor and element: type, range, or a coordinate that is
  ///             not finite; Error::unsupported for absurd numbers of zeros
  const std::vector<Vec3d>& positions(int accessor, const std::string& wanted_by);

  /// The same without keeping it.
  std::vector<Vec3d> vectors(int accessor, const std::string& wanted_by);

  /// The components of all elements, one element after the other.
  ///
  /// Throws:     Error::invalid_input naming accessor and element: of another kind, out of range, not finite
  std::vector<double> numbers(int accessor, const ElementKind& kind, const std::string& wanted_by);

  /// SCALAR of an unsigned type; none of them the largest value of its type, which glTF forbids.
  ///
  /// Throws:     Error::invalid_input naming accessor and element
  std::vector<std::uint32_t> indices(int accessor, const std::string& wanted_by);

  /// The number of elements, compared with the bytes behind them.
  std::size_t count(int accessor, const std::string& wanted_by);

 private:
  struct Supplied {
    tinygltf::Accessor accessor;
    int declared = -1;  ///< the one in the file
  };

  /// Equally spaced elements.
  struct Elements {
    const std::uint8_t* first = nullptr;  ///< nullptr stands for zeros
    std::size_t stride = 0;
    std::size_t count = 0;
  };

  template <class Value, class Decode>
  std::vector<Value> read(const tinygltf::Accessor& accessor, const std::string& place,
                          std::size_t values_per_element, const Decode& decode);
  const Supplied* supplied_at(int accessor) const;
  void check_zeros(const tinygltf::Accessor& accessor, const std::string& place) const;
  Elements base(const tinygltf::Accessor& accessor, const std::string& place);
  Elements elements(int view, std::uint64_t offset, std::uint64_t count, std::size_t size,
                    const std::string& place, bool tightly_packed);
  std::vector<std::uint32_t> sparse_targets(const tinygltf::Accessor& accessor, const std::string& place);
  Elements sparse_values(const tinygltf::Accessor& accessor, std::size_t size, const std::string& place);

  const tinygltf::Model& model_;
  GltfViews& views_;
  std::size_t file_size_;
  std::deque<Supplied> supplied_;  ///< from first_index_of_ours on; they stay in place
  std::unordered_map<int, std::vector<Vec3d>> positions_;  ///< by accessor
};

}  // namespace provis
