// The view: a z-buffer over pixel centres, one band of rows per task, colours put on afterwards.

#include <algorithm>
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
constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

// A see-through surface in front of a pixel.
struct Veil {
  int pixel;
  double nearness;
  std::uint32_t footprint;
};

// Everything that is drawn through one frame, opaque and see-through, by band.
struct Layers {
  std::vector<Footprint> footprints;
  std::vector<bool> see_through;
  std::vector<std::vector<std::uint32_t>> by_band;
};

bool lets_light_through(const Scene& scene, PrimitiveId id) {
  const std::size_t triangles = scene.triangles().size();
  const std::uint8_t flags =
      id < triangles ? scene.triangle_flags()[id] : scene.sphere_flags()[id - triangles];
  return (flags & PrimitiveFlag::see_through) != 0;
}

Layers visible_layers(const Scene& scene, const VisibleSet& set, const Raster& raster) {
  Layers layers;
  layers.by_band.resize(static_cast<std::size_t>((raster.height() + band_rows - 1) / band_rows));
  for (PrimitiveId id : set.with(Status::visible)) {
    const std::optional<Footprint> footprint = Footprint::of(scene, id, raster);
    if (!footprint) continue;
    const auto index = static_cast<std::uint32_t>(layers.footprints.size());
    layers.footprints.push_back(*footprint);
    layers.see_through.push_back(lets_light_through(scene, id));
    for (int band = footprint->box().y0 / band_rows; band * band_rows < footprint->box().y1; ++band) {
      layers.by_band[static_cast<std::size_t>(band)].push_back(index);
    }
  }
  return layers;
}

// The rows [first, last) of the picture while they are being worked on.
class Band {
 public:
  Band(const Scene& scene, const Raster& raster, const Layers& layers, int index)
      : scene_(scene),
        raster_(raster),
        layers_(layers),
        members_(layers.by_band[static_cast<std::size_t>(index)]),
        first_(index * band_rows),
        last_(std::min(raster.height(), first_ + band_rows)),
        nearest_(static_cast<std::size_t>((last_ - first_) * raster.width()),
                 -std::numeric_limits<double>::infinity()),
        owner_(nearest_.size(), nothing) {}

  void draw(Image& image) {
    for (std::uint32_t index : members_) {
      if (!layers_.see_through[index]) draw_opaque(index);
    }
    for (std::uint32_t index : members_) {
      if (layers_.see_through[index]) collect_veils(index);
    }
    // Farthest first, as light comes; the smaller id lies on top of an equal one.
    std::sort(veils_.begin(), veils_.end(), [](const Veil& a, const Veil& b) {
      if (a.pixel != b.pixel) return a.pixel < b.pixel;
      return a.nearness != b.nearness ? a.nearness < b.nearness : a.footprint > b.footprint;
    });
    paint(image);
  }

 private:
  // Calls use(pixel of the band, nearness) wherever the footprint is hit.
  template <class Use>
  void each_hit(const Footprint& footprint, Use use) const {
    const PixelBox& box = footprint.box();
    for (int row = std::max(box.y0, first_); row < std::min(box.y1, last_); ++row) {
      for (int column = box.x0; column < box.x1; ++column) {
        const auto nearness = footprint.nearness(raster_, raster_.centre(column, row));
        if (nearness) use((row - first_) * raster_.width() + column, *nearness);
      }
    }
  }

  void draw_opaque(std::uint32_t index) {
    each_hit(layers_.footprints[index], [&](int pixel, double nearness) {
      const auto at = static_cast<std::size_t>(pixel);
      if (nearness <= nearest_[at]) return;
      nearest_[at] = nearness;
      owner_[at] = index;
    });
  }

  void collect_veils(std::uint32_t index) {
    each_hit(layers_.footprints[index], [&](int pixel, double nearness) {
      if (nearness > nearest_[static_cast<std::size_t>(pixel)]) veils_.push_back({pixel, nearness, index});
    });
  }

  Color shaded(std::uint32_t index, const Vec3d& centre) const {
    const Footprint& footprint = layers_.footprints[index];
    return scaled(id_color(footprint.id()), facing_shade(footprint.cosine(scene_, raster_, centre)));
  }

  void paint(Image& image) const {
    auto veil = veils_.begin();
    for (int pixel = 0; pixel < static_cast<int>(owner_.size()); ++pixel) {
      const int row = first_ + pixel / raster_.width(), column = pixel % raster_.width();
      const Vec3d centre = raster_.centre(column, row);
      const std::uint32_t owner = owner_[static_cast<std::size_t>(pixel)];
      Color color = owner == nothing ? background_color : shaded(owner, centre);
      for (; veil != veils_.end() && veil->pixel == pixel; ++veil) {
        color = blend(color, shaded(veil->footprint, centre), see_through_opacity);
      }
      set_pixel(image, column, row, color);
    }
  }

  const Scene& scene_;
  const Raster& raster_;
  const Layers& layers_;
  const std::vector<std::uint32_t>& members_;
  int first_, last_;
  std::vector<double> nearest_;
  std::vector<std::uint32_t> owner_;
  std::vector<Veil> veils_;
};

}  // namespace

Image draw_view(const Scene& scene, const VisibleSet& set, const PointView& view, int frame, int width,
                int height) {
  require_match(scene, set);
  if (frame < 0 || frame >= static_cast<int>(view.frames.size())) {
    throw Error(Error::Code::usage, "frame", "the view has no frame of that number");
  }
  Image image = blank_image(width, height);
  const Raster raster(view.eye, view.projection, view.frames[static_cast<std::size_t>(frame)], width, height);
  const Layers layers = visible_layers(scene, set, raster);
  parallel_for(layers.by_band.size(),
               [&](std::size_t band) { Band(scene, raster, layers, static_cast<int>(band)).draw(image); });
  return image;
}

Image draw_frames(const Scene& scene, const VisibleSet& set, const PointView& view, int width, int height,
                  DrawFrame draw) {
  if (view.frames.size() == 1) return draw(scene, set, view, 0, width, height);
  constexpr int columns = 3;
  const int count = static_cast<int>(view.frames.size());
  const int rows = (count + columns - 1) / columns;
  const int side = std::max(1, std::min(width / columns, height / std::max(1, rows)));
  Image image = blank_image(width, height);
  for (int frame = 0; frame < count; ++frame) {
    const Image part = draw(scene, set, view, frame, side, side);
    paste(image, part, frame % columns * side, frame / columns * side);
  }
  return image;
}

}  // namespace provis
