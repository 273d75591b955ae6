#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "comparisons/quantities/reference.h"
#include "comparisons/quantities/surface_fields.h"
#include "comparisons/run/figures.h"
#include "report/format.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/oscillating_cylinder.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::comparisons {

namespace {

using contact::History;

constexpr std::size_t most_points = 400;  // per curve: more than the picture resolves
constexpr int theory_points = 400;
constexpr double half_width = 1.12;  // of the figure, over a

/// Adds a closed form of |x|/a.
template <class F>
void add_theory_curve(report::Figure& figure, const std::string& name, const F& function) {
    figure.curves.emplace_back(report::Curve{.name = name, .theory = true})
        .sample(-half_width, half_width, theory_points,
                [&](double x) { return function(std::abs(x)); });
}

/// Least Hertzian bound p/p0 at `position` on an axis at `angle` to the rolling: whichever turning
/// point is farther.
double least_bound(double position, double w, double angle) {
    const double r2 = position * position + w * w + 2 * std::abs(position * w * std::cos(angle));
    return r2 < 1 ? std::sqrt(1 - r2) : 0;
}

/// Of zone_kinds(). Traction vanishes for good on released points only after shakedown.
std::size_t kind_of(Zone zone, bool shaken_down) {
    if (zone == Zone::zero) return shaken_down ? 2 : 3;
    return zone == Zone::stick ? 0 : 1;
}

report::Strip zone_strip(const History& history, const CentreLine& line) {
    report::Strip strip{.name = report::display_name(history.model)};
    const bool shaken_down = history.verdict.state == contact::State::shakedown;
    for (const Stretch& stretch : stretches(line))
        if (stretch.zone != Zone::open)
            strip.stretches.push_back(
                {kind_of(stretch.zone, shaken_down), stretch.begin, stretch.end});
    return strip;
}

void add_models(const contact::Case& c, const Histories& histories, Axis axis,
                report::Figure& figure) {
    for (const History& history : histories) {
        const CentreLine line =
            centre_line(history, *c.friction.law(), axis, drawn_pressure(c, history.scales));
        if (line.position.empty()) continue;
        auto& curve = figure.curves.emplace_back(curve_of(history));
        for (const std::size_t i : report::thinned(line.position.size(), most_points))
            if (std::abs(line.position[i]) <= half_width)
                curve.add(line.position[i], line.traction[i]);
        figure.strips.push_back(zone_strip(history, line));
    }
}

void add_bounds(const contact::Case& c, const Reference& r, Axis axis, report::Figure& figure) {
    if (!c.friction.is_coulomb() || c.interface.is_elastic()) return;
    if ((!contact::is_hertz_round(c) && !c.is_cylindrical()) || c.has_hole()) return;
    add_theory_curve(figure, "bound μp, upright", [](double x) { return least_bound(x, 0, 0); });
    if (!c.rolling || !constant_loads(c)) return;
    const double angle =
        axis == Axis::x ? c.rolling->angle : std::numbers::pi / 2 - c.rolling->angle;
    add_theory_curve(figure, "least μp of a period",
                     [&](double x) { return least_bound(x, r.amplitude_ratio, angle); });
}

/// The closed form for the state drawn, if there is one.
void add_theory(const contact::Case& c, const Reference& r, report::Figure& figure) {
    const double f = r.tangential_ratio;
    if (!in_unit_range(f) || f == 0 || !contact::is_coulomb_round(c)) return;
    if (!c.rolling)
        add_theory_curve(figure, "Cattaneo–Mindlin",
                         [&](double x) { return theory::cattaneo_mindlin_traction(x, f); });
    else if (r.shakedown_shift_ratio)
        add_theory_curve(figure, "MDR closed form", [&](double x) {
            return theory::mdr_shakedown_traction(x, r.amplitude_ratio, *r.shakedown_shift_ratio);
        });
}

/// The same of a line contact; w = 0 is Cattaneo's.
void add_line_theory(const contact::Case& c, const Reference& r, report::Figure& figure) {
    if (!r.stick_ratio) return;
    add_theory_curve(figure, "exact, half-space", [&](double x) {
        return theory::line_shakedown_traction(x, r.amplitude_ratio, *r.stick_ratio);
    });
    const bool ellipses = c.rolling && r.amplitude_ratio + *r.stick_ratio < 1;
    const auto of_thesis =
        ellipses ? theory::thesis_line_stick_half_width(r.amplitude_ratio, r.tangential_ratio)
                 : std::nullopt;
    if (of_thesis)
        add_theory_curve(figure, "thesis (3.5.22)", [&](double x) {
            return theory::thesis_line_traction(x, r.amplitude_ratio, *of_thesis);
        });
}

report::Figure traction_figure(const contact::Case& c, const Histories& histories, Axis axis) {
    const Reference r = reference(c);
    const std::string letter = axis == Axis::x ? "x" : "y";
    report::Figure figure{
        .id = "traction_" + letter,
        .title = "Traction on the centre line along " + letter,
        .caption =
            std::string("The last upright state. Strips: what each point does during the last "
                        "period. Dark "
                        "blue, stick: always in contact, below the friction bound; amber, slip: at "
                        "the bound ") +
            std::string(c.friction.bound_symbol()) +
            " at some instant; light grey, zero or released: out of contact at some instant, after "
            "shakedown no traction is left there (in coupled contact what the pressure drags). " +
            std::string(contact::has_conical_tip(c)
                            ? "a and the mean pressure p_m are each model's own: at the tip the "
                              "pressure is infinite."
                            : "a and p_0 are each model's own."),
        .x = {.label = "position " + letter + "/a", .low = -half_width, .high = half_width},
        .y = {fmt::format("traction τ_x / ({})", drawn_bound_symbol(c))},
        .kinds = zone_kinds()};
    add_models(c, histories, axis, figure);
    add_bounds(c, r, axis, figure);
    if (c.is_line_contact())
        add_line_theory(c, r, figure);
    else
        add_theory(c, r, figure);
    return figure;
}

}  // namespace

Figures traction_figures(const contact::Case& c, const Histories& histories) {
    Figures figures;
    for (const Axis axis : {Axis::x, Axis::y}) {
        if (axis == Axis::y && c.is_line_contact()) continue;  // uniform
        report::Figure figure = traction_figure(c, histories, axis);
        if (!figure.strips.empty()) figures.push_back(std::move(figure));
    }
    return figures;
}

}  // namespace tricontact::comparisons
