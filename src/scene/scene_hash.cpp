#include "src/scene/scene_hash.hpp"

#include <openssl/evp.h>

#include <array>
#include <cstring>
#include <memory>
#include <new>

#include "src/scene/failure.hpp"
#include "src/scene/little_endian.hpp"

namespace provis {
namespace {

/// SHA-256 behind a small buffer, so that single numbers can be added cheaply.
class Digest {
 public:
  Digest() : context_(EVP_MD_CTX_new(), &EVP_MD_CTX_free) {
    if (!context_) throw std::bad_alloc();
    require(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
  }

  void add_bytes(const void* data, std::size_t size) {
    flush();
    require(EVP_DigestUpdate(context_.get(), data, size));
  }

  template <class T>
  void add(T value) {
    if (used_ + sizeof(T) > buffer_.size()) flush();
    std::memcpy(buffer_.data() + used_, &value, sizeof(T));
    used_ += sizeof(T);
  }

  /// -0 and +0 are one number, so they must have one hash.
  void add_coordinate(double x) { add(x == 0 ? 0.0 : x); }

  void add_point(const Vec3d& p) {
    add_coordinate(p.x);
    add_coordinate(p.y);
    add_coordinate(p.z);
  }

  std::string hex() {
    flush();
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned int size = 0;
    require(EVP_DigestFinal_ex(context_.get(), digest.data(), &size));
    std::string text;
    for (unsigned int i = 0; i < size; ++i) {
      text += "0123456789abcdef"[digest[i] >> 4];
      text += "0123456789abcdef"[digest[i] & 15];
    }
    return text;
  }

 private:
  static void require(int ok) {
    if (ok != 1) throw Error(Error::Code::internal, "SHA-256", "libcrypto refused to compute a digest");
  }

  void flush() {
    require(EVP_DigestUpdate(context_.get(), buffer_.data(), used_));
    used_ = 0;
  }

  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
  std::array<unsigned char, 1 << 15> buffer_;
  std::size_t used_ = 0;
};

}  // namespace

std::string scene_hash(const SceneArrays& arrays) {
  Digest digest;
  digest.add_bytes("provis-scene-1", sizeof("provis-scene-1"));  // with its final zero byte
  digest.add(static_cast<std::uint64_t>(arrays.vertices.size()));
  digest.add(static_cast<std::uint64_t>(arrays.triangles.size()));
  digest.add(static_cast<std::uint64_t>(arrays.spheres.size()));
  for (const Vec3d& vertex : arrays.vertices) digest.add_point(vertex);
  digest.add_bytes(arrays.triangles.data(), arrays.triangles.size() * sizeof(Triangle));
  digest.add_bytes(arrays.triangle_flags.data(), arrays.triangle_flags.size());
  for (std::size_t i = 0; i < arrays.spheres.size(); ++i) {
    digest.add_point(arrays.spheres[i].center);
    digest.add_coordinate(arrays.spheres[i].radius);
    digest.add(arrays.sphere_flags[i]);
  }
  return digest.hex();
}

std::string bytes_hash(ByteSpan bytes) {
  Digest digest;
  digest.add_bytes(bytes.data(), bytes.size());
  return digest.hex();
}

}  // namespace provis
