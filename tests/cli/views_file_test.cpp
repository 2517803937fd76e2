// Named views in both formats.

#include "src/cli/views_file.hpp"

#include <catch2/catch.hpp>

#include "provis/error.hpp"
#include "tests/scene/files.hpp"

using namespace provis;

namespace {

class ViewsFile {
 public:
  explicit ViewsFile(const std::string& text) { std::ofstream(directory_.path() / "views.json") << text; }

  ViewRequest read(const std::string& name, const std::string& scene) const {
    return read_named_view((directory_.path() / "views.json").string(), name, scene);
  }
  Error::Code failure(const std::string& name, const std::string& scene) const {
    try {
      read(name, scene);
    } catch (const Error& error) {
      return error.code();
    }
    return Error::Code::internal;
  }

 private:
  TempFolder directory_;
};

const char* const array_text = R"([
  {"scene": "a.glb", "name": "walk", "eye": [1, 2, 3], "dir": [1, 0, 0], "up": [0, 1, 0], "fovy_deg": 45, "check": {}},
  {"scene": "b.glb", "name": "walk", "eye": [4, 5, 6], "dir": [0, 0, 1], "up": [0, 1, 0], "fovy_deg": 60},
  {"scene": "b.glb", "name": "door", "eye": [7, 8, 9], "dir": [0, 0, 1], "up": [0, 1, 0], "fovy_deg": 60}])";

}  // namespace

TEST_CASE("the array format: by name, then by the scene's file name") {
  const ViewsFile file(array_text);
  const ViewRequest a = file.read("walk", "some/where/a.glb");
  CHECK(a.eye == Vec3d{1, 2, 3});
  CHECK(a.fovy_degrees == 45.0);
  CHECK(file.read("walk", "b.glb").eye == Vec3d{4, 5, 6});
  CHECK(file.read("door", "copy_of_b.glb").eye == Vec3d{7, 8, 9});
  CHECK(file.failure("walk", "c.glb") == Error::Code::usage);
  CHECK(file.failure("window", "a.glb") == Error::Code::usage);
}

TEST_CASE("our own format: cameras, verbatim frames, omni") {
  const ViewsFile file(R"({"format": "provis.views", "version": 1, "views": [
    {"name": "camera", "eye": [0, 0, 0], "look_at": [1, 1, 1]},
    {"name": "frame", "projection": "parallel", "eye": [0, 0, 0], "right": [1, 0, 0], "up": [0, 1, 0],
     "forward": [0, 0, -1], "window": [-1, 1, -2, 2]},
    {"name": "around", "projection": "omni", "eye": [0, 0, 0]}]})");
  CHECK(file.read("camera", "x").look_at == Vec3d{1, 1, 1});
  const ViewRequest frame = file.read("frame", "x");
  CHECK(frame.projection == Projection::parallel);
  CHECK(frame.window == Window{-1, 1, -2, 2});
  CHECK(file.read("around", "x").projection == Projection::omni);
}

TEST_CASE("files that are no views are invalid input") {
  for (const char* text : {"", "{", "{}", "[{}]", R"({"format": "provis.views", "version": 2, "views": []})",
                           R"([{"name": "v", "eye": [1, 2]}])", R"([{"name": "v"}])",
                           R"([{"name": "v", "eye": [1, 2, 3], "projection": "fisheye"}])"}) {
    CHECK(ViewsFile(text).failure("v", "x") == Error::Code::invalid_input);
  }
}
