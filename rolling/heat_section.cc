#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/heat.h"
#include "report/format.h"
#include "rolling/rolling_document.h"
#include "theory/rolling/flash_temperature.h"

namespace tricontact::rolling {

namespace {

using contact::ContactHeat;
using contact::ThermalBody;

const ContactHeat* heat_of(const RollingReport& report) {
    return report.c.kept.find<ContactHeat>();
}

/// First point of the row that is warmest in contact.
std::size_t warmest_row(const contact::Surface& s, const SurfaceTemperatures& t) {
    std::size_t warmest = 0;
    double highest = -contact::infinity;
    for (std::size_t i = 0; i < s.size(); ++i)
        if (s.normal_traction[i] > 0 && t.substrate[i] > highest)
            highest = t.substrate[i], warmest = i;
    return warmest / s.n_x * s.n_x;
}

report::Figure row_figure(const RollingRun& run) {
    const contact::Surface& s = run.history.surface;
    const SurfaceTemperatures& t = *run.history.temperatures;
    const std::size_t row = warmest_row(s, t);
    const double a = run.history.steady.half_length;
    report::Figure figure{
        .id = "temperature_" + report::id_of_model(run.model),
        .title = fmt::format("Temperatures of the surfaces: {}", report::display_name(run.model)),
        .caption =
            "On the warmest row of points along the rolling, to the right; material passes to "
            "the left. In contact both surfaces are as warm; behind it each cools into its "
            "depth, without heat to the air.",
        .x = {"x/a [-]"},
        .y = {"T [°C]"}};
    report::Curve indenter{.name = "indenter"}, substrate{.name = "substrate"};
    for (int i = 0; i < s.n_x; ++i) {
        const double x = (s.x(i) - s.offset[0]) / a;
        indenter.add(x, t.indenter[row + i]);
        substrate.add(x, t.substrate[row + i]);
    }
    figure.curves = {std::move(indenter), std::move(substrate)};
    return figure;
}

void add_body(const std::string& name, const ThermalBody& body,
              std::vector<std::pair<std::string, std::string>>& settings) {
    settings.emplace_back(name, fmt::format("λ = {}, c = {}, ρ = {}, bulk {} °C",
                                            report::given_quantity(body.conductivity, "W/(m K)"),
                                            report::given_quantity(body.specific_heat, "J/(kg K)"),
                                            report::given_quantity(body.density, "kg/m3"),
                                            report::as_given(body.temperature)));
}

}  // namespace

std::optional<HeatNumbers> heat_numbers(const RollingReport& report, const RollingRun& run) {
    const ContactHeat* heat = heat_of(report);
    const RollingState& steady = run.history.steady;
    if (!heat || !steady.temperature) return {};
    const double v = report.c.tractive_rolling->speed, a = steady.half_length;
    HeatNumbers numbers{.peclet_indenter = heat->indenter.peclet(a, v),
                        .peclet_substrate = heat->substrate.peclet(a, v),
                        .substrate_share = heat->substrate_share()};
    numbers.band_error =
        theory::band_error(std::min(numbers.peclet_indenter, numbers.peclet_substrate));
    return numbers;
}

std::string heat_sentence(const RollingReport& report, const RollingRun& run) {
    const auto numbers = heat_numbers(report, run);
    if (!numbers) return {};
    const HighestTemperature& highest = *run.history.steady.temperature;
    return fmt::format(
        "{}: the contact is at most {} °C warm, friction heats it by at most {} K. Heat flows into "
        "the depth alone (Pe = {} of the indenter, {} of the substrate): under a uniform band that "
        "is too warm by {}.",
        report::display_name(run.model), report::significant(highest.value, 4),
        report::significant(highest.friction_rise, 4),
        report::significant(numbers->peclet_indenter, 3),
        report::significant(numbers->peclet_substrate, 3), report::share(numbers->band_error, 2));
}

std::vector<std::pair<std::string, std::string>> heat_settings(const RollingReport& report) {
    std::vector<std::pair<std::string, std::string>> settings;
    if (const ContactHeat* heat = heat_of(report)) {
        add_body("heat, indenter", heat->indenter, settings);
        add_body("heat, substrate", heat->substrate, settings);
    }
    return settings;
}

report::DocumentSection heat_section(const RollingReport& report) {
    report::DocumentSection section{.id = "heat_section", .heading = "Surface temperatures"};
    report::DocumentTable table{
        .id = "temperatures",
        .title = "Heat of friction and of the bodies",
        .note =
            "T is the highest in contact, the rise its largest part by friction. Pe = v a/(2 κ); "
            "the error is that of flow into the depth alone under a uniform band as long "
            "(Jaeger 1942). Ertz and Knothe (2002); docs/explanation/surface-temperatures.md.",
        .columns =
            report::columns("model", "T [°C]", "rise [K]", "Pe, indenter:3", "Pe, substrate:3",
                            "heat of friction into the substrate [share]:3", "error [share]:2")};
    for (const RollingRun& run : report.runs) {
        const auto numbers = heat_numbers(report, run);
        if (!numbers) continue;
        const HighestTemperature& highest = *run.history.steady.temperature;
        table.rows.push_back({report::display_name(run.model), highest.value, highest.friction_rise,
                              numbers->peclet_indenter, numbers->peclet_substrate,
                              numbers->substrate_share, numbers->band_error});
        section.figures.push_back(row_figure(run));
    }
    section.tables.push_back(std::move(table));
    return section;
}

}  // namespace tricontact::rolling
