// --skip-invalid: what is left out, what is kept, and how ids lead back to rows.
#include <catch2/catch.hpp>

#include "provis/source.hpp"
#include "tests/scene/files.hpp"

namespace provis {
namespace {

const char xyz[] = "property float x\nproperty float y\nproperty float z\n";
const char faces[] = "property list uchar int vertex_indices\n";

std::string ply(const std::string& elements, const std::string& rows) {
  return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + rows;
}

LoadOptions skipping() {
  LoadOptions options;
  options.skip_invalid = true;
  return options;
}

Scene load(const std::string& text) { return load_content("scene.ply", text, skipping()); }

/// Four vertices and these rows of faces; the first row is line 14.
std::string with_faces(int count, const std::string& rows) {
  return ply(std::string("element vertex 4\n") + xyz + "element face " + std::to_string(count) + "\n" + faces,
             "0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + rows);
}

void check_left_out(const Scene& scene, const std::vector<std::pair<std::string, std::string>>& expected) {
  REQUIRE(scene.left_out().size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(scene.left_out()[i].place == expected[i].first);
    CHECK(scene.left_out()[i].reason == expected[i].second);
  }
}

std::uint32_t row_of(const Scene& scene, PrimitiveId id) { return source_of(scene, id)->element; }

TEST_CASE("faces with a wrong index or without corners are left out and listed") {
  const std::string text = with_faces(6, "3 0 1 2\n3 0 1 4\n0\n3 0 2 3\n4 0 1 2 -1\n4 0 1 2 3\n");
  CHECK_FAILURE(load_failure("scene.ply", text), 2, "line 15");
  const Scene scene = load(text);
  check_left_out(scene, {{"line 15", "face 1 uses vertex 4 of 4"},
                         {"line 16", "face 2 has no corners"},
                         {"line 18", "face 4 uses vertex -1 of 4"}});
  REQUIRE(scene.triangles().size() == 4);
  CHECK(scene.triangles()[1] == Triangle{0, 2, 3});
  CHECK(row_of(scene, 0) == 0);
  CHECK(row_of(scene, 1) == 3);
  CHECK(row_of(scene, 2) == 5);
  CHECK((row_of(scene, 3) == 5 && source_of(scene, 3)->part == 1));
}

TEST_CASE("what is left out is what the error would have said") {
  const std::string text = with_faces(1, "3 0 1 9\n");
  const Scene scene = load(text);
  const Failure failure = load_failure("scene.ply", text);
  REQUIRE(scene.left_out().size() == 1);
  CHECK(scene.left_out()[0].place == failure.place);
  CHECK_THAT(failure.message, Catch::EndsWith(scene.left_out()[0].place + ": " + scene.left_out()[0].reason));
}

TEST_CASE("ids lead back to rows whatever polygons stand there") {
  const Scene scene =
      load(with_faces(7, "3 0 1 2\n3 1 2 3\n4 0 1 2 3\n4 3 2 1 0\n2 0 1\n4 0 1 2 3\n3 0 2 3\n"));
  const std::uint32_t rows[] = {0, 1, 2, 2, 3, 3, 5, 5, 6};
  REQUIRE(scene.triangles().size() == 9);
  for (PrimitiveId id = 0; id < 9; ++id) CHECK(row_of(scene, id) == rows[id]);
  CHECK(scene.sources().size() == 4);
  CHECK(scene.skipped().lines == 1);
  CHECK(scene.notes().elements.at(static_cast<std::size_t>(scene.sources()[0].primitive)) == "face");
}

TEST_CASE("a vertex that is not finite keeps its place and takes its faces along") {
  const std::string text = ply(std::string("element vertex 4\n") + xyz + "element face 3\n" + faces,
                               "0 0 0\nnan 0 0\n1 1 0\n0 1 0\n3 0 2 3\n3 0 1 2\n3 3 2 0\n");
  CHECK_FAILURE(load_failure("scene.ply", text), 2, "line 11");
  const Scene scene = load(text);
  REQUIRE(scene.vertices().size() == 4);
  CHECK(scene.vertices()[1] == Vec3d{0, 0, 0});
  CHECK(scene.triangles()[1] == Triangle{3, 2, 0});
  check_left_out(scene, {{"line 15", "face 1 uses vertex 1, which is not finite"}});
}

TEST_CASE("the same where faces come before the vertices") {
  const std::string text = ply(std::string("element face 2\n") + faces + "element vertex 4\n" + xyz,
                               "3 0 1 2\n3 0 2 3\n0 0 0\n0 inf 0\n1 1 0\n0 1 0\n");
  CHECK_FAILURE(load_failure("scene.ply", text), 2, "line 13");
  const Scene scene = load(text);
  CHECK(scene.triangles().size() == 1);
  check_left_out(scene, {{"line 10", "face 0 uses vertex 1, which is not finite"}});
}

TEST_CASE("spheres that are none are left out, by row") {
  const std::string scalars = std::string(xyz) + "property float radius\n";
  const std::string rows = "0 0 0 1\nnan 0 0 1\n1 0 0 -1\n2 0 0 inf\n3 0 0 0\n4 0 0 nan\n5 0 0 2\n";
  for (const std::string element : {"sphere", "vertex"}) {
    const Scene scene = load(ply("element " + element + " 7\n" + scalars, rows));
    REQUIRE(scene.spheres().size() == 3);
    CHECK(scene.spheres()[2].center == Vec3d{5, 0, 0});
    CHECK((row_of(scene, 0) == 0 && row_of(scene, 1) == 4 && row_of(scene, 2) == 6));
    REQUIRE(scene.left_out().size() == 4);
    CHECK(scene.left_out()[1].place == "line 11");
    CHECK(scene.left_out()[1].reason == element + " 2 has radius -1");
  }
}

TEST_CASE("a sphere that moves out of the numbers is left out") {
  LoadOptions options = skipping();
  options.time = 10;
  const Scene scene = load_content(
      "scene.ply",
      ply("element sphere 2\nproperty double x\nproperty double y\nproperty double z\nproperty double "
          "radius\nproperty double vx\nproperty double vy\nproperty double vz\n",
          "0 0 0 1 1e308 0 0\n0 0 0 1 1 0 0\n"),
      options);
  CHECK(scene.spheres().size() == 1);
  CHECK(scene.left_out().size() == 1);
}

TEST_CASE("in a binary file the place is a byte") {
  const std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" + std::string(xyz) +
                             "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string body = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const auto face = [](std::int32_t last) {
    return bytes_of<std::uint8_t>({3}) + bytes_of<std::int32_t>({0, 1, last});
  };
  const Scene scene = load(header + body + face(7) + face(2));
  check_left_out(scene, {{"byte " + std::to_string(header.size() + 36), "face 0 uses vertex 7 of 3"}});
}

TEST_CASE("structure stays an error") {
  const auto fails = [](const std::string& text) {
    return failure_of([&] { load_content("scene.ply", text, skipping()); }).status;
  };
  CHECK(fails(with_faces(2, "3 0 1 2\n")) == 2);
  CHECK(fails(with_faces(1, "3 0 1 2\n3 0 1 2\n")) == 2);
  CHECK(fails(with_faces(1, "3 0 1 two\n")) == 2);
  CHECK(fails("ply\nformat ascii 1.0\nelement vertex x\nend_header\n") == 2);
  CHECK(fails(with_faces(1, "3 0 1 2\n")) == 0);
}

TEST_CASE("the lines of many left-out rows are counted right, whatever ends them") {
  std::string rows;
  for (int i = 0; i < 1000; ++i) rows += "3 0 1\n 9\n\n";
  const Scene scene = load(with_faces(1000, rows));
  REQUIRE(scene.left_out().size() == 1000);
  for (std::size_t i = 0; i < 1000; ++i)
    CHECK(scene.left_out()[i].place == "line " + std::to_string(14 + 3 * i));
}

TEST_CASE("a list of a million is long enough") {
  const auto zeros = [](std::size_t count) {
    std::string text = "ply\nformat binary_little_endian 1.0\nelement face " + std::to_string(count) +
                       "\nproperty list uchar uchar vertex_indices\nend_header\n";
    return text.append(count, '\0');
  };
  CHECK(load(zeros(1000000)).left_out().size() == 1000000);
  const Failure failure = load_failure("scene.ply", zeros(1000001), skipping());
  CHECK(failure.status == 3);
  CHECK_THAT(failure.place, Catch::StartsWith("byte "));
}

TEST_CASE("an exported file with a broken face loads without it, hash or not") {
  const TempFolder folder;
  const auto file = folder.path() / "x.ply";
  export_ply(load(with_faces(2, "3 0 1 2\n3 0 2 3\n")), file);
  std::string text = read_text(file);
  text.replace(text.size() - 5, 1, "\x63");  // the low byte of the last face's last index
  CHECK(load_failure("x.ply", text).status == 2);
  const Scene scene = load_content("x.ply", text, skipping());
  CHECK(scene.triangles().size() == 1);
  CHECK(scene.left_out().size() == 1);
}

}  // namespace
}  // namespace provis
