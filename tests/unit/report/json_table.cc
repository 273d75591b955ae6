#include "report/json_table.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/table_text.h"

namespace tricontact::report::json_table_test {

using Json = nlohmann::ordered_json;

const Json springs = Json::parse(R"([
    {"model": "bem-layer", "name": "a, soft", "stiffness_N_per_m": 1234.5, "error_N_per_m": 40.0,
     "coils": 3, "welded": false, "load": {"force_N": 2.5}},
    {"model": "mdr", "name": "b", "stiffness_N_per_m": null, "error_N_per_m": null, "coils": 4,
     "welded": true, "load": {"force_N": 3.0}}])");

TEST(JsonTable, LinesOfCsv) {
    EXPECT_EQ(
        csv_of(springs, {"model", "name", "stiffness_N_per_m", "coils", "welded", "/load/force_N"}),
        "model,name,stiffness_N_per_m,coils,welded,/load/force_N\n"
        "bem-layer,\"a, soft\",1234.5,3,false,2.5\nmdr,b,,4,true,3\n");
}

TEST(JsonTable, TableForPageAndTerminal) {
    const DocumentTable table = table_of({.id = "springs"}, springs,
                                         {{"model", "model"},
                                          {"name", "spring"},
                                          {"stiffness_N_per_m", "k [kN/m]:3", 1e3, "error_N_per_m"},
                                          {"coils", "coils"},
                                          {"welded", "welded"},
                                          {"/load/force_N", "F [N]"}});
    EXPECT_EQ(table.columns[2].heading, "k [kN/m]");
    EXPECT_EQ(table.columns[2].digits, 3);
    EXPECT_EQ(std::get<WithError>(table.rows[0][2]).error, .04);
    EXPECT_EQ(table_text(table),
              "model      spring      k [kN/m]  coils  welded  F [N]\n"
              "BEM layer  a, soft  1.23 ± 0.04      3  no      2.500\n"
              "MDR        b                  –      4  yes     3.000\n");
    EXPECT_EQ(table_text(table, 1), "model\nBEM layer\nMDR\n");
    EXPECT_THROW(table_of({}, springs, {{"stifness", "k"}}), Json::out_of_range);
}

TEST(JsonTable, EstimatesAreValuesWithBars) {
    const auto cell = [](const char* text) {
        return std::get<WithError>(cell_of(Json::parse(text), .1));
    };
    EXPECT_NEAR(cell(R"({"value": 2.0, "standard_error": 0.1, "low": 1.5, "high": 2.5})").error, 5,
                1e-12);
    EXPECT_NEAR(cell(R"({"value": 2.0, "standard_error": 0.1})").error, 1, 1e-12);
    EXPECT_NEAR(std::get<double>(cell_of(Json::parse(R"({"value": 2.0, "standard_error": null})"))),
                2, 1e-12);
}

}  // namespace tricontact::report::json_table_test
