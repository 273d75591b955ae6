// Which law tables and record leave together.
#include "experiments/predictions/record_laws.h"

#include <gtest/gtest.h>

namespace tricontact::experiments::record_laws_test {
namespace {

struct Told {
    const char* law;
    bool by_tables_excluded;
    double aicc;
    std::optional<bool> record_differs;
};

/// W_lim of a record is 1 to 1.1 mm.
RecordLaws laws_of(const std::vector<Told>& all) {
    RecordLaws laws;
    for (const Told& one : all) {
        LawFit fit{.law = &io::measurement_law(one.law), .aicc = one.aicc};
        if (one.by_tables_excluded) fit.why_excluded = "AICc 30 above the least";
        laws.tables.laws.push_back(std::move(fit));
        RecordedLaw& law = laws.laws.emplace_back();
        if (!one.record_differs) continue;
        law.measured_limit = Estimate{1.05e-3, 0, 1e-3, 1.1e-3};
        const double low = *one.record_differs ? 1.2e-3 : 1.05e-3;
        law.predicted_limit = Estimate{low + 5e-5, 0, low, low + 1e-4};
    }
    judge(laws);
    return laws;
}

TEST(RecordLaws, TheRecordNamesOneOfTwoThatTablesLeave) {
    const RecordLaws laws =
        laws_of({{"coulomb", false, 10, true}, {"shear-strength", false, 11, false}});
    ASSERT_TRUE(laws.named);
    EXPECT_EQ(*laws.named, 1U);
    EXPECT_EQ(laws.laws[0].why_excluded, "the record");
}

TEST(RecordLaws, WithoutARecordThatTellsTheyStayOpen) {
    const RecordLaws laws =
        laws_of({{"coulomb", false, 10, {}}, {"shear-strength", false, 11, false}});
    EXPECT_FALSE(laws.named);
    EXPECT_EQ(laws.supported().size(), 2U);
    EXPECT_EQ(laws.best, 0U);
}

TEST(RecordLaws, TheRecordMayContradictTheLawThatTablesName) {
    const RecordLaws laws =
        laws_of({{"coulomb", false, 10, true}, {"shear-strength", true, 40, false}});
    EXPECT_TRUE(laws.supported().empty());
    EXPECT_FALSE(laws.named);
}

// tau_0 + mu p with mu = 0 is the strength, with which the record agrees.
TEST(RecordLaws, ALawThatContainsOneThatAgreesIsNotExcludedByTheRecord) {
    const RecordLaws laws = laws_of({{"coulomb", false, 10, true},
                                     {"shear-strength", false, 11, false},
                                     {"strength-and-coulomb", false, 12, true}});
    EXPECT_FALSE(laws.laws[2].is_excluded());
    EXPECT_TRUE(laws.laws[0].is_excluded());
    EXPECT_FALSE(laws.named);
    std::string sentence = record_law_verdicts(laws).front().sentence;
    EXPECT_NE(sentence.find("Of those of one number shear-strength (tau_0) alone is left"),
              std::string::npos)
        << sentence;
}

}  // namespace
}  // namespace tricontact::experiments::record_laws_test
