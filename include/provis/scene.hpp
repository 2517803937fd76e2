#pragma once
// A scene: triangles and spheres with float64 coordinates that are taken as exact (R1 to R5).

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "provis/context.hpp"
#include "provis/vec3.hpp"

namespace provis {

/// Rank of a primitive in loading order; spheres follow after all triangles (R2).
using PrimitiveId = std::uint32_t;

/// Per-primitive flags as they enter the scene's hash, after sides and opacity were resolved (R4, R5).
enum PrimitiveFlag : std::uint8_t {
  single_sided = 1,  ///< neither visible nor an occluder when seen from behind
  see_through = 2,   ///< visible, but never an occluder
};

using Triangle = std::array<std::uint32_t, 3>;  ///< vertex indices, counter-clockwise seen from the front

struct Sphere {
  Vec3d center;
  double radius = 0;
};

/// A run of primitives that came from one place of the file; runs are stored in id order.
///
/// An element is what the file counts inside that place. glTF: a triangle or a point of the primitive, by its
/// rank in index order (in strips and fans too). PLY: a row of face, sphere or vertex; a face of k corners
/// becomes k - 2 ids of one element. What was left out keeps its rank or row, so that a run ends before it.
struct SourceRange {
  PrimitiveId first = 0;          ///< of the run
  std::uint32_t count = 0;        ///< primitives in this run
  std::int32_t node = -1;         ///< glTF node index, -1 where the format has none
  std::int32_t mesh = -1;         ///< glTF mesh index, -1 where the format has none
  std::int32_t primitive = -1;    ///< glTF: index inside the mesh; PLY: index in FileNotes::elements
  std::int32_t instance = -1;     ///< which of the node's instances, -1 where it is not instanced
  std::uint32_t element = 0;      ///< element of the first id
  std::uint32_t per_element = 1;  ///< ids that each element became; count is a multiple of it
};

/// Things the file holds that are no surface: reported, never dropped in silence.
struct Skipped {
  std::uint64_t points = 0;  ///< points without a radius
  std::uint64_t lines = 0;   ///< line segments
};

/// Something of the file that LoadOptions::skip_invalid left out.
struct LeftOut {
  std::string place;   ///< node, mesh and primitive, or line or byte of a PLY row
  std::string reason;  ///< what would have been the error
};

/// An animation that the file offers.
struct AnimationInfo {
  std::string name;            ///< may be empty
  double first = 0, last = 0;  ///< seconds between which it changes anything
  int index = 0;               ///< in the file: broken ones, which are not listed, count there
};

/// What else the file says: nothing of it decides visibility.
struct FileNotes {
  std::string format;               ///< "glTF", "PLY" or empty
  std::string unit;                 ///< of lengths: "metre", or empty where the format does not say
  std::vector<std::string> scenes;  ///< their names, which may be empty, by index
  int scene = -1;                   ///< the one that was loaded; -1 where there is none to choose
  std::vector<AnimationInfo> animations;
  int animation = -1;                 ///< index of the one that LoadOptions::time applied; -1 for none
  std::vector<std::string> elements;  ///< of a PLY header, in order
};

/// The arrays a scene is made of; fill one, then give it to Scene.
struct SceneArrays {
  std::vector<Vec3d> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::uint8_t> triangle_flags;  ///< one per triangle, PrimitiveFlag bits
  std::vector<Sphere> spheres;
  std::vector<std::uint8_t> sphere_flags;  ///< one per sphere
  std::vector<SourceRange> sources;        ///< may be empty; otherwise covers all ids in order
  std::vector<std::string> node_names;     ///< by glTF node index; may be empty
  Skipped skipped;
  std::vector<LeftOut> left_out;
  FileNotes notes;
};

/// An immutable scene.
///
/// Input:      arrays: V vertices, F triangles, S spheres in world units
/// Guarantee:  coordinates are kept bit for bit; ids are positions in the arrays (R1, R2)
/// Degenerate: triangles of zero area and spheres of radius 0 keep their ids; they are never seen (R3)
/// Throws:     Error::invalid_input naming the first non-finite coordinate, index out of range, negative
///             radius, gap between sources or array of the wrong length; more than 2^32 - 1 primitives
class Scene {
 public:
  Scene() : Scene(SceneArrays{}) {}
  explicit Scene(SceneArrays arrays);

  std::span<const Vec3d> vertices() const { return arrays_.vertices; }
  std::span<const Triangle> triangles() const { return arrays_.triangles; }
  std::span<const std::uint8_t> triangle_flags() const { return arrays_.triangle_flags; }
  std::span<const Sphere> spheres() const { return arrays_.spheres; }
  std::span<const std::uint8_t> sphere_flags() const { return arrays_.sphere_flags; }
  std::span<const SourceRange> sources() const { return arrays_.sources; }
  std::span<const std::string> node_names() const { return arrays_.node_names; }
  const Skipped& skipped() const { return arrays_.skipped; }
  std::span<const LeftOut> left_out() const { return arrays_.left_out; }
  const FileNotes& notes() const { return arrays_.notes; }

  std::size_t primitive_count() const { return arrays_.triangles.size() + arrays_.spheres.size(); }

  /// Corner k of triangle t.
  const Vec3d& corner(std::size_t t, int k) const {
    return arrays_.vertices[arrays_.triangles[t][static_cast<std::size_t>(k)]];
  }

  /// SHA-256 of the exact content, 64 lower-case hexadecimal digits (semantics.md, "Hash").
  const std::string& hash() const { return hash_; }

  const SceneArrays& arrays() const { return arrays_; }

 private:
  SceneArrays arrays_;
  std::string hash_;
};

enum class Sides { material, both };   ///< R4
enum class Opacity { material, all };  ///< R5

struct LoadOptions {
  Sides sides = Sides::material;
  Opacity opacity = Opacity::material;
  std::optional<int> scene = {};      ///< glTF scene; else the file's default, else 0, else every root node
  std::optional<double> time = {};    ///< seconds, clamped to the animation's ends; else the rest pose. Of a
                                      ///< PLY file: what the velocities of its spheres are multiplied by
  std::string animation = {};         ///< index or name; empty: the first. Needs time
  std::optional<double> radius = {};  ///< of points that have none of their own, in scene units
  bool skip_invalid = false;          ///< leave broken primitives out, and list them, instead of failing
};

/// Reads a scene from a glTF 2.0 (.gltf, .glb) or PLY (.ply) file, told apart by content.
///
/// Returns:    the scene, ids in the file's order (R2)
/// Guarantee:  coordinates follow the loading arithmetic of R1: one documented float64 rounding
/// Degenerate: nothing is merged, dropped or reordered; points and lines are counted as skipped
/// Throws:     Error::invalid_input (unreadable, malformed; names file and place),
///             Error::unsupported (valid, but needs something outside the program's reach),
///             Error::usage (options that make no sense, or none for this file; names the option)
Scene load_scene(const std::filesystem::path& file, const LoadOptions& options = {});

/// Writes the scene as binary little-endian float64 PLY in id order, its hash in a comment.
///
/// Guarantee:  load_scene of the file gives a scene of the same hash
/// Throws:     Error::output; no partial file is left behind
void export_ply(const Scene& scene, const std::filesystem::path& file);

/// R12: moves every coordinate by a pseudo-random number from [-delta, delta], a function of the
/// seed and the exact position, so that equal positions move together. Spheres move by their centers.
///
/// Guarantee:  same seed, same scene, same result on every machine
/// Throws:     Error::usage if delta is not finite, negative, or below one ulp of the largest coordinate
Scene perturb(const Scene& scene, double delta, std::uint64_t seed);

/// Counts that `provis info` prints.
struct SceneSummary {
  std::size_t triangles = 0, spheres = 0, vertices = 0;
  std::size_t degenerate_triangles = 0;                                 ///< exactly zero area
  std::size_t degenerate_spheres = 0;                                   ///< radius 0
  std::array<std::size_t, 4> triangles_by_flags{}, spheres_by_flags{};  ///< index: PrimitiveFlag bits
  std::size_t single_sided = 0, see_through = 0;                        ///< triangles and spheres
  double smallest_radius = 0, largest_radius = 0;  ///< of spheres; 0 where there are none
  Vec3d lower, upper;  ///< extent over referenced vertices and spheres; zero for an empty scene
};

/// Guarantee:  zero area is decided exactly
/// Throws:     Error::cancelled
/// Cost:       O(F + S); parallel; same answer for any thread count
SceneSummary summarize(const Scene& scene, const Context& context = {});

/// Bytes that the scene's arrays of vertices, indices, spheres and flags take in memory.
std::size_t array_bytes(const Scene& scene);

}  // namespace provis
