#include "tests/support/case.hpp"

#include <cstdlib>
#include <istream>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "fmt/format.h"

namespace provis::test {

namespace {

constexpr const char* headline = "provis-case";

const char* word(Projection projection) {
  switch (projection) {
    case Projection::pinhole:
      return "pinhole";
    case Projection::parallel:
      return "parallel";
    case Projection::omni:
      return "omni";
  }
  throw std::logic_error("no such projection");
}

std::string text(double v) { return fmt::format("{:a}", v); }
std::string text(const Vec3d& v) { return fmt::format("{:a} {:a} {:a}", v.x, v.y, v.z); }

/// Reads word by word.
class Words {
 public:
  explicit Words(std::istream& in) : in_(in) {}

  std::string next() {
    std::string token;
    if (!(in_ >> token)) throw std::runtime_error("case text ends too early");
    return token;
  }

  void expect(const std::string& wanted) {
    if (const std::string token = next(); token != wanted) {
      throw std::runtime_error("case text: found '" + token + "' in place of '" + wanted + "'");
    }
  }

  std::uint64_t integer() {
    const std::string token = next();
    char* end = nullptr;
    const std::uint64_t value = std::strtoull(token.c_str(), &end, 10);
    if (*end != 0) throw std::runtime_error("case text: '" + token + "' is no integer");
    return value;
  }

  double number() {
    const std::string token = next();
    char* end = nullptr;
    const double value = std::strtod(token.c_str(), &end);
    if (*end != 0) throw std::runtime_error("case text: '" + token + "' is no number");
    return value;
  }

  Vec3d point() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

  std::string rest_of_line() {
    std::string line;
    std::getline(in_ >> std::ws, line);
    return line;
  }

 private:
  std::istream& in_;
};

Projection projection(const std::string& token) {
  for (const Projection p : {Projection::pinhole, Projection::parallel, Projection::omni}) {
    if (token == word(p)) return p;
  }
  throw std::runtime_error("case text: '" + token + "' is no projection");
}

}  // namespace

std::string describe(const Case& c) {
  std::ostringstream out;
  out << "case '" << c.name << "', seed " << c.seed << "; to replay it:\n";
  write_text(out, c);
  return out.str();
}

void write_text(std::ostream& out, const Case& c) {
  out << headline << " 1\nname " << (c.name.empty() ? "-" : c.name) << "\nseed " << c.seed << "\nvertices "
      << c.arrays.vertices.size() << "\n";
  for (const Vec3d& v : c.arrays.vertices) out << text(v) << "\n";
  out << "triangles " << c.arrays.triangles.size() << "\n";
  for (std::size_t t = 0; t < c.arrays.triangles.size(); ++t) {
    const Triangle& corners = c.arrays.triangles[t];
    out << corners[0] << " " << corners[1] << " " << corners[2] << " " << int{c.arrays.triangle_flags[t]}
        << "\n";
  }
  out << "view " << word(c.view.projection) << "\neye " << text(c.view.eye) << "\nframes "
      << c.view.frames.size() << "\n";
  for (const Frame& f : c.view.frames) {
    out << text(f.right) << "  " << text(f.up) << "  " << text(f.forward) << "  " << text(f.window.x0) << " "
        << text(f.window.x1) << " " << text(f.window.y0) << " " << text(f.window.y1) << "\n";
  }
}

Case read_text(std::istream& in) {
  Case c;
  Words words(in);
  words.expect(headline);
  words.expect("1");
  words.expect("name");
  c.name = words.rest_of_line();
  words.expect("seed");
  c.seed = words.integer();
  words.expect("vertices");
  c.arrays.vertices.resize(words.integer());
  for (Vec3d& v : c.arrays.vertices) v = words.point();
  words.expect("triangles");
  c.arrays.triangles.resize(words.integer());
  for (Triangle& t : c.arrays.triangles) {
    for (std::uint32_t& corner : t) corner = static_cast<std::uint32_t>(words.integer());
    c.arrays.triangle_flags.push_back(static_cast<std::uint8_t>(words.integer()));
  }
  words.expect("view");
  c.view.projection = projection(words.next());
  words.expect("eye");
  c.view.eye = words.point();
  words.expect("frames");
  c.view.frames.resize(words.integer());
  for (Frame& f : c.view.frames) {
    f.right = words.point();
    f.up = words.point();
    f.forward = words.point();
    for (double* border : {&f.window.x0, &f.window.x1, &f.window.y0, &f.window.y1}) *border = words.number();
  }
  return c;
}

}  // namespace provis::test
