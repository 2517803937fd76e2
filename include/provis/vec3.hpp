#pragma once
// Points and vectors: three numbers of one type, and the few products every formula is made of.

namespace provis {

/// Three coordinates over a number type N: a point, a vector or the coefficients of a linear functional.
template <class N>
struct Vec3 {
  N x{}, y{}, z{};

  friend bool operator==(const Vec3&, const Vec3&) = default;
};

using Vec3d = Vec3<double>;

template <class N>
Vec3<N> operator+(const Vec3<N>& a, const Vec3<N>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class N>
Vec3<N> operator-(const Vec3<N>& a, const Vec3<N>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class N>
Vec3<N> operator-(const Vec3<N>& a) {
  return {-a.x, -a.y, -a.z};
}

template <class N>
Vec3<N> operator*(const N& s, const Vec3<N>& a) {
  return {s * a.x, s * a.y, s * a.z};
}

template <class N>
Vec3<N> cross(const Vec3<N>& a, const Vec3<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class N>
N dot(const Vec3<N>& a, const Vec3<N>& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

}  // namespace provis
