#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "contact/half_space_scales.h"
#include "contact/models/model_kind.h"
#include "contact/rig_stiffness.h"
#include "report/format.h"
#include "report/json_table.h"
#include "theory/worn_paraboloid.h"
#include "wear/wear_report.h"

namespace tricontact::wear {

namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

constexpr std::size_t most_shown = 8;

std::string cycles_text(double cycles) {
    return fmt::format("{:.6g} cycles", cycles);
}

/// What partial slip wears in the end, where it is known: a paraboloid on the half-space under a
/// depth and a shift that are prescribed.
std::optional<theory::WornParaboloid> limit_of(const contact::Case& c, const WearResult& r) {
    const contact::PrescribedPath& path = *c.prescribed_path;
    const auto& row = path.rows.back();
    const auto* const rig = c.kept.find<contact::RigStiffness>();
    if ((rig && rig->yields()) || contact::norm(path.reach()) > 0) return {};
    if (!contact::model_kind(r.history.model).is_half_space() ||
        c.indenter.shape != contact::Case::Shape::paraboloid || !contact::is_coulomb_round(c) ||
        row.normal.kind != contact::NormalControl::Kind::indentation ||
        row.tangential[0].kind != contact::TangentialControl::Kind::shift || path.loads_across() ||
        path.twists())
        return {};
    for (const auto& other : path.rows)
        if (other.normal != row.normal) return {};
    const auto bodies = c.materials();
    const auto limit = theory::WornParaboloid::of_cycle(
        c.indenter.radius, row.normal.value, r.last().cycle.shift_amplitude,
        c.friction_coefficient() * bodies.effective_modulus() / bodies.effective_shear_modulus());
    if (!(limit.stick_radius > 0)) return {};
    return limit;
}

/// Over x, a curve for each shown state.
template <class Value>
report::Figure profile_figure(const WearResult& r, const std::string& id, const std::string& title,
                              const std::string& axis, const Value& value) {
    const std::string model = report::display_name(r.history.model);
    report::Figure figure{.id = id + '-' + report::id_of_model(r.history.model),
                          .title = title + ", " + model,
                          .caption = title +
                                     " along x through the centre, after the cycles that "
                                     "the legend states.",
                          .x = {.label = r.is_of_revolution ? "r [mm]" : "x [mm]"},
                          .y = {.label = axis}};
    for (const std::size_t k : shown_states(r.history)) {
        const WornState& s = r.history.states[k];
        report::Curve curve{.name = cycles_text(s.cycles)};
        for (std::size_t i = 0; i < r.line.size(); ++i)
            curve.add(1e3 * r.x[i], value(s, r.line[i]));
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

/// Over the cycles, a curve for each model.
template <class Value>
report::Figure history_figure(const WearReport& report, const std::string& id,
                              const std::string& title, const std::string& axis,
                              const Value& value) {
    report::Figure figure{.id = id,
                          .title = title,
                          .caption = title + " over the cycles of the path.",
                          .x = {.label = "cycles [-]"},
                          .y = {.label = axis}};
    for (const WearResult& r : report.results) {
        report::Curve curve{.name = report::display_name(r.history.model)};
        for (const WornState& s : r.history.states) curve.add(s.cycles, value(s));
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

report::DocumentSection numbers_section(const WearReport& report) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    const nlohmann::ordered_json all = wear_json(report);
    for (const auto& one : all["models"].items()) rows.push_back(one.value());
    return {.id = "wear",
            .heading = "Wear",
            .tables = {report::table_of(
                {.id = "wear",
                 .title = "After the last cycle",
                 .note = "Bars add up what jumps over cycles leave (a bound) and the difference "
                         "to a run on cells twice as large, where there is one. Radii are those of "
                         "discs as large as what never slips and as what touches."},
                rows,
                {{"model", "model"},
                 {"cycles", "cycles"},
                 {"regime", "regime"},
                 {"worn_volume_m3", "worn volume [mm³]", 1e-9, "worn_volume_bar_m3"},
                 {"worn_depth_m", "largest depth [µm]", 1e-6, "worn_depth_bar_m"},
                 {"wear_work_J", "friction work [J]"},
                 {"stick_disc_radius_m", "stick radius [mm]", 1e-3},
                 {"contact_disc_radius_m", "contact radius [mm]", 1e-3},
                 {"cycles_computed", "cycles computed"}})},
            .open = true};
}

report::DocumentSection history_section(const WearReport& report) {
    return {.id = "over-cycles",
            .heading = "Over the cycles",
            .figures = {
                history_figure(report, "volume", "Worn volume", "worn volume [mm³]",
                               [](const WornState& s) { return 1e9 * s.volume; }),
                history_figure(report, "stick-radius", "Stick radius", "stick radius [mm]",
                               [](const WornState& s) { return 1e3 * s.stick_radius(); }),
                history_figure(report, "contact-radius", "Contact radius", "contact radius [mm]",
                               [](const WornState& s) { return 1e3 * s.contact_radius(); }),
                history_figure(report, "work", "Friction work in a cycle", "work in a cycle [mJ]",
                               [](const WornState& s) { return 1e3 * s.cycle.work; })}};
}

report::DocumentSection profile_section(const contact::Case& c, const WearResult& r) {
    report::DocumentSection section{
        .id = "profiles-" + report::id_of_model(r.history.model),
        .heading = "Profiles, " + report::display_name(r.history.model),
        .figures = {
            profile_figure(r, "depth", "Worn depth", "worn depth [µm]",
                           [](const WornState& s, std::size_t i) { return 1e6 * s.worn[i]; }),
            profile_figure(
                r, "pressure", "Pressure", "p [MPa]",
                [](const WornState& s, std::size_t i) { return 1e-6 * s.cycle.pressure[i]; })}};
    if (const auto limit = limit_of(c, r)) {
        report::Curve curve{.name = "limit, Popov (2014)", .theory = true};
        for (const double x : r.x) curve.add(1e3 * x, 1e6 * limit->worn(std::abs(x)));
        section.figures.front().curves.push_back(std::move(curve));
    }
    return section;
}

std::string sentence_of(const WearResult& r) {
    const WornState& s = r.last();
    return fmt::format("{}: after {} ({}) {} mm³ are worn, {} µm at the deepest.",
                       report::display_name(r.history.model), cycles_text(s.cycles),
                       name_of(s.regime()),
                       report::with_error(1e9 * s.volume, 1e9 * r.volume_bar()),
                       report::with_error(1e6 * s.depth, 1e6 * r.depth_bar()));
}

/// In coupled contact, pressures change from step to step of the cycle.
std::string steps_sentence(const WearResult& r) {
    const contact::WornCycle& cycle = r.last().cycle;
    constexpr double told = 1e-3;
    const double off = std::abs(cycle.volume_by_means / cycle.volume - 1);
    if (!(cycle.volume > 0) || off < told) return {};
    return fmt::format(
        "{}: pressures change within the cycle; steps leave about {} of its wear, see path.steps.",
        report::display_name(r.history.model), report::share(off));
}

Settings settings_of(const contact::Case& c) {
    const auto& law = c.of<contact::Wear>();
    Settings settings{{"cycles", fmt::format("{}", law.cycles)}};
    if (law.coefficient)
        settings.emplace_back("k_w", report::significant(*law.coefficient * 1e9, 4) + " mm³/(N m)");
    else
        settings.emplace_back("k_E",
                              report::significant(*law.energy_coefficient * 1e9, 4) + " mm³/J");
    settings.emplace_back("tolerance of jumps", report::as_given(law.tolerance));
    return settings;
}

}  // namespace

std::vector<std::size_t> shown_states(const WearHistory& history) {
    const std::size_t last = history.states.size() - 1;
    std::vector<std::size_t> shown{0};
    const double end = history.states[last].cycles;
    const double first = last > 0 ? history.states[1].cycles : end;
    for (std::size_t k = 0; k + 2 < most_shown; ++k) {
        const double at = first * std::pow(end / first, static_cast<double>(k) / (most_shown - 2));
        const auto found = std::ranges::find_if(
            history.states, [&](const WornState& s) { return s.cycles >= at * (1 - 1e-12); });
        const auto index = static_cast<std::size_t>(found - history.states.begin());
        if (index > shown.back() && index < last) shown.push_back(index);
    }
    if (last > 0) shown.push_back(last);
    return shown;
}

report::Document wear_document(const WearReport& report) {
    report::Document document{
        .kind = "Wear",
        .title = report.c.title.empty() ? "A contact that wears" : report.c.title,
        .lead =
            "The closed cycle of a path is repeated; where the surfaces slip under pressure "
            "they wear, and the next cycles press on the worn profile. Most cycles are jumped "
            "over, with a bound of what that leaves.",
        .settings = settings_of(report.c),
        .sections = {numbers_section(report), history_section(report)},
        .files = report.files};
    for (const WearResult& r : report.results) {
        document.verdicts.push_back({.sentence = sentence_of(r)});
        if (const auto limit = limit_sentence(r); !limit.empty())
            document.verdicts.push_back(
                {.sentence = report::display_name(r.history.model) + ": " + limit});
        if (const auto steps = steps_sentence(r); !steps.empty())
            document.verdicts.push_back({.sentence = steps});
        document.sections.push_back(profile_section(report.c, r));
    }
    return document;
}

}  // namespace tricontact::wear
