// Two diagrams side by side: what share of the set, and of the image, is missed after how much time. What
// misses nothing has no place on a logarithmic axis, and gets a strip of its own below it.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>

#include "src/report/accuracy.hpp"
#include "src/report/svg.hpp"

namespace provis {

namespace {

constexpr const char *ink = "#222222", *grey = "#666666", *grid = "#e4e4e4", *strip_color = "#eaf6ee";
constexpr double width = 960, top = 84, bottom = 372, strip_gap = 6, strip_row = 19;
constexpr double panel_width = 370, small = 12;

/// What is drawn alike.
struct Family {
  const char* title;
  const char* color;
  Marker marker;
  bool hollow;
};

constexpr Family sampling = {"uniform samples per pixel", "#0072b2", Marker::circle, false};
constexpr Family viewpoints = {"viewpoints along the segment", "#0072b2", Marker::circle, false};
constexpr Family plain_engine = {"plain engine", "#56b4e9", Marker::diamond, false};
constexpr Family aggressive = {"aggressive", "#e69f00", Marker::diamond, false};
constexpr Family grid_views = {"grid of viewpoints, float64", "#0072b2", Marker::circle, false};
constexpr Family exact_views = {"exact sets from viewpoints", "#00835f", Marker::square, false};
constexpr Family offset_space = {"camera offset space, by pixels", "#e69f00", Marker::diamond, false};
constexpr Family all_stages = {"all stages", "#7b3294", Marker::square, true};
constexpr Family certain = {"exact, by certain signs", "#00835f", Marker::square, false};
constexpr Family doubles = {"plain doubles", "#c8361d", Marker::square, true};

constexpr const Family* families[] = {&sampling, &viewpoints, &aggressive,  &plain_engine, &certain,
                                      &doubles,  &grid_views, &exact_views, &offset_space, &all_stages};

const Family& family(const Way& way) {
  if (way.cell == CellMethod::cos) return offset_space;
  if (way.cell) return way.viewpoints > 0 ? exact_views : all_stages;
  if (way.method == Method::sampled && way.from_cell()) return grid_views;
  if (way.method == Method::sampled) return way.viewpoints > 0 ? viewpoints : sampling;
  if (way.plain) return plain_engine;
  if (way.method == Method::aggressive) return aggressive;
  return way.certain() ? certain : doubles;
}

/// Positions of powers of ten, and of what lies between.
class LogAxis {
 public:
  /// Holds all values, each above 0; at least one decade.
  LogAxis(const std::vector<double>& values, double from, double to) : from_(from), to_(to) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    first_ = values.empty() ? 0 : static_cast<int>(std::floor(std::log10(*least)));
    last_ = values.empty() ? 1 : std::max(first_ + 1, static_cast<int>(std::ceil(std::log10(*most))));
  }
  double at(double value) const {
    return from_ + (to_ - from_) * (std::log10(value) - first_) / (last_ - first_);
  }
  /// Exponents to be labelled: not more than eight.
  std::vector<int> ticks() const {
    std::vector<int> exponents;
    const int step = (last_ - first_) / 8 + 1;
    for (int e = last_; e >= first_; e -= step) exponents.push_back(e);
    return exponents;
  }

 private:
  int first_ = 0, last_ = 1;
  double from_, to_;
};

struct Dot {
  const WayOutcome* outcome;
  double missed;
};

/// The number 10^exponent, written out where that is short.
std::string power_of_ten(int exponent) {
  if (exponent < -3) return fmt::format("1e{}", exponent);
  return fmt::format("{:.{}f}", std::pow(10, exponent), std::max(0, -exponent));
}

std::size_t complete(const std::vector<Dot>& dots) {
  return static_cast<std::size_t>(
      std::count_if(dots.begin(), dots.end(), [](const Dot& d) { return !(d.missed > 0); }));
}

/// Whether it is one of many that differ in fineness, joined by a curve.
bool in_series(const Way& way) {
  return way.method == Method::sampled || way.cell == CellMethod::cos || way.viewpoints > 0;
}

/// Of a way in a series: short, since there are many.
std::string fineness(const Way& way) {
  if (way.cell == CellMethod::cos) return fmt::format("{}x{}", way.pixels.width, way.pixels.height);
  return way.viewpoints > 0 ? fmt::format("{}", way.viewpoints) : fmt::format("{}²", way.samples);
}

std::string label(const WayOutcome& o) {
  if (in_series(o.way)) return fineness(o.way);
  std::string text = name(o.way);
  if (o.score && o.score->wrong_in > 0) text += fmt::format(", {} wrongly in", o.score->wrong_in);
  return text;
}

struct Wording {
  const char* title;
  const char* none = "missed";  ///< "nothing ..."
  const char* share = "share missed";
};

class Panel {
 public:
  /// floor: the lower end of the strip.
  Panel(Svg& svg, double left, double floor, const Wording& wording, std::vector<Dot> dots)
      : svg_(svg),
        left_(left),
        floor_(floor),
        wording_(wording),
        dots_(std::move(dots)),
        x_(times(), left, left + panel_width),
        y_(shares(), bottom, top) {}

  void draw() {
    draw_axes();
    draw_curves();
    for (const Dot& dot : dots_)
      if (dot.missed > 0) draw_missing(dot);
    draw_strip();
  }

 private:
  std::vector<double> times() const {
    std::vector<double> values;
    for (const Dot& dot : dots_) values.push_back(seconds(dot));
    return values;
  }
  std::vector<double> shares() const {
    std::vector<double> values = {1};
    for (const Dot& dot : dots_)
      if (dot.missed > 0) values.push_back(dot.missed);
    return values;
  }
  // A clock that saw nothing saw less than it can see.
  static double seconds(const Dot& dot) { return std::max(dot.outcome->cpu_seconds.median, 1e-5); }
  SvgPoint place(const Dot& dot) const { return {x_.at(seconds(dot)), y_.at(dot.missed)}; }

  void draw_axes();
  void draw_curves();
  void draw_missing(const Dot& dot);
  void draw_strip();

  Svg& svg_;
  double left_, floor_;
  Wording wording_;
  SvgPoint labelled_{0, 0};  ///< the last dot with a label above it
  std::vector<Dot> dots_;
  LogAxis x_, y_;
};

void Panel::draw_axes() {
  const double strip = bottom + strip_gap, middle = (strip + floor_) / 2;
  svg_.text({left_ + panel_width / 2, top - 12}, wording_.title, Anchor::middle, 14, ink);
  svg_.rectangle({left_, strip}, panel_width, floor_ - strip, strip_color);
  for (const int e : x_.ticks()) {
    const double x = x_.at(std::pow(10, e));
    svg_.line({x, top}, {x, bottom}, grid, 1);
    svg_.text({x, floor_ + 18}, power_of_ten(e) + " s", Anchor::middle, small, grey);
  }
  for (const int e : y_.ticks()) {
    const double y = y_.at(std::pow(10, e));
    svg_.line({left_, y}, {left_ + panel_width, y}, grid, 1);
    svg_.text({left_ - 8, y + 4}, power_of_ten(e + 2) + " %", Anchor::end, small, grey);
  }
  svg_.line({left_, top}, {left_, floor_}, grey, 1);
  svg_.line({left_, floor_}, {left_ + panel_width, floor_}, grey, 1);
  svg_.text({left_ - 8, middle - 3}, "nothing", Anchor::end, small, ink);
  svg_.text({left_ - 8, middle + 12}, wording_.none, Anchor::end, small, ink);
  svg_.text({left_ + panel_width / 2, floor_ + 38}, "CPU time", Anchor::middle, 13, ink);
  svg_.upward_text({left_ - 66, (top + bottom) / 2}, wording_.share, 13, ink);
}

/// The ways of each series, joined as far as they miss anything.
void Panel::draw_curves() {
  for (const Family* f : families) {
    std::vector<SvgPoint> points;
    for (const Dot& dot : dots_)
      if (&family(dot.outcome->way) == f && in_series(dot.outcome->way) && dot.missed > 0)
        points.push_back(place(dot));
    if (!points.empty()) svg_.path(points, f->color, 2);
  }
}

void Panel::draw_missing(const Dot& dot) {
  const Family& f = family(dot.outcome->way);
  const SvgPoint at = place(dot);
  svg_.marker(f.marker, at, f.color, f.hollow);
  // The labels of a series lie above its curve where there is room, all others below it.
  const bool crowded = std::abs(at.x - labelled_.x) < 64 && std::abs(at.y - labelled_.y) < 20;
  const bool above = in_series(dot.outcome->way) && !crowded;
  if (above) labelled_ = at;
  const bool near_end = at.x > left_ + panel_width - (in_series(dot.outcome->way) ? 36 : 150);
  svg_.text({at.x + (near_end ? -8 : 8), at.y + (above ? -6 : 17)}, label(*dot.outcome),
            near_end ? Anchor::end : Anchor::start, small, f.color);
}

/// One row for each, so that no label lies on another; the fastest on top.
void Panel::draw_strip() {
  std::vector<Dot> done;
  for (const Dot& dot : dots_)
    if (!(dot.missed > 0)) done.push_back(dot);
  std::stable_sort(done.begin(), done.end(),
                   [](const Dot& a, const Dot& b) { return seconds(a) < seconds(b); });
  for (std::size_t k = 0; k < done.size(); ++k) {
    const Family& f = family(done[k].outcome->way);
    const SvgPoint at = {x_.at(seconds(done[k])),
                         bottom + strip_gap + strip_row * (static_cast<double>(k) + 0.7)};
    svg_.marker(f.marker, at, f.color, f.hollow);
    const bool near_end = at.x > left_ + panel_width - 160;
    svg_.text({at.x + (near_end ? -10 : 10), at.y + 4}, label(*done[k].outcome),
              near_end ? Anchor::end : Anchor::start, small, f.color);
  }
}

void draw_legend(Svg& svg, const AccuracyReport& report) {
  const auto drawn = [&](const Family* f) {
    return std::any_of(report.outcomes.begin(), report.outcomes.end(),
                       [&](const WayOutcome& o) { return &family(o.way) == f; });
  };
  double x = 90;
  for (const Family* f : families) {
    if (!drawn(f)) continue;
    svg.marker(f->marker, {x, 46}, f->color, f->hollow);
    svg.text({x + 12, 50}, f->title, Anchor::start, 13, ink);
    x += 40 + 6.8 * static_cast<double>(std::string_view(f->title).size());
  }
}

/// What has no dot, so that nothing is left out in silence.
void draw_absent(Svg& svg, const AccuracyReport& report, double y) {
  std::string line;
  std::string_view last;
  for (const WayOutcome& o : report.outcomes) {
    if (o.ending == Ending::done) continue;
    if (name(o.ending) != last)
      line += (line.empty() ? "Not shown: " : "; ") + std::string(name(o.ending)) + ": ";
    if (name(o.ending) == last) line += ", ";
    line += in_series(o.way) && !report.header.cell ? fineness(o.way) : name(o.way);
    last = name(o.ending);
  }
  svg.text({24, y}, line, Anchor::start, small, grey);
}

const char* second_title(AreaMeasure measure) {
  if (measure == AreaMeasure::sight) return "Pixels x time missed";
  return measure == AreaMeasure::subdivision ? "Image area missed"
                                             : "Projected area missed (hidden parts too)";
}

std::string heading(const AccuracyReport& report) {
  const std::string scene = std::filesystem::path(report.header.scene_file).filename().string();
  return fmt::format("What accuracy costs: {}, {} triangles", scene, report.header.triangles);
}

}  // namespace

void write_accuracy_picture(const AccuracyReport& report, std::ostream& out) {
  std::vector<Dot> set, area;
  for (const WayOutcome& o : report.outcomes) {
    if (o.ending != Ending::done) continue;
    if (o.score) set.push_back({&o, o.score->set_missed});
    if (report.header.cell) {
      if (o.excess) area.push_back({&o, o.excess->share});
    } else if (o.score) {
      area.push_back({&o, o.score->area_missed});
    }
  }
  const std::size_t rows = std::max({complete(set), complete(area), std::size_t{4}});
  const double floor = bottom + strip_gap + strip_row * (static_cast<double>(rows) + 0.4);
  Svg svg(width, floor + 82);
  svg.text({24, 26}, heading(report), Anchor::start, 17, ink);
  draw_legend(svg, report);
  const double second = 92 + panel_width + 104;
  if (report.header.cell) {
    Panel(svg, 92, floor, {"Missed of what is proven visible"}, set).draw();
    Panel(svg, second, floor,
          {"Not hidden, beyond what is proven visible", "beyond", "share of the proven ones"}, area)
        .draw();
  } else {
    Panel(svg, 92, floor, {"Visible triangles missed"}, set).draw();
    Panel(svg, second, floor, {second_title(report.area)}, area).draw();
  }
  draw_absent(svg, report, floor + 66);
  out << svg.take();
}

}  // namespace provis
