// The identities that README.md states for each formula, as equations between exact numbers.

#include <catch2/catch.hpp>

#include <cmath>

#include "predicates/exact_number.hpp"
#include "predicates/formulas.hpp"
#include "predicates/line.hpp"
#include "tests/predicates/near_degenerate.hpp"

namespace provis::test {
namespace {

using N = ExactNumber;
using V = Vec3<N>;

bool zero(const N& x) { return sign_of(x) == Sign::zero; }
bool zero(const V& v) { return zero(v.x) && zero(v.y) && zero(v.z); }
N det(const V& a, const V& b, const V& c) { return dot(a, cross(b, c)); }
N sign_number(Sign s) { return N(static_cast<int>(s)); }

template <class Check>
void for_inputs(const Check& check) {
  for (const NearFamily family : families) DYNAMIC_SECTION(name(family)) {
      for (const std::uint64_t seed : seeds(family == NearFamily::extreme ? 1 : 10)) {
        INFO("PROVIS_SEED=" << seed);
        check(make_input(family, seed));
      }
    }
}

N power(const N& base, int exponent) {
  N p(1);
  for (int k = 0; k < exponent; ++k) p = p * base;
  return p;
}

/// All lengths times 2^k: points, eye and frame; window coordinates are plain numbers and stay.
Input scaled(Input in, int k) {
  const auto scale = [&](Vec3d& v) { v = {std::ldexp(v.x, k), std::ldexp(v.y, k), std::ldexp(v.z, k)}; };
  for (Vec3d* v : {&in.geometry.eye, &in.geometry.right, &in.geometry.up, &in.geometry.forward,
                   &in.geometry.shear_direction})
    scale(*v);
  for (Vec3d& p : in.points) scale(p);
  return in;
}

Input with_axes(Input in, Vec3d (*map)(const Vec3d&)) {
  for (Vec3d& p : in.points) p = map(p);
  const ViewGeometry& g = in.geometry;
  in.geometry = make_geometry(map(g.eye), {map(g.right), map(g.up), map(g.forward), {}}, g.at_infinity);
  return in;
}

Sign edge_side(const Input& in, int a, int b, int p) {
  const auto at = [&](int k) -> const Vec3d& { return in.points[static_cast<std::size_t>(k)]; };
  return sign_of(dot(edge_line<N>(in.geometry, at(a), at(b)), project_point<N>(in.geometry, at(p))));
}

Sign facing(const Input& in) {
  return sign_of(triangle_plane<N>(in.geometry, in.points[0], in.points[1], in.points[2]).at_eye);
}

}  // namespace

TEST_CASE("edge_line: antisymmetric, and zero at both end points") {
  for_inputs([](const Input& in) {
    const ViewGeometry& g = in.geometry;
    const auto& [a, b, c, d, e, f, p] = in.points;
    const V ab = edge_line<N>(g, a, b);
    CHECK(zero(ab + edge_line<N>(g, b, a)));
    CHECK(zero(dot(ab, project_point<N>(g, a))));
    CHECK(zero(dot(ab, project_point<N>(g, b))));
    CHECK(zero(edge_line<N>(g, c, c)));
  });
}

TEST_CASE("edge_line: turns are permutations' signs") {
  for_inputs([](const Input& in) {
    const Sign s = edge_side(in, 0, 1, 2);
    CHECK(edge_side(in, 1, 2, 0) == s);
    CHECK(edge_side(in, 2, 0, 1) == s);
    CHECK(edge_side(in, 1, 0, 2) == -s);
    CHECK(edge_side(in, 0, 2, 1) == -s);
    CHECK(edge_side(in, 2, 1, 0) == -s);
  });
}

TEST_CASE("facing: the sign of det[a - e, b - e, c - e], and of the turn of the corners") {
  for_inputs([](const Input& in) {
    const ViewGeometry& g = in.geometry;
    const auto& [a, b, c, d, e, f, p] = in.points;
    const V eye = numbers<N>(g.eye);
    const N at_eye = triangle_plane<N>(g, a, b, c).at_eye;
    if (!g.at_infinity) CHECK(at_eye == det(numbers<N>(a) - eye, numbers<N>(b) - eye, numbers<N>(c) - eye));
    CHECK(sign_of(at_eye) == edge_side(in, 0, 1, 2));
    CHECK(triangle_plane<N>(g, b, c, a).at_eye == at_eye);
    CHECK(triangle_plane<N>(g, b, a, c).at_eye == -at_eye);
    CHECK(zero(triangle_plane<N>(g, a, b, b).at_eye));
  });
}

TEST_CASE("triangle_plane: the depth at a corner is the corner's") {
  for_inputs([](const Input& in) {
    const ViewGeometry& g = in.geometry;
    const auto& [a, b, c, d, e, f, p] = in.points;
    const Plane<N> plane = triangle_plane<N>(g, a, b, c);
    for (const Vec3d* corner : {&a, &b, &c})
      // 1/distance is 1 at the corner for a finite eye; for one at infinity the corner itself is at distance
      // 0 when seen from where it is.
      CHECK(dot(plane.normal, numbers<N>(*corner) - numbers<N>(g.eye)) + plane.offset ==
            (g.at_infinity ? N(0) : plane.at_eye));
  });
}

TEST_CASE("depth_line: antisymmetric, zero for one plane, at shared corners, and dependent in threes") {
  for_inputs([](const Input& in) {
    const ViewGeometry& g = in.geometry;
    const auto& [a, b, c, d, e, f, p] = in.points;
    const Plane<N> i = triangle_plane<N>(g, a, b, c), j = triangle_plane<N>(g, a, b, d),
                   k = triangle_plane<N>(g, d, e, f);
    const V ij = depth_line(g, i, j), jk = depth_line(g, j, k), ik = depth_line(g, i, k);
    CHECK(zero(ij + depth_line(g, j, i)));
    CHECK(zero(depth_line(g, i, i)));
    CHECK(zero(depth_line(g, i, triangle_plane<N>(g, b, c, a))));
    CHECK(zero(dot(ij, project_point<N>(g, a))));
    CHECK(zero(dot(ij, project_point<N>(g, b))));
    CHECK(zero(dot(jk, project_point<N>(g, d))));
    CHECK(zero(k.at_eye * ij + i.at_eye * jk - j.at_eye * ik));
    CHECK(zero(det(ij, jk, ik)));
  });
}

TEST_CASE("borders: zero at their coordinate, increasing, antisymmetric about it") {
  for_inputs([](const Input& in) {
    const ViewGeometry& g = in.geometry;
    const auto [x, y] = in.at;
    const N hand = sign_number(g.handedness);
    const V ray = window_ray<N>(g, x, y);
    CHECK(zero(dot(x_border<N>(g, x), ray)));
    CHECK(zero(dot(y_border<N>(g, y), ray)));
    CHECK(sign_of(hand * dot(x_border<N>(g, y), ray)) == sign_of(N(x) - N(y)));
    CHECK(sign_of(hand * dot(y_border<N>(g, x), ray)) == sign_of(N(y) - N(x)));
    CHECK(sign_of(hand * dot(image_side<N>(g), ray)) == Sign::positive);
    CHECK(sign_of(window_plane<N>(g).at_eye) == Sign::positive);
  });
}

TEST_CASE("front: the window's plane against a triangle changes sign where the triangle meets it") {
  for_inputs([](const Input& in) {
    const ViewGeometry& g = in.geometry;
    if (!g.at_infinity) return;
    const auto& [a, b, c, d, e, f, p] = in.points;
    const Plane<N> plane = triangle_plane<N>(g, a, b, c);
    if (sign_of(plane.at_eye) != Sign::positive) return;
    const V line = depth_line(g, window_plane<N>(g), plane);
    for (const Vec3d* corner : {&a, &b, &c})
      CHECK(sign_of(dot(line, project_point<N>(g, *corner))) == sign_of(beyond_window<N>(g, *corner)));
  });
}

TEST_CASE("degrees: all lengths times 2^k multiply each value by 2^(k degree)") {
  for (const NearFamily family :
       {NearFamily::generic, NearFamily::grid, NearFamily::nudged, NearFamily::mixed})
    for (const std::uint64_t seed : seeds(10)) {
      INFO(name(family) << ", PROVIS_SEED=" << seed);
      const int k = 1 + static_cast<int>(seed % 3) * 20;  // upwards, so that nudged zeros do not underflow
      const Input in = make_input(family, seed), big = scaled(in, k);
      const N two_k(std::ldexp(1.0, k));
      const bool at_infinity = in.geometry.at_infinity;
      const auto grows = [&](int degree, const auto& formula) {
        CHECK(formula(big) == power(two_k, degree) * formula(in));
      };
      const auto plane = [](const Input& i, std::size_t first) {
        return triangle_plane<N>(i.geometry, i.points[first], i.points[first + 1], i.points[first + 2]);
      };
      const auto point = [](const Input& i) { return project_point<N>(i.geometry, i.points[6]); };
      const auto edge = [](const Input& i) { return edge_line<N>(i.geometry, i.points[0], i.points[1]); };
      grows(2, [&](const Input& i) { return plane(i, 0).normal.x; });
      grows(3, [&](const Input& i) { return plane(i, 0).at_eye; });
      grows(3, [&](const Input& i) { return plane(i, 0).offset; });
      grows(3, [&](const Input& i) { return beyond_window<N>(i.geometry, i.points[6]); });
      grows(at_infinity ? 2 : 1, [&](const Input& i) { return point(i).x; });
      grows(at_infinity ? 2 : 1,
            [&](const Input& i) { return window_ray<N>(i.geometry, i.at[0], i.at[1]).y; });
      grows(at_infinity ? 4 : 2, [&](const Input& i) { return edge(i).z; });
      grows(5, [&](const Input& i) { return depth_line(i.geometry, plane(i, 0), plane(i, 3)).x; });
      grows(at_infinity ? 5 : 3, [&](const Input& i) { return dot(edge(i), point(i)); });
      grows(at_infinity ? 5 : 3,
            [&](const Input& i) { return dot(x_border<N>(i.geometry, i.at[0]), point(i)); });
      grows(at_infinity ? 5 : 3,
            [&](const Input& i) { return dot(y_border<N>(i.geometry, i.at[0]), point(i)); });
      grows(at_infinity ? 5 : 3, [&](const Input& i) { return dot(image_side<N>(i.geometry), point(i)); });
      grows(at_infinity ? 7 : 6,
            [&](const Input& i) { return dot(depth_line(i.geometry, plane(i, 0), plane(i, 3)), point(i)); });
    }
}

TEST_CASE("axes: an even permutation of x, y, z changes nothing, a mirror turns everything round") {
  for_inputs([](const Input& in) {
    const Input turned = with_axes(in, [](const Vec3d& v) { return Vec3d{v.y, v.z, v.x}; });
    const Input mirrored = with_axes(in, [](const Vec3d& v) { return Vec3d{-v.x, v.y, v.z}; });
    const Input swapped = with_axes(in, [](const Vec3d& v) { return Vec3d{v.y, v.x, v.z}; });
    CHECK(turned.geometry.handedness == in.geometry.handedness);
    CHECK(mirrored.geometry.handedness == -in.geometry.handedness);
    CHECK(facing(turned) == facing(in));
    CHECK(facing(mirrored) == -facing(in));
    CHECK(facing(swapped) == -facing(in));
    CHECK(edge_side(turned, 3, 4, 5) == edge_side(in, 3, 4, 5));
    CHECK(edge_side(mirrored, 3, 4, 5) == -edge_side(in, 3, 4, 5));
    CHECK(edge_side(swapped, 3, 4, 5) == -edge_side(in, 3, 4, 5));
    const auto front = [](const Input& i) { return sign_of(beyond_window<N>(i.geometry, i.points[6])); };
    CHECK(front(turned) == front(in));
    CHECK(front(mirrored) == front(in));
    CHECK(front(swapped) == front(in));
  });
}

}  // namespace provis::test
