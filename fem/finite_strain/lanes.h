#pragma once

#include <cstddef>

namespace tricontact::fem {

constexpr std::size_t n_lanes = 8;

/// Compiled once for each kind of processor; the one that fits is chosen when the program starts.
/// All that such a function calls must be TRICONTACT_INLINE to be compiled with it.
#define TRICONTACT_LANES_CLONES \
    __attribute__((target_clones("arch=x86-64-v4", "avx2,fma", "default")))
#define TRICONTACT_INLINE [[gnu::always_inline]] inline

/// Numbers of several elements side by side. The compiler makes the widest instructions of them
/// that the target of the calling function has; since callers may have others, memory is aligned as
/// a single number's.
class Lanes {
  public:
    Lanes() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): constants are numbers like all others
    TRICONTACT_INLINE Lanes(double constant) : all_(Vector{} + constant) {}

    TRICONTACT_INLINE double& operator[](std::size_t lane) {
        return reinterpret_cast<double*>(&all_)[lane];
    }
    TRICONTACT_INLINE double operator[](std::size_t lane) const { return all_[lane]; }

    TRICONTACT_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) {
        return Lanes(a.all_ + b.all_);
    }
    TRICONTACT_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) {
        return Lanes(a.all_ - b.all_);
    }
    TRICONTACT_INLINE friend Lanes operator-(const Lanes& a) { return Lanes(-a.all_); }
    TRICONTACT_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) {
        return Lanes(a.all_ * b.all_);
    }
    TRICONTACT_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) {
        return Lanes(a.all_ / b.all_);
    }
    TRICONTACT_INLINE friend Lanes smaller(const Lanes& a, const Lanes& b) {
        return Lanes(a.all_ < b.all_ ? a.all_ : b.all_);
    }
    TRICONTACT_INLINE Lanes& operator+=(const Lanes& a) { return *this = *this + a; }
    TRICONTACT_INLINE Lanes& operator*=(const Lanes& a) { return *this = *this * a; }

  private:
    using Vector = double __attribute__((vector_size(n_lanes * sizeof(double)), aligned(8)));
    TRICONTACT_INLINE explicit Lanes(const Vector& all) : all_(all) {}
    Vector all_{};
};

/// A number and its derivative in one direction.
template <class T>
struct Dual {
    T value{}, change{};

    Dual() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): constants are numbers like all others
    Dual(double constant) : value(constant), change(0) {}
    Dual(const T& v, const T& c) : value(v), change(c) {}

    TRICONTACT_INLINE friend Dual operator+(const Dual& a, const Dual& b) {
        return {a.value + b.value, a.change + b.change};
    }
    TRICONTACT_INLINE friend Dual operator-(const Dual& a, const Dual& b) {
        return {a.value - b.value, a.change - b.change};
    }
    TRICONTACT_INLINE friend Dual operator*(const Dual& a, const Dual& b) {
        return {a.value * b.value, a.change * b.value + a.value * b.change};
    }
    TRICONTACT_INLINE friend Dual operator/(const Dual& a, const Dual& b) {
        const T quotient = a.value / b.value;
        return {quotient, (a.change - quotient * b.change) / b.value};
    }
    TRICONTACT_INLINE Dual& operator+=(const Dual& a) { return *this = *this + a; }
};

/// The cube root of numbers between 1e-3 and 1e3, by Halley's iteration from that of 1; with 2
/// steps of numbers between 2/3 and 3/2.
template <int steps = 7, class T>
TRICONTACT_INLINE T cube_root(const T& a) {
    T x = (2. * a + 1.) / (a + 2.);
    for (int k = 0; k < steps; ++k) {
        const T cube = x * x * x;
        x = x * (cube + 2. * a) / (2. * cube + a);
    }
    return x;
}
template <int steps = 7, class T>
TRICONTACT_INLINE Dual<T> cube_root(const Dual<T>& a) {
    const T root = cube_root<steps>(a.value);
    return {root, a.change / (3. * root * root)};
}

}  // namespace tricontact::fem
