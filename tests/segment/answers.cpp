#include "tests/segment/answers.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace provis::test {

Answer answer_of(const SegmentAnswer& oracle) { return {oracle.visible, oracle.boundary, oracle.pixels}; }

Answer engine_answer(const SegmentCase& c, SegmentOptions options, const Context& context, SegmentSet* set) {
  Answer answer;
  options.on_pixel = [&](const PixelSights& sights) { answer.pixels.push_back(exact(sights)); };
  SegmentSet found = visible_from_segment(Scene(c.start.arrays), c.view(), options, context);
  answer.visible = found.set.with(Status::visible);
  answer.boundary = found.boundary;
  if (set != nullptr) *set = std::move(found);
  return answer;
}

ExactSights exact(const PixelSights& sights) {
  ExactSights all{sights.frame, sights.column, sights.row, {}};
  for (const Sight& s : sights.sights) {
    ExactSight e{Rational(s.from), Rational(s.to), s.visible};
    e.from.canonicalize();
    e.to.canonicalize();
    all.sights.push_back(std::move(e));
  }
  return all;
}

ExactSights joined(const ExactSights& sights) {
  ExactSights all{sights.frame, sights.column, sights.row, {}};
  for (const ExactSight& s : sights.sights) {
    if (!all.sights.empty() && all.sights.back().visible == s.visible) {
      all.sights.back().to = s.to;
    } else {
      all.sights.push_back(s);
    }
  }
  return all;
}

std::string text(const std::vector<PrimitiveId>& ids) {
  std::ostringstream out;
  out << '{';
  for (const PrimitiveId id : ids) out << ' ' << id;
  out << " }";
  return out.str();
}

std::string text(const ExactSights& sights) {
  std::ostringstream out;
  out << "frame " << sights.frame << " column " << sights.column << " row " << sights.row << ":";
  for (const ExactSight& s : sights.sights) out << " [" << s.from << ", " << s.to << "] " << text(s.visible);
  return out.str();
}

std::string difference(const Answer& engine, const Answer& expected) {
  if (engine.pixels.size() != expected.pixels.size()) {
    return std::to_string(engine.pixels.size()) + " pixels in place of " +
           std::to_string(expected.pixels.size());
  }
  for (std::size_t p = 0; p < engine.pixels.size(); ++p) {
    if (engine.pixels[p] == expected.pixels[p]) continue;
    return "sights\n  " + text(engine.pixels[p]) + "\nin place of\n  " + text(expected.pixels[p]);
  }
  const auto ids = [](const char* what, const auto& found, const auto& wanted) {
    return found == wanted ? "" : what + text(found) + " in place of " + text(wanted);
  };
  const std::string visible = ids("visible ", engine.visible, expected.visible);
  return visible.empty() ? ids("boundary ", engine.boundary, expected.boundary) : visible;
}

std::string difference(const std::vector<Seen>& engine, const std::vector<ExactSeen>& expected) {
  if (engine.size() != expected.size()) {
    return "seen: " + std::to_string(engine.size()) + " primitives in place of " +
           std::to_string(expected.size());
  }
  for (std::size_t i = 0; i < engine.size(); ++i) {
    const Seen& e = engine[i];
    const ExactSeen& x = expected[i];
    std::ostringstream out;
    // A measure and no claim: the ends of a sight are rounded, not always to nearest.
    const Rational bound = Rational(x.sights) * Rational(0x1p-30);
    if (e.primitive == x.primitive && e.pixels == x.pixels && std::isfinite(e.length) &&
        abs(Rational(e.length) - x.length) <= bound)
      continue;
    out << "seen: triangle " << e.primitive << ", " << e.pixels << " pixels, length " << e.length
        << " in place of " << x.primitive << ", " << x.pixels << ", " << x.length;
    return out.str();
  }
  return {};
}

}  // namespace provis::test
