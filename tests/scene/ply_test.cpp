// PLY in all encodings, types and shapes.
#include <catch2/catch.hpp>

#include "tests/scene/gltf_builder.hpp"

namespace provis {
namespace {

Scene load_ply_text(const std::string& text, const LoadOptions& options = {}) {
  return load_content("scene.ply", text, options);
}

const char square[] =
    "ply\nformat ascii 1.0\ncomment a square\nobj_info nothing\nelement vertex 4\nproperty float x\nproperty "
    "float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

template <class T>
std::string swapped(T value) {
  std::string bytes = bytes_of({value});
  return {bytes.rbegin(), bytes.rend()};
}

TEST_CASE("a polygon becomes a fan around its first corner") {
  const Scene scene = load_ply_text(square);
  REQUIRE(scene.triangles().size() == 2);
  CHECK(scene.triangles()[0] == Triangle{0, 1, 2});
  CHECK(scene.triangles()[1] == Triangle{0, 2, 3});
  CHECK(scene.triangle_flags()[0] == 0);
  CHECK(scene.skipped().points == 0);
  REQUIRE(scene.sources().size() == 1);
  CHECK(scene.sources()[0].count == 2);
  CHECK(scene.sources()[0].node == -1);
}

TEST_CASE("lines of a PLY file may end in any of three ways") {
  const std::string hash = load_ply_text(square).hash();
  for (const std::string end : {"\r\n", "\r"}) {
    std::string text;
    for (const char c : std::string(square)) text += c == '\n' ? end : std::string(1, c);
    CHECK(load_ply_text(text).hash() == hash);
  }
  std::string last = square;
  last.pop_back();
  CHECK(load_ply_text(last).hash() == hash);
}

TEST_CASE("white space around words does not matter") {
  std::string text = square;
  text.replace(text.find("element face 1"), 14, " \telement   face\t1 ");
  text.replace(text.find("end_header"), 10, "  end_header ");
  text.replace(text.find("0 1 0\n4"), 6, "\n 0\n1   0 \n\n");
  CHECK(load_ply_text(text).hash() == load_ply_text(square).hash());
}

TEST_CASE("ASCII numbers are rounded once, to the declared type") {
  const auto vertex = [](const std::string& type, const std::string& x) {
    return load_ply_text("ply\nformat ascii 1.0\nelement vertex 1\nproperty " + type +
                         " x\nproperty float y\n"
                         "property float z\nend_header\n" +
                         x + " 0 0\n")
        .vertices()[0]
        .x;
  };
  CHECK(vertex("float", "0.1") == 0.1f);
  CHECK(vertex("double", "0.1") == 0.1);
  CHECK(vertex("float64", "+1e-3") == 1e-3);
  CHECK(vertex("double", "4.9e-324") == 4.9e-324);
  CHECK(vertex("double", "1e-400") == 0);
  CHECK(vertex("double", "2.2250738585072011e-308") == 2.2250738585072011e-308);
  CHECK(vertex("int", "-2147483648") == -2147483648.0);
  CHECK(vertex("uint8", "255") == 255);
}

/// One triangle whose coordinates are 1 to 9, in a binary encoding, every scalar of type T.
template <class T>
std::string binary_triangle(const std::string& type, bool big_endian) {
  std::string header = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                       "_endian 1.0\nelement vertex 3\n";
  for (const char* name : {"x", "y", "z"}) header += "property " + type + " " + name + "\n";
  header += "element face 1\nproperty list ushort int vertex_index\nend_header\n";
  const auto number = [big_endian](auto value) { return big_endian ? swapped(value) : bytes_of({value}); };
  for (int i = 1; i <= 9; ++i) header += number(static_cast<T>(i));
  header += number(std::uint16_t{3});
  for (const std::int32_t i : {2, 0, 1}) header += number(i);
  return header;
}

template <class T>
void check_binary(const std::string& type) {
  for (const bool big_endian : {false, true}) {
    const Scene scene = load_ply_text(binary_triangle<T>(type, big_endian));
    CAPTURE(type, big_endian);
    REQUIRE(scene.triangles().size() == 1);
    CHECK(scene.corner(0, 0) == Vec3d{7, 8, 9});
    CHECK(scene.corner(0, 1) == Vec3d{1, 2, 3});
  }
}

TEST_CASE("binary scalars of every type are read in both byte orders") {
  check_binary<std::int8_t>("char");
  check_binary<std::uint8_t>("uint8");
  check_binary<std::int16_t>("short");
  check_binary<std::uint16_t>("uint16");
  check_binary<std::int32_t>("int");
  check_binary<std::uint32_t>("uint32");
  check_binary<float>("float");
  check_binary<double>("float64");
}

TEST_CASE("a binary body may begin with a byte that looks like a line end") {
  std::string text = binary_triangle<std::uint8_t>("uchar", false);
  text[text.find("end_header\n") + 11] = '\n';
  CHECK(load_ply_text(text).vertices()[0] == Vec3d{10, 2, 3});
  text.replace(text.find("end_header\n"), 11, "end_header\r\n");
  CHECK(load_ply_text(text).vertices()[0] == Vec3d{10, 2, 3});
}

TEST_CASE("unknown elements and properties are passed over") {
  const Scene scene = load_ply_text(
      "ply\nformat ascii 1.0\nelement material 2\nproperty list uchar float colour\nproperty int id\nelement "
      "vertex 3\n"
      "property uchar red\nproperty float x\nproperty list uchar int links\nproperty float y\nproperty float "
      "z\n"
      "property int flags\nelement face 1\nproperty float quality\nproperty list uchar int vertex_indices\n"
      "property int flags\nelement edge 2\nproperty int vertex1\nproperty int vertex2\nend_header\n"
      "2 0.5 0.5 7\n0 8\n255 0 1 2 0 0 64\n255 1 0 0 0 64\n255 0 2 5 6 1 0 64\n0.5 3 0 1 2 64\n0 1\n1 2\n");
  REQUIRE(scene.triangles().size() == 1);
  CHECK(scene.corner(0, 2) == Vec3d{0, 1, 0});
  CHECK(scene.triangle_flags()[0] == 0);
  CHECK(scene.skipped().lines == 2);
}

TEST_CASE("our flags are resolved by --sides and --opacity") {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face 2\n"
      "property list uchar int vertex_indices\nproperty uchar flags\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 "
      "2 3\n3 2 1 0 2\n";
  const Scene scene = load_ply_text(text);
  CHECK(scene.triangle_flags()[0] == (single_sided | see_through));
  CHECK(scene.triangle_flags()[1] == see_through);
  CHECK(load_ply_text(text, {Sides::both, Opacity::material}).triangle_flags()[0] == see_through);
  CHECK(load_ply_text(text, {Sides::material, Opacity::all}).triangle_flags()[0] == single_sided);
}

TEST_CASE("spheres come as an element of their own or as vertices with a radius") {
  const std::string scalars = "property float x\nproperty float y\nproperty float z\nproperty float radius\n";
  for (const std::string element : {"sphere", "vertex"}) {
    const Scene scene = load_ply_text("ply\nformat ascii 1.0\nelement " + element + " 2\n" + scalars +
                                      "end_header\n1 2 3 0.5\n4 5 6 0\n");
    REQUIRE(scene.spheres().size() == 2);
    CHECK(scene.spheres()[1].center == Vec3d{4, 5, 6});
    CHECK(scene.spheres()[0].radius == 0.5);
    // R4: seen and occluding from outside only
    CHECK(scene.sphere_flags()[0] == single_sided);
    CHECK(scene.skipped().points == 0);
  }
}

TEST_CASE("vertices without faces and faces without surface are skipped, and counted") {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  CHECK(load_ply_text(header + "end_header\n" + vertices).skipped().points == 3);
  const Scene scene =
      load_ply_text(header + "element face 3\nproperty list uchar int vertex_indices\nend_header\n" +
                    vertices + "1 0\n2 0 1\n3 0 1 2\n");
  CHECK(scene.triangles().size() == 1);
  CHECK(scene.skipped().points == 1);
  CHECK(scene.skipped().lines == 1);
}

TEST_CASE("faces may come before the vertices they name") {
  const Scene scene = load_ply_text(
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nelement vertex "
      "3\nproperty float x\n"
      "property float y\nproperty float z\nend_header\n3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n");
  CHECK(scene.triangles().size() == 1);
}

}  // namespace
}  // namespace provis
