#include "src/cli/view_options.hpp"

#include "provis/error.hpp"
#include "src/cli/arguments.hpp"
#include "src/cli/option_group.hpp"
#include "src/cli/views_file.hpp"
#include "src/report/names.hpp"

namespace provis {

namespace {

// FILE:NAME, cut at the last colon; NAME holds none.
ViewRequest named_request(const std::string& text, const std::string& scene_file) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0 || colon + 1 == text.size()) {
    throw Error(Error::Code::usage, "--views", "expected FILE:NAME, got \"" + text + "\"");
  }
  return read_named_view(text.substr(0, colon), text.substr(colon + 1), scene_file);
}

}  // namespace

void ViewOptions::add_to(CLI::App& command) {
  const OptionGroup add(command, group);
  add("--eye", eye, "x,y,z", "Viewpoint, in scene units (required, unless --views is given)");
  add("--dir", dir, "x,y,z",
      "Direction of view, of any length but 0; this, --look-at or --right is required, unless --view is "
      "omni");
  add("--look-at", look_at, "x,y,z", "Instead of --dir: a point to look at, in scene units");
  add("--up", up, "x,y,z",
      "Upward direction of the camera, which need not be at a right angle to --dir [0,1,0; 0,0,-1 if "
      "parallel "
      "to the direction]");
  add("--fovy", fovy, "DEG", "Vertical field of view in degrees, above 0 and below 180 [60]");
  add("--size", size, "WxH",
      "Pixels of the picture that the view stands for, 1 to 16384 each: an exact set depends on their ratio "
      "only, the window's width to height; the other methods look at every pixel (of an omni view: 1024x1024 "
      "for each face, unless it is given) [1280x720]");
  add("--view", projection, {"pinhole", "omni", "parallel"},
      "'pinhole': an eye and a window; 'omni': an eye that sees all around; 'parallel': an eye at infinity, "
      "the "
      "window in scene units through --eye, and only what is in front of it [pinhole]");
  add("--window", window, "x0,x1,y0,y1",
      "Instead of --fovy and --size: the rectangle to look through, at distance 1. Rays run along forward + "
      "x "
      "right + y up for x from x0 to x1 and y from y0 to y1");
  add("--right", right, "x,y,z",
      "Instead of --dir and --fovy: the vectors --right, --up and --forward as they are, of any length and "
      "at "
      "any angle, taken as exact, with --window");
  add("--forward", forward, "x,y,z", "See --right");
  exclude(
      add("--views", views, "FILE:NAME",
          "Instead of all these: the view called NAME of a JSON file of views; only --size may go with it"),
      {"--eye", "--dir", "--look-at", "--up", "--fovy", "--view", "--window", "--right", "--forward"});
}

PointView ViewOptions::view(const std::string& scene_file) const {
  if (!views.empty()) {
    ViewRequest request = named_request(views, scene_file);
    if (!size.empty()) request.size = parse_size("--size", size);
    return build_view(request, "--views " + views + ": ");
  }
  ViewRequest request = CameraOptions::request();
  if (!projection.empty()) request.projection = projection_named(projection).value();
  request.eye = optional_vec3("--eye", eye);
  if (!size.empty()) request.size = parse_size("--size", size);
  return build_view(request, "--");
}

}  // namespace provis
