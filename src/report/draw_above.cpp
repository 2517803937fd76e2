// The bird's-eye picture. Scenes have roofs, so depth does not decide what is shown: hidden primitives
// are a thin wash that grows with their number, and what is visible lies on top of all of it.

#include <algorithm>
#include <cmath>
#include <limits>

#include "provis/draw.hpp"
#include "provis/error.hpp"
#include "src/report/colors.hpp"
#include "src/report/footprint.hpp"
#include "src/report/marks.hpp"
#include "src/report/picture.hpp"
#include "src/report/plan.hpp"

namespace provis {

namespace {

constexpr double no_height = -std::numeric_limits<double>::infinity();

// What lies under the pixels, by status.
struct Sheet {
  explicit Sheet(std::size_t pixels)
      : hidden(pixels, 0), undecided(pixels, false), top(pixels, no_height), wall(pixels, false) {}

  std::vector<int> hidden;  // how many hidden primitives
  std::vector<bool> undecided;
  std::vector<double> top;  // nearness of the topmost visible primitive
  std::vector<bool> wall;   // a visible primitive seen edge-on, or too small to hold a pixel centre
};

class Drawing {
 public:
  Drawing(const Scene& scene, const Plan& plan)
      : scene_(scene),
        plan_(plan),
        sheet_(static_cast<std::size_t>(plan.raster().width()) *
               static_cast<std::size_t>(plan.raster().height())) {}

  void add(PrimitiveId id, Status status) {
    if (const auto footprint = Footprint::of(scene_, id, plan_.raster())) fill(*footprint, status);
    if (id >= scene_.triangles().size()) return;
    const std::array<PixelPoint, 3> p = {plan_.point(scene_.corner(id, 0)), plan_.point(scene_.corner(id, 1)),
                                         plan_.point(scene_.corner(id, 2))};
    if (is_thin(p)) stroke(p, status);
  }

  void paint(Image& image) const;

 private:
  void fill(const Footprint& footprint, Status status);
  void stroke(const std::array<PixelPoint, 3>& corners, Status status);
  void mark(std::size_t pixel, Status status, double nearness);

  // Less than two pixels across: its pixels' centres may all miss it.
  static bool is_thin(const std::array<PixelPoint, 3>& p) {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const PixelPoint &a = p[k], &b = p[(k + 1) % 3];
      longest = std::max(longest, std::hypot(b[0] - a[0], b[1] - a[1]));
    }
    const double area =
        std::abs((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]));
    return area <= 2 * longest;
  }

  const Scene& scene_;
  const Plan& plan_;
  Sheet sheet_;
};

void Drawing::mark(std::size_t pixel, Status status, double nearness) {
  switch (status) {
    case Status::hidden:
      ++sheet_.hidden[pixel];
      break;
    case Status::undecided:
      sheet_.undecided[pixel] = true;
      break;
    case Status::visible:
      sheet_.top[pixel] = std::max(sheet_.top[pixel], nearness);
      break;
  }
}

void Drawing::fill(const Footprint& footprint, Status status) {
  const Raster& raster = plan_.raster();
  const PixelBox& box = footprint.box();
  for (int row = box.y0; row < box.y1; ++row) {
    for (int column = box.x0; column < box.x1; ++column) {
      const auto nearness = footprint.nearness(raster, raster.centre(column, row));
      if (!nearness) continue;
      mark(static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.width()) +
               static_cast<std::size_t>(column),
           status, *nearness);
    }
  }
}

void Drawing::stroke(const std::array<PixelPoint, 3>& corners, Status status) {
  const Raster& raster = plan_.raster();
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t pixel :
         pixels_under(corners[k], corners[(k + 1) % 3], raster.width(), raster.height())) {
      if (status == Status::visible) {
        sheet_.wall[pixel] = true;
      } else {
        mark(pixel, status, 0);
      }
    }
  }
}

void Drawing::paint(Image& image) const {
  double low = INFINITY, high = -INFINITY;
  for (double top : sheet_.top) {
    if (top == no_height) continue;
    low = std::min(low, top);
    high = std::max(high, top);
  }
  for (std::size_t pixel = 0; pixel < sheet_.top.size(); ++pixel) {
    Color color = blend(background_color, hidden_color, 0.6 * (1 - std::pow(0.75, sheet_.hidden[pixel])));
    if (sheet_.undecided[pixel]) color = blend(color, undecided_color, 0.8);
    if (sheet_.top[pixel] != no_height) {
      const double height = high > low ? (sheet_.top[pixel] - low) / (high - low) : 1;
      color = blend(color, blend(visible_low_color, visible_high_color, height), 0.8);
    }
    if (sheet_.wall[pixel]) color = visible_wall_color;
    const int width = image.width;
    set_pixel(image, static_cast<int>(pixel) % width, static_cast<int>(pixel) / width, color);
  }
}

// Where the window's left and right borders run: rays from the eye, or two parallel lines.
void draw_window(Image& image, const Plan& plan, const PointView& view) {
  const Frame& frame = view.frames.front();
  const double reach = 2.0 * (image.width + image.height);
  const double middle = frame.window.y0 / 2 + frame.window.y1 / 2;
  for (double x : {frame.window.x0, frame.window.x1}) {
    const Vec3d offset = x * frame.right + middle * frame.up;
    const bool parallel = view.projection == Projection::parallel;
    const PixelPoint from = plan.point(parallel ? view.eye + offset : view.eye);
    const PixelPoint step = plan.direction(parallel ? frame.forward : frame.forward + offset);
    draw_line(image, from, {from[0] + reach * step[0], from[1] + reach * step[1]}, eye_color);
  }
}

void draw_viewpoint(Image& image, const Plan& plan, const PointView& view) {
  const double radius = std::max(3.0, std::min(image.width, image.height) / 100.0);
  const PixelPoint eye = plan.point(view.eye);
  if (view.projection == Projection::omni) {
    draw_ring(image, eye, 3 * radius, 3 * radius + 2, eye_color);
  } else {
    draw_window(image, plan, view);
  }
  draw_ring(image, eye, 0, radius + 2, {255, 255, 255});
  draw_ring(image, eye, 0, radius, eye_color);
}

}  // namespace

Image draw_above(const Scene& scene, const VisibleSet& set, const PointView& view, int width, int height) {
  require_match(scene, set);
  if (view.frames.empty()) throw Error(Error::Code::usage, "view", "has no frame");
  Image image = blank_image(width, height);
  const Plan plan(scene, view, width, height);
  Drawing drawing(scene, plan);
  for (std::size_t id = 0; id < set.status.size(); ++id) {
    drawing.add(static_cast<PrimitiveId>(id), set.status[id]);
  }
  drawing.paint(image);
  draw_viewpoint(image, plan, view);
  return image;
}

}  // namespace provis
