// The text of an answer, and the same as JSON.

#include "runs/answer.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tricontact::answer_test {
namespace {

using runs::Answer;

TEST(Answer, TextIsWhatWasAddedInThatOrder) {
    Answer answer([]() -> std::string { throw std::logic_error("nobody asked for JSON"); }, "a\n");
    answer.note("  leaves out b\n", "mdr ").add("c\n");
    EXPECT_EQ(answer.printed(false), "a\n  leaves out b\nc\n");
}

TEST(Answer, NotesStandInTheDataWithTheOneTheyAreOf) {
    int calls = 0;
    Answer answer([&] {
        ++calls;
        return std::string(R"({"z": 1, "a": 2})");
    });
    EXPECT_EQ(answer.printed(true), "{\"z\": 1, \"a\": 2}\n");
    answer.add("text").note("  leaves out b\nwarning: c\n", "mdr ").note("d\n");
    const auto data = nlohmann::ordered_json::parse(answer.printed(true));
    EXPECT_EQ(data["notes"], (nlohmann::ordered_json{"mdr leaves out b", "mdr warning: c", "d"}));
    EXPECT_EQ(data.begin().key(), "z");  // the order of the data stays
    EXPECT_EQ(calls, 2);
}

TEST(Answer, NoNoteIsNoList) {
    Answer answer([] { return std::string("{}\n"); });
    answer.note("");
    EXPECT_EQ(answer.printed(true), "{}\n");
}

}  // namespace
}  // namespace tricontact::answer_test
