#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "comparisons/quantities/quantities.h"
#include "report/csv.h"
#include "report/format.h"
#include "report/json_table.h"
#include "wear/wear_report.h"

namespace tricontact::wear {

namespace {

namespace quantities = comparisons::quantities;
using Json = nlohmann::ordered_json;

/// A state in summary.json and wear.csv.
Json state_json(const WornState& s) {
    Json json{{"cycles", s.cycles},
              {"worn_volume_m3", s.volume},
              {"worn_volume_error_m3", s.volume_error},
              {"worn_depth_m", s.depth},
              {"worn_depth_error_m", s.depth_error},
              {"wear_work_J", s.work},
              {"regime", name_of(s.regime())},
              {"stick_disc_radius_m", s.stick_radius()},
              {"contact_disc_radius_m", s.contact_radius()},
              {quantities::normal_force.key, s.cycle.normal_force},
              {quantities::indentation.key, s.cycle.indentation},
              {"force_amplitude_N", s.cycle.force_amplitude},
              {"shift_amplitude_m", s.cycle.shift_amplitude},
              {"worn_volume_per_cycle_m3", s.cycle.volume},
              {"work_per_cycle_J", s.cycle.work}};
    if (std::isfinite(s.cycle.shakedown_limit))
        json["worn_shakedown_limit"] = s.cycle.shakedown_limit;
    return json;
}

Json result_json(const WearResult& result) {
    Json json{{"model", result.history.model}};
    json.update(state_json(result.last()));
    json.update({{"worn_volume_bar_m3", result.volume_bar()},
                 {"worn_depth_bar_m", result.depth_bar()},
                 {"worn_shakedown_limit_bar",
                  result.limits_of_cells ? Json(result.limits_of_cells->second) : Json()},
                 {"why_no_cells", result.why_no_cells.empty() ? Json() : Json(result.why_no_cells)},
                 {"cycles_computed", result.history.cycles_computed},
                 {"states", result.history.states.size()}});
    return json;
}

}  // namespace

WearResult told_result(const contact::Case& c, contact::Model& model, const WearOptions& options) {
    WearResult result;
    WearOptions all = options;
    all.at_end = [&](const contact::WearingContact& contact, const WearHistory& history) {
        result.surface = contact.surface();
        result.line = contact.line();
        for (const std::size_t point : result.line) result.x.push_back(contact.x(point));
        result.is_of_revolution = contact.is_of_revolution();
        for (const std::size_t k : shown_states(history)) {
            const WornState& s = history.states[k];
            result.shown.push_back({{"worn_depth_m", contact.on_surface(s.worn)},
                                    {"normal_traction_Pa", contact.on_surface(s.cycle.pressure)},
                                    {"wear_per_cycle_m", contact.on_surface(s.cycle.rate)}});
        }
    };
    result.history = run_wear(c, model, all);
    return result;
}

std::string wear_csv(const WearHistory& history) {
    const Json rows = report::list_of(history.states, state_json);
    std::vector<std::string> keys;
    for (const auto& [key, value] : rows.front().items()) keys.push_back(key);
    return report::csv_of(rows, keys);
}

std::string profiles_csv(const WearResult& result) {
    std::string text =
        report::csv_line({"cycles", result.is_of_revolution ? "r_m" : "x_m", "worn_depth_m",
                          "pressure_Pa", "slip_path_per_cycle_m", "wear_per_cycle_m"});
    for (const std::size_t k : shown_states(result.history)) {
        const WornState& s = result.history.states[k];
        for (std::size_t i = 0; i < result.line.size(); ++i) {
            const std::size_t at = result.line[i];
            text += report::csv_row(s.cycles, result.x[i], s.worn[at], s.cycle.pressure[at],
                                    s.cycle.slip_path[at], s.cycle.rate[at]);
        }
    }
    return text;
}

nlohmann::ordered_json wear_json(const WearReport& report) {
    Json models = Json::object();
    for (const WearResult& result : report.results)
        models[result.history.model] = result_json(result);
    return {{"models", models}};
}

std::string limit_sentence(const WearResult& r) {
    const double before = r.history.states.front().cycle.shakedown_limit,
                 after = r.last().cycle.shakedown_limit;
    if (!std::isfinite(before) || !std::isfinite(after)) return {};
    const auto told = [&](double limit, double bar) {
        return r.limits_of_cells ? report::with_error(limit, bar) : report::significant(limit, 4);
    };
    const auto [of_new, of_worn] = r.limits_of_cells.value_or(std::pair(0., 0.));
    return fmt::format(
        "Limit of shakedown of the worn profile: F_T/(mu F_N) = {}; of the new one {}.",
        told(after, of_worn), told(before, of_new));
}

std::string wear_text(const WearReport& report) {
    std::string text;
    for (const WearResult& r : report.results) {
        const WornState& s = r.last();
        text += fmt::format(
            "{}: {} after {:.0f} cycles, worn volume {} mm3, largest depth {} µm; {} cycles "
            "computed\n",
            r.history.model, name_of(s.regime()), s.cycles,
            report::with_error(1e9 * s.volume, 1e9 * r.volume_bar()),
            report::with_error(1e6 * s.depth, 1e6 * r.depth_bar()), r.history.cycles_computed);
        if (const auto limit = limit_sentence(r); !limit.empty()) text += "  " + limit + '\n';
        if (s.regime() == WearRegime::stick)
            text +=
                "  nothing slips at its points; a ring of slip narrower than their distance is "
                "not seen\n";
    }
    return text;
}

}  // namespace tricontact::wear
