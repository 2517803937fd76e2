#pragma once
// As much of SVG as a diagram needs: shapes, text, and nothing that a viewer has to fetch.

#include <string>
#include <string_view>
#include <vector>

namespace provis {

/// Pixels, y downwards.
struct SvgPoint {
  double x = 0, y = 0;
};

enum class Marker { circle, diamond, square };
enum class Anchor { start, middle, end };

/// A picture that is added to until its text is taken. Colours are "#rrggbb".
class Svg {
 public:
  Svg(double width, double height);

  void rectangle(SvgPoint corner, double width, double height, std::string_view fill);
  void line(SvgPoint from, SvgPoint to, std::string_view stroke, double width);
  void path(const std::vector<SvgPoint>& points, std::string_view stroke, double width);
  /// hollow: white inside.
  void marker(Marker shape, SvgPoint centre, std::string_view color, bool hollow);
  void text(SvgPoint at, std::string_view text, Anchor anchor, double size, std::string_view color);
  /// Reads upwards.
  void upward_text(SvgPoint at, std::string_view text, double size, std::string_view color);

  /// All of it. Call it once, last.
  std::string take();

 private:
  std::string body_;
};

}  // namespace provis
