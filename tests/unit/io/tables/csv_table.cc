#include "io/tables/csv_table.h"

#include <gtest/gtest.h>

#include <string>

#include "contact/base/error.h"
#include "io/keys/messages.h"
#include "io/tables/divided_text.h"

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

/// Two rows of 1.5, 2 and 3, 4.25 in seconds and micrometres.
void expect_run(const CsvTable& table, const std::string& what) {
    SCOPED_TRACE(what);
    ASSERT_EQ(table.n_rows(), 2U);
    ASSERT_EQ(table.columns().size(), 2U);
    EXPECT_EQ(table.values("time", Dimension::time), (std::vector<double>{1.5, 3}));
    EXPECT_EQ(table.values("shift", Dimension::length), (std::vector<double>{2e-6, 4.25e-6}));
}

TEST(CsvTable, IsReadAsProgramsWriteIt) {
    for (const char* text :
         {// R: write.csv, with and without row.names, and write.table
          "\"\",\"time [s]\",\"shift [um]\"\n\"1\",1.5,2\n\"2\",3,4.25\n",
          "\"time [s]\",\"shift [um]\"\n1.5,2\n3,4.25\n",
          "\"time [s]\" \"shift [um]\"\n\"1\" 1.5 2\n\"2\" 3 4.25\n",
          // R: write.csv2 of a German locale
          "\"\";\"time [s]\";\"shift [um]\"\n\"1\";1,5;2\n\"2\";3;4,25\n",
          // pandas: to_csv, to_csv(sep=\"\\t\"), to_csv(index=False, decimal=",", sep=";")
          ",time [s],shift [um]\n0,1.5,2.0\n1,3.0,4.25\n",
          "\ttime [s]\tshift [um]\n0\t1.5\t2.0\n1\t3.0\t4.25\n",
          "time [s];shift [um]\n1,5;2,0\n3,0;4,25\n",
          // pandas after rows were dropped
          ",time [s],shift [um]\n3,1.5,2.0\n7,3.0,4.25\n",
          // NumPy: savetxt with a header
          "# a note\n# time [s] shift [um]\n1.5 2.0\n3.0 4.25\n",
          // quoted numbers, dividers at the ends of lines, units in parentheses
          "\"time [s]\",\"shift [um]\"\n\"1,5\",\"2\"\n\"3\",\"4,25\"\n",
          "time (s),shift (um),\n1.5,2,\n3,4.25,\n", "time [s],shift [um]\n1.5,2,\n3,4.25,\n",
          // units in a second row
          "time,shift\ns,um\n1.5,2\n3,4.25\n", "time;shift\n[s];[um]\n1,5;2\n3;4,25\n",
          // a preamble, of other widths and of the same
          "Instrument v2\nDate,2026-01-01,12:00\n\ntime [s],shift [um]\n1.5,2\n3,4.25\n",
          "Sample,gel 3\nTemperature,25.1\nDate,2026-01-01\ntime [s], shift [um]\n1.5,2\n3,4.25\n",
          "Sample\tgel 3\ntime\tshift\ns\tum\n1.5\t2\n3\t4.25\n",
          // line ends of other systems
          "time [s],shift [um]\r\n1.5,2\r\n3,4.25\r\n"})
        expect_run(table_of(text), text);
}

TEST(CsvTable, EncodingsAreTold) {
    const std::string plain = "time [s],shift [\u00b5m]\n1.5,2\n3,4.25\n";
    std::string latin, little("\xFF\xFE"), big("\xFE\xFF");
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const bool micro = plain.compare(i, 2, "\u00b5") == 0;
        const char c = micro ? '\xB5' : plain[i];
        i += micro;
        latin += c;
        little += c;
        little += '\0';
        big += '\0';
        big += c;
    }
    for (const std::string& bytes : {plain, latin, little, big})
        expect_run(table_of(utf8_text(bytes, "run.csv")), shortened(bytes, 8));
    EXPECT_EQ(utf8_text("a\rb\r", "run.csv"), "a\nb\n");
    // Beyond the first plane, RFC 2781: U+10437.
    EXPECT_EQ(utf8_text(std::string("\xFF\xFE\x01\xD8\x37\xDC", 6), "a"), "\U00010437");
    EXPECT_EQ(message_of([&] { utf8_text(little.substr(2), "run.csv"); }),
              "run.csv: holds zero bytes: UTF-16 without its mark, or no text; save it as text in "
              "UTF-8");
    EXPECT_EQ(message_of([] { utf8_text(std::string("\xFF\xFE\x01\xD8", 4), "run.csv"); }),
              "run.csv: is no whole text in UTF-16; save it as text in UTF-8");
}

TEST(CsvTable, WhatIsNotClearIsRefused) {
    const auto refusal = [](const std::string& text) {
        return message_of([&] { table_of(text); });
    };
    EXPECT_EQ(refusal("a;b\n1,5;2.5\n"),
              "run.csv:2: 2.5: the file has both decimal points and decimal commas; write all "
              "numbers with points, without marks of thousands");
    EXPECT_EQ(refusal("a;b\n1.234,5;2\n"),
              "run.csv:2: a = 1.234,5: must be a number; write for example 0.21, with a point");
    EXPECT_EQ(refusal("a,b\n1,5,2,5\n"),
              "run.csv:2: has 4 columns instead of 2; divide columns by semicolons where numbers "
              "have decimal commas");
    EXPECT_EQ(refusal(",a,b\n0.5,1,2\n0.7,3,4\n"),
              "run.csv:2: \"0.5\": the first column has no name and does not count the rows; name "
              "it, or write the table without it: row.names = FALSE in R, index=False in pandas");
    EXPECT_EQ(refusal("\"a\",\"b\n1,2\n"),
              "run.csv:1: \"\\\"b\": the quote does not end; close it in its line");
    EXPECT_EQ(refusal("a [s],b\nms,um\n1,2\n"),
              "run.csv:2: a = ms: must be a number; write for example 0.21, with a point");
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
