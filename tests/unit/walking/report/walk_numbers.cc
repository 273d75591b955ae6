// Numbers of a walking machine's run as files have them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/unit/walking/sets.h"
#include "walking/report/walk_document.h"
#include "walking/run/walk.h"

namespace tricontact::walking::walk_numbers_test {
namespace {

constexpr Recording recording{.start = 0, .tail = 10, .interval = 0.1};

WalkCase set_b(double end) {
    WalkCase c;
    c.machine.kappas = walking::set_b();
    c.time.end = end;
    return c;
}

// A table whose columns are called by their names.
class Table {
  public:
    explicit Table(const std::string& csv) {
        std::istringstream in(csv);
        std::string line;
        std::getline(in, line);
        names_ = split(line);
        while (std::getline(in, line)) rows_.push_back(split(line));
    }

    std::size_t n_rows() const { return rows_.size(); }
    double at(std::size_t row, const std::string& name) const {
        const auto place = std::ranges::find(names_, name) - names_.begin();
        return std::stod(rows_.at(row).at(static_cast<std::size_t>(place)));
    }

  private:
    static std::vector<std::string> split(const std::string& line) {
        std::vector<std::string> fields;
        std::istringstream in(line);
        for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
        return fields;
    }

    std::vector<std::string> names_;
    std::vector<std::vector<std::string>> rows_;
};

TEST(WalkJson, UndefinedNumbersAreNull) {
    Walk walk;
    walk.result.mu_e = std::numeric_limits<double>::quiet_NaN();
    walk.result.spots = {{0.25, -0.5}, {0.75, std::numeric_limits<double>::quiet_NaN()}};
    const auto json = walk_json(set_b(1), walk);
    EXPECT_TRUE(json["mu_e"].is_null());
    EXPECT_TRUE(json["period"].is_null());
    EXPECT_TRUE(json["phases"].is_null());
    EXPECT_TRUE(json["tilting_time"].is_null());
    EXPECT_EQ(json["stick_time_1"], 0.25);
    EXPECT_EQ(json["stick_time_2"], 0.75);
    EXPECT_EQ(json["correlation_1"], -0.5);
    EXPECT_TRUE(json["correlation_2"].is_null());
}

TEST(WalkJson, DimensionalNumbersAreTheOthersInSiUnits) {
    WalkCase c = set_b(1);
    c.dimensional = with_dimensions(c.machine.kappas, 0.5, 0.02);
    Walk walk;
    walk.result.regime = Regime::limit_cycle;
    walk.result.mu_e = 0.25;
    walk.result.period = 4;
    const auto json = walk_json(c, walk)["dimensional"];
    const double tau = std::sqrt(0.5 / c.dimensional->tangential_stiffness);
    EXPECT_DOUBLE_EQ(json["period_s"], 4 * tau);
    EXPECT_DOUBLE_EQ(json["frequency_Hz"], 1 / (4 * tau));
    // A quarter of the friction of steady sliding, mu m g.
    EXPECT_DOUBLE_EQ(json["mean_spring_force_N"], 0.25 * 0.68 * 0.5 * 9.81);
    // kappa4 b/(2 kappa2)
    EXPECT_DOUBLE_EQ(json["static_displacement_m"], 1e-4 * 0.02 / 2.4);
    EXPECT_TRUE(walk_json(set_b(1), walk)["dimensional"].is_null());
}

// From the turning point on.
TEST(WalkJson, PhasesHaveTheirNames) {
    Walk walk;
    walk.phases = WalkPhases{.period = 4,
                             .sticking = 50,
                             .turning_point = 51,
                             .release = 52,
                             .jump = 53,
                             .landing = 55,
                             .jump_height = 0.25,
                             .airborne = 0.5,
                             .airborne_advance = 0.75};
    const auto json = walk_json(set_b(1), walk)["phases"];
    EXPECT_EQ(json["sticking"], -1);
    EXPECT_EQ(json["release"], 1);
    EXPECT_EQ(json["jump"], 2);
    EXPECT_EQ(json["landing"], 4);
    EXPECT_EQ(json["jump_height"], 0.25);
    EXPECT_EQ(json["airborne"], 0.5);
    EXPECT_EQ(json["airborne_advance"], 0.75);
}

// k_x = m g/(kappa4 b): units of force k_x b and of time sqrt(m/k_x).
TEST(WalkCsv, DimensionalColumnsAreTheOthersInSiUnits) {
    WalkCase c = set_b(1);
    c.dimensional = with_dimensions(c.machine.kappas, 0.5, 0.02);
    Walk walk;
    walk.tail.resize(1);
    walk.tail[0].motion = {.time = 3, .base = 2e-5, .spots = {{}, {}}};
    walk.tail[0].spots.resize(2);
    const Table table(motion_csv(c, walk));
    EXPECT_DOUBLE_EQ(table.at(0, "time"), 3);
    EXPECT_NEAR(table.at(0, "time_s"), 3 * std::sqrt(1e-4 * 0.02 / 9.81), 1e-15);
    EXPECT_DOUBLE_EQ(table.at(0, "spring_force"), 4e-5);
    EXPECT_NEAR(table.at(0, "spring_force_N"), 0.4 * 0.5 * 9.81, 1e-12);
}

// The base moves at kappa6, and the force is that of the spring between base and body.
TEST(WalkCsv, MotionIsThatOfTheEnd) {
    const WalkCase c = set_b(100);
    const Table table(motion_csv(c, walk(c, recording)));
    ASSERT_EQ(table.n_rows(), 101U);
    for (const std::size_t row : {0U, 50U, 100U}) {
        const double time = 90 + 0.1 * static_cast<double>(row);
        EXPECT_NEAR(table.at(row, "time"), time, 1e-9);
        EXPECT_NEAR(table.at(row, "base"), 1e-4 * time, 1e-12);
        EXPECT_NEAR(table.at(row, "spring_force"),
                    2 * (table.at(row, "base") - table.at(row, "x") + 1.18 * table.at(row, "phi")),
                    1e-16);
        const double left = table.at(row, "z") + table.at(row, "phi") / 0.5;
        EXPECT_NEAR(table.at(row, "normal_force_1"), 1.2 * std::max(0., left), 1e-16);
        EXPECT_EQ(table.at(row, "contact_state_1") == 0, left <= 0);
    }
}

// Windows follow each other to the end of the run.
TEST(WalkCsv, WindowsMakeUpTheRun) {
    const WalkCase c = set_b(400);
    const Walk walk = walking::walk(c, recording);
    const Table table(windows_csv(c, walk));
    ASSERT_EQ(table.n_rows(), walk.windows.size());
    EXPECT_EQ(table.at(0, "begin"), 0);
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < table.n_rows(); ++row) {
        if (row > 0) {
            EXPECT_EQ(table.at(row, "begin"), table.at(row - 1, "end"));
        }
        EXPECT_GE(table.at(row, "stick_time_1"), 0);
        EXPECT_LE(table.at(row, "stick_time_1"), 1);
        EXPECT_LE(std::abs(table.at(row, "correlation_2")), 1);
        lowest = std::min(lowest, table.at(row, "z_min_ratio"));
    }
    EXPECT_NEAR(table.at(table.n_rows() - 1, "end"), 400, 20);
    EXPECT_LT(lowest, 0);  // it jumps on its way to the limit cycle
}

}  // namespace
}  // namespace tricontact::walking::walk_numbers_test
