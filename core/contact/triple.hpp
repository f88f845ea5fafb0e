#pragma once

/// Vector with three components of a scalar type, in whatever right-handed orthonormal directions
/// its user names. For formulas that run with numbers, vectors of numbers and dual numbers; seen by
/// the race kernels, so nothing is included.
namespace adore::contact {

template <class T>
struct Triple {
  T x, y, z;
};

template <class T, class U>
[[gnu::always_inline]] inline auto operator+(const Triple<T>& a, const Triple<U>& b) {
  return Triple<decltype(a.x + b.x)>{a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T, class U>
[[gnu::always_inline]] inline auto operator-(const Triple<T>& a, const Triple<U>& b) {
  return Triple<decltype(a.x - b.x)>{a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class S, class T>
[[gnu::always_inline]] inline auto operator*(const S& s, const Triple<T>& a) {
  return Triple<decltype(s * a.x)>{s * a.x, s * a.y, s * a.z};
}
template <class T, class U>
[[gnu::always_inline]] inline auto dot(const Triple<T>& a, const Triple<U>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T, class U>
[[gnu::always_inline]] inline auto cross(const Triple<T>& a, const Triple<U>& b) {
  return Triple<decltype(a.x * b.x)>{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                                     a.x * b.y - a.y * b.x};
}

/// Base axes (x, y, z) to those of an azimuth, (e_x, e_r, e_θ) with e_r = (0, -sin, cos), e_θ = (0,
/// -cos, -sin), and back.
template <class T, class S>
[[gnu::always_inline]] inline auto to_azimuth(const Triple<T>& base, const S& sine,
                                              const S& cosine) {
  using R = decltype(cosine * base.z);
  return Triple<R>{R(base.x), cosine * base.z - sine * base.y, -cosine * base.y - sine * base.z};
}
template <class T, class S>
[[gnu::always_inline]] inline Triple<T> from_azimuth(const Triple<T>& v, const S& sine,
                                                     const S& cosine) {
  return {v.x, -(sine * v.y) - cosine * v.z, cosine * v.y - sine * v.z};
}

}  // namespace adore::contact
