#include "tests/segment/engine_cases.hpp"

#include <sstream>

#include "tests/support/generator.hpp"
#include "tests/support/random.hpp"

namespace provis::test {

EngineCase generate_engine_case(std::uint64_t seed) {
  EngineCase c{generate(seed), {}};
  Random random(seed ^ 0x5e6e47u);
  const PointView& view = c.scene.view;
  c.view.frames = view.frames;
  c.view.from = view.eye;
  const Vec3d& corner = random.pick_from(c.scene.arrays.vertices);
  switch (random.between(0, 7)) {
    case 0:
      c.view.to = view.eye;
      break;
    case 1:
      c.view.to = corner;
      break;
    case 2: {
      // Along an edge of the scene, which it may even run on.
      const Triangle& t = random.pick_from(c.scene.arrays.triangles);
      c.view.from = c.scene.arrays.vertices[t[0]];
      c.view.to = c.scene.arrays.vertices[t[1]];
      break;
    }
    case 3:
      c.view.to = view.eye + view.frames.front().forward;
      break;
    case 4:
      c.view.to = view.eye + (corner - view.eye) + (corner - view.eye);
      break;
    default: {
      const Vec3d step = random.lattice(3);
      c.view.to = view.eye + step;
    }
  }
  c.view.pixels = {random.between(1, 7), random.between(1, 5)};
  if (random.chance(25)) c.view.pixels = {random.between(15, 20), random.between(15, 18)};
  return c;
}

std::string describe(const EngineCase& c) {
  std::ostringstream out;
  out << std::hexfloat << "from " << c.view.from.x << ' ' << c.view.from.y << ' ' << c.view.from.z << " to "
      << c.view.to.x << ' ' << c.view.to.y << ' ' << c.view.to.z << ", " << c.view.pixels.width << 'x'
      << c.view.pixels.height << " pixels\n"
      << describe(c.scene);
  return out.str();
}

PrintedAnswer answer(const Scene& scene, const SegmentView& view, SegmentOptions options,
                     const Context& context) {
  PrintedAnswer a;
  options.on_pixel = [&](const PixelSights& p) {
    std::ostringstream line;
    line << p.frame << ' ' << p.column << ' ' << p.row << ':';
    for (const Sight& s : p.sights) {
      line << " [" << s.from << ' ' << s.to << ']';
      for (const PrimitiveId id : s.visible) line << ' ' << id;
    }
    a.sights.push_back(line.str());
  };
  const SegmentSet set = visible_from_segment(scene, view, options, context);
  a.visible = set.set.with(Status::visible);
  a.boundary = set.boundary;
  for (const Seen& s : set.seen) a.pixels.push_back(s.pixels);
  return a;
}

}  // namespace provis::test
