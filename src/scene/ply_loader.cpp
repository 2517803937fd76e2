#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "src/scene/failure.hpp"
#include "src/scene/finite.hpp"
#include "src/scene/ply_body.hpp"
#include "src/scene/scene_source.hpp"

namespace provis {
namespace {

constexpr std::size_t no_list = std::numeric_limits<std::size_t>::max();

class PlyLoader {
 public:
  explicit PlyLoader(ByteSpan file) : header_(read_ply_header(file)), body_(file, header_) {}

  SceneSource load() {
    for (const PlyElement& element : header_.elements) {
      body_.check_count(element);
      if (element.name == "vertex")
        read_vertices(element);
      else if (element.name == "face")
        read_faces(element);
      else if (element.name == "sphere")
        read_spheres(element);
      else
        skip(element);
    }
    body_.check_end();
    if (count_of("face") == 0) arrays_.skipped.points = arrays_.vertices.size();
    add_sources();
    return {std::move(arrays_), header_.hash};
  }

 private:
  /// Rows of the element named so, 0 if there is none.
  std::uint64_t count_of(const char* name) const {
    for (const PlyElement& element : header_.elements)
      if (element.name == name) return element.count;
    return 0;
  }

  static std::size_t required_scalar(const PlyElement& element, const char* name) {
    const auto found = element.scalar(name);
    if (!found)
      fail_invalid(fmt::format("line {}", element.line),
                   fmt::format("element {} has no property {}", element.name, name));
    return *found;
  }

  /// The position of our own flags; other programs use the name for numbers of other types.
  static std::optional<std::size_t> flags_property(const PlyElement& element) {
    const auto found = element.scalar("flags");
    return found && element.properties[*found].type == PlyType::uint8 ? found : std::nullopt;
  }

  std::uint8_t flags_of(const PlyRow& row, std::optional<std::size_t> property,
                        std::uint8_t otherwise) const {
    if (!property) return otherwise;
    const double flags = row.scalars[*property];
    if (flags > (single_sided | see_through))
      fail_invalid(body_.row_place(), fmt::format("unknown flag bits in {}", flags));
    return static_cast<std::uint8_t>(flags);
  }

  void read_vertices(const PlyElement& element) {
    const auto radius = element.scalar("radius");
    if (radius && count_of("face") > 0)
      fail_unsupported(fmt::format("line {}", element.line), "vertices that have a radius beside faces");
    if (radius) return read_spheres(element);
    const std::size_t x = required_scalar(element, "x"), y = required_scalar(element, "y"),
                      z = required_scalar(element, "z");
    arrays_.vertices.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      body_.read_row(element, no_list, row_);
      arrays_.vertices.push_back({row_.scalars[x], row_.scalars[y], row_.scalars[z]});
      check_finite("vertex", i, arrays_.vertices.back());
    }
  }

  void read_spheres(const PlyElement& element) {
    const std::size_t x = required_scalar(element, "x"), y = required_scalar(element, "y"),
                      z = required_scalar(element, "z");
    const std::size_t radius = required_scalar(element, "radius");
    const auto flags = flags_property(element);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      body_.read_row(element, no_list, row_);
      const double r = row_.scalars[radius];
      const Sphere sphere{{row_.scalars[x], row_.scalars[y], row_.scalars[z]}, r};
      check_finite(element.name, i, sphere.center);
      if (!(r >= 0) || std::isinf(r))
        fail_invalid(body_.row_place(), fmt::format("{} {} has radius {}", element.name, i, r));
      arrays_.spheres.push_back(sphere);
      arrays_.sphere_flags.push_back(flags_of(row_, flags, single_sided));
    }
  }

  void read_faces(const PlyElement& element) {
    auto corners = element.list("vertex_indices");
    if (!corners) corners = element.list("vertex_index");
    const std::string line = fmt::format("line {}", element.line);
    if (!corners) fail_invalid(line, "element face has no list vertex_indices");
    if (!is_integer(element.properties[*corners].type)) fail_invalid(line, "vertex_indices are no integers");
    const auto flags = flags_property(element);
    const std::uint64_t vertices = count_of("vertex");
    for (std::uint64_t i = 0; i < element.count; ++i) {
      body_.read_row(element, *corners, row_);
      for (const double index : row_.list)
        if (index < 0 || index >= static_cast<double>(vertices))
          fail_invalid(body_.row_place(), fmt::format("face {} uses vertex {} of {}", i, index, vertices));
      if (row_.list.empty()) fail_invalid(body_.row_place(), fmt::format("face {} has no corners", i));
      add_face(flags_of(row_, flags, 0));
    }
  }

  /// A polygon becomes a fan around its first corner; one or two corners are no surface.
  void add_face(std::uint8_t flags) {
    const auto corner = [this](std::size_t k) { return static_cast<std::uint32_t>(row_.list[k]); };
    arrays_.skipped.points += row_.list.size() == 1;
    arrays_.skipped.lines += row_.list.size() == 2;
    for (std::size_t k = 2; k < row_.list.size(); ++k) {
      arrays_.triangles.push_back({corner(0), corner(k - 1), corner(k)});
      arrays_.triangle_flags.push_back(flags);
    }
  }

  void skip(const PlyElement& element) {
    if (element.count == 0 || element.properties.empty()) return;
    if (element.name == "tristrips" || element.name == "trifans")
      fail_unsupported(fmt::format("line {}", element.line), fmt::format("element {}", element.name));
    if (element.name == "edge") arrays_.skipped.lines += element.count;
    for (std::uint64_t i = 0; i < element.count; ++i) body_.read_row(element, no_list, row_);
  }

  void check_finite(const std::string& what, std::uint64_t index, const Vec3d& p) const {
    if (!finite(p))
      fail_invalid(body_.row_place(),
                   fmt::format("{} {} is not finite: ({}, {}, {})", what, index, p.x, p.y, p.z));
  }

  /// One run of triangles and one of spheres: a PLY file has neither nodes nor meshes.
  void add_sources() {
    const std::size_t triangles = arrays_.triangles.size(), spheres = arrays_.spheres.size();
    if (triangles + spheres > std::numeric_limits<PrimitiveId>::max()) return;  // Scene says what is wrong
    const auto ids = [](std::size_t n) { return static_cast<PrimitiveId>(n); };
    if (triangles > 0) arrays_.sources.push_back({0, ids(triangles), -1, -1, -1});
    if (spheres > 0) arrays_.sources.push_back({ids(triangles), ids(spheres), -1, -1, -1});
  }

  PlyHeader header_;
  PlyBody body_;
  PlyRow row_;
  SceneArrays arrays_;
};

}  // namespace

SceneSource load_ply(ByteSpan file, const LoadOptions& options) {
  static_cast<void>(options);
  return PlyLoader(file).load();
}

}  // namespace provis
