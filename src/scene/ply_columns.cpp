#include "src/scene/ply_columns.hpp"

#include <fmt/format.h>

#include "src/scene/failure.hpp"

namespace provis {
namespace {

[[noreturn]] void fail_element(const PlyElement& element, const std::string& what) {
  fail_invalid(fmt::format("line {}", element.line), what);
}

std::size_t required_scalar(const PlyElement& element, const char* name) {
  const auto found = element.scalar(name);
  if (!found) fail_element(element, fmt::format("element {} has no property {}", element.name, name));
  return *found;
}

PlyFlags flags_of(const PlyElement& element) {
  const auto found = element.scalar("flags");
  return found && element.properties[*found].type == PlyType::uint8 ? found : std::nullopt;
}

std::optional<PlyPoint> velocity_of(const PlyElement& element) {
  const auto x = element.scalar("vx"), y = element.scalar("vy"), z = element.scalar("vz");
  if (!x || !y || !z) return std::nullopt;
  return PlyPoint{*x, *y, *z};
}

}  // namespace

PlyPoint ply_position(const PlyElement& element) {
  return {required_scalar(element, "x"), required_scalar(element, "y"), required_scalar(element, "z")};
}

PlySphereColumns ply_sphere_columns(const PlyElement& element) {
  return {ply_position(element), element.scalar("radius"), velocity_of(element), flags_of(element)};
}

PlyFaceColumns ply_face_columns(const PlyElement& element) {
  auto corners = element.list("vertex_indices");
  if (!corners) corners = element.list("vertex_index");
  if (!corners) fail_element(element, "element face has no list vertex_indices");
  if (!is_integer(element.properties[*corners].type)) fail_element(element, "vertex_indices are no integers");
  return {*corners, flags_of(element)};
}

}  // namespace provis
