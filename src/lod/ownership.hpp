#pragma once
// Which primitives of a scene belong to which object.

#include "provis/level_of_detail.hpp"

namespace provis::lod {

/// Throws Error::invalid_input about an object in a file.
[[noreturn]] void refuse(const std::string& file, const std::string& object, const std::string& what);

/// Which object each primitive of one scene belongs to.
class Ownership {
 public:
  /// Throws:     Error::unsupported for a scene with spheres
  Ownership(const DetailScene& scene, const std::vector<DetailObject>& objects);

  /// The ids of one object, ascending. Throws where one is out of range, or belongs to an object already.
  std::vector<PrimitiveId> take(std::uint32_t object, const std::vector<IdRange>& ranges);

  /// Throws where a primitive belongs to nobody.
  void require_all() const;

  std::vector<std::uint32_t> owners() && { return std::move(owner_); }

 private:
  const DetailScene& scene_;
  const std::vector<DetailObject>& objects_;
  std::vector<std::uint32_t> owner_;
};

}  // namespace provis::lod
