// PLY files that are not what they say: the expected code and place for each.
#include <catch2/catch.hpp>

#include "tests/scene/files.hpp"

namespace provis {
namespace {

Failure ply_failure(const std::string& text) { return load_failure("scene.ply", text); }

const char start[] = "ply\nformat ascii 1.0\n";
const char vertex_3[] = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const char face_1[] = "element face 1\nproperty list uchar int vertex_indices\n";
const char vertices[] = "0 0 0\n1 0 0\n0 1 0\n";

std::string with_header(const std::string& lines) { return start + lines + "end_header\n"; }

TEST_CASE("broken PLY headers are errors that name the line") {
  CHECK_FAILURE(ply_failure("ply\n"), 2, "line 2");
  CHECK_FAILURE(ply_failure("ply\nend_header\n"), 2, "line 2");
  CHECK_FAILURE(ply_failure("ply\nformat ascii\nend_header\n"), 2, "line 2");
  CHECK_FAILURE(ply_failure("ply\nformat binary_mixed_endian 1.0\nend_header\n"), 2, "line 2");
  CHECK_FAILURE(ply_failure("ply\nformat ascii 2.0\nend_header\n"), 3, "line 2");
  CHECK_FAILURE(ply_failure("ply\nelement vertex 0\nformat ascii 1.0\nend_header\n"), 2, "line 2");
  CHECK_FAILURE(ply_failure(with_header("format ascii 1.0\n")), 2, "line 3");
  CHECK_FAILURE(ply_failure(with_header("elephant vertex 3\n")), 2, "line 3");
  CHECK_FAILURE(ply_failure(with_header("element vertex\n")), 2, "line 3");
  CHECK_FAILURE(ply_failure(with_header("element vertex three\n")), 2, "line 3");
  CHECK_FAILURE(ply_failure(with_header("element vertex -3\n")), 2, "line 3");
  CHECK_FAILURE(ply_failure(with_header("element vertex 99999999999999999999\n")), 2, "line 3");
  CHECK_FAILURE(ply_failure(with_header("property float x\n")), 2, "line 3");
  CHECK_FAILURE(ply_failure(with_header("element vertex 0\nproperty float16 x\n")), 2, "line 4");
  CHECK_FAILURE(ply_failure(with_header("element vertex 0\nproperty float\n")), 2, "line 4");
  CHECK_FAILURE(ply_failure(with_header("element vertex 0\nproperty list float int x\n")), 2, "line 4");
  CHECK_FAILURE(ply_failure(with_header("element vertex 0\nproperty float x\nproperty float x\n")), 2,
                "line 5");
  CHECK_FAILURE(ply_failure(with_header(std::string(vertex_3) + vertex_3)), 2, "line 7");
}

TEST_CASE("elements without what makes them geometry are errors that name their line") {
  CHECK_FAILURE(ply_failure(with_header("element vertex 0\nproperty float x\nproperty float z\n")), 2,
                "line 3");
  CHECK_FAILURE(ply_failure(with_header("element vertex 0\nproperty list int float x\n")), 2, "line 3");
  CHECK_FAILURE(ply_failure(with_header("element face 0\nproperty list uchar int corners\n")), 2, "line 3");
  CHECK_FAILURE(ply_failure(with_header("element face 0\nproperty list uchar float vertex_indices\n")), 2,
                "line 3");
  CHECK_FAILURE(ply_failure(with_header("element sphere 0\nproperty float x\n")), 2, "line 3");
}

TEST_CASE("geometry in elements that are not read is unsupported") {
  CHECK_FAILURE(
      ply_failure(with_header("element tristrips 1\nproperty list int int vertex_indices\n") + "3 0 1 2\n"),
      3, "line 3");
  CHECK_FAILURE(
      ply_failure(with_header("element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                              "property float radius\n" +
                              std::string(face_1)) +
                  "0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n"),
      3, "line 3");
}

TEST_CASE("broken ASCII bodies are errors that name the line") {
  const std::string header = with_header(std::string(vertex_3) + face_1);  // 9 lines
  CHECK(ply_failure(header + vertices + "3 0 1 2\n").status == 0);
  CHECK_FAILURE(ply_failure(header + vertices), 2, "line 13");
  CHECK_FAILURE(ply_failure(header + vertices + "3 0 1\n"), 2, "line 14");
  CHECK_FAILURE(ply_failure(header + "0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n"), 2, "line 11");
  CHECK_FAILURE(ply_failure(header + "0 0 0\n1 0\n0 1 0\n3 0 1 2\n"), 2, "line 12");
  CHECK_FAILURE(ply_failure(header + "0 0 0\n1 0 0 0\n0 1 0\n3 0 1 2\n"), 2, "line 11");
  CHECK_FAILURE(ply_failure(header + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"), 2, "line 11");
  CHECK_FAILURE(ply_failure(header + "0 0 0\n1 0 0\n0 1 1e39\n3 0 1 2\n"), 2, "line 12");
  CHECK_FAILURE(ply_failure(header + vertices + "3 0 1 3\n"), 2, "line 13");
  CHECK_FAILURE(ply_failure(header + vertices + "3 0 1 -1\n"), 2, "line 13");
  CHECK_FAILURE(ply_failure(header + vertices + "3 0 1 1.5\n"), 2, "line 13");
  CHECK_FAILURE(ply_failure(header + vertices + "300 0 1 2\n"), 2, "line 13");
  CHECK_FAILURE(ply_failure(header + vertices + "0\n"), 2, "line 13");
  CHECK_FAILURE(ply_failure(header + vertices + "3 0 1 2\n3 0 1 2\n"), 2, "line 14");
}

std::string binary_header(const std::string& elements) {
  return "ply\nformat binary_little_endian 1.0\n" + elements + "end_header\n";
}

TEST_CASE("broken binary bodies are errors that name the byte") {
  const std::string header = binary_header(std::string(vertex_3) + face_1);
  const std::string body = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const std::string face = bytes_of<std::uint8_t>({3}) + bytes_of<std::int32_t>({0, 1, 2});
  const auto byte = [&](std::size_t offset) { return "byte " + std::to_string(header.size() + offset); };
  CHECK(ply_failure(header + body + face).status == 0);
  CHECK(ply_failure(header + body + face + "\n").status == 0);
  CHECK_FAILURE(ply_failure(header + body.substr(1)), 2, byte(0));
  CHECK_FAILURE(ply_failure(header + body), 2, byte(36));
  CHECK_FAILURE(ply_failure(header + body + face.substr(0, 12)), 2, byte(45));
  CHECK_FAILURE(ply_failure(header + body + face + face), 2, byte(49));
  CHECK_FAILURE(ply_failure(header + body + bytes_of<std::uint8_t>({3}) + bytes_of<std::int32_t>({0, 1, 9})),
                2, byte(36));
  CHECK_FAILURE(ply_failure(header + body + bytes_of<std::uint8_t>({0})), 2, byte(36));
}

TEST_CASE("a list of negative length is an error") {
  const std::string header =
      binary_header(std::string(vertex_3) + "element face 1\nproperty list char int vertex_indices\n");
  const std::string body(36, '\0');
  CHECK_FAILURE(ply_failure(header + body + "\xFF"), 2, "byte " + std::to_string(header.size() + 36));
}

TEST_CASE("absurd counts are refused before memory is taken") {
  const std::string body(100, '\0');
  const std::string many = "18446744073709551615";
  const std::string vertex =
      "element vertex " + many + "\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string face = "element face " + many + "\nproperty list uchar int vertex_indices\n";
  const std::string other = "element other " + many + "\nproperty char x\n";
  for (const std::string& element : {vertex, face, other}) {
    const std::string binary = binary_header(element);
    CHECK_FAILURE(ply_failure(binary + body), 2, "byte " + std::to_string(binary.size()));
    CHECK(ply_failure(with_header(element) + "0 0 0\n").status == 2);
  }
  // A list that claims four billion items.
  const std::string header = binary_header("element other 1\nproperty list uint double x\n");
  CHECK(ply_failure(header + std::string(64, '\xFF')).status == 2);
}

TEST_CASE("elements without properties take neither time nor memory") {
  CHECK(ply_failure(with_header("element nothing 18446744073709551615\n")).status == 0);
}

TEST_CASE("unknown flag bits and bad radii are errors") {
  const std::string flagged = with_header(vertex_3 + std::string(face_1) + "property uchar flags\n");
  CHECK_FAILURE(ply_failure(flagged + vertices + "3 0 1 2 4\n"), 2, "line 14");
  const std::string spheres = with_header(
      "element sphere 1\nproperty float x\nproperty float y\nproperty float z\nproperty float radius\n");
  CHECK_FAILURE(ply_failure(spheres + "0 0 0 -1\n"), 2, "line 9");
  CHECK_FAILURE(ply_failure(spheres + "0 0 0 nan\n"), 2, "line 9");
  CHECK_FAILURE(ply_failure(spheres + "0 inf 0 1\n"), 2, "line 9");
}

}  // namespace
}  // namespace provis
