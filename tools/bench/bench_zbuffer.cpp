// Measures the z-buffer pass.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "provis/draw.hpp"
#include "tools/bench/child.hpp"
#include "tools/bench/zbuffer.hpp"

namespace provis::bench {

namespace {

/// Each triangle in a grey by how steeply the view meets it, tinted by its id.
Image picture_of(const ZBuffer& buffer, const Scene& scene, const PointView& view) {
  Image image{width, height, {}};
  const Vec3d light = view.frames.front().forward + 0.4 * view.frames.front().right - view.frames.front().up;
  for (const std::uint32_t id : buffer.ids()) {
    std::array<double, 3> color = {0.6, 0.75, 0.95};
    if (id != ZBuffer::nothing) {
      const Vec3d a = scene.corner(id, 0), n = cross(scene.corner(id, 1) - a, scene.corner(id, 2) - a);
      const double lit = 0.25 + 0.5 * std::abs(dot(n, light)) / std::sqrt(dot(n, n) * dot(light, light));
      for (std::size_t k = 0; k < 3; ++k) color[k] = lit + 0.02 * ((id >> (3 * k)) % 8);
    }
    for (const double c : color) image.rgb.push_back(static_cast<std::uint8_t>(255 * std::min(1.0, c)));
  }
  return image;
}

int run(int argc, char** argv) {
  Child child("bench_zbuffer");
  std::string picture;
  child.options().add_option("--picture", picture, "Write what was drawn as PNG, to see what a view sees");
  return child.run(argc, argv, [&](const Child& c) {
    std::vector<std::uint8_t> seen;
    std::optional<ZBuffer> buffer;
    nlohmann::json result = c.measured([&] {
      buffer.emplace(width, height);
      buffer->draw(c.scene(), c.view());
      seen = buffer->seen(c.scene().triangles().size());
    });
    if (!picture.empty()) write_png(picture_of(*buffer, c.scene(), c.view()), picture);
    result.update(c.found(flagged(seen)));
    return result;
  });
}

}  // namespace

}  // namespace provis::bench

int main(int argc, char** argv) { return provis::bench::run(argc, argv); }
