#include "comparisons/resolution/fineness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/cells.h"
#include "contact/half_space_scales.h"
#include "contact/load_path.h"
#include "fem/settings.h"
#include "mdr/settings.h"

namespace tricontact::comparisons {

namespace {

constexpr double least_growth = 1.05;  // that a case file may ask for
constexpr int fewest_springs = 10;

int springs_of(int springs, const Fineness& by) {
    if (by.coarser == 1) return static_cast<int>(std::lround(springs * by.finer));
    // Halves whose springs stand where the whole has some agree with it by accident.
    return std::max(static_cast<int>(springs / by.coarser) - 1, fewest_springs);
}

}  // namespace

double cell_size(const contact::Case& c, const contact::ModelKind& kind) {
    if (kind.is_meshed()) return c.of<fem::Settings>().size.value();
    if (kind.is_on_cells()) return contact::cell_side(c);
    const double radius = contact::half_space_scales(c).contact_radius;
    const auto& line = c.of<mdr::Settings>();
    if (!mdr::springs_are_independent(kind, c.interface)) return radius / line.elements_per_radius;
    return 2 * (radius + contact::norm(contact::path_reach(c, radius))) / line.springs;
}

void change_resolution(contact::Case& c, const contact::ModelKind& kind, const Fineness& by) {
    const auto scale = [&](std::optional<double>& length) {
        if (length) length = *length * by.coarser / by.finer;
    };
    auto& line = c.of<mdr::Settings>();
    const bool independent = mdr::springs_are_independent(kind, c.interface);
    if (independent) line.springs = springs_of(line.springs, by);
    if (kind.is_on_line() && !independent)
        line.elements_per_radius =
            static_cast<int>(std::lround(line.elements_per_radius * by.finer / by.coarser));
    if (kind.is_on_cells()) {
        auto& cells = c.of<contact::Cells>();
        scale(cells.spacing);
        if (cells.per_radius) cells.per_radius = *cells.per_radius * by.finer / by.coarser;
    }
    if (!kind.is_meshed()) return;
    auto& elements = c.of<fem::Settings>();
    scale(elements.size);
    elements.accuracy.reset();
}

std::vector<std::string> level_keys(const contact::Case& c, const contact::ModelKind& kind,
                                    const Fineness& by) {
    const std::string key = kind.resolution;
    if (key.empty())
        throw contact::InputError(fmt::format("levels: {} {}; omit levels, or leave it out",
                                              kind.name, kind.why_no_levels));
    if (kind.is_meshed() && !c.of<fem::Settings>().size)
        throw contact::InputError(
            "levels: fem is refined from fem.size, which is not given; give it, or omit levels");
    contact::Case level = c;
    change_resolution(level, kind, by);
    const auto& line = level.of<mdr::Settings>();
    if (kind.is_on_line())
        return {fmt::format("{}={}", mdr::line_resolution(kind, c.interface),
                            mdr::springs_are_independent(kind, c.interface)
                                ? line.springs
                                : line.elements_per_radius)};
    const auto& cells = level.of<contact::Cells>();
    if (kind.is_on_cells())
        return {cells.spacing ? length_key(key, *cells.spacing)
                              : fmt::format("bem.cells_per_radius={}", *cells.per_radius)};
    const double growth = std::pow(c.of<fem::Settings>().growth, by.coarser / by.finer);
    return {length_key(key, *level.of<fem::Settings>().size),
            fmt::format("fem.growth={}", std::max(growth, least_growth))};
}

std::string length_key(const std::string& key, double metres) {
    return fmt::format("{}=\"{} m\"", key, metres);
}

}  // namespace tricontact::comparisons
