#include "src/report/svg.hpp"

#include <fmt/format.h>

#include <iterator>

namespace provis {

namespace {

/// What a text may not hold as it is.
std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '&':
        safe += "&amp;";
        break;
      default:
        safe += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return safe;
}

const char* word(Anchor anchor) {
  return anchor == Anchor::start ? "start" : anchor == Anchor::middle ? "middle" : "end";
}

std::string joined(const std::vector<SvgPoint>& points) {
  std::string text;
  for (const SvgPoint& p : points) fmt::format_to(std::back_inserter(text), "{:.1f},{:.1f} ", p.x, p.y);
  return text;
}

}  // namespace

Svg::Svg(double width, double height) {
  body_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
      "height=\"{1:g}\" "
      "font-family=\"Helvetica, Arial, sans-serif\">\n",
      width, height);
  rectangle({0, 0}, width, height, "#ffffff");
}

void Svg::rectangle(SvgPoint corner, double width, double height, std::string_view fill) {
  body_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n",
                       corner.x, corner.y, width, height, fill);
}

void Svg::line(SvgPoint from, SvgPoint to, std::string_view stroke, double width) {
  path({from, to}, stroke, width);
}

void Svg::path(const std::vector<SvgPoint>& points, std::string_view stroke, double width) {
  body_ += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:g}\"/>\n",
                       joined(points), stroke, width);
}

void Svg::marker(Marker shape, SvgPoint c, std::string_view color, bool hollow) {
  const std::string paint =
      fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"2\"/>\n", hollow ? "#ffffff" : color, color);
  if (shape == Marker::circle) {
    body_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" {}", c.x, c.y, paint);
    return;
  }
  const double r = shape == Marker::diamond ? 6 : 4;
  const std::vector<SvgPoint> corners =
      shape == Marker::diamond
          ? std::vector<SvgPoint>{{c.x - r, c.y}, {c.x, c.y - r}, {c.x + r, c.y}, {c.x, c.y + r}}
          : std::vector<SvgPoint>{
                {c.x - r, c.y - r}, {c.x + r, c.y - r}, {c.x + r, c.y + r}, {c.x - r, c.y + r}};
  body_ += fmt::format("<polygon points=\"{}\" {}", joined(corners), paint);
}

void Svg::text(SvgPoint at, std::string_view text, Anchor anchor, double size, std::string_view color) {
  body_ += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{:g}\" fill=\"{}\">{}</text>\n", at.x,
      at.y, word(anchor), size, color, escaped(text));
}

void Svg::upward_text(SvgPoint at, std::string_view text, double size, std::string_view color) {
  body_ += fmt::format(
      "<text transform=\"translate({:.1f} {:.1f}) rotate(-90)\" text-anchor=\"middle\" font-size=\"{:g}\" "
      "fill=\"{}\">{}</text>\n",
      at.x, at.y, size, color, escaped(text));
}

std::string Svg::take() { return std::move(body_) + "</svg>\n"; }

}  // namespace provis
