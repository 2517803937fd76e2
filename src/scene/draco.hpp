#pragma once
// A mesh out of Draco's bitstream, by libdraco.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "src/scene/file_bytes.hpp"

namespace provis {

/// The memory that the Draco meshes of one document may take together. Their length says little: entropy
/// coding can repeat a triangle for next to nothing, so the counts at their beginning are weighed.
class DracoBudget {
 public:
  /// So much is fine for any document, and so much more for each compressed byte. Published files take up to
  /// 150 a byte; a plane grid of two million triangles in 50 000 bytes is let pass.
  static constexpr std::uint64_t always = std::uint64_t{512} << 20, per_byte = 512;

  void grow(std::uint64_t compressed_bytes) { left_ += per_byte * compressed_bytes; }

  /// Throws Error::unsupported where there is less left.
  void take(std::uint64_t bytes, const std::string& place);

 private:
  std::uint64_t left_ = always;
};

/// One value for every point.
struct DracoValues {
  std::size_t components = 0;   ///< of one value
  bool normalized = false;      ///< whether integers stand for fractions of their type's largest
  std::vector<double> numbers;  ///< components after one another; all types that are taken fit a double
};

class DracoMesh {
 public:
  /// Throws:     Error::invalid_input at place: broken data, no triangle mesh; Error::unsupported: a version
  ///             other than the extension's 2.2, too large for the budget
  DracoMesh(ByteSpan compressed, DracoBudget& budget, const std::string& place);
  DracoMesh(DracoMesh&&) noexcept;
  ~DracoMesh();

  std::size_t point_count() const;
  std::size_t triangle_count() const;

  /// Three points for each triangle; whether there are such points is not checked.
  std::vector<double> corners() const;

  /// Throws:     Error::invalid_input at place: no attribute has that id, its values have 64 bits or are none
  ///             of numbers, or do not reach all points
  DracoValues attribute(std::uint64_t unique_id, const std::string& place) const;

 private:
  class Geometry;
  std::unique_ptr<Geometry> geometry_;
};

}  // namespace provis
