#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <utility>

#include "provis/scene.hpp"
#include "src/scene/failure.hpp"
#include "src/scene/glb_container.hpp"
#include "src/scene/scene_hash.hpp"
#include "src/scene/scene_source.hpp"

namespace provis {
namespace {

/// What the file begins with, after a byte order mark and white space.
std::string_view beginning(ByteSpan file) {
  std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view{} : text.substr(first);
}

void check_options(const LoadOptions& options) {
  const auto fail = [](const char* option, const std::string& what) {
    throw Error(Error::Code::usage, option, what);
  };
  if (options.scene && *options.scene < 0) fail("--scene", fmt::format("{} is no index", *options.scene));
  if (options.time && !std::isfinite(*options.time))
    fail("--time", fmt::format("{} is no time", *options.time));
  if (!options.animation.empty() && !options.time) fail("--animation", "needs --time");
  if (options.radius && !(*options.radius > 0 && std::isfinite(*options.radius)))
    fail("--radius", fmt::format("{} is no radius above 0", *options.radius));
}

void check_hash(const SceneSource& source) {
  if (!source.hash) return;
  const std::string actual = scene_hash(source.arrays);
  if (actual != *source.hash)
    fail_invalid("comment",
                 "the content has hash " + actual + ", not " + *source.hash + " as the comment says");
}

void clear_flag(SceneArrays& arrays, PrimitiveFlag flag) {
  for (std::uint8_t& flags : arrays.triangle_flags) flags = static_cast<std::uint8_t>(flags & ~flag);
  for (std::uint8_t& flags : arrays.sphere_flags) flags = static_cast<std::uint8_t>(flags & ~flag);
}

}  // namespace

SceneSource load_source(ByteSpan file, const std::filesystem::path& folder, const LoadOptions& options) {
  if (is_glb(file)) return load_gltf(file, folder, options);
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  if (text.starts_with("ply\n") || text.starts_with("ply\r")) return load_ply(file, options);
  if (beginning(file).starts_with('{')) return load_gltf(file, folder, options);
  fail_invalid("byte 0", file.empty() ? "the file is empty" : "neither glTF nor PLY");
}

Scene load_scene(const std::filesystem::path& file, const LoadOptions& options) {
  check_options(options);
  try {
    const Bytes bytes = read_file(file);
    SceneSource source = load_source(bytes, file.parent_path(), options);
    check_hash(source);
    if (options.sides == Sides::both) clear_flag(source.arrays, single_sided);
    if (options.opacity == Opacity::all) clear_flag(source.arrays, see_through);
    return Scene(std::move(source.arrays));
  } catch (const Error& error) {
    throw in_file(file.string(), error);
  }
}

}  // namespace provis
