#include "io/tables/csv_table.h"

#include <gtest/gtest.h>

#include <string>

#include "contact/error.h"

namespace tricontact::io::csv_table_test {
namespace {

const CsvForm form{"record", "time [s], shift [um]", 4, "leave out every second row"};

CsvTable table_of(const std::string& text) {
    return {text, "run.csv", form};
}

template <class F>
std::string message_of(F refused) {
    try {
        refused();
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(CsvTable, ValuesAreInSiUnitsByTheHeader) {
    const CsvTable table =
        table_of("# a note\nshift [um]; time [min]; weight; ratio [%]\n\n1.1; 2; 3; 4\n-5;6;7;8\n");
    EXPECT_EQ(table.name(), "run.csv");
    EXPECT_EQ(table.n_rows(), 2U);
    EXPECT_EQ(table.columns()[0].heading, "shift [um]");
    // Equal to the last bit: a quantity is the double nearest to what the text says.
    EXPECT_EQ(table.values("shift", Dimension::length), (std::vector<double>{1.1e-6, -5e-6}));
    EXPECT_EQ(table.values("time", Dimension::time), (std::vector<double>{120, 360}));
    EXPECT_EQ(table.values("weight", Dimension::none), (std::vector<double>{3, 7}));
    EXPECT_TRUE(table.has("ratio"));
    EXPECT_FALSE(table.has("ratio [%]"));
}

TEST(CsvTable, ColumnsAreAskedForByNameAndDimension) {
    const CsvTable table = table_of("\ntime [s], shfit [um], force\n1, 2, 3\n");
    const std::string remedy = "; write for example time [s], shift [um]";
    EXPECT_EQ(message_of([&] { table.values("shift", Dimension::length); }),
              "run.csv:2: the column shift is missing (is \"shfit\" meant to be it?)" + remedy);
    EXPECT_EQ(message_of([&] { table.values("drive", Dimension::length); }),
              "run.csv:2: the column drive is missing" + remedy);
    EXPECT_EQ(message_of([&] { table.values("force", Dimension::force); }),
              "run.csv:2: the column \"force\" has no unit in brackets" + remedy);
    EXPECT_EQ(message_of([&] { table.values("time", Dimension::length); }),
              "run.csv:2: \"s\" is a unit of time, but this is a length" + remedy);
    EXPECT_EQ(message_of([&] { table.refuse_value(0, "time", "is late", "start earlier"); }),
              "run.csv:3: time = 1: is late; start earlier");
}

TEST(CsvTable, BadTextsAreRefused) {
    const auto refusal = [](const std::string& text) {
        return message_of([&] { table_of(text); });
    };
    const std::string remedy = "; write for example time [s], shift [um]";
    EXPECT_EQ(refusal(""), "run.csv: the table is empty" + remedy);
    EXPECT_EQ(refusal("a,b\n1,2\n1\n"), "run.csv:3: has 1 columns instead of 2" + remedy);
    EXPECT_EQ(refusal("a [m],a [s]\n"), "run.csv:1: the column \"a [s]\" stands twice" + remedy);
    EXPECT_EQ(refusal("a,b\n1,nan\n"),
              "run.csv:2: b = nan: must be a finite number; correct or remove the row");
    for (const std::string number : {"1e-999999999", "1e999", "-1e-400"})
        EXPECT_EQ(refusal("a,b\n1," + number + "\n"),
                  "run.csv:2: b = " + number +
                      ": is too large or too small for double precision; correct the row");
    for (const std::string number : {"1e308", "1e-320"})
        EXPECT_NE(
            message_of([&] {
                const std::string unit = number[2] == '3' ? "km" : "nm";
                table_of("a [" + unit + "]\n1\n" + number + "\n").values("a", Dimension::length);
            }).find(": leaves the range of double precision in SI units; correct the row"),
            std::string::npos)
            << number;
    EXPECT_EQ(refusal("a,b\n1,2 um\n"),
              "run.csv:2: b = 2 um: must be a number; write for example 0.21, with a point");
    EXPECT_EQ(refusal("a\n1\n2\n3\n4\n5\n"),
              "run.csv: has more than 4 rows; leave out every second row");
}

}  // namespace
}  // namespace tricontact::io::csv_table_test
