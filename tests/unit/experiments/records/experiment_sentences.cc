// What an evaluated experiment says in words, and where it must not.
#include <gtest/gtest.h>

#include "experiments/records/experiment_report.h"
#include "tests/unit/experiments/records/synthetic_record.h"

namespace tricontact::experiments::experiment_sentences_test {
namespace {

bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Its sentences beside a model that follows the drive by `excess` more than the measured shift.
std::string words_beside(ExperimentEvaluation e, double excess) {
    e.normalised.emplace().radius = 0.04;
    e.predictions = {
        {"bem-layer", {}, contact::State::shakedown, e.wobble->at_confidence.value + excess, {}}};
    std::string text;
    for (const report::Verdict& verdict : experiment_verdicts(e)) text += verdict.sentence + '\n';
    return text;
}

// 5.1.11: Dh = R dU/dW; 3 um per mm over R = 40 mm are 120 um.
TEST(ExperimentSentences, PivotsAreHighLowOrLevelWithTheContact) {
    std::mt19937_64 random(9);
    Experiment experiment;
    experiment.records = {tests::SyntheticRecord().make(random)};
    const ExperimentEvaluation e = evaluate_experiment(experiment);
    ASSERT_TRUE(e.wobble);
    const std::string high = words_beside(e, -0.003), low = words_beside(e, 0.003),
                      level = words_beside(e, 0);
    EXPECT_TRUE(says(high, "the pivot sits 120")) << high;
    EXPECT_TRUE(says(high, "µm too high (5.1.11")) << high;
    EXPECT_TRUE(says(low, "the pivot sits 120")) << low;
    EXPECT_TRUE(says(low, "µm too low (5.1.11")) << low;
    EXPECT_FALSE(says(low, "too high")) << low;
    EXPECT_TRUE(says(level, "level with the contact")) << level;
    for (const char* side : {"too high", "too low"}) EXPECT_FALSE(says(level, side)) << level;
}

}  // namespace
}  // namespace tricontact::experiments::experiment_sentences_test
