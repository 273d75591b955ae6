#include "io/results/history_csv.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <vector>

namespace tricontact::io::history_csv_test {
namespace {

// Columns by name, one number per line.
std::map<std::string, std::vector<double>> parsed(const std::string& csv) {
    std::istringstream lines(csv);
    std::string line, cell;
    std::getline(lines, line);
    std::vector<std::string> names;
    for (std::istringstream cells(line); std::getline(cells, cell, ',');) names.push_back(cell);
    std::map<std::string, std::vector<double>> columns;
    while (std::getline(lines, line)) {
        std::istringstream cells(line);
        for (const auto& name : names) {
            if (!std::getline(cells, cell, ',')) ADD_FAILURE() << "short line: " << line;
            columns[name].push_back(std::stod(cell));
        }
        EXPECT_FALSE(std::getline(cells, cell, ',')) << "long line: " << line;
    }
    return columns;
}

TEST(HistoryCsv, HoldsEveryNumberOfEveryStepExactly) {
    contact::History history;
    contact::StepRecord s;  // all different, none short in decimal
    s.phase = 1. / 3;
    s.time = 61. / 3;
    s.offset = {0.1 + 0.2, -1e-300 / 3};
    s.normal_force = 21.1 / 7;
    s.tangential_force = {6.7 / 3, 1e22 / 3};
    s.indentation = 5e-4 / 3;
    s.shift = {1e-5 / 3, -1e-6 / 3};
    s.rotation = 1e-2 / 3;
    s.torque = -1e-3 / 3;
    s.dissipation = 1e-9 / 7;
    s.material_dissipation = 1e-9 / 11;
    s.largest_stretch = 12. / 11;
    s.largest_shear = 2. / 11;
    s.stored_energy = 1e-3 / 7;
    s.released_energy = 1e-4 / 7;
    s.may_differ = 1;
    s.contact_area = 1. / 11;
    s.stick_area = 1. / 13;
    s.slip_area = 1. / 17;
    s.open_area = 1. / 19;
    s.normal_iterations = 48;
    s.tangential_iterations = 5;
    s.normal_residual = 1e-11 / 3;
    s.tangential_residual = 1e-12 / 3;
    s.force_residual = 1e-13 / 3;
    history.steps = {contact::StepRecord{}, s};

    const auto columns = parsed(history_csv(history));
    const std::map<std::string, double> expected{{"step", 1},
                                                 {"phase", s.phase},
                                                 {"time_s", s.time},
                                                 {"offset_x_m", s.offset[0]},
                                                 {"offset_y_m", s.offset[1]},
                                                 {"normal_force_N", s.normal_force},
                                                 {"tangential_force_x_N", s.tangential_force[0]},
                                                 {"tangential_force_y_N", s.tangential_force[1]},
                                                 {"indentation_m", s.indentation},
                                                 {"shift_x_m", s.shift[0]},
                                                 {"shift_y_m", s.shift[1]},
                                                 {"rotation_rad", s.rotation},
                                                 {"torque_N_m", s.torque},
                                                 {"dissipation_J", s.dissipation},
                                                 {"material_dissipation_J", s.material_dissipation},
                                                 {"stored_energy_J", s.stored_energy},
                                                 {"released_energy_J", s.released_energy},
                                                 {"may_differ", 1},
                                                 {"contact_area_m2", s.contact_area},
                                                 {"stick_area_m2", s.stick_area},
                                                 {"slip_area_m2", s.slip_area},
                                                 {"open_area_m2", s.open_area},
                                                 {"largest_stretch", s.largest_stretch},
                                                 {"largest_shear", s.largest_shear},
                                                 {"normal_iterations", 48},
                                                 {"tangential_iterations", 5},
                                                 {"normal_residual", s.normal_residual},
                                                 {"tangential_residual", s.tangential_residual},
                                                 {"force_residual", s.force_residual}};
    ASSERT_EQ(columns.size(), expected.size());
    for (const auto& [name, value] : expected) {
        ASSERT_TRUE(columns.contains(name)) << name;
        EXPECT_EQ(columns.at(name), (std::vector<double>{0, value})) << name;
    }
}

TEST(HistoryCsv, AnEmptyHistoryHasTheHeadOnly) {
    const std::string csv = history_csv({});
    EXPECT_EQ(csv.rfind("step,phase,time_s,offset_x_m,", 0), 0U);
    EXPECT_EQ(csv.find('\n'), csv.size() - 1);
}

}  // namespace
}  // namespace tricontact::io::history_csv_test
