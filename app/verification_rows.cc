#include "app/verification_rows.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>

#include "contact/run.h"

namespace tricontact::app {

using contact::Case;
using contact::History;

namespace {

void add_level(Levels& levels, const Case& c, double size, const Say& say) {
    say(fmt::format("{}, level {}", levels.model, levels.sizes.size() + 1));
    levels.sizes.push_back(size);
    levels.histories.push_back(contact::run(c, *make_model(levels.model, c, 1, say)));
}

}  // namespace

Levels run_levels(const std::string& model, const Case& base, const SetLevel& set_level,
                  const Size& size, const Say& say) {
    Levels levels{model, {}, {}};
    for (int factor = 1; factor <= 4; factor *= 2) {
        Case c = base;
        set_level(c, factor);
        add_level(levels, c, size(c), say);
    }
    return levels;
}

Levels run_level(const std::string& model, const Case& c, double size, const Say& say) {
    Levels levels{model, {}, {}};
    add_level(levels, c, size, say);
    return levels;
}

double radius_mm(const History& h) {
    return h.scales.contact_radius * 1e3;
}
double indentation_mm(const History& h) {
    return h.scales.indentation * 1e3;
}
double peak_pressure_mpa(const History& h) {
    return h.scales.peak_pressure * 1e-6;
}
double unit_shift_mm(const History& h) {
    return h.scales.unit_shift * 1e3;
}
double limit(const History& h) {
    return h.limit_tangential_ratio;
}
double static_shift_mm(const History& h) {
    return h.static_shift * 1e3;
}
double static_ratio(const History& h) {
    return h.static_shift / h.scales.unit_shift;
}
double settled_ratio(const History& h) {
    return h.shift_per_period.back() / h.scales.unit_shift;
}
double stick_ratio(const History& h) {
    auto loaded = h.steps.begin();
    while (std::next(loaded) != h.steps.end() && std::next(loaded)->phase == 0) ++loaded;
    return std::sqrt(loaded->stick_area / std::numbers::pi) / h.scales.contact_radius;
}

}  // namespace tricontact::app
