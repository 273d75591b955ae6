#include "report/fields.h"

#include <gtest/gtest.h>

#include "contact/special_values.h"
#include "report/table_text.h"

namespace tricontact::report::fields_test {

struct Spring {
    std::string name;
    double stiffness;  // [N/m]
    std::optional<double> error;
    int coils;
    bool welded;
};

const Fields<Spring> spring_fields{
    {"name", "spring", &Spring::name},
    {"stiffness_N_per_m", "k [kN/m]:3", &Spring::stiffness, 1e3, &Spring::error},
    {"error_N_per_m", &Spring::error, In::json},
    {"coils", "coils", &Spring::coils},
    {"welded", "welded", &Spring::welded},
    {"", "k per coil [N/m]", [](auto& s) { return s.stiffness / s.coils; }}};

const std::vector<Spring> springs{{"a, soft", 1234.5, 40., 3, false},
                                  {"b", contact::undefined, {}, 4, true}};

TEST(Fields, ObjectInJson) {
    EXPECT_EQ(json_of(spring_fields, springs[0]).dump(),
              R"({"name":"a, soft","stiffness_N_per_m":1234.5,"error_N_per_m":40.0,"coils":3,)"
              R"("welded":false})");
    EXPECT_EQ(json_of(spring_fields, springs[1]).dump(),
              R"({"name":"b","stiffness_N_per_m":null,"error_N_per_m":null,"coils":4,)"
              R"("welded":true})");
}

TEST(Fields, LinesOfCsv) {
    EXPECT_EQ(csv_of(spring_fields, springs),
              "name,stiffness_N_per_m,coils,welded\n\"a, soft\",1234.5,3,false\nb,,4,true\n");
}

TEST(Fields, TableForPageAndTerminal) {
    const DocumentTable table = table_of({.id = "springs"}, spring_fields, springs);
    ASSERT_EQ(table.columns.size(), 5U);
    EXPECT_EQ(table.columns[1].heading, "k [kN/m]");
    EXPECT_EQ(table.columns[1].digits, 3);
    EXPECT_EQ(std::get<WithError>(table.rows[0][1]).error, .04);
    EXPECT_EQ(table_text(table),
              "spring      k [kN/m]  coils  welded  k per coil [N/m]\n"
              "a, soft  1.23 ± 0.04      3  no                 411.5\n"
              "b                  –      4  yes                    –\n");
    EXPECT_EQ(table_text(table, 1), "spring\na, soft\nb\n");
}

TEST(Fields, WithWhatTheResultBelongsTo) {
    const Fields<Spring, double> fields{
        {"share", "share [%]", [](auto& s, double whole) { return s.stiffness / whole; }, .01}};
    EXPECT_EQ(csv_of(fields, springs, 2469.), "share\n0.5\n\n");
    EXPECT_EQ(std::get<double>(table_of({}, fields, springs, 2469.).rows[0][0]), 50);
}

}  // namespace tricontact::report::fields_test
