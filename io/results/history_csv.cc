#include "io/results/history_csv.h"

#include <array>

#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

using contact::StepRecord;
using Place = std::variant<const double*, const int*>;

constexpr std::array<HistoryColumn, 28> columns{{
    {"phase", [](const StepRecord& s) { return Place(&s.phase); }},
    {"time_s", [](const StepRecord& s) { return Place(&s.time); }},
    {"offset_x_m", [](const StepRecord& s) { return Place(&s.offset[0]); }},
    {"offset_y_m", [](const StepRecord& s) { return Place(&s.offset[1]); }},
    {"normal_force_N", [](const StepRecord& s) { return Place(&s.normal_force); }},
    {"tangential_force_x_N", [](const StepRecord& s) { return Place(&s.tangential_force[0]); }},
    {"tangential_force_y_N", [](const StepRecord& s) { return Place(&s.tangential_force[1]); }},
    {"indentation_m", [](const StepRecord& s) { return Place(&s.indentation); }},
    {"shift_x_m", [](const StepRecord& s) { return Place(&s.shift[0]); }},
    {"shift_y_m", [](const StepRecord& s) { return Place(&s.shift[1]); }},
    {"rotation_rad", [](const StepRecord& s) { return Place(&s.rotation); }},
    {"torque_N_m", [](const StepRecord& s) { return Place(&s.torque); }},
    {"dissipation_J", [](const StepRecord& s) { return Place(&s.dissipation); }},
    {"material_dissipation_J", [](const StepRecord& s) { return Place(&s.material_dissipation); }},
    {"stored_energy_J", [](const StepRecord& s) { return Place(&s.stored_energy); }},
    {"released_energy_J", [](const StepRecord& s) { return Place(&s.released_energy); }},
    {"may_differ", [](const StepRecord& s) { return Place(&s.may_differ); }},
    {"contact_area_m2", [](const StepRecord& s) { return Place(&s.contact_area); }},
    {"stick_area_m2", [](const StepRecord& s) { return Place(&s.stick_area); }},
    {"slip_area_m2", [](const StepRecord& s) { return Place(&s.slip_area); }},
    {"open_area_m2", [](const StepRecord& s) { return Place(&s.open_area); }},
    {"largest_stretch", [](const StepRecord& s) { return Place(&s.largest_stretch); }},
    {"largest_shear", [](const StepRecord& s) { return Place(&s.largest_shear); }},
    {"normal_iterations", [](const StepRecord& s) { return Place(&s.normal_iterations); }},
    {"tangential_iterations", [](const StepRecord& s) { return Place(&s.tangential_iterations); }},
    {"normal_residual", [](const StepRecord& s) { return Place(&s.normal_residual); }},
    {"tangential_residual", [](const StepRecord& s) { return Place(&s.tangential_residual); }},
    {"force_residual", [](const StepRecord& s) { return Place(&s.force_residual); }},
}};

using contact::RigStiffness;

constexpr std::array<DriveColumn, 3> of_drive{{
    {"drive_shift_x_m",
     [](const RigStiffness& rig, const StepRecord& s) { return rig.drive_shift(s)[0]; }},
    {"drive_shift_y_m",
     [](const RigStiffness& rig, const StepRecord& s) { return rig.drive_shift(s)[1]; }},
    {"drive_indentation_m",
     [](const RigStiffness& rig, const StepRecord& s) { return rig.drive_depth(s); }},
}};

}  // namespace

std::span<const DriveColumn> drive_columns() {
    return of_drive;
}

std::span<const HistoryColumn> history_columns() {
    return columns;
}

std::string history_csv(const contact::History& history) {
    const contact::RigStiffness& rig = history.rig;
    const auto number = [](const auto* place) { return shortest(*place); };
    std::string out = "step";
    for (const HistoryColumn& column : history_columns()) out.append(",").append(column.name);
    if (rig.yields())
        for (const DriveColumn& column : drive_columns()) out.append(",").append(column.name);
    out += '\n';
    for (std::size_t i = 0; i < history.steps.size(); ++i) {
        out += std::to_string(i);
        for (const HistoryColumn& column : history_columns())
            out.append(",").append(std::visit(number, column.place(history.steps[i])));
        if (rig.yields())
            for (const DriveColumn& column : drive_columns())
                out.append(",").append(shortest(column.value(rig, history.steps[i])));
        out += '\n';
    }
    return out;
}

}  // namespace tricontact::io
