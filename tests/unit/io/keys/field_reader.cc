#include "io/keys/field_reader.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "contact/base/error.h"

namespace tricontact::io::field_reader_test {
namespace {

const Key tables = bare_list_of(choice_key("measured.tables", {}, R"("a.csv")", "tables"));
const Key runs = list_of(choice_key("measured.runs", {}, R"(["a.csv"])", "runs"));

std::vector<std::string> read(const Key& key, Value value) {
    std::vector<std::string> texts;
    read_field(key, overriding(std::string(key.path), std::move(value), "case.toml"),
               Field(&texts));
    return texts;
}

std::string written(const Key& key, std::vector<std::string> texts) {
    KeyWriter writer;
    writer.add(key, Field(&texts));
    return writer.text();
}

TEST(FieldReader, ATextStandsForAListOfOneWhereTheKeySaysSo) {
    const std::vector<std::string> one{"a.csv"}, two{"a.csv", "b.csv"};
    EXPECT_EQ(read(tables, std::string("a.csv")), one);
    EXPECT_EQ(read(tables, one), one);
    EXPECT_EQ(read(tables, two), two);
    EXPECT_EQ(read(runs, one), one);
    EXPECT_THROW(read(runs, std::string("a.csv")), contact::InputError);
    EXPECT_THROW(read(tables, 1.), contact::InputError);
    EXPECT_THROW(read(tables, std::vector<std::string>{}), contact::InputError);
}

TEST(FieldReader, AListOfOneIsWrittenAsItsText) {
    EXPECT_EQ(written(tables, {"a.csv"}), "\n[measured]\ntables = \"a.csv\"\n");
    EXPECT_EQ(written(tables, {"a.csv", "b.csv"}),
              "\n[measured]\ntables = [\"a.csv\", \"b.csv\"]\n");
    EXPECT_EQ(written(runs, {"a.csv"}), "\n[measured]\nruns = [\"a.csv\"]\n");
}

}  // namespace
}  // namespace tricontact::io::field_reader_test
