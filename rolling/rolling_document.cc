#include "rolling/rolling_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/heat.h"
#include "contact/models/model_kind.h"
#include "report/format.h"
#include "rolling/creep_theory.h"

namespace tricontact::rolling {

namespace {

using contact::Case;
using Settings = std::vector<std::pair<std::string, std::string>>;

std::string driven_by(const Case& c, const RollingRun& run) {
    const auto& s = run.history.steady;
    if (by_creepage(c))
        return fmt::format("driven by ξ = {}", report::significant(s.creepage.longitudinal, 4));
    const double f = force_ratio(s, c.friction);
    if (std::abs(f) < 1e-9) return "rolling freely";  // the solver's rounding
    return fmt::format("driven by F_x = {} {}", report::significant(f, 3),
                       c.friction.limit_symbol());
}

/// With what cells leave in it, where that is known.
std::string with_error(double value, const RollingRun& run, const char* key) {
    const auto width = run.error ? run.error->of(key) : std::nullopt;
    return width ? report::with_error(value, *width) : report::significant(value, 4);
}

std::string steady_sentence(const RollingReport& report, const RollingRun& run) {
    const Case& c = report.c;
    const auto& s = run.history.steady;
    std::string text = fmt::format("{}, {}: ", report::display_name(run.model), driven_by(c, run));
    text +=
        by_creepage(c)
            ? fmt::format("F_x = {} {}", with_error(force_ratio(s, c.friction), run, "force_ratio"),
                          c.friction.limit_symbol())
            : fmt::format("ξ = {}",
                          with_error(s.creepage.longitudinal, run, "longitudinal_creepage"));
    text += fmt::format(", {} % of the contact sticks",
                        report::significant(100 * s.stick_area / s.contact_area, 3));
    if (const auto way = steady_after(report, run))
        text += fmt::format("; within 1 % of it after {} a", report::significant(*way, 3));
    return text + ".";
}

// Empty where there is nothing to say.

std::string energy_sentence(const RollingReport& report) {
    std::optional<double> worst;
    for (const RollingRun& run : report.runs)
        worst = std::max(worst, energy_error(run.history.steady));
    if (!worst) return {};
    return fmt::format(
        "Energy balance: {} differs by {} from the work of creepage, spin and resistance.",
        report.c.relaxation ? "dissipation by friction and material" : "dissipation",
        report::share(*worst, 2));
}

/// Where the search for a state begins, and what may leave several.
struct StateWords {
    const char *friction, *first, *other, *of;
};

/// Friction that follows from the state may have several, of which both ends are looked for.
std::string states_sentence(const RollingReport& report, const RollingRun& run) {
    constexpr double same = 1e-5;  // far above the solver's tolerance
    if (!friction_changes(report.c)) return {};
    const StateWords words =
        report.c.friction.rate
            ? StateWords{"friction that falls with the slip", "slow", "fast", "slip"}
            : StateWords{"friction that changes with the temperature", "cold", "hot", "surfaces"};
    const std::string model = report::display_name(run.model);
    if (!run.history.why_no_fast_slip.empty())
        return fmt::format(
            "{}: whether this steady state is the only one is not known; from {} {}: {}.", model,
            words.other, words.of, run.history.why_no_fast_slip);
    if (!run.history.from_fast_slip)
        return fmt::format(
            "{}: under a force, this is the state that is found from {} {}; {} may have others, "
            "which are not looked for.",
            model, words.first, words.of, words.friction);
    const auto &slow = run.history.steady, &fast = *run.history.from_fast_slip;
    const double f = force_ratio(slow, report.c.friction),
                 other = force_ratio(fast, report.c.friction);
    const double stick = (slow.stick_area - fast.stick_area) / slow.contact_area;
    if (std::abs(f - other) <= same && std::abs(stick) <= same)
        return fmt::format("{}: from {} and from {} {} the same steady state is found.", model,
                           words.first, words.other, words.of);
    return fmt::format(
        "{}: {} leaves more than one steady state. From {} {} (told here) F_x = {} μ F_N; from {} "
        "{} {} μ F_N, and {} % of the contact sticks.",
        model, words.friction, words.first, words.of, report::significant(f, 6), words.other,
        words.of, report::significant(other, 6),
        report::significant(100 * fast.stick_area / fast.contact_area, 3));
}

/// MDR's creep over that of three dimensions beside what closed forms have for it.
std::string ratio_sentence(const RollingReport& report) {
    const RollingRun* mdr = run_of_springs(report);
    const RollingRun* bem = run_of_half_space(report);
    if (!mdr || !bem || by_creepage(report.c) || !has_thesis_creep_ratio(report.c)) return {};
    if (!(force_ratio(bem->history.steady, report.c.friction) > 0)) return {};
    const double measured =
        mdr->history.steady.creepage.longitudinal / bem->history.steady.creepage.longitudinal;
    if (!std::isfinite(measured)) return {};
    return fmt::format("MDR creeps {} times as much as BEM; by the closed forms it is {} (2.2.31).",
                       report::significant(measured, 3),
                       report::significant(thesis_creep_ratio(report.c), 3));
}

/// Of each model what the relaxing substrate resists.
std::string resistance_sentence(const RollingReport& report, const RollingRun& run) {
    if (!report.c.relaxation) return {};
    const auto& s = run.history.steady;
    return fmt::format("{}: the relaxing substrate resists with {} F_N.",
                       report::display_name(run.model),
                       report::significant(s.resistance / s.normal_force, 4));
}

/// Dissimilar cylinders without a force, beside both bounds.
std::string free_sentence(const RollingReport& report, const RollingRun& run) {
    const auto bounds = free_creepages(report.c);
    if (bounds.empty()) return {};
    const double unit = creepage_unit(report.c);
    std::string text = fmt::format(
        "{} creeps under its normal load alone, ξ = {} units", report::display_name(run.model),
        report::significant(run.history.steady.creepage.longitudinal / unit, 4));
    for (const ClosedForm& bound : bounds)
        text += fmt::format("; {}: {}", bound.name, report::significant(bound.value / unit, 4));
    return text + ".";
}

/// Of finite elements that a finite block ends.
std::string variation_sentence(const RollingRun& run) {
    if (!run.variation) return {};
    return fmt::format(
        "{}: bodies that roll on are taken for the same along their surface. By where it is within "
        "the contact, the response of a cell varies by {} of its own.",
        report::display_name(run.model), report::share(*run.variation, 2));
}

/// Of an indenter that deforms about its hub.
std::string small_strain_sentence(const RollingReport& report, const RollingRun& run) {
    const Case& c = report.c;
    if (!contact::model_kind(run.model).is_meshed() || !c.indenter.body) return {};
    const double square = std::pow(run.history.steady.half_length / c.indenter.radius, 2);
    return fmt::format(
        "{}: bodies that deform creep without a force, too, by the order of (a/R)² = {}, {} units: "
        "what small strains neglect. Half the difference of ξ under F_T and −F_T is free of "
        "it.",
        report::display_name(run.model), report::significant(square, 2),
        report::significant(square / creepage_unit(c), 2));
}

Settings settings_of(const Case& c) {
    const contact::HalfSpaceScales scales = contact::half_space_scales(c);
    Settings settings{
        {"F_N", report::quantity(scales.normal_force, "N")},
        {"a, on the half-space", report::quantity(scales.contact_radius, "m")},
        {"E", report::given_quantity(c.substrate.young, "Pa")},
        {"ν", report::as_given(c.substrate.poisson)},
        c.friction.is_coulomb_at_rest()
            ? std::pair<std::string, std::string>{"μ", report::as_given(c.friction_coefficient())}
            : std::pair<std::string, std::string>{"τ", c.friction.formula()},
        {"rolled way", report::as_given(c.tractive_rolling->distance) + " a"},
        {"unit of creepage", report::significant(creepage_unit(c), 4)},
        {"spin φ", report::as_given(c.tractive_rolling->spin) + " rad/m"}};
    if (c.interface.normal_stiffness)
        settings.emplace_back("k_n", report::given_quantity(*c.interface.normal_stiffness, "Pa/m"));
    if (c.interface.tangential_stiffness)
        settings.emplace_back("k_t",
                              report::given_quantity(*c.interface.tangential_stiffness, "Pa/m"));
    if (friction_changes(c))
        std::erase_if(settings, [](const auto& one) { return one.first == "rolled way"; });
    if (c.friction.rate) settings.emplace_back("friction", c.friction.formula());
    if (const auto& law = c.friction.temperature)
        settings.emplace_back(
            "friction",
            fmt::format("μ = {} up to {} °C, {} from {} °C on, linear between",
                        report::as_given(c.friction_coefficient()), report::as_given(law->from),
                        report::as_given(c.friction_coefficient() + law->change),
                        report::as_given(law->to)));
    if (c.tractive_rolling->speed > 0)
        settings.emplace_back("v", report::given_quantity(c.tractive_rolling->speed, "m/s"));
    if (c.layer.thickness)
        settings.emplace_back("layer, seen by BEM layer and FEM",
                              report::given_quantity(*c.layer.thickness, "m"));
    return settings;
}

}  // namespace

report::Document rolling_document(const RollingReport& report) {
    report::Document document{
        .kind = "Tractive rolling",
        .title = report.c.title.empty() ? "A contact that rolls on" : report.c.title,
        .lead =
            "The indenter rolls on to the right, from rest and steadily: how force and creepage go "
            "together, where the contact sticks, and closed forms. Creepage is the "
            "sliding of the indenter over the substrate per rolled way.",
        .settings = settings_of(report.c),
        .sections = {steady_section(report), resistance_section(report), heat_section(report),
                     transient_section(report), creep_section(report), zones_section(report)},
        .files = report.files};
    for (auto& setting : heat_settings(report)) document.settings.push_back(std::move(setting));
    const auto add = [&](const std::string& sentence) {
        if (!sentence.empty()) document.verdicts.push_back({.sentence = sentence});
    };
    for (const RollingRun& run : report.runs) {
        add(steady_sentence(report, run));
        add(states_sentence(report, run));
        add(variation_sentence(run));
        add(small_strain_sentence(report, run));
        add(resistance_sentence(report, run));
        add(heat_sentence(report, run));
        add(free_sentence(report, run));
    }
    add(ratio_sentence(report));
    add(energy_sentence(report));
    for (report::DocumentSection& section : document.sections)
        std::erase_if(section.tables, [](const auto& table) { return table.rows.empty(); });
    std::erase_if(document.sections, [](const report::DocumentSection& section) {
        return section.tables.empty() &&
               std::ranges::all_of(section.figures, [](const report::Figure& figure) {
                   return figure.curves.empty();
               });
    });
    return document;
}

}  // namespace tricontact::rolling
