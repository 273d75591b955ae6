#include "walking/kernels/kernel_step.h"

namespace tricontact::walking::kernels {
namespace {

template <class Value>
struct Plain {
    using Number = Value;
    using Register = Value;
    static Value min(Value a, Value b) { return a < b ? a : b; }
    static Value max(Value a, Value b) { return a > b ? a : b; }
    static Value sqrt(Value a) { return static_cast<Value>(__builtin_sqrt(a)); }
    static Value count_zero(Value count, Value a) { return a == 0 ? count + 1 : count; }
};

}  // namespace

template <class Number>
LaneFunctions<Number> plain_lanes() {
    return lane_functions<Pack<Plain<Number>>>();
}
template LaneFunctions<float> plain_lanes();
template LaneFunctions<double> plain_lanes();

}  // namespace tricontact::walking::kernels
