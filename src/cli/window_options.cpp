#include "src/cli/window_options.hpp"

#include "src/cli/option_group.hpp"

namespace provis {

std::optional<Frame> WindowOptions::frame(const Vec3d& middle, const std::array<int, 2>& size) const {
  if (!camera()) return std::nullopt;
  ViewRequest request = CameraOptions::request();
  request.eye = middle;
  if (!request.right && !request.forward && !request.window) request.size = size;
  return build_view(request, "--").frames.front();
}

void WindowOptions::add_to(CLI::App& command) {
  const OptionGroup add(command, group);
  add("--dir", dir, "x,y,z",
      "Look only along this direction, of any length but 0, as a camera does; without it, or --look-at, or "
      "--right, "
      "all around");
  add("--look-at", look_at, "x,y,z", "Instead of --dir: a point to look at from the middle of the cell");
  add("--up", up, "x,y,z", "Upward direction of the camera [0,1,0; 0,0,-1 if parallel to the direction]");
  add("--fovy", fovy, "DEG",
      "Vertical field of view in degrees, above 0 and below 180; as wide to high as --cos-size [60]");
  add("--window", window, "x0,x1,y0,y1",
      "Instead of --fovy: the rectangle to look through, at distance 1. Rays run along forward + x right + y "
      "up");
  add("--right", right, "x,y,z",
      "Instead of --dir and --fovy: the vectors --right, --up and --forward as they are, taken as exact, "
      "with "
      "--window");
  add("--forward", forward, "x,y,z", "See --right");
}

}  // namespace provis
