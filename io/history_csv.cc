#include "io/history_csv.h"

#include <array>
#include <string_view>

#include "io/messages.h"

namespace tricontact::io {

namespace {

using contact::StepRecord;

struct Column {
    std::string_view name;
    double (*value)(const StepRecord&);
};

constexpr std::array<Column, 22> columns{{
    {"phase", [](const StepRecord& s) { return s.phase; }},
    {"time_s", [](const StepRecord& s) { return s.time; }},
    {"offset_x_m", [](const StepRecord& s) { return s.offset[0]; }},
    {"offset_y_m", [](const StepRecord& s) { return s.offset[1]; }},
    {"normal_force_N", [](const StepRecord& s) { return s.normal_force; }},
    {"tangential_force_x_N", [](const StepRecord& s) { return s.tangential_force[0]; }},
    {"tangential_force_y_N", [](const StepRecord& s) { return s.tangential_force[1]; }},
    {"indentation_m", [](const StepRecord& s) { return s.indentation; }},
    {"shift_x_m", [](const StepRecord& s) { return s.shift[0]; }},
    {"shift_y_m", [](const StepRecord& s) { return s.shift[1]; }},
    {"dissipation_J", [](const StepRecord& s) { return s.dissipation; }},
    {"material_dissipation_J", [](const StepRecord& s) { return s.material_dissipation; }},
    {"stored_energy_J", [](const StepRecord& s) { return s.stored_energy; }},
    {"contact_area_m2", [](const StepRecord& s) { return s.contact_area; }},
    {"stick_area_m2", [](const StepRecord& s) { return s.stick_area; }},
    {"slip_area_m2", [](const StepRecord& s) { return s.slip_area; }},
    {"open_area_m2", [](const StepRecord& s) { return s.open_area; }},
    {"normal_iterations", [](const StepRecord& s) { return double(s.normal_iterations); }},
    {"tangential_iterations", [](const StepRecord& s) { return double(s.tangential_iterations); }},
    {"normal_residual", [](const StepRecord& s) { return s.normal_residual; }},
    {"tangential_residual", [](const StepRecord& s) { return s.tangential_residual; }},
    {"force_residual", [](const StepRecord& s) { return s.force_residual; }},
}};

}  // namespace

std::string history_csv(const contact::History& history) {
    std::string out = "step";
    for (const Column& column : columns) out.append(",").append(column.name);
    out += '\n';
    for (std::size_t i = 0; i < history.steps.size(); ++i) {
        out += std::to_string(i);
        for (const Column& column : columns)
            out.append(",").append(shortest(column.value(history.steps[i])));
        out += '\n';
    }
    return out;
}

}  // namespace tricontact::io
