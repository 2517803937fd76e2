// What goes together in a view, and what does not.

#include "src/cli/view_request.hpp"

#include <catch2/catch.hpp>

#include "provis/error.hpp"

using namespace provis;

namespace {

ViewRequest camera() {
  ViewRequest request;
  request.eye = Vec3d{1, 2, 3};
  request.dir = Vec3d{1, 0, 0};
  return request;
}

ViewRequest verbatim() {
  ViewRequest request;
  request.eye = Vec3d{1, 2, 3};
  request.right = Vec3d{2, 0, 0};
  request.up = Vec3d{1, 1, 0};
  request.forward = Vec3d{0, 0, -3};
  request.window = Window{0, 1, 0, 2};
  return request;
}

std::string complaint(const ViewRequest& request) {
  try {
    build_view(request, "--");
    FAIL("was taken");
    return "";
  } catch (const Error& error) {
    CHECK(error.code() == Error::Code::usage);
    return error.what();
  }
}

void refused(const ViewRequest& request, const std::string& option) {
  CHECK_THAT(complaint(request), Catch::Contains(option));
}

}  // namespace

TEST_CASE("a camera has the documented defaults") {
  const PointView view = build_view(camera(), "--"),
                  same = look_at({{1, 2, 3}, {1, 0, 0}, {0, 1, 0}, 60, 1280, 720});
  CHECK(view.eye == same.eye);
  CHECK(view.frames == same.frames);
  CHECK(view.projection == Projection::pinhole);
}

TEST_CASE("looking at a point is looking along the way to it") {
  ViewRequest request = camera();
  request.dir.reset();
  request.look_at = Vec3d{6, 2, 3};
  CHECK(build_view(request, "--").frames == build_view(camera(), "--").frames);
}

TEST_CASE("a stated window replaces the field of view") {
  ViewRequest request = camera();
  request.window = Window{-3, 1, 0, 1};
  CHECK(build_view(request, "--").frames[0].window == Window{-3, 1, 0, 1});
  request.projection = Projection::parallel;
  CHECK(build_view(request, "--").projection == Projection::parallel);
}

TEST_CASE("a frame is taken verbatim, orthonormal or not") {
  const PointView view = build_view(verbatim(), "--");
  REQUIRE(view.frames.size() == 1);
  CHECK(view.frames[0] == Frame{{2, 0, 0}, {1, 1, 0}, {0, 0, -3}, {0, 1, 0, 2}});
}

TEST_CASE("an omni view is six frames around the eye") {
  ViewRequest request;
  request.eye = Vec3d{1, 2, 3};
  request.projection = Projection::omni;
  CHECK(build_view(request, "--").frames.size() == 6);
  request.dir = Vec3d{1, 0, 0};
  refused(request, "--dir");
}

TEST_CASE("a direction that is missing is no direction that is stated twice") {
  ViewRequest none = camera();
  none.dir.reset();
  CHECK_THAT(complaint(none), Catch::Contains("no direction") && Catch::Contains("--look-at"));
  ViewRequest twice = camera();
  twice.look_at = Vec3d{0, 0, 0};
  CHECK_THAT(complaint(twice), Catch::Contains("both") && Catch::Contains("--look-at"));
}

TEST_CASE("views that say too little, too much or nonsense are refused") {
  const auto changed = [](ViewRequest request, auto change) {
    change(request);
    return request;
  };
  refused(changed(camera(), [](ViewRequest& r) { r.eye.reset(); }), "--eye");
  refused(changed(camera(), [](ViewRequest& r) { r.dir.reset(); }), "--dir");
  refused(changed(camera(), [](ViewRequest& r) { r.look_at = Vec3d{0, 0, 0}; }), "--dir");
  refused(changed(camera(), [](ViewRequest& r) { r.dir = Vec3d{0, 0, 0}; }), "direction");
  refused(changed(camera(), [](ViewRequest& r) { r.fovy_degrees = 180; }), "--fovy");
  refused(changed(camera(), [](ViewRequest& r) { r.fovy_degrees = 0; }), "--fovy");
  refused(changed(camera(), [](ViewRequest& r) { r.projection = Projection::parallel; }), "--window");
  refused(changed(camera(), [](ViewRequest& r) { r.window = Window{1, -1, 0, 1}; }), "window");
  refused(changed(verbatim(), [](ViewRequest& r) { r.up.reset(); }), "--up");
  refused(changed(verbatim(), [](ViewRequest& r) { r.window.reset(); }), "--window");
  refused(changed(verbatim(), [](ViewRequest& r) { r.dir = Vec3d{1, 0, 0}; }), "--dir");
  refused(changed(verbatim(), [](ViewRequest& r) { r.right = Vec3d{0, 0, 1}; }), "dependent");
}
