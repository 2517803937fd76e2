#include "tools/scenes/ply_mesh.hpp"

#include <fmt/format.h>

namespace provis::scenes {

namespace {

constexpr std::size_t block_size = 1 << 20;

// cos 0.1 and sin 0.1; constants, because libraries of mathematics differ in the last bit.
constexpr double cosine = 0.99500416527802576610, sine = 0.09983341664682815231;

}  // namespace

template <class T>
void Mesh::put(T value) {
  block_.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

void Mesh::flush() {
  out_.write(block_.data(), static_cast<std::streamsize>(block_.size()));
  block_.clear();
}

void Mesh::write_vertex(const Point& p) {
  const double x = form_.unit * p.x, y = form_.unit * p.y, z = form_.unit * p.z;
  if (form_.rotated) {
    put(cosine * x + sine * z);
    put(y);
    put(cosine * z - sine * x);
  } else {
    for (const double v : {x, y, z}) put(static_cast<float>(v));
  }
  if (block_.size() >= block_size) flush();
}

void Mesh::write_face(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  put(std::uint8_t{3});
  for (const std::uint32_t index : {a, b, c}) put(index);
  if (block_.size() >= block_size) flush();
}

void write_ply(std::ostream& out, const std::function<void(Mesh&)>& generator, const PlyForm& form) {
  Mesh counted(Mesh::Pass::count, form, out);
  generator(counted);
  out << fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment {0}\nelement vertex {1}\n"
      "property {2} x\nproperty {2} y\nproperty {2} z\n"
      "element face {3}\nproperty list uchar uint vertex_indices\nend_header\n",
      form.comment, counted.vertices_, form.rotated ? "double" : "float", counted.triangles_);
  for (const Mesh::Pass pass : {Mesh::Pass::vertices, Mesh::Pass::faces}) {
    Mesh mesh(pass, form, out);
    generator(mesh);
    mesh.flush();
  }
}

}  // namespace provis::scenes
