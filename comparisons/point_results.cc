#include "comparisons/point_results.h"

#include <algorithm>
#include <array>

#include "comparisons/json_number.h"
#include "comparisons/relaxation_study.h"
#include "comparisons/summary.h"

namespace tricontact::comparisons {

namespace {

using json = nlohmann::ordered_json;

struct Input {
    const contact::History& history;
    const ModelSummary& summary;
    const std::optional<DriveValues>& drive;  // empty on an elastic substrate
};

struct Column {
    const char* name;
    json (*value)(const Input& in);
};

json last(const std::vector<std::optional<double>>& values) {
    return values.empty() ? json() : number(values.back());
}

json of_ends(const Input& in, double RollerEnds::*member) {
    return in.summary.ends ? number((*in.summary.ends).*member) : json();
}

json of_drive(const Input& in, double DriveValues::*member) {
    return in.drive ? number(*in.drive.*member) : json();
}

constexpr std::array<Column, 30> columns{{
    {"normal_force_N", [](const Input& in) { return number(in.history.scales.normal_force); }},
    {"indentation_m", [](const Input& in) { return number(in.summary.indentation); }},
    {"contact_radius_m", [](const Input& in) { return number(in.summary.contact_radius); }},
    {"peak_pressure_Pa", [](const Input& in) { return number(in.summary.peak_pressure); }},
    {"unit_shift_m", [](const Input& in) { return number(in.summary.unit_shift); }},
    {"tangential_ratio", [](const Input& in) { return number(in.summary.tangential_ratio); }},
    {"amplitude_m", [](const Input& in) { return number(in.history.amplitude); }},
    {"amplitude_ratio", [](const Input& in) { return number(in.summary.amplitude_ratio); }},
    {"static_shift_m", [](const Input& in) { return number(in.summary.static_shift); }},
    {"static_shift_ratio", [](const Input& in) { return number(in.summary.static_shift_ratio); }},
    {"final_shift_m", [](const Input& in) { return number(in.summary.final_shift); }},
    {"final_shift_ratio", [](const Input& in) { return number(in.summary.final_shift_ratio); }},
    {"shift_increment_ratio",
     [](const Input& in) { return number(in.summary.shift_increment_ratio); }},
    {"state",
     [](const Input& in) {
         return in.summary.state ? json(contact::name_of(*in.summary.state)) : json();
     }},
    {"periods", [](const Input& in) { return json(in.summary.periods); }},
    {"limit_tangential_ratio",
     [](const Input& in) { return number(in.summary.limit_tangential_ratio); }},
    {"stick_ratio", [](const Input& in) { return number(in.summary.stick_ratio); }},
    {"kappa", [](const Input& in) { return number(in.summary.kappa); }},
    {"eta", [](const Input& in) { return number(in.summary.eta); }},
    {"dissipation_J",
     [](const Input& in) {
         const auto& work = in.history.dissipation_per_period;
         return work.empty() ? json() : number(work.back());
     }},
    {"dissipation_ratio",
     [](const Input& in) { return last(in.summary.dissipation_ratio_per_period); }},
    {"frequency_Hz", [](const Input& in) { return of_drive(in, &DriveValues::frequency); }},
    {"storage_modulus_Pa", [](const Input& in) { return of_drive(in, &DriveValues::storage); }},
    {"loss_modulus_Pa", [](const Input& in) { return of_drive(in, &DriveValues::loss); }},
    {"largest_deborah_number",
     [](const Input& in) {
         if (!in.drive) return json();
         return json(*std::max_element(in.drive->deborah.begin(), in.drive->deborah.end()));
     }},
    {"widest_half_width_ratio",
     [](const Input& in) { return of_ends(in, &RollerEnds::widest_ratio); }},
    {"knuckle_m", [](const Input& in) { return of_ends(in, &RollerEnds::knuckle); }},
    {"end_reach_m", [](const Input& in) { return of_ends(in, &RollerEnds::reach); }},
    {"steps", [](const Input& in) { return json(in.summary.steps); }},
    {"max_force_residual_ratio",
     [](const Input& in) { return number(in.summary.max_force_residual_ratio); }},
}};

}  // namespace

const std::vector<std::string>& point_result_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Column& column : columns) all.emplace_back(column.name);
        return all;
    }();
    return names;
}

json point_results(const contact::Case& c, const contact::History& history) {
    const ModelSummary summary = summarise(c, history);
    const auto drive = drive_values(c, history.amplitude);
    json results = json::object();
    for (const Column& column : columns)
        results[column.name] = column.value({history, summary, drive});
    return results;
}

}  // namespace tricontact::comparisons
