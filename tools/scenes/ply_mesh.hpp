#pragma once
// A mesh that is written as PLY while it is being made, in bounded memory.

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>

namespace provis::scenes {

/// A point on an integer grid: the same on every machine, and exact in float32 below 2^24.
struct Point {
  std::int32_t x = 0, y = 0, z = 0;

  friend Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
};

/// What a generator adds its vertices and triangles to.
///
/// PLY states its counts first, then all vertices, then all faces. So a generator runs three times, and each
/// pass keeps what it is there for; nothing but a buffer is held in memory.
class Mesh {
 public:
  std::uint32_t vertex(const Point& p) {
    if (pass_ == Pass::vertices) write_vertex(p);
    return vertices_++;
  }

  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (pass_ == Pass::faces) write_face(a, b, c);
    ++triangles_;
  }

  /// Two triangles, counter-clockwise seen from the front like everything here.
  void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }

  /// So far; the same in every pass.
  std::uint64_t triangles() const { return triangles_; }

 private:
  friend void write_ply(std::ostream&, const std::function<void(Mesh&)>&, const struct PlyForm&);
  enum class Pass { count, vertices, faces };

  Mesh(Pass pass, const struct PlyForm& form, std::ostream& out) : pass_(pass), form_(form), out_(out) {}
  void write_vertex(const Point& p);
  void write_face(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  template <class T>
  void put(T value);
  void flush();

  Pass pass_;
  const PlyForm& form_;
  std::ostream& out_;
  std::string block_;
  std::uint32_t vertices_ = 0;
  std::uint64_t triangles_ = 0;
};

/// How grid points become coordinates.
struct PlyForm {
  double unit = 1;       ///< a power of two: what one step of the grid is long
  bool rotated = false;  ///< by 0.1 rad about y, as float64; else float32, which is exact here
  std::string comment;   ///< one line
};

/// Runs the generator and writes what it makes.
void write_ply(std::ostream& out, const std::function<void(Mesh&)>& generator, const PlyForm& form);

}  // namespace provis::scenes
