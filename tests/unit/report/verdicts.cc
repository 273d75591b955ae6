#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "report/document.h"

// One vocabulary for verdicts, failures first.

namespace tricontact::report::verdicts_test {
namespace {

using Standing = Verdict::Standing;

std::vector<Verdict> some() {
    return {{.standing = Standing::holds,
             .sentence = "a",
             .subject = "smooth surfaces",
             .number = "l = 2 nm",
             .threshold = "at most 1 µm"},
            {.standing = Standing::finding, .sentence = "E = 5.2 MPa."},
            {.standing = Standing::not_testable, .sentence = "b", .subject = "level surface"},
            {.standing = Standing::violated,
             .sentence = "c",
             .subject = "half-space",
             .number = "b/a = 1.8",
             .threshold = "at least 10",
             .effect = "static shift +21 %"},
            {.standing = Standing::not_resolved, .sentence = "BEM and FEM."},
            {.standing = Standing::fail, .sentence = "2 of 8 points failed."}};
}

TEST(Verdicts, FailuresComeFirst) {
    std::string order;
    for (const Verdict& one : by_severity(some()))
        order += std::string(word_of(one.standing)) + ';';
    EXPECT_EQ(order, "violated;fail;not testable;not resolved;holds;finding;");
}

// An assumption holds, is violated or not testable; a comparison passes, fails or is not resolved.
TEST(Verdicts, HaveOneVocabulary) {
    const std::vector<std::string> words{"holds", "violated", "not testable", "finding",
                                         "pass",  "fail",     "not resolved"};
    for (std::size_t i = 0; i < words.size(); ++i)
        EXPECT_EQ(word_of(static_cast<Standing>(i)), words[i]);
}

// With a subject they are rows: assumption, verdict, number, threshold, effect; the others cards.
TEST(Verdicts, AreATableWhereTheyHaveNumbers) {
    const DocumentTable table = verdict_table({.verdicts = some()});
    ASSERT_EQ(table.rows.size(), 3u);
    const std::vector<Cell> worst{std::string("half-space"), std::string("violated"),
                                  std::string("b/a = 1.8"), std::string("at least 10"),
                                  std::string("static shift +21 %")};
    for (std::size_t i = 0; i < worst.size(); ++i)
        EXPECT_EQ(std::get<std::string>(table.rows[0][i]), std::get<std::string>(worst[i]));
    EXPECT_EQ(std::get<std::string>(table.rows[2][0]), "smooth surfaces");
    Document document{.kind = "Test", .title = "Title"};
    document.verdicts = some();
    const std::string page = document_html(document);
    const auto at = [&](const std::string& text) { return page.find(text); };
    EXPECT_NE(at("<li class=\"fail\"><b>fail</b>"), std::string::npos);
    EXPECT_NE(at("<li class=\"not_resolved\"><b>not resolved</b>"), std::string::npos);
    EXPECT_EQ(at("<li class=\"violated\""), std::string::npos);  // a row, no card
    EXPECT_LT(at("static shift +21"), at("smooth surfaces"));
    EXPECT_LT(at("2 of 8 points failed"), at("E = 5.2"));
}

}  // namespace
}  // namespace tricontact::report::verdicts_test
