#include "src/lod/ownership.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "provis/error.hpp"
#include "src/lod/parts.hpp"

namespace provis::lod {

void refuse(const std::string& file, const std::string& object, const std::string& what) {
  throw Error(Error::Code::invalid_input, fmt::format("{}: object \"{}\"", file, object), what);
}

Ownership::Ownership(const DetailScene& scene, const std::vector<DetailObject>& objects)
    : scene_(scene), objects_(objects), owner_(scene.scene->primitive_count(), no_object) {
  if (!scene.scene->spheres().empty())
    throw Error(Error::Code::unsupported, scene.file,
                fmt::format("spheres have no level of detail: {} of them", scene.scene->spheres().size()));
}

std::vector<PrimitiveId> Ownership::take(std::uint32_t object, const std::vector<IdRange>& ranges) {
  const std::string& name = objects_[object].name;
  std::vector<PrimitiveId> ids;
  for (const auto& [first, last] : ranges) {
    if (first > last || last >= owner_.size())
      refuse(scene_.file, name,
             fmt::format("ids {}-{} in a scene of {} primitives", first, last, owner_.size()));
    for (PrimitiveId id = first; id <= last; ++id) {
      if (owner_[id] == object) refuse(scene_.file, name, fmt::format("id {} is listed twice", id));
      if (owner_[id] != no_object)
        refuse(scene_.file, name,
               fmt::format("id {} belongs to object \"{}\" too", id, objects_[owner_[id]].name));
      owner_[id] = object;
      ids.push_back(id);
    }
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

void Ownership::require_all() const {
  const auto found = std::find(owner_.begin(), owner_.end(), no_object);
  if (found != owner_.end())
    throw Error(Error::Code::invalid_input, scene_.file,
                fmt::format("id {} belongs to no object", found - owner_.begin()));
}

}  // namespace provis::lod
