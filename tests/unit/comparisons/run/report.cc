#include "comparisons/run/report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "comparisons/run/answer.h"
#include "comparisons/run/reading.h"
#include "comparisons/run/report_tables.h"
#include "report/format.h"
#include "tests/unit/comparisons/document.h"
#include "tests/unit/comparisons/history.h"

namespace tricontact::comparisons::report_test {
namespace {

using synthetic::Options;

report::Document document_of(const contact::Case& c, const Options& options = {}) {
    return run_document(c, "title = \"a <b> & 'c'\"\n", "1.2.3", synthetic::two_models(options));
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

/// The page's own text: without its scripts.
std::string page_of(const report::Document& document) {
    const std::string page = report::document_html(document);
    return page.substr(0, page.find("<script"));
}

TEST(Report, FilesAndNames) {
    report::Document document = document_of(synthetic::unit_case());
    for (report::DocumentSection& section : document.sections) section.figures.clear();
    std::vector<std::string> names;
    for (const ReportFile& file : report_files(document)) {
        names.push_back(file.name);
        EXPECT_FALSE(file.content.empty()) << file.name;
    }
    EXPECT_EQ(names, (std::vector<std::string>{"report.html", "plots/shift.svg", "plots/shift.png",
                                               "plots/shift.csv"}));
}

/// The row of a model in the table behind the answer.
std::vector<report::Cell> row_of(const report::Document& document, const std::string& model) {
    for (const auto& row : document.comparison->rows)
        if (std::get<std::string>(row.front()) == model) return row;
    throw std::out_of_range(model);
}

// The last model answers; how far the others are off in metres, whatever their own U_max is, and
// what they take for granted.
TEST(Report, AnswersFirst) {
    std::vector<contact::History> histories = synthetic::two_models();
    for (contact::History& history : histories) history.verdict = {contact::State::shakedown, 0, 0};
    for (double& shift : histories[0].shift_per_period) shift *= 1.25;
    histories[0].scales.unit_shift = 2;
    const double ratio =
        histories[0].shift_per_period.back() / histories[1].shift_per_period.back();
    const report::Document document = run_document(synthetic::unit_case(), "", "1", histories);
    EXPECT_EQ(document.answer->word, "shakedown");
    EXPECT_TRUE(document.answer->sentence.starts_with(
        "The indenter settles at a shift of " +
        report::quantity(histories[1].shift_per_period.back(), "m") + " (BEM)."))
        << document.answer->sentence;
    EXPECT_EQ(std::get<std::string>(document.comparison->rows.front().front()), "BEM");
    EXPECT_EQ(std::get<std::string>(row_of(document, "BEM").back()), "reference");
    const auto mdr = row_of(document, "MDR");
    EXPECT_NEAR(std::get<double>(mdr[3]), 100 * (ratio - 1), 1e-9);
    EXPECT_TRUE(contains(std::get<std::string>(mdr.back()), "springs on a line"));
    const report::Verdict& springs = document.verdicts.front();
    EXPECT_EQ(springs.standing, report::Verdict::Standing::violated);
    EXPECT_TRUE(contains(springs.sentence, report::percent(ratio))) << springs.sentence;
    EXPECT_TRUE(contains(springs.sentence, "(MDR beside BEM)")) << springs.sentence;
}

// Below 5 % an assumption holds.
TEST(Report, AnAssumptionThatChangesLittleHolds) {
    std::vector<contact::History> histories = synthetic::two_models();
    for (contact::History& history : histories) history.verdict = {contact::State::shakedown, 0, 0};
    for (double& shift : histories[0].shift_per_period) shift *= 1.04;
    const auto verdicts = run_document(synthetic::unit_case(), "", "1", histories).verdicts;
    EXPECT_EQ(verdicts.front().standing, report::Verdict::Standing::holds);
    EXPECT_EQ(verdicts.back().standing, report::Verdict::Standing::not_testable);
    EXPECT_TRUE(contains(verdicts.back().sentence, "small strains")) << verdicts.back().sentence;
}

// Static shift here, growth per period there: no numbers are set beside each other, the states are.
TEST(Report, ComparesNoneButEqualQuantities) {
    std::vector<contact::History> histories = synthetic::two_models();
    histories[0].verdict = {contact::State::ratcheting, 0, 0};
    histories[1].verdict = {contact::State::shakedown, 0, 0};
    const report::Document document = run_document(synthetic::unit_case(), "", "1", histories);
    const auto mdr = row_of(document, "MDR");
    EXPECT_TRUE(std::isnan(std::get<double>(mdr[2])));
    EXPECT_TRUE(std::isnan(std::get<double>(mdr[3])));
    EXPECT_TRUE(contains(document.verdicts.front().sentence, "ratcheting instead of shakedown"))
        << document.verdicts.front().sentence;
}

TEST(Report, OneModelIsComparedWithNobody) {
    auto histories = synthetic::two_models();
    histories.erase(histories.begin());
    const report::Document document = run_document(synthetic::unit_case(), "", "1", histories);
    EXPECT_FALSE(document.comparison);
    EXPECT_EQ(document.verdicts.size(), 1u);
}

TEST(Report, WithoutATangentialForceNothingIsShifted) {
    const Options still{.f = 0, .rolling = false};
    const auto answer = run_document(synthetic::unit_case(still), "", "1",
                                     {synthetic::loaded_history("bem", still)})
                            .answer;
    EXPECT_EQ(answer->word, "pressed");
    EXPECT_TRUE(contains(answer->sentence, "Pressed in by 1.000 m, the indenter carries 1.333 N"))
        << answer->sentence;
    EXPECT_FALSE(contains(answer->sentence, "shift")) << answer->sentence;
    contact::Case by_force = synthetic::unit_case(still);
    by_force.load.indentation.reset();
    by_force.load.normal_force = 4. / 3;
    const auto other =
        run_document(by_force, "", "1", {synthetic::loaded_history("bem", still)}).answer;
    EXPECT_TRUE(contains(other->sentence, "The indenter is pressed in by 1.000 m"))
        << other->sentence;
}

TEST(Report, NeedsNoNetworkAndNoOtherFile) {
    const std::string page = page_of(document_of(synthetic::unit_case()));
    const std::regex attribute("(src|href)=\"([^\"]*)\"");
    for (std::sregex_iterator it(page.begin(), page.end(), attribute), end; it != end; ++it) {
        const std::string kind = (*it)[1], target = (*it)[2];
        EXPECT_EQ(kind, "href");
        EXPECT_FALSE(contains(target.substr(0, 8), "//")) << target;
    }
    for (const char* part : {"http:", "https:", "<link rel=\"stylesheet", "@import", "url("})
        EXPECT_FALSE(contains(page, part)) << part;
    EXPECT_EQ(count(page, "<figure "), 8u);
    EXPECT_EQ(count(page, "href=\"plots/"), 3 * 8u);
}

TEST(Report, ElementsAreClosed) {
    for (const Options& options : {Options{.f = 0.8, .w = 0.5}, Options{.rolling = false}}) {
        const std::string page = page_of(document_of(synthetic::unit_case(options), options));
        EXPECT_FALSE(contains(page, "{{"));
        EXPECT_FALSE(contains(page, "nan"));
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
    const std::string page = report::document_html(document_of(c));
    EXPECT_FALSE(contains(page, "<script>alert"));
    EXPECT_TRUE(contains(page,
                         "&lt;script&gt;alert(&apos;x&apos;)&lt;/script&gt; &amp; "
                         "&quot;quoted&quot; {{title}}"));
    EXPECT_TRUE(contains(page, "title = &quot;a &lt;b&gt; &amp; &apos;c&apos;&quot;"));
    // The name of an audit check.
    EXPECT_TRUE(contains(page, "p ≥ 0 &amp; gap ≥ 0"));
}

TEST(Report, SaysWhatMadeIt) {
    const report::Document document = document_of(synthetic::unit_case());
    EXPECT_EQ(document.command, "tricontact run case.toml");
    EXPECT_EQ(document.version, "1.2.3");
}

TEST(Report, LongPeriodTablesStartFolded) {
    const auto is_folded = [](const Options& options) {
        const auto document = document_of(synthetic::unit_case(options), options);
        return find_section(document, "results")->tables.back().folded;
    };
    EXPECT_FALSE(is_folded({}));  // 12 periods
    EXPECT_TRUE(is_folded({.periods = 13}));
}

TEST(Report, SameInputSameBytes) {
    const auto page = [] { return report::document_html(document_of(synthetic::unit_case())); };
    EXPECT_EQ(page(), page());
}

TEST(Tables, ComparesWithTheLastModelOrWithTheory) {
    const contact::Case c = synthetic::unit_case();
    auto histories = synthetic::two_models();
    histories[0].shift_per_period.back() = 1.165 * histories[1].shift_per_period.back();
    const std::vector<Results> both{Results(c, histories[0]), Results(c, histories[1])};
    const auto tables = results_tables(c, both), alone = results_tables(c, {both[1]});
    EXPECT_EQ(headings(tables.front()), (std::vector<std::string>{"quantity", "unit", "MDR", "BEM",
                                                                  "theory", "MDR vs BEM [%]"}));
    EXPECT_EQ(headings(alone.front()),
              (std::vector<std::string>{"quantity", "unit", "BEM", "theory", "BEM vs theory [%]"}));
    const auto last_cell = [](const auto& list, const std::string& label) {
        for (const report::DocumentTable& table : list)
            for (const auto& row : table.rows)
                if (std::get<std::string>(row[0]) == label) return std::get<double>(row.back());
        return static_cast<double>(NAN);
    };
    EXPECT_NEAR(last_cell(tables, "final shift u_end"), 16.5, 1e-9);
    EXPECT_NEAR(last_cell(alone, "final shift u_end"), 0, 0.005);
    for (const auto& list : {tables, alone})
        for (const report::DocumentTable& table : list)
            for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
}

TEST(Tables, ModelsMayRunDifferentNumbersOfPeriods) {
    const contact::Case c = synthetic::unit_case();
    const report::DocumentTable table =
        period_table({Results(c, synthetic::settling_history("mdr", {.periods = 3})),
                      Results(c, synthetic::settling_history("bem"))});
    ASSERT_EQ(table.rows.size(), 13u);  // n = 0 ... 12
    const auto& fourth = table.rows[4];
    ASSERT_EQ(fourth.size(), table.columns.size());
    EXPECT_TRUE(std::isnan(std::get<double>(fourth[1])));
    EXPECT_FALSE(std::isnan(std::get<double>(fourth[4])));
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

TEST_F(Reading, WhereTheLimitLies) {
    const std::string text = reading_text(c_, {mdr_, bem_});
    EXPECT_TRUE(contains(text, "cannot distinguish rolling along the load from rolling across"))
        << text;
    EXPECT_TRUE(contains(text, "13.4 % below it: shakedown is expected")) << text;
    EXPECT_FALSE(contains(reading_text(c_, {bem_}), "MDR's springs"));
}

/// What the assumptions of two models of a layer come to, of which the first has another state.
std::string assumptions_text(const Results& other, const Results& reference) {
    contact::Case c = synthetic::unit_case();
    c.layer.thickness = 1;
    std::string text;
    for (const report::Verdict& verdict : assumption_verdicts(c, {other, reference}, {}))
        text += verdict.sentence + "\n";
    return text;
}

// Whatever separates two models fails where they come to different verdicts; nothing separates
// those that take the same for granted.
TEST_F(Reading, DisagreementIsSaidOnce) {
    Results layer = bem_, fem = bem_;
    layer.model = "bem-layer", fem.model = "fem";
    EXPECT_FALSE(contains(assumptions_text(layer, fem), "different verdicts"));
    layer.set(quantities::state, contact::State::ratcheting);
    const std::string same = assumptions_text(layer, fem);
    EXPECT_EQ(count(same, "ratcheting"), 1u) << same;
    EXPECT_TRUE(contains(same,
                         "BEM layer and FEM make the same assumptions but reach different "
                         "verdicts (ratcheting and shakedown)"));
    bem_.set(quantities::state, contact::State::ratcheting);
    const std::string text = assumptions_text(bem_, fem);
    EXPECT_TRUE(contains(text, "ratcheting instead of shakedown (BEM beside FEM)")) << text;
    EXPECT_FALSE(contains(text, "different verdicts")) << text;
    EXPECT_FALSE(contains(reading_text(c_, {bem_, fem}), "ratcheting against")) << text;
}

// Where a path ends at a prescribed shift all models agree on that: what differs is what it takes.
TEST_F(Reading, APrescribedShiftIsNoResult) {
    contact::Case c = synthetic::unit_case({.rolling = false});
    c.layer.thickness = 1;
    contact::PrescribedPath path{std::vector<contact::PrescribedPath::Row>(2)};
    path.rows[1].tangential[0] = {contact::TangentialControl::Kind::shift, 8e-4};
    c.prescribed_path = path;
    contact::History history = synthetic::loaded_history("bem", {.rolling = false});
    history.static_shift = 8e-4;
    history.steps.push_back(history.steps.back());
    history.steps.back().phase = 1;
    history.steps.back().tangential_force[0] = 2.4;
    const auto verdicts_of = [&](double half_space, double layer) {
        history.steps.back().dissipation = half_space;
        history.model = "bem";
        const Results of_half_space(c, history);
        history.steps.back().dissipation = layer;
        history.model = "bem-layer";
        const Results of_layer(c, history);
        EXPECT_TRUE(contains(answer_of(c, of_layer, {}).sentence, "The shift is prescribed"));
        std::string text;
        for (const auto& verdict : assumption_verdicts(c, {of_half_space, of_layer}, {}))
            text += verdict.sentence + "\n";
        EXPECT_FALSE(contains(text, "of the shift at the end of the path")) << text;
        return text;
    };
    EXPECT_TRUE(contains(verdicts_of(.68e-3, 1e-3), "−32.0 % of the frictional work of the path"));
    // Nothing slips.
    EXPECT_TRUE(contains(verdicts_of(0, 0), "of the tangential force at the end of the path"));
}

TEST_F(Reading, WhoIsUndecidedDoesNotDisagree) {
    Results layer = bem_, fem = bem_;
    layer.model = "bem-layer", fem.model = "fem";
    layer.set(quantities::state, contact::State::undecided);
    layer.set(quantities::settled_shift, {});
    EXPECT_FALSE(contains(assumptions_text(layer, fem), "different verdicts"));
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

TEST_F(Reading, UndecidedSaysWhatToDo) {
    c_.contact.coupling = false;
    bem_.set(quantities::state, contact::State::undecided);
    const std::string text = reading_text(c_, {bem_});
    EXPECT_TRUE(contains(text, "BEM is undecided after 12 periods")) << text;
    EXPECT_TRUE(contains(text, "raise rolling.periods")) << text;
    EXPECT_TRUE(contains(text, "it must shake down in the end")) << text;
}

TEST_F(Reading, WhoIsKnownToSettleButNotWhereSaysSo) {
    const std::string unknown = "where is not known yet";
    EXPECT_FALSE(contains(reading_text(c_, {mdr_}), unknown));
    mdr_.verdict.by_limit = true;
    mdr_.set(quantities::settled_shift, {});
    const std::string text = reading_text(c_, {mdr_});
    EXPECT_TRUE(contains(text, "in the end: f_T is below the exact limit; " + unknown)) << text;
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
