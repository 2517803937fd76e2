// Measures Embree: building its tree over the scene, then 1, 16 and 256 rays through each pixel.
// Embree computes in float32 and proves nothing; the coordinates are taken relative to the eye before they
// are rounded, which is the best that can be done for it.

#include <embree3/rtcore.h>

#include <array>
#include <atomic>
#include <limits>
#include <memory>

#include "provis/error.hpp"
#include "src/scene/parallel.hpp"
#include "tools/bench/child.hpp"

namespace provis::bench {

namespace {

/// The scene as Embree has it.
class Tree {
 public:
  Tree(const Scene& scene, const Vec3d& eye, int threads);

  /// Builds it anew; this alone is measured as the build.
  void build();

  RTCScene get() const { return scene_.get(); }

 private:
  template <class T, void (*release)(T*)>
  struct Releaser {
    void operator()(T* t) const { release(t); }
  };
  std::unique_ptr<RTCDeviceTy, Releaser<RTCDeviceTy, rtcReleaseDevice>> device_;
  std::unique_ptr<RTCGeometryTy, Releaser<RTCGeometryTy, rtcReleaseGeometry>> mesh_;
  std::unique_ptr<RTCSceneTy, Releaser<RTCSceneTy, rtcReleaseScene>> scene_;
};

Tree::Tree(const Scene& scene, const Vec3d& eye, int threads)
    : device_(rtcNewDevice(("threads=" + std::to_string(threads)).c_str())),
      mesh_(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE)) {
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      mesh_.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), scene.vertices().size()));
  for (const Vec3d& p : scene.vertices())
    for (const double v : {p.x - eye.x, p.y - eye.y, p.z - eye.z}) *vertices++ = static_cast<float>(v);
  rtcSetSharedGeometryBuffer(mesh_.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             scene.triangles().data(), 0, sizeof(Triangle), scene.triangles().size());
  rtcCommitGeometry(mesh_.get());
}

void Tree::build() {
  scene_.reset();
  scene_.reset(rtcNewScene(device_.get()));
  rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_MEDIUM);
  rtcAttachGeometry(scene_.get(), mesh_.get());
  rtcCommitScene(scene_.get());
  if (const RTCError error = rtcGetDeviceError(device_.get()); error != RTC_ERROR_NONE)
    throw Error(Error::Code::internal, "Embree", "error " + std::to_string(error));
}

/// A regular grid of rays, side by side in packets of 4 by 2.
class Sampler {
 public:
  Sampler(const Tree& tree, const PointView& view, int per_axis)
      : tree_(tree), frame_(view.frames.front()), columns_(width * per_axis), rows_(height * per_axis) {}

  std::vector<std::uint8_t> seen(std::size_t triangles, const Context& context) const {
    std::vector<std::uint8_t> flags(triangles, 0);
    on_threads(context, [&] {
      parallel_for((static_cast<std::size_t>(rows_) + 1) / 2, [&](std::size_t pair) {
        for (int x = 0; x < columns_; x += 4) trace(x, static_cast<int>(2 * pair), flags);
      });
      return 0;
    });
    return flags;
  }

 private:
  void trace(int x, int y, std::vector<std::uint8_t>& flags) const {
    alignas(32) RTCRayHit8 packet{};
    alignas(32) std::array<int, 8> valid{};
    for (int k = 0; k < 8; ++k) {
      const int column = x + k % 4, row = y + k / 4;
      const auto slot = static_cast<std::size_t>(k);
      valid[slot] = column < columns_ && row < rows_ ? -1 : 0;
      const Window& w = frame_.window;
      const Vec3d d = frame_.forward + (w.x0 + (column + 0.5) * ((w.x1 - w.x0) / columns_)) * frame_.right +
                      (w.y0 + (row + 0.5) * ((w.y1 - w.y0) / rows_)) * frame_.up;
      packet.ray.dir_x[slot] = static_cast<float>(d.x);
      packet.ray.dir_y[slot] = static_cast<float>(d.y);
      packet.ray.dir_z[slot] = static_cast<float>(d.z);
      packet.ray.tfar[slot] = std::numeric_limits<float>::infinity();
      packet.ray.mask[slot] = ~0u;
      packet.hit.geomID[slot] = packet.hit.primID[slot] = RTC_INVALID_GEOMETRY_ID;
      packet.hit.instID[0][slot] = RTC_INVALID_GEOMETRY_ID;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect8(valid.data(), tree_.get(), &context, &packet);
    for (std::size_t k = 0; k < 8; ++k)
      if (valid[k] != 0 && packet.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID) mark(flags[packet.hit.primID[k]]);
  }

  static void mark(std::uint8_t& flag) {
    const std::atomic_ref<std::uint8_t> shared(flag);
    if (shared.load(std::memory_order_relaxed) == 0) shared.store(1, std::memory_order_relaxed);
  }

  const Tree& tree_;
  const Frame& frame_;
  int columns_, rows_;
};

int run(int argc, char** argv) {
  Child child("bench_embree");
  return child.run(argc, argv, [](const Child& c) {
    Tree tree(c.scene(), c.view().eye, c.threads());
    nlohmann::json result = c.measured([&] { tree.build(); });
    result["samples"] = nlohmann::json::array();
    double last = 0;
    for (const int per_axis : {1, 4, 16}) {
      nlohmann::json entry = {{"per_pixel", per_axis * per_axis}};
      if (16 * last > c.budget()) {
        entry["unavailable"] = "over the budget";
      } else {
        std::vector<std::uint8_t> seen;
        const Sampler sampler(tree, c.view(), per_axis);
        entry.update(c.measured([&] { seen = sampler.seen(c.scene().triangles().size(), c.context()); }));
        entry.update(c.found(flagged(seen)));
        last = entry["cpu"].front();
      }
      result["samples"].push_back(entry);
    }
    return result;
  });
}

}  // namespace

}  // namespace provis::bench

int main(int argc, char** argv) { return provis::bench::run(argc, argv); }
