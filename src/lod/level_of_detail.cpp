#include "provis/level_of_detail.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "predicates/environment.hpp"
#include "predicates/zero_area.hpp"
#include "provis/error.hpp"
#include "src/lod/open_edge.hpp"
#include "src/lod/ownership.hpp"
#include "src/lod/parts.hpp"
#include "src/lod/solid.hpp"
#include "src/scene/parallel.hpp"
#include "src/scene/stopwatch.hpp"

namespace provis {
namespace {

using lod::Chain;
using lod::Object;
using lod::Ownership;
using lod::refuse;

std::string text(const Vec3d& p) { return fmt::format("{},{},{}", p.x, p.y, p.z); }

/// The three scenes while they are checked.
class Verifier {
 public:
  Verifier(const DetailScene& full, const DetailScene& occluders, const DetailScene& shell,
           const std::vector<DetailObject>& objects, const Context& context)
      : full_(full), occluders_(occluders), shell_(shell), objects_(objects), context_(context) {}

  LevelOfDetail::Parts verified();

 private:
  void assign();
  void require_closed() const;
  void require_closed(const Chain& chain, const offset::Seams& seams, const std::string& object,
                      const std::string& file, const char* what) const;
  void require_inside() const;

  /// A triangle and the chain that has to hold it.
  struct Task {
    const Object* object;
    bool occluder;
    PrimitiveId id;
  };
  std::vector<Task> tasks() const;
  std::optional<Vec3d> escape(const Task& task) const;
  [[noreturn]] void refuse_escape(const Task& task, const Vec3d& where) const;

  const DetailScene &full_, &occluders_, &shell_;
  const std::vector<DetailObject>& objects_;
  const Context& context_;
  LevelOfDetail::Parts parts_;
};

bool opaque(const Scene& scene, PrimitiveId id) { return !(scene.triangle_flags()[id] & see_through); }

bool one_sided(const Chain& chain) {
  return std::any_of(chain.triangles().begin(), chain.triangles().end(),
                     [&](PrimitiveId id) { return chain.scene().triangle_flags()[id] & single_sided; });
}

std::vector<PrimitiveId> opaque_of(const Scene& scene, std::vector<PrimitiveId> ids) {
  std::erase_if(ids, [&](PrimitiveId id) { return !opaque(scene, id); });
  return ids;
}

void Verifier::assign() {
  Ownership full(full_, objects_), occluders(occluders_, objects_), shell(shell_, objects_);
  for (std::uint32_t k = 0; k < objects_.size(); ++k) {
    const DetailObject& o = objects_[k];
    std::vector<PrimitiveId> full_ids = full.take(k, o.full), occluder_ids = occluders.take(k, o.occluders),
                             shell_ids = shell.take(k, o.shell);
    if (full_ids.empty()) refuse(full_.file, o.name, "has no primitives in the full scene");
    if (shell_ids.empty()) refuse(shell_.file, o.name, "has no shell");
    parts_.objects.push_back({o.name, std::move(full_ids), std::move(occluder_ids),
                              Chain(*shell_.scene, std::move(shell_ids)), std::nullopt});
    Object& object = parts_.objects.back();
    if (!object.occluders.empty()) object.solid.emplace(*full_.scene, opaque_of(*full_.scene, object.full));
  }
  occluders.require_all();
  shell.require_all();
  parts_.object_of = std::move(full).owners();
}

void Verifier::require_closed(const Chain& chain, const offset::Seams& seams, const std::string& object,
                              const std::string& file, const char* what) const {
  if (const auto edge = open_edge(chain, seams))
    refuse(
        file, object,
        fmt::format("{} no closed oriented surface: from {} to {}, along id {}, triangles that run one way "
                    "are not as many as those that run the other way",
                    what, text(edge->from), text(edge->to), edge->triangle));
}

void Verifier::require_closed() const {
  const offset::Seams full(*full_.scene), shell(*shell_.scene);
  for (const Object& o : parts_.objects) {
    if (context_.cancelled()) throw Error(Error::Code::cancelled, "level of detail", "interrupted");
    require_closed(o.shell, shell, o.name, shell_.file, "its shell is");
    if (o.solid)
      require_closed(*o.solid, full, o.name, full_.file, "has occluders, but its opaque triangles are");
  }
}

std::vector<Verifier::Task> Verifier::tasks() const {
  std::vector<Task> all;
  for (const Object& o : parts_.objects)
    for (const PrimitiveId id : o.full) all.push_back({&o, false, id});
  for (const Object& o : parts_.objects)
    for (const PrimitiveId id : o.occluders) all.push_back({&o, true, id});
  return all;
}

/// A point of the triangle, rounded, that is where it must not be.
std::optional<Vec3d> Verifier::escape(const Task& task) const {
  const Scene& scene = task.occluder ? *occluders_.scene : *full_.scene;
  const Vec3d &a = scene.corner(task.id, 0), &b = scene.corner(task.id, 1), &c = scene.corner(task.id, 2);
  if (zero_area(a, b, c)) return std::nullopt;
  const RoundUp guard;
  const Chain& chain = task.occluder ? *task.object->solid : task.object->shell;
  const auto inside = task.occluder && one_sided(chain) ? lod::Inside::fronts : lod::Inside::any_side;
  const auto point = lod::outside(chain, inside, a, b, c);
  return point ? std::optional(lod::rounded(*point)) : std::nullopt;
}

void Verifier::refuse_escape(const Task& task, const Vec3d& where) const {
  if (!task.occluder)
    refuse(full_.file, task.object->name,
           fmt::format("id {} is outside of the shell of {} near {}", task.id, shell_.file, text(where)));
  refuse(occluders_.file, task.object->name,
         fmt::format("occluder {} is outside of what the opaque triangles of {} enclose, near {}{}", task.id,
                     full_.file, text(where),
                     one_sided(*task.object->solid)
                         ? "; some of them are single-sided, so their fronts must look outwards"
                         : ""));
}

void Verifier::require_inside() const {
  const std::vector<Task> all = tasks();
  std::vector<std::optional<Vec3d>> escapes(all.size());
  parallel_for(all.size(), [&](std::size_t k) {
    if (context_.cancelled()) throw Error(Error::Code::cancelled, "level of detail", "interrupted");
    escapes[k] = escape(all[k]);
  });
  for (std::size_t k = 0; k < all.size(); ++k)
    if (escapes[k]) refuse_escape(all[k], *escapes[k]);
}

LevelOfDetail::Parts Verifier::verified() {
  const Stopwatch stopwatch;
  parts_.full = full_.scene;
  parts_.occluders = occluders_.scene;
  parts_.shell = shell_.scene;
  assign();
  on_threads(context_, [&] {
    require_closed();
    require_inside();
  });
  parts_.seconds = stopwatch.seconds();
  return std::move(parts_);
}

}  // namespace

LevelOfDetail::LevelOfDetail(const DetailScene& full, const DetailScene& occluders, const DetailScene& shell,
                             const std::vector<DetailObject>& objects, const Context& context) {
  check_environment();
  parts_ = std::make_unique<const Parts>(Verifier(full, occluders, shell, objects, context).verified());
}

LevelOfDetail::~LevelOfDetail() = default;
LevelOfDetail::LevelOfDetail(LevelOfDetail&&) noexcept = default;
LevelOfDetail& LevelOfDetail::operator=(LevelOfDetail&&) noexcept = default;

}  // namespace provis
