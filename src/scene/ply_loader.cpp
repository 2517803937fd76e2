#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "src/scene/failure.hpp"
#include "src/scene/finite.hpp"
#include "src/scene/ply_body.hpp"
#include "src/scene/ply_columns.hpp"
#include "src/scene/ply_runs.hpp"
#include "src/scene/scene_source.hpp"

namespace provis {
namespace {

constexpr std::size_t no_list = std::numeric_limits<std::size_t>::max();
/// A longer list is of no use to anybody, and a row of one byte would make a hundred of it.
constexpr std::size_t most_left_out = 1'000'000;
constexpr std::uint64_t last_id = std::numeric_limits<PrimitiveId>::max();

class PlyLoader {
 public:
  PlyLoader(ByteSpan file, const LoadOptions& options)
      : options_(options), header_(read_ply_header(file)), body_(file, header_) {}

  SceneSource load();

 private:
  const PlyElement* find(const char* name) const;
  bool has_faces() const { return find("face") != nullptr && find("face")->count > 0; }

  /// Vertices are centres where no face uses them and they have a radius, their own or the stated one.
  bool makes_spheres(const PlyElement& element) const;
  void check_options() const;

  void read_element(std::size_t element);
  void read_vertices(const PlyElement& element);
  void read_spheres(std::size_t element);
  void read_faces(std::size_t element, PlyBody& body);
  void pass_over(const PlyElement& element);
  void skip(const PlyElement& element);

  /// What is wrong with the row that was read last; empty if nothing is.
  std::string complaint(const std::string& what, std::uint64_t row, const Sphere& sphere, bool moved) const;
  std::string complaint(std::uint64_t face) const;

  /// Fails, or notes what is left out.
  void refuse(const PlyBody& body, const std::string& what);

  void add_sphere(const Sphere& sphere, std::uint8_t flags, PlyRowNumber from);
  void add_face(std::uint8_t flags, PlyRowNumber from);
  void join_sources();

  std::uint8_t flags_of(const PlyBody& body, PlyFlags property, std::uint8_t otherwise) const;

  const LoadOptions& options_;
  PlyHeader header_;
  PlyBody body_;
  PlyRow row_;
  std::vector<std::uint64_t> not_finite_;  ///< rows of vertices that faces must not use, ascending
  bool restated_ = false;                  ///< options made other spheres of the file than it holds
  PlyRuns face_runs_, sphere_runs_;
  SceneArrays arrays_;
};

SceneSource PlyLoader::load() {
  check_options();
  // Whether a face can be kept is known after the vertices only.
  std::optional<std::pair<std::size_t, PlyBody>> early_faces;
  bool vertices_read = find("vertex") == nullptr;
  for (std::size_t e = 0; e < header_.elements.size(); ++e) {
    const PlyElement& element = header_.elements[e];
    body_.check_count(element);
    vertices_read |= element.name == "vertex";
    if (element.name == "face" && !vertices_read) {
      early_faces.emplace(e, body_);
      pass_over(element);
    } else {
      read_element(e);
    }
    arrays_.notes.elements.push_back(element.name);
  }
  body_.check_end();
  if (early_faces) read_faces(early_faces->first, early_faces->second);
  if (!has_faces()) arrays_.skipped.points = arrays_.vertices.size();
  join_sources();
  arrays_.notes.format = "PLY";
  // The file's hash is of what the file holds.
  if (restated_ || !arrays_.left_out.empty()) header_.hash.reset();
  return {std::move(arrays_), header_.hash};
}

const PlyElement* PlyLoader::find(const char* name) const {
  const auto found = std::ranges::find(header_.elements, name, &PlyElement::name);
  return found == header_.elements.end() ? nullptr : &*found;
}

bool PlyLoader::makes_spheres(const PlyElement& element) const {
  if (element.name == "sphere") return true;
  return element.name == "vertex" && !has_faces() && (element.scalar("radius") || options_.radius);
}

void PlyLoader::check_options() const {
  const auto fail = [](const char* option, const char* what) {
    throw Error(Error::Code::usage, option, what);
  };
  if (options_.scene) fail("--scene", "a PLY file holds one scene");
  if (!options_.animation.empty()) fail("--animation", "a PLY file has no animations");
  const auto moves = [this](const PlyElement& element) {
    return makes_spheres(element) && ply_sphere_columns(element).velocity;
  };
  if (options_.time && std::ranges::none_of(header_.elements, moves))
    fail("--time", "nothing moves: no sphere of the file has vx, vy and vz");
}

void PlyLoader::read_element(std::size_t e) {
  const PlyElement& element = header_.elements[e];
  if (makes_spheres(element)) return read_spheres(e);
  if (element.name == "vertex") return read_vertices(element);
  if (element.name == "face") return read_faces(e, body_);
  skip(element);
}

void PlyLoader::read_vertices(const PlyElement& element) {
  if (element.scalar("radius"))
    fail_unsupported(fmt::format("line {}", element.line), "vertices that have a radius beside faces");
  const PlyPoint position = ply_position(element);
  arrays_.vertices.reserve(element.count);
  for (std::uint64_t i = 0; i < element.count; ++i) {
    body_.read_row(element, no_list, row_);
    const Vec3d p = position.in(row_);
    arrays_.vertices.push_back(finite(p) ? p : Vec3d{});
    if (finite(p)) continue;
    if (!options_.skip_invalid)
      fail_invalid(body_.row_place(), fmt::format("vertex {} is not finite: ({}, {}, {})", i, p.x, p.y, p.z));
    not_finite_.push_back(i);
  }
}

void PlyLoader::read_spheres(std::size_t e) {
  const PlyElement& element = header_.elements[e];
  const PlySphereColumns columns = ply_sphere_columns(element);
  if (!columns.radius && element.name == "sphere")
    fail_invalid(fmt::format("line {}", element.line), "element sphere has no property radius");
  const bool moved = options_.time && columns.velocity;
  restated_ |= element.count > 0 && (moved || !columns.radius);
  for (std::uint64_t i = 0; i < element.count; ++i) {
    body_.read_row(element, no_list, row_);
    Sphere sphere{columns.center.in(row_), columns.radius ? row_.scalars[*columns.radius] : *options_.radius};
    if (moved) sphere.center = sphere.center + *options_.time * columns.velocity->in(row_);
    const std::string wrong = complaint(element.name, i, sphere, moved);
    if (wrong.empty())
      add_sphere(sphere, flags_of(body_, columns.flags, single_sided), {e, i});
    else
      refuse(body_, wrong);
  }
}

std::string PlyLoader::complaint(const std::string& what, std::uint64_t row, const Sphere& sphere,
                                 bool moved) const {
  const auto& [c, r] = sphere;
  if (!finite(c))
    return fmt::format("{} {} is not finite{}: ({}, {}, {})", what, row,
                       moved ? fmt::format(" at time {}", *options_.time) : "", c.x, c.y, c.z);
  if (!(r >= 0) || std::isinf(r)) return fmt::format("{} {} has radius {}", what, row, r);
  return {};
}

void PlyLoader::read_faces(std::size_t e, PlyBody& body) {
  const PlyElement& element = header_.elements[e];
  const PlyFaceColumns columns = ply_face_columns(element);
  for (std::uint64_t i = 0; i < element.count; ++i) {
    body.read_row(element, columns.corners, row_);
    const std::string wrong = complaint(i);
    if (wrong.empty())
      add_face(flags_of(body, columns.flags, 0), {e, i});
    else
      refuse(body, wrong);
  }
}

std::string PlyLoader::complaint(std::uint64_t face) const {
  const std::uint64_t vertices = find("vertex") ? find("vertex")->count : 0;
  for (const double index : row_.list) {
    if (index < 0 || index >= static_cast<double>(vertices))
      return fmt::format("face {} uses vertex {} of {}", face, index, vertices);
    if (std::ranges::binary_search(not_finite_, static_cast<std::uint64_t>(index)))
      return fmt::format("face {} uses vertex {}, which is not finite", face, index);
  }
  if (row_.list.empty()) return fmt::format("face {} has no corners", face);
  return {};
}

/// Reads rows only to find where the next element begins.
void PlyLoader::pass_over(const PlyElement& element) {
  for (std::uint64_t i = 0; i < element.count; ++i) body_.read_row(element, no_list, row_);
}

void PlyLoader::skip(const PlyElement& element) {
  if (element.count == 0 || element.properties.empty()) return;
  if (element.name == "tristrips" || element.name == "trifans")
    fail_unsupported(fmt::format("line {}", element.line), fmt::format("element {}", element.name));
  if (element.name == "edge") arrays_.skipped.lines += element.count;
  pass_over(element);
}

void PlyLoader::refuse(const PlyBody& body, const std::string& what) {
  if (!options_.skip_invalid) fail_invalid(body.row_place(), what);
  if (arrays_.left_out.size() == most_left_out)
    fail_unsupported(body.row_place(), fmt::format("more than {} invalid primitives", most_left_out));
  arrays_.left_out.push_back({body.row_place(), what});
}

std::uint8_t PlyLoader::flags_of(const PlyBody& body, PlyFlags property, std::uint8_t otherwise) const {
  if (!property) return otherwise;
  const double flags = row_.scalars[*property];
  if (flags > (single_sided | see_through))
    fail_invalid(body.row_place(), fmt::format("unknown flag bits in {}", flags));
  return static_cast<std::uint8_t>(flags);
}

void PlyLoader::add_sphere(const Sphere& sphere, std::uint8_t flags, PlyRowNumber from) {
  arrays_.spheres.push_back(sphere);
  arrays_.sphere_flags.push_back(flags);
  sphere_runs_.add(1, from);
}

/// A polygon becomes a fan around its first corner; one or two corners are no surface.
void PlyLoader::add_face(std::uint8_t flags, PlyRowNumber from) {
  const auto corner = [this](std::size_t k) { return static_cast<std::uint32_t>(row_.list[k]); };
  arrays_.skipped.points += row_.list.size() == 1;
  arrays_.skipped.lines += row_.list.size() == 2;
  if (row_.list.size() < 3) return;
  for (std::size_t k = 2; k < row_.list.size(); ++k) {
    arrays_.triangles.push_back({corner(0), corner(k - 1), corner(k)});
    arrays_.triangle_flags.push_back(flags);
  }
  face_runs_.add(row_.list.size() - 2, from);
}

/// Spheres follow after all triangles (R2).
void PlyLoader::join_sources() {
  const std::size_t triangles = arrays_.triangles.size();
  if (triangles + arrays_.spheres.size() > last_id) return;  // Scene says what is wrong
  face_runs_.append_to(arrays_.sources, 0);
  sphere_runs_.append_to(arrays_.sources, static_cast<PrimitiveId>(triangles));
}

}  // namespace

SceneSource load_ply(ByteSpan file, const LoadOptions& options) { return PlyLoader(file, options).load(); }

}  // namespace provis
