#include <fmt/format.h>

#include <ostream>

#include "provis/scene.hpp"
#include "src/scene/atomic_file.hpp"
#include "src/scene/little_endian.hpp"
#include "src/scene/ply_format.hpp"

namespace provis {
namespace {

/// Bytes of fixed-size records, handed to the stream a block at a time.
class RecordWriter {
 public:
  explicit RecordWriter(std::ostream& out) : out_(out) {}
  ~RecordWriter() { flush(); }

  template <class T>
  void add(T value) {
    const char* bytes = reinterpret_cast<const char*>(&value);
    block_.append(bytes, sizeof(T));
    if (block_.size() >= block_size) flush();
  }

  void add_point(const Vec3d& p) {
    add(p.x);
    add(p.y);
    add(p.z);
  }

 private:
  static constexpr std::size_t block_size = 1 << 16;

  void flush() {
    out_.write(block_.data(), static_cast<std::streamsize>(block_.size()));
    block_.clear();
  }

  std::ostream& out_;
  std::string block_;
};

std::string header(const Scene& scene) {
  return fmt::format(
      "ply\n"
      "format binary_little_endian 1.0\n"
      "comment {} {}\n"
      "comment flags: bit 0 single-sided, bit 1 see-through\n"
      "element vertex {}\n"
      "property double x\nproperty double y\nproperty double z\n"
      "element face {}\n"
      "property list uchar uint vertex_indices\nproperty uchar flags\n"
      "element sphere {}\n"
      "property double x\nproperty double y\nproperty double z\nproperty double radius\nproperty uchar "
      "flags\n"
      "end_header\n",
      ply_hash_comment, scene.hash(), scene.vertices().size(), scene.triangles().size(),
      scene.spheres().size());
}

}  // namespace

void export_ply(const Scene& scene, const std::filesystem::path& file) {
  AtomicFile output(file);
  output.stream() << header(scene);
  {
    RecordWriter records(output.stream());
    for (const Vec3d& vertex : scene.vertices()) records.add_point(vertex);
    for (std::size_t t = 0; t < scene.triangles().size(); ++t) {
      records.add(std::uint8_t{3});
      for (const std::uint32_t index : scene.triangles()[t]) records.add(index);
      records.add(scene.triangle_flags()[t]);
    }
    for (std::size_t s = 0; s < scene.spheres().size(); ++s) {
      records.add_point(scene.spheres()[s].center);
      records.add(scene.spheres()[s].radius);
      records.add(scene.sphere_flags()[s]);
    }
  }
  output.commit();
}

}  // namespace provis
