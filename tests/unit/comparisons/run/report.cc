#include "comparisons/run/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "comparisons/run/reading.h"
#include "comparisons/run/report_tables.h"
#include "report/format.h"
#include "tests/unit/comparisons/history.h"

namespace tricontact::comparisons::report_test {
namespace {

using synthetic::Options;

std::vector<ReportFile> report_of(const contact::Case& c, const Options& options) {
    return make_report(c, "title = \"a <b> & 'c'\"\n", "1.2.3", synthetic::two_models(options));
}

std::string page_of(const Options& options) {
    return report_of(synthetic::unit_case(options), options).front().content;
}

/// The default case's report, drawn once for all tests that only read it.
const std::vector<ReportFile>& default_report() {
    static const std::vector<ReportFile> files = report_of(synthetic::unit_case(), {});
    return files;
}
const std::string& default_page() {
    return default_report().front().content;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++n;
    return n;
}

/// The page without its long data URIs, which std::regex cannot swallow.
std::string without_images(std::string page) {
    for (std::size_t at = page.find("base64,"); at != std::string::npos;
         at = page.find("base64,", at + 1))
        page.erase(at + 7, page.find('"', at) - at - 7);
    return page;
}

TEST(Report, FilesAndNames) {
    const auto& files = default_report();
    ASSERT_EQ(files.size(), 1u + 2 * 8);
    EXPECT_EQ(files.front().name, "report.html");
    EXPECT_EQ(files[1].name, "plots/shift.svg");
    EXPECT_EQ(files[2].name, "plots/shift.png");
    for (const ReportFile& file : files) EXPECT_FALSE(file.content.empty()) << file.name;
}

TEST(Report, NeedsNoNetworkAndNoOtherFile) {
    const std::string page = without_images(default_page());
    const std::regex attribute("(src|href)=\"([^\"]*)\"");
    int images = 0;
    for (std::sregex_iterator it(page.begin(), page.end(), attribute), end; it != end; ++it) {
        const std::string kind = (*it)[1], target = (*it)[2];
        if (kind == "src") {
            EXPECT_TRUE(target.starts_with("data:image/")) << target;
            ++images;
        } else {
            // Sections of the page, the empty icon, and the figures' files on a click.
            EXPECT_TRUE(target.starts_with("#") || target == "data:," ||
                        target.starts_with("plots/"))
                << target;
        }
    }
    EXPECT_EQ(images, 8);
    for (const char* part :
         {"http:", "https:", "<script", "<link rel=\"stylesheet", "@import", "url("})
        EXPECT_FALSE(contains(page, part)) << part;
}

TEST(Report, NoPlaceholderIsLeft) {
    const std::string page = without_images(default_page());
    EXPECT_FALSE(contains(page, "{{"));
    EXPECT_FALSE(contains(page, "}}"));
    EXPECT_FALSE(contains(page, "nan"));
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
    EXPECT_TRUE(page.ends_with("</html>\n"));
}

TEST(Report, ElementsAreClosed) {
    for (const Options& options : {Options{.f = 0.8, .w = 0.5}, Options{.rolling = false}}) {
        const std::string page = page_of(options);
        for (const std::string element :
             {"section", "table", "tbody", "thead", "tr",     "th",         "td",      "ul",
              "li",      "p",     "div",   "dl",    "figure", "figcaption", "details", "summary",
              "pre",     "code",  "span",  "sub",   "i",      "b"})
            EXPECT_EQ(count(page, "<" + element + ">") + count(page, "<" + element + " "),
                      count(page, "</" + element + ">"))
                << element;
    }
}

TEST(Report, TextsOfTheUserAreEscaped) {
    contact::Case c = synthetic::unit_case();
    c.title = "<script>alert('x')</script> & \"quoted\" {{title}}";
    const std::string page = report_of(c, {}).front().content;
    EXPECT_FALSE(contains(page, "<script>"));
    EXPECT_TRUE(contains(page,
                         "&lt;script&gt;alert(&apos;x&apos;)&lt;/script&gt; &amp; "
                         "&quot;quoted&quot; {{title}}"));
    EXPECT_TRUE(contains(page, "title = &quot;a &lt;b&gt; &amp; &apos;c&apos;&quot;"));
    // The name of an audit check.
    EXPECT_TRUE(contains(page, "p &gt;= 0 &amp; gap &gt;= 0"));
}

TEST(Report, SaysVerdictsAndNumbers) {
    const Options options;
    const std::string& page = default_page();
    const double u = theory::settled_shift_ratio(options.w, options.f).value();
    EXPECT_TRUE(contains(page, "<p class=\"value\">" + report::quantity(u, "m") + "</p>"));
    EXPECT_TRUE(contains(page, "verdict shakedown"));
    EXPECT_TRUE(contains(page, "κ = 1.50"));
    EXPECT_TRUE(contains(page, "tricontact run case.toml"));
    EXPECT_TRUE(contains(page, "Tricontact 1.2.3"));
}

TEST(Report, LongPeriodTablesStartFolded) {
    // The default case runs 12 periods.
    EXPECT_TRUE(contains(default_page(), "<details open>"));
    EXPECT_FALSE(contains(page_of({.periods = 13}), "<details open>"));
}

TEST(Report, SameInputSameBytes) {
    const auto& first = default_report();
    const auto second = report_of(synthetic::unit_case(), {});
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].content, second[i].content);
}

TEST(Tables, ComparesWithTheLastModelOrWithTheory) {
    const contact::Case c = synthetic::unit_case();
    auto histories = synthetic::two_models();
    histories[0].shift_per_period.back() = 1.165 * histories[1].shift_per_period.back();
    const std::vector<Results> both{Results(c, histories[0]), Results(c, histories[1])};
    const Table table = results_table(c, both);
    EXPECT_EQ(table.columns, (std::vector<std::string>{"MDR", "BEM", "theory", "MDR vs BEM"}));
    const Table alone = results_table(c, {both[1]});
    EXPECT_EQ(alone.columns, (std::vector<std::string>{"BEM", "theory", "vs theory"}));
    const auto cell = [](const Table& t, const std::string& label) {
        for (const auto& group : t.groups)
            for (const auto& row : group.rows)
                if (row.label == label) return row.cells.back();
        return std::string("no such row");
    };
    EXPECT_EQ(cell(table, "final shift <i>u</i><sub>end</sub>"), "+16.5 %");
    EXPECT_EQ(cell(alone, "final shift <i>u</i><sub>end</sub>"), "0.00 %");
    for (const Table& t : {table, alone})
        for (const auto& group : t.groups)
            for (const auto& row : group.rows)
                EXPECT_EQ(row.cells.size(), t.columns.size()) << row.label;
}

TEST(Tables, ModelsMayRunDifferentNumbersOfPeriods) {
    const contact::Case c = synthetic::unit_case();
    const Table table =
        period_table({Results(c, synthetic::settling_history("mdr", {.periods = 3})),
                      Results(c, synthetic::settling_history("bem"))});
    ASSERT_EQ(table.groups.front().rows.size(), 13u);  // n = 0 ... 12
    const auto& fourth = table.groups.front().rows[4].cells;
    ASSERT_EQ(fourth.size(), table.columns.size());
    EXPECT_EQ(fourth[0], "–");
    EXPECT_NE(fourth[3], "–");
}

/// All sentences in one text.
std::string reading_text(const contact::Case& c, const std::vector<Results>& summaries) {
    std::string text;
    for (const std::string& sentence : reading(c, summaries)) text += sentence + "\n";
    return text;
}

class Reading : public testing::Test {
  protected:
    contact::Case c_ = synthetic::unit_case();
    Results mdr_{c_, synthetic::settling_history("mdr")};
    Results bem_{c_, synthetic::settling_history("bem")};
};

TEST_F(Reading, DifferenceBetweenModels) {
    // U_max of MDR is 5 % larger: in metres the difference is another.
    const double u = *bem_.number(quantities::final_shift_ratio);
    mdr_.set(quantities::final_shift_ratio, 1.165 * u);
    mdr_.set(quantities::final_shift, 1.05 * 1.165 * u);
    bem_.set(quantities::kappa, 1.04);
    const std::string text = reading_text(c_, {mdr_, bem_});
    EXPECT_TRUE(contains(
        text,
        "MDR's settled shift is 22.3 % higher than BEM's in metres (+16.5 % in U_max, each of "
        "its own): κ = 1.50 against 1.04."))
        << text;
    EXPECT_TRUE(contains(text, "cannot tell rolling along the load from rolling across")) << text;
    EXPECT_TRUE(contains(text, "13.4 % below it: shakedown is expected")) << text;
    EXPECT_FALSE(contains(reading_text(c_, {bem_}), "MDR's springs"));
}

TEST_F(Reading, DisagreementIsSaid) {
    mdr_.set(quantities::state, contact::State::ratcheting);
    EXPECT_TRUE(contains(reading_text(c_, {mdr_, bem_}),
                         "do not agree on the verdict (ratcheting against shakedown)"));
}

TEST_F(Reading, WhoIsUndecidedDoesNotDisagree) {
    bem_.set(quantities::state, contact::State::undecided);
    bem_.set(quantities::settled_shift, {});
    const std::string text = reading_text(c_, {mdr_, bem_});
    EXPECT_FALSE(contains(text, "do not agree")) << text;
    EXPECT_TRUE(contains(text, "MDR's present shift is as high as BEM's")) << text;
}

TEST_F(Reading, OnlyHalfSpacesIgnoreTheLayer) {
    EXPECT_TRUE(contains(reading_text(c_, {mdr_, bem_}), "All models take the bodies as elastic"));
    c_.layer.thickness = 1;
    Results fem = bem_;
    fem.model = "fem";
    const std::string text = reading_text(c_, {mdr_, bem_, fem});
    EXPECT_TRUE(contains(text, "MDR and BEM take the bodies as elastic half-spaces")) << text;
    EXPECT_TRUE(contains(text, "the exact limit of shakedown on a half-space is")) << text;
    EXPECT_FALSE(contains(reading_text(c_, {fem}), "half-spaces:"));
    fem.set(quantities::state, contact::State::undecided);
    EXPECT_FALSE(contains(reading_text(c_, {fem}), "By the exact limit"));
}

TEST_F(Reading, RatchetingSpeeds) {
    for (Results* s : {&mdr_, &bem_}) s->set(quantities::state, contact::State::ratcheting);
    for (const auto* q : {&quantities::shift_increment, &quantities::shift_increment_ratio}) {
        mdr_.set(*q, 0.9);
        bem_.set(*q, 0.3);
    }
    EXPECT_TRUE(contains(reading_text(c_, {mdr_, bem_}),
                         "MDR's shift per period is 200 % higher than BEM's in metres"));
}

TEST_F(Reading, UndecidedSaysWhatToDo) {
    c_.contact.coupling = false;
    bem_.set(quantities::state, contact::State::undecided);
    const std::string text = reading_text(c_, {bem_});
    EXPECT_TRUE(contains(text, "BEM is undecided after 12 periods")) << text;
    EXPECT_TRUE(contains(text, "raise rolling.periods")) << text;
    EXPECT_TRUE(contains(text, "it must shake down in the end")) << text;
}

TEST_F(Reading, WhoIsKnownToSettleButNotWhereSaysSo) {
    const std::string unknown = "but where is not known yet";
    EXPECT_FALSE(contains(reading_text(c_, {mdr_}), unknown));
    mdr_.verdict.by_limit = true;
    mdr_.set(quantities::settled_shift, {});
    const std::string text = reading_text(c_, {mdr_});
    EXPECT_TRUE(contains(text, "in the end, by the limit of uncoupled contact, " + unknown))
        << text;
    EXPECT_TRUE(contains(text, "Raise rolling.periods")) << text;
}

TEST_F(Reading, TheLimitIsSaidToDecideWhereItDid) {
    const std::string claim = "The verdict of MDR compares f_T with f_T,lim";
    EXPECT_FALSE(contains(reading_text(c_, {mdr_, bem_}), "compares f_T with f_T,lim"));
    mdr_.verdict.by_limit = true;
    EXPECT_TRUE(contains(reading_text(c_, {mdr_, bem_}), claim));
}

TEST_F(Reading, FailedAuditComesFirst) {
    EXPECT_TRUE(contains(reading(c_, {mdr_, bem_}).back(), "All 4 audit checks"));
    bem_.audit.front().worst = 1;
    EXPECT_TRUE(contains(reading(c_, {mdr_, bem_}).front(), "Do not use these numbers: 1 of 4"));
}

TEST_F(Reading, OscillatingLoadsAndTheSphereAreSaid) {
    c_.load.normal_amplitude_ratio = 0.2;
    c_.indenter.shape = contact::Case::Shape::sphere;
    const std::string text = reading_text(c_, {bem_});
    EXPECT_TRUE(contains(text, "The loads oscillate")) << text;
    EXPECT_TRUE(contains(text, "exact sphere")) << text;
    EXPECT_FALSE(contains(text, "exact limit of shakedown")) << text;
}

}  // namespace
}  // namespace tricontact::comparisons::report_test
