#include <vector>

#include "report/csv.h"
#include "walking/machine/forces.h"
#include "walking/report/walk_document.h"
#include "walking/run/walk_judge.h"

namespace tricontact::walking {

namespace {

// Names of the columns of each spot: name_1, name_2 ...
void add_names(std::vector<std::string>& fields, const std::vector<std::string>& names,
               std::size_t n_spots) {
    for (std::size_t i = 1; i <= n_spots; ++i)
        for (const std::string& name : names) fields.push_back(name + '_' + std::to_string(i));
}

void add(std::vector<std::string>& fields, std::initializer_list<double> values) {
    for (const double value : values) fields.push_back(report::csv_field(value));
}

}  // namespace

std::string windows_csv(const WalkCase& walk_case, const Walk& walk) {
    std::vector<std::string> fields{"begin",       "end",         "mu_e",    "kinetic_energy",
                                    "z_min_ratio", "z_max_ratio", "phi_min", "phi_max"};
    add_names(fields, {"stick_time", "correlation"}, spots_of(walk_case.machine).size());
    std::string text = report::csv_line(fields);
    for (const WalkWindow& window : walk.windows) {
        WalkResult mean;
        take_statistics(walk_case.machine, window.sums, mean);
        fields.clear();
        add(fields, {window.begin, window.end, mean.mu_e, mean.kinetic_energy, mean.z_min_ratio,
                     mean.z_max_ratio, mean.phi_min, mean.phi_max});
        for (const auto& [stick_time, correlation] : mean.spots)
            add(fields, {stick_time, correlation});
        text += report::csv_line(fields);
    }
    return text;
}

std::string motion_csv(const WalkCase& walk_case, const Walk& walk) {
    const Machine& machine = walk_case.machine;
    const auto& dimensional = walk_case.dimensional;
    const auto spots = spots_of(machine);
    std::vector<std::string> fields{"time",       "base",         "x",
                                    "z",          "phi",          "x_velocity",
                                    "z_velocity", "phi_velocity", "spring_force"};
    if (dimensional) fields.insert(fields.end(), {"time_s", "spring_force_N"});
    add_names(fields, {"normal_force", "tangential_force", "contact_state"}, spots.size());
    std::string text = report::csv_line(fields);
    for (const Snapshot& snapshot : walk.tail) {
        const Motion& m = snapshot.motion;
        const double pull = spring_force(machine, m);
        fields.clear();
        add(fields,
            {m.time, m.base, m.x, m.z, m.phi, m.x_velocity, m.z_velocity, m.phi_velocity, pull});
        if (dimensional)
            add(fields,
                {m.time * characteristic_time(*dimensional), pull * force_unit(*dimensional)});
        for (std::size_t i = 0; i < spots.size(); ++i) {
            const auto force = spot_force(machine, spots[i], m.spots[i]);
            add(fields, {force.normal, force.tangential});
            fields.push_back(std::to_string(static_cast<int>(snapshot.spots[i])));
        }
        text += report::csv_line(fields);
    }
    return text;
}

}  // namespace tricontact::walking
