#pragma once

#include <array>
#include <cmath>

namespace tricontact::contact {

/// A vector in the surface plane: x along the tangential load, y across it.
using Vector2 = std::array<double, 2>;

inline Vector2 operator+(const Vector2& a, const Vector2& b) {
    return {a[0] + b[0], a[1] + b[1]};
}
inline Vector2 operator-(const Vector2& a, const Vector2& b) {
    return {a[0] - b[0], a[1] - b[1]};
}
inline Vector2 operator*(double factor, const Vector2& a) {
    return {factor * a[0], factor * a[1]};
}
inline Vector2 operator/(const Vector2& a, double divisor) {
    return {a[0] / divisor, a[1] / divisor};
}
inline double dot(const Vector2& a, const Vector2& b) {
    return a[0] * b[0] + a[1] * b[1];
}
inline double norm(const Vector2& a) {
    return std::sqrt(dot(a, a));
}

}  // namespace tricontact::contact
