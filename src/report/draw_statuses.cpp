// The view by status: what is hidden lies behind what is seen, so depth decides only among equals.

#include <algorithm>
#include <cmath>
#include <limits>

#include "provis/draw.hpp"
#include "provis/error.hpp"
#include "src/report/colors.hpp"
#include "src/report/footprint.hpp"
#include "src/report/picture.hpp"
#include "src/scene/parallel.hpp"

namespace provis {

namespace {

constexpr int band_rows = 16;

struct Nearest {
  double nearness = -std::numeric_limits<double>::infinity();
  const Footprint* footprint = nullptr;

  void offer(double at, const Footprint& f) {
    if (at > nearness) *this = {at, &f};
  }
};

/// What lies on one pixel's line of sight.
struct Stack {
  int hidden = 0;
  Nearest visible, undecided;
};

class StatusPicture {
 public:
  StatusPicture(const Scene& scene, const VisibleSet& set, const Raster& raster)
      : scene_(scene), set_(set), raster_(raster) {
    for (PrimitiveId id = 0; id < set.status.size(); ++id)
      if (const auto f = Footprint::of(scene, id, raster)) footprints_.push_back(*f);
  }

  void draw(int band, Image& image) const;

 private:
  void add(const Footprint& f, Stack& stack, double nearness) const;
  Color color(const Stack& stack, const Vec3d& centre) const;

  const Scene& scene_;
  const VisibleSet& set_;
  const Raster& raster_;
  std::vector<Footprint> footprints_;  ///< in id order: of equal nearness the smaller id wins
};

void StatusPicture::add(const Footprint& f, Stack& stack, double nearness) const {
  switch (set_.status[f.id()]) {
    case Status::hidden:
      ++stack.hidden;
      break;
    case Status::undecided:
      stack.undecided.offer(nearness, f);
      break;
    case Status::visible:
      stack.visible.offer(nearness, f);
  }
}

Color StatusPicture::color(const Stack& stack, const Vec3d& centre) const {
  const auto shaded = [&](const Color& c, const Nearest& n) {
    return scaled(c, facing_shade(n.footprint->cosine(scene_, raster_, centre)));
  };
  Color color = blend(background_color, hidden_color, 0.6 * (1 - std::pow(0.75, stack.hidden)));
  if (stack.visible.footprint) color = blend(color, shaded(visible_high_color, stack.visible), 0.8);
  if (stack.undecided.footprint) color = blend(color, shaded(undecided_color, stack.undecided), 0.6);
  return color;
}

void StatusPicture::draw(int band, Image& image) const {
  const int first = band * band_rows, last = std::min(raster_.height(), first + band_rows);
  const auto width = static_cast<std::size_t>(raster_.width());
  std::vector<Stack> stacks(static_cast<std::size_t>(last - first) * width);
  for (const Footprint& f : footprints_)
    for (int row = std::max(f.box().y0, first); row < std::min(f.box().y1, last); ++row)
      for (int column = f.box().x0; column < f.box().x1; ++column)
        if (const auto nearness = f.nearness(raster_, raster_.centre(column, row)))
          add(f, stacks[static_cast<std::size_t>(row - first) * width + static_cast<std::size_t>(column)],
              *nearness);
  for (int row = first; row < last; ++row)
    for (int column = 0; column < raster_.width(); ++column)
      set_pixel(
          image, column, row,
          color(stacks[static_cast<std::size_t>(row - first) * width + static_cast<std::size_t>(column)],
                raster_.centre(column, row)));
}

}  // namespace

Image draw_statuses(const Scene& scene, const VisibleSet& set, const PointView& view, int frame, int width,
                    int height) {
  require_match(scene, set);
  if (frame < 0 || frame >= static_cast<int>(view.frames.size()))
    throw Error(Error::Code::usage, "frame", "the view has no frame of that number");
  Image image = blank_image(width, height);
  const Raster raster(view.eye, view.projection, view.frames[static_cast<std::size_t>(frame)], width, height);
  const StatusPicture picture(scene, set, raster);
  parallel_for(static_cast<std::size_t>((height + band_rows - 1) / band_rows),
               [&](std::size_t band) { picture.draw(static_cast<int>(band), image); });
  return image;
}

}  // namespace provis
