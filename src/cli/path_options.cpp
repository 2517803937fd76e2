#include "src/cli/path_options.hpp"

#include <cmath>

#include "provis/error.hpp"
#include "src/cli/arguments.hpp"
#include "src/cli/option_group.hpp"
#include "src/scene/random.hpp"

namespace provis {

namespace {

constexpr std::uint64_t most_runs = 10000;

[[noreturn]] void refuse(const std::string& option, const std::string& what) {
  throw Error(Error::Code::usage, option, what);
}

/// The columns of a rotation, from a quaternion that is uniform on the sphere: no function but the square
/// root, which every machine rounds alike.
struct Rotation {
  Vec3d x, y, z;

  Vec3d operator()(const Vec3d& v) const { return v.x * x + v.y * y + v.z * z; }
};

Rotation random_rotation(Random& random) {
  double a, b, c, d, size;
  do {
    a = random.signed_unit();
    b = random.signed_unit();
    c = random.signed_unit();
    d = random.signed_unit();
    size = a * a + b * b + c * c + d * d;
  } while (size > 1 || size < 0.01);
  const double s = 2 / size;
  return {{1 - s * (c * c + d * d), s * (b * c + a * d), s * (b * d - a * c)},
          {s * (b * c - a * d), 1 - s * (b * b + d * d), s * (c * d + a * b)},
          {s * (b * d + a * c), s * (c * d - a * b), 1 - s * (b * b + c * c)}};
}

/// x,y,z:ux,uy,uz:vx,vy,vz
std::array<Vec3d, 3> parse_rect(const std::string& text) {
  const std::size_t first = text.find(':');
  const std::size_t second = first == std::string::npos ? first : text.find(':', first + 1);
  if (second == std::string::npos || text.find(':', second + 1) != std::string::npos)
    refuse("--rect", "expected x,y,z:ux,uy,uz:vx,vy,vz, got \"" + text + "\"");
  return {parse_vec3("--rect", text.substr(0, first)),
          parse_vec3("--rect", text.substr(first + 1, second - first - 1)),
          parse_vec3("--rect", text.substr(second + 1))};
}

}  // namespace

std::vector<Frame> turned_cube(std::uint64_t seed, std::uint64_t run) {
  Random random(seed, run);
  const Rotation turn = random_rotation(random);
  std::vector<Frame> frames = omni({0, 0, 0}).frames;
  for (Frame& f : frames) f = {turn(f.right), turn(f.up), turn(f.forward), f.window};
  return frames;
}

bool PathOptions::pinhole() const {
  if (faces == "6" && camera())
    refuse("--faces", "6 faces look everywhere: a camera's options have no place");
  return camera() || faces == "1";
}

std::vector<SegmentQuery::Path> PathOptions::paths() const {
  if (!rect.empty()) {
    const auto [p, u, v] = parse_rect(rect);
    const Vec3d a = p + u, b = p + u + v, c = p + v;
    return {{p, a}, {a, b}, {b, c}, {c, p}};
  }
  if (from.empty() || to.empty()) refuse("--from", "give --from and --to, or --rect");
  return {{parse_vec3("--from", from), parse_vec3("--to", to)}};
}

std::vector<Frame> PathOptions::frames(const Vec3d& eye, std::uint64_t seed) const {
  if (!pinhole()) {
    if (runs.empty()) return omni(eye).frames;
    const std::uint64_t n = parse_whole("--runs", runs, 1, most_runs);
    std::vector<Frame> all;
    for (std::uint64_t k = 0; k < n; ++k) {
      const std::vector<Frame> cube = turned_cube(seed, k);
      all.insert(all.end(), cube.begin(), cube.end());
    }
    return all;
  }
  if (!runs.empty()) refuse("--runs", "turns cubes of 6 faces: a camera's options have no place");
  ViewRequest request = CameraOptions::request();
  request.eye = eye;
  if (!size.empty()) request.size = parse_size("--size", size);
  return build_view(request, "--").frames;
}

SegmentQuery PathOptions::query(std::uint64_t seed) const {
  SegmentQuery q;
  q.paths = paths();
  q.frames = frames(q.paths.front().from, seed);
  q.pixels = pinhole() ? PixelGrid{} : PixelGrid{800, 800};
  if (!size.empty()) {
    const auto [width, height] = parse_size("--size", size);
    q.pixels = {width, height};
  }
  for (std::size_t k = 0; k < q.paths.size(); ++k) check(q.view(k));
  return q;
}

void PathOptions::add_paths_to(CLI::App& command) {
  const OptionGroup add(command, group);
  add("--from", from, "x,y,z", "Where the camera starts, in scene units; with --to");
  add("--to", to, "x,y,z", "Where it ends; it moves straight there and does not turn");
  exclude(add("--rect", rect, "P:U:V",
              "Instead of --from and --to: the four sides of the parallelogram at the point P with sides U "
              "and V, "
              "each of the "
              "three as x,y,z in scene units; the answers are united"),
          {"--from", "--to"});
  add("--faces", faces, {"1", "6"},
      "6: a cube of square faces that sees all around; 1: a camera, with --dir or --right [6]");
}

void PathOptions::add_to(CLI::App& command) {
  add_paths_to(command);
  const OptionGroup add(command, group);
  add("--size", size, "WxH",
      "Pixels of each face or of the camera, 1 to 16384 each: the query is answered at their centres "
      "[800x800; "
      "1280x720 of a camera]");
  add("--runs", runs, "K",
      "Look through K cubes, 1 to 10000, each turned at random, and unite what they see [one cube along the "
      "axes]");
  add("--dir", dir, "x,y,z", "A camera: its direction of view, of any length but 0");
  add("--look-at", look_at, "x,y,z",
      "Instead of --dir: a point to look at from the start of the (first) segment, in scene units");
  add("--up", up, "x,y,z",
      "A camera: its upward direction, which need not be at a right angle to --dir [0,1,0; 0,0,-1 if "
      "parallel to "
      "the direction]");
  add("--fovy", fovy, "DEG", "A camera: vertical field of view in degrees, above 0 and below 180 [60]");
  add("--window", window, "x0,x1,y0,y1", "Instead of --fovy: the rectangle to look through, at distance 1");
  add("--right", right, "x,y,z",
      "Instead of --dir and --fovy: the vectors --right, --up and --forward as they are, of any length and "
      "at any "
      "angle, taken as exact, with --window");
  add("--forward", forward, "x,y,z", "See --right");
}

}  // namespace provis
