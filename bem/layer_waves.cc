#include "bem/layer_waves.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>

namespace tricontact::bem {

namespace {

constexpr int points_per_panel = 10;   // Gauss: exact to rounding over half a wave
constexpr double phase_per_panel = 4;  // of the waves of the argument k r

/// Ends of panels over k b: finer towards zero, where what lies deep is seen, and never wider than
/// the waves allow.
std::vector<double> panels(double first, double farthest, double last) {
    const double widest = std::min(0.5, phase_per_panel / farthest);
    std::vector<double> ends{0};
    for (double width = std::min(widest, first); ends.back() < last;
         width = std::min(widest, 2 * width))
        ends.push_back(ends.back() + width);
    return ends;
}

}  // namespace

std::vector<Wave> layer_waves(const theory::LayerStack& stack, double farthest, double last) {
    using Rule = boost::math::quadrature::gauss<double, points_per_panel>;
    const double b = stack.sheets.front().thickness;
    const auto ends = panels(theory::softest_wave_number(stack) * b, farthest / b, last);
    std::vector<Wave> waves;
    for (std::size_t p = 1; p < ends.size(); ++p) {
        const double middle = (ends[p] + ends[p - 1]) / (2 * b),
                     half = (ends[p] - ends[p - 1]) / (2 * b);
        for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
            for (const int side : {-1, 1})
                waves.push_back(
                    {middle + side * half * Rule::abscissa()[i], half * Rule::weights()[i]});
    }
    return waves;
}

theory::LayerCompliance half_space_at(const contact::Material& material, double k) {
    const double scale = 1 / (material.shear_modulus() * k), nu = material.poisson;
    return {(1 - nu) * scale, (1 - nu) * scale, scale, (1 - 2 * nu) / 2 * scale};
}

theory::LayerStack continued(const theory::LayerStack& stack) {
    const auto& top = stack.sheets.front();
    return {{{top.material, stack.thickness()}}, stack.base, top.material};
}

}  // namespace tricontact::bem
