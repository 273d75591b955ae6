#include "walking/kernels/kernel_step.h"

namespace tricontact::walking::kernels {
namespace {

struct Plain {
    using Register = double;
    static double fmadd(double a, double b, double c) { return a * b + c; }
    static double fmsub(double a, double b, double c) { return a * b - c; }
    static double fnmadd(double a, double b, double c) { return c - a * b; }
    static double min(double a, double b) { return a < b ? a : b; }
    static double max(double a, double b) { return a > b ? a : b; }
    static double sqrt(double a) { return __builtin_sqrt(a); }
    static double count_zero(double count, double a) { return a == 0 ? count + 1 : count; }
};

}  // namespace

LaneFunctions plain_lanes() {
    return lane_functions<Pack<Plain>>();
}

}  // namespace tricontact::walking::kernels
