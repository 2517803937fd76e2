// Particles: points that become spheres, and spheres that move.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/scene/files.hpp"

namespace provis {
namespace {

const char xyz[] = "property double x\nproperty double y\nproperty double z\n";
const char velocity[] = "property double vx\nproperty double vy\nproperty double vz\n";

std::string ply(const std::string& elements, const std::string& rows) {
  return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + rows;
}

const std::string points = ply(std::string("element vertex 3\n") + xyz, "0 0 0\n1 2 3\n4 5 6\n");
const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";

Scene load(const std::string& text, const LoadOptions& options = {}) {
  return load_content("scene.ply", text, options);
}

LoadOptions with_radius(double radius) {
  LoadOptions options;
  options.radius = radius;
  return options;
}

LoadOptions at_time(double time) {
  LoadOptions options;
  options.time = time;
  return options;
}

Failure failure(const std::string& text, const LoadOptions& options) {
  return load_failure("scene.ply", text, options);
}

TEST_CASE("points become spheres of the stated radius, seen from outside only") {
  const Scene scene = load(points, with_radius(0.1));
  REQUIRE(scene.spheres().size() == 3);
  CHECK(scene.spheres()[1].center == Vec3d{1, 2, 3});
  for (const Sphere& sphere : scene.spheres()) CHECK(sphere.radius == 0.1);
  CHECK(scene.sphere_flags()[2] == single_sided);
  CHECK(scene.vertices().empty());
  CHECK(scene.skipped().points == 0);
  CHECK(load(points).skipped().points == 3);
  LoadOptions both = with_radius(0.1);
  both.sides = Sides::both;
  CHECK(load(points, both).sphere_flags()[0] == 0);
}

TEST_CASE("a stated radius is for points that have none, and for points only") {
  const std::string sized =
      ply(std::string("element vertex 1\n") + xyz + "property float radius\n", "0 0 0 0.5\n");
  CHECK(load(sized, with_radius(3)).hash() == load(sized).hash());
  const std::string mesh =
      ply(std::string("element vertex 3\n") + xyz + face, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  CHECK(load(mesh, with_radius(3)).hash() == load(mesh).hash());
  // Faces that are declared and absent use no vertex.
  const std::string no_faces = ply(
      std::string("element vertex 1\n") + xyz + "element face 0\nproperty list uchar int vertex_indices\n",
      "1 2 3\n");
  CHECK(load(no_faces, with_radius(3)).spheres().size() == 1);
}

TEST_CASE("vertices and an element of spheres may stand side by side") {
  const std::string text =
      ply(std::string("element vertex 1\n") + xyz + "element sphere 1\n" + xyz + "property double radius\n",
          "1 2 3\n4 5 6 7\n");
  const Scene scene = load(text, with_radius(0.5));
  REQUIRE(scene.spheres().size() == 2);
  CHECK(scene.spheres()[0].radius == 0.5);
  CHECK(scene.spheres()[1].radius == 7);
  REQUIRE(scene.sources().size() == 2);
  CHECK((scene.sources()[1].primitive == 1 && scene.sources()[1].element == 0));
  CHECK(load(text).skipped().points == 1);
  CHECK(load(text).spheres().size() == 1);
}

TEST_CASE("spheres move by time times velocity, each product and sum rounded once") {
  const std::string text =
      ply(std::string("element sphere 2\n") + xyz + "property double radius\n" + velocity,
          "0.3 0.2 -0.3 1 0.9 0.7 0.1\n5 6 7 2 0 0 0\n");
  const double t = 0.3;
  const Scene scene = load(text, at_time(t));
  // Volatile: no fused operation may give the expected value either.
  const volatile double x = t * 0.9, y = t * 0.7, z = t * 0.1;
  CHECK(scene.spheres()[0].center == Vec3d{0.3 + x, 0.2 + y, -0.3 + z});
  CHECK(std::fma(t, 0.9, 0.3) != 0.3 + x);
  CHECK(std::fma(t, 0.7, 0.2) != 0.2 + y);
  CHECK(scene.spheres()[1].center == Vec3d{5, 6, 7});
  CHECK(load(text).spheres()[0].center == Vec3d{0.3, 0.2, -0.3});
  CHECK(load(text, at_time(0)).hash() == load(text).hash());
  CHECK(load(text, at_time(-2)).spheres()[0].center.y == 0.2 - 2 * 0.7);
}

TEST_CASE("points that become spheres move too") {
  const std::string text = ply(std::string("element vertex 1\n") + xyz + velocity, "1 2 3 10 20 30\n");
  LoadOptions options = at_time(0.5);
  options.radius = 2;
  const Scene scene = load(text, options);
  CHECK(scene.spheres()[0].center == Vec3d{6, 12, 18});
  CHECK_FAILURE(failure(text, at_time(0.5)), 1, "--time");
}

TEST_CASE("a place that is not finite names the row") {
  const std::string header = std::string("element sphere 2\n") + xyz + "property double radius\n" + velocity;
  const std::string text = ply(header, "0 0 0 1 0 0 0\n1e308 0 0 1 1e308 0 0\n");
  CHECK(load(text).spheres().size() == 2);
  const Failure overflow = failure(text, at_time(2));
  CHECK_FAILURE(overflow, 2, "line 13");
  CHECK_THAT(overflow.message, Catch::Contains("at time 2"));
  const std::string nan = ply(header, "0 0 0 1 0 nan 0\n0 0 0 1 0 0 0\n");
  CHECK(load(nan).spheres().size() == 2);
  CHECK_FAILURE(failure(nan, at_time(0)), 2, "line 12");
}

TEST_CASE("options that a PLY file has no use for are refused by name") {
  LoadOptions options;
  options.scene = 0;
  CHECK_FAILURE(failure(points, options), 1, "--scene");
  options = at_time(1);
  options.animation = "walk";
  CHECK_FAILURE(failure(points, options), 1, "--animation");
  CHECK_FAILURE(failure(points, at_time(1)), 1, "--time");
  // Two components are no velocity, and a velocity of mesh vertices moves nothing.
  const std::string two = ply(std::string("element sphere 0\n") + xyz +
                                  "property double radius\nproperty double "
                                  "vx\nproperty double vy\n",
                              "");
  CHECK_FAILURE(failure(two, at_time(1)), 1, "--time");
  const std::string mesh = ply(std::string("element vertex 3\n") + xyz + velocity + face,
                               "0 0 0 1 1 1\n1 0 0 1 1 1\n0 1 0 1 1 1\n3 0 1 2\n");
  CHECK(load(mesh).triangles().size() == 1);
  CHECK_FAILURE(failure(mesh, at_time(1)), 1, "--time");
}

TEST_CASE("options that make no sense are refused before the file is read") {
  const auto code = [](const LoadOptions& options) {
    return failure_of([&] { load_scene("no-such-file.ply", options); });
  };
  const double inf = std::numeric_limits<double>::infinity();
  for (const double radius : {0.0, -1.0, inf, std::nan("")})
    CHECK_FAILURE(code(with_radius(radius)), 1, "--radius");
  for (const double time : {inf, -inf, std::nan("")}) CHECK_FAILURE(code(at_time(time)), 1, "--time");
  LoadOptions options;
  options.scene = -1;
  CHECK_FAILURE(code(options), 1, "--scene");
  options = {};
  options.animation = "walk";
  CHECK_FAILURE(code(options), 1, "--animation");
  CHECK(code({}).status == 2);
}

TEST_CASE("the hash of an exported file is of what it holds, not of what options make of it") {
  const TempFolder folder;
  const auto file = folder.path() / "points.ply";
  export_ply(load(points), file);
  CHECK(load_scene(file).vertices().size() == 3);
  CHECK(load_scene(file, with_radius(2)).hash() == load(points, with_radius(2)).hash());
}

TEST_CASE("the file's format and its elements are noted") {
  const FileNotes notes = load(points).notes();
  CHECK(notes.format == "PLY");
  CHECK(notes.unit.empty());
  CHECK(notes.scene == -1);
  CHECK(notes.scenes.empty());
  CHECK(notes.elements == std::vector<std::string>{"vertex"});
}

}  // namespace
}  // namespace provis
