#include "dynamics/kernel_lanes.h"

namespace tricontact::dynamics::kernels {
namespace {

struct Pack {
    static constexpr int size = 1;
    double v;

    static Pack load(const double* from) { return {*from}; }
    static Pack all(double value) { return {value}; }
    void store(double* to) const { *to = v; }
};

inline Pack operator+(Pack a, Pack b) {
    return {a.v + b.v};
}
inline Pack operator-(Pack a, Pack b) {
    return {a.v - b.v};
}
inline Pack operator*(Pack a, Pack b) {
    return {a.v * b.v};
}
inline Pack operator/(Pack a, Pack b) {
    return {a.v / b.v};
}
inline Pack multiply_add(Pack a, Pack b, Pack c) {
    return a * b + c;
}
inline Pack multiply_subtract(Pack a, Pack b, Pack c) {
    return a * b - c;
}
inline Pack negative_multiply_add(Pack a, Pack b, Pack c) {
    return c - a * b;
}
inline Pack min(Pack a, Pack b) {
    return {a.v < b.v ? a.v : b.v};
}
inline Pack max(Pack a, Pack b) {
    return {a.v > b.v ? a.v : b.v};
}
inline Pack square_root(Pack a) {
    return {__builtin_sqrt(a.v)};
}
inline Pack clamp(Pack a, Pack bound) {
    return min(max(a, Pack{-bound.v}), bound);
}
inline Pack count_zero(Pack count, Pack a) {
    return {a.v == 0 ? count.v + 1 : count.v};
}

}  // namespace

LaneFunctions plain_lanes() {
    return lane_functions<Pack, 3>();
}

}  // namespace tricontact::dynamics::kernels
