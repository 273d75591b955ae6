// A killed run goes on from its journal to the same bits; what it lost alone is computed again.

#include "io/results/journal.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "contact/base/error.h"
#include "tests/unit/io/results/fake_model.h"

namespace tricontact::io::journal_test {
namespace {

namespace fs = std::filesystem;
using contact::LoadStep;
using contact::NormalControl;
using contact::StepRecord;
using contact::TangentialControl;

void expect_same(const StepRecord& a, const StepRecord& b) {
    EXPECT_EQ(a.phase, b.phase);
    EXPECT_EQ(a.offset, b.offset);
    EXPECT_EQ(a.normal_force, b.normal_force);
    EXPECT_EQ(a.tangential_force, b.tangential_force);
    EXPECT_EQ(a.indentation, b.indentation);
    EXPECT_EQ(a.shift, b.shift);
    EXPECT_EQ(a.dissipation, b.dissipation);
    EXPECT_EQ(a.contact_area, b.contact_area);
    EXPECT_EQ(a.stick_area, b.stick_area);
    EXPECT_EQ(a.slip_area, b.slip_area);
    EXPECT_EQ(a.open_area, b.open_area);
    EXPECT_EQ(a.normal_iterations, b.normal_iterations);
    EXPECT_EQ(a.tangential_iterations, b.tangential_iterations);
    EXPECT_EQ(a.normal_residual, b.normal_residual);
    EXPECT_EQ(a.tangential_residual, b.tangential_residual);
    EXPECT_EQ(a.force_residual, b.force_residual);
}

// A run: a trial press, release, then a path; all controls appear. Calls 0 ... n_calls - 1.
constexpr int n_calls = 10, release_at = 1, limit_at = 5, period_at = 7;
constexpr int n_steps = n_calls - 2;

LoadStep step_of(int i) {
    LoadStep step;
    step.phase = i / 7.;
    step.offset = {i / 3., -i / 11.};
    step.normal = {i % 3 ? NormalControl::Kind::force : NormalControl::Kind::indentation, 21.1 / i};
    step.tangential[0] = {i % 2 ? TangentialControl::Kind::force : TangentialControl::Kind::shift,
                          6.7 / (i + 1)};
    step.tangential[1] = {TangentialControl::Kind::force, i / 13.};
    step.friction = i % 4 != 0;
    if (i == 0) step.normal.value = 21.1;
    return step;
}

struct Outcome {
    std::vector<StepRecord> records;
    std::vector<double> gaps, energies;  // asked of the model after each step
    double limit = 0;
    std::string state;
};

void call(contact::Model& model, int i, const LoadStep& step, Outcome& out) {
    if (i == period_at) model.start_period();  // no entry of its own
    if (i == release_at)
        model.release();
    else if (i == limit_at)
        model.start_limit();
    else
        out.records.push_back(model.advance(step));
}

// The first `n` calls.
Outcome run(contact::Model& model, int n = n_calls) {
    Outcome out;
    for (int i = 0; i < n; ++i) {
        call(model, i, step_of(i), out);
        out.gaps.push_back(model.surface().gap[0]);
        out.energies.push_back(model.interior()->strain_energy);
    }
    out.limit = model.limit_tangential_ratio();
    out.state = model.write_state();
    return out;
}

void expect_same(const Outcome& a, const Outcome& b) {
    ASSERT_EQ(a.records.size(), b.records.size());
    for (std::size_t i = 0; i < a.records.size(); ++i) expect_same(a.records[i], b.records[i]);
    EXPECT_EQ(a.gaps, b.gaps);
    EXPECT_EQ(a.energies, b.energies);
    EXPECT_EQ(a.limit, b.limit);
    EXPECT_EQ(a.state, b.state);
}

class Journal : public testing::Test {
  protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(testing::TempDir()) /
                  ("io_journal_" + std::string(test->name()) + std::to_string(::getpid()));
        fs::create_directories(folder_);
        path_ = (folder_ / "journal").string();
        FakeModel::Count count;
        FakeModel model(count);
        due_ = run(model);
    }
    void TearDown() override { fs::remove_all(folder_); }

    JournalledModel journalled(const std::string& key = "case 1", bool with_state = true) {
        count_ = {};
        warnings_.clear();
        return {std::make_unique<FakeModel>(count_, with_state), path_, key,
                [this](const std::string& text) { warnings_.push_back(text); }};
    }
    std::string content() const {
        std::ostringstream out;
        out << std::ifstream(path_, std::ios::binary).rdbuf();
        return out.str();
    }
    // A new file: some file systems write one that was emptied to the disk when it is closed.
    void put(const std::string& bytes) const {
        fs::remove(path_);
        std::ofstream(path_, std::ios::binary) << bytes;
    }
    // File of a run that was killed after n calls.
    std::string content_after(int n) {
        fs::remove(path_);
        {
            auto model = journalled();
            run(model, n);
        }
        return content();
    }
    // Whole entries at the front of a file of this size.
    static int n_whole(const std::vector<std::size_t>& ends, std::size_t size) {
        int n = 0;
        while (n < n_calls && ends[n + 1] <= size) ++n;
        return n;
    }
    static int n_steps_in(int n_entries) {
        return n_entries - (n_entries > release_at) - (n_entries > limit_at);
    }
    // Sizes of the file after 0 ... n_calls calls.
    std::vector<std::size_t> ends() {
        std::vector<std::size_t> sizes;
        for (int n = 0; n <= n_calls; ++n) sizes.push_back(content_after(n).size());
        return sizes;
    }
    // A run over what is there: the outcome is due, `n_reused` steps are not solved again.
    void expect_goes_on(int n_reused, const std::string& what) {
        SCOPED_TRACE(what);
        auto model = journalled();
        EXPECT_EQ(model.n_found(), n_reused);
        expect_same(run(model), due_);
        EXPECT_EQ(count_.solved, n_steps - n_reused);
        EXPECT_EQ(count_.released, 1);
        EXPECT_TRUE(warnings_.empty());
    }

    fs::path folder_;
    std::string path_;
    Outcome due_;
    FakeModel::Count count_;
    std::vector<std::string> warnings_;
};

TEST_F(Journal, ARunKilledAfterAnyCallGoesOnWithTheSameBits) {
    const std::string whole = content_after(n_calls);
    for (int n = 0; n <= n_calls; ++n) {
        content_after(n);
        expect_goes_on(n_steps_in(n), "killed after " + std::to_string(n));
        EXPECT_EQ(content(), whole) << "the journal of the rest is not the same";
    }
}

TEST_F(Journal, AFileCutAnywhereLosesOnlyTheStepsThatAreNotWhole) {
    const auto sizes = ends();
    const std::string whole = content_after(n_calls);
    ASSERT_EQ(whole.size(), sizes.back());
    for (std::size_t size = 0; size < whole.size(); ++size) {
        put(whole.substr(0, size));
        expect_goes_on(n_steps_in(n_whole(sizes, size)), "cut to " + std::to_string(size));
        ASSERT_EQ(content(), whole) << size;
    }
}

TEST_F(Journal, ADamagedByteAnywhereLosesOnlyWhatFollows) {
    const auto sizes = ends();
    const std::string whole = content_after(n_calls);
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string damaged = whole;
        damaged[i] ^= static_cast<char>(1 << (i % 8));
        put(damaged);
        expect_goes_on(n_steps_in(n_whole(sizes, i)), "damaged at " + std::to_string(i));
        ASSERT_EQ(content(), whole) << i;
    }
}

TEST_F(Journal, TwoWholeJournalsOneBehindTheOtherAreOne) {
    const std::string whole = content_after(n_calls);
    put(whole + whole.substr(ends()[0]));
    put(whole + whole);
    expect_goes_on(n_steps, "twice");
    EXPECT_EQ(content(), whole);
}

TEST_F(Journal, AnotherKeyBeginsAnew) {
    content_after(5);
    for (const std::string key : {"case 2", "case 1 ", "case", ""}) {
        auto model = journalled(key);
        EXPECT_EQ(model.n_found(), 0) << key;
        expect_same(run(model), due_);
        EXPECT_EQ(count_.solved, n_steps) << key;
    }
    auto model = journalled("");
    EXPECT_EQ(model.n_found(), n_steps) << "the last key's journal is there";
}

TEST_F(Journal, ZerosOfAPowerCutBeginAnew) {
    put(std::string(5000, '\0'));
    expect_goes_on(0, "zeros");
}

TEST_F(Journal, AFileThatIsNoJournalIsLeftAlone) {
    for (const std::string text : {"p", "precious", "tricycle journal of a whole life\n"}) {
        put(text);
        EXPECT_THROW(journalled(), contact::InputError) << text;
        EXPECT_EQ(content(), text);
    }
}

TEST_F(Journal, NothingIsWrittenThroughALink) {
    std::ofstream(folder_ / "target") << "";
    fs::create_symlink(folder_ / "target", path_);
    EXPECT_THROW(journalled(), contact::InputError);
    EXPECT_TRUE(fs::is_symlink(path_) && fs::is_empty(folder_ / "target"));
}

TEST_F(Journal, OtherCallsThanTheRecordedAreComputed) {
    for (int changed = 0; changed < n_calls; ++changed) {
        if (changed == release_at || changed == limit_at) continue;
        content_after(n_calls);
        auto model = journalled();
        FakeModel::Count count;
        FakeModel plain(count);
        Outcome out, due;
        for (int i = 0; i < n_calls; ++i) {
            LoadStep step = step_of(i);
            if (i == changed) step.tangential[1].value += 1e-15;
            call(model, i, step, out);
            call(plain, i, step, due);
        }
        for (int i = 0; i < n_steps; ++i) expect_same(out.records[i], due.records[i]);
        EXPECT_EQ(model.write_state(), plain.write_state()) << changed;
        EXPECT_EQ(count_.solved, n_steps - n_steps_in(changed)) << changed;
    }
}

TEST_F(Journal, CallsInAnotherOrderAreComputed) {
    content_after(n_calls);
    auto model = journalled();
    FakeModel::Count count;
    FakeModel plain(count);
    Outcome out, due;
    for (const int i : {0, release_at, 2, 3, limit_at, 4, 6, 7})
        for (const auto& [each, records] : {std::pair<contact::Model*, Outcome*>{&model, &out},
                                            std::pair<contact::Model*, Outcome*>{&plain, &due}})
            call(*each, i, step_of(i), *records);
    EXPECT_EQ(model.write_state(), plain.write_state());
    EXPECT_EQ(count_.solved, 6 - 3);
}

TEST_F(Journal, AReleaseThatWasNotThereIsCarriedOut) {
    content_after(n_calls);
    auto model = journalled();
    model.release();
    EXPECT_EQ(count_.released, 1);
    run(model, 1);
    EXPECT_EQ(count_.solved, 1);
}

TEST_F(Journal, AStepThatDoesNotConvergeIsNotKept) {
    const std::string before = content_after(4);
    auto model = journalled();
    run(model, 4);
    LoadStep far;
    far.phase = 1e9;
    EXPECT_THROW(model.advance(far), contact::NotConverged);
    EXPECT_EQ(content(), before);
}

TEST_F(Journal, FinishRemovesTheFile) {
    auto model = journalled();
    run(model);
    ASSERT_TRUE(fs::exists(path_));
    model.finish();
    EXPECT_FALSE(fs::exists(path_));
    EXPECT_NO_THROW(model.advance(step_of(2))) << "the model lives on";
    EXPECT_FALSE(fs::exists(path_));
}

TEST_F(Journal, AModelWithoutStateHasNone) {
    auto model = journalled("case 1", false);
    const Outcome out = run(model);
    EXPECT_FALSE(fs::exists(path_));
    EXPECT_TRUE(warnings_.empty());
    for (std::size_t i = 0; i < out.records.size(); ++i)
        expect_same(out.records[i], due_.records[i]);
}

TEST_F(Journal, WhatIsAskedOfTheModelIsPassedOn) {
    auto model = journalled();
    EXPECT_EQ(model.name(), "fake");
    EXPECT_TRUE(model.is_coupled());
    model.advance(step_of(3));
    EXPECT_EQ(model.scales().normal_force, model.surface().gap[0]);
    EXPECT_TRUE(model.audit().passed());
    const std::string state = model.write_state();
    model.advance(step_of(4));
    EXPECT_NE(model.write_state(), state);
    model.read_state(state);
    EXPECT_EQ(model.write_state(), state);
}

TEST_F(Journal, AFullDiskIsSaidOnceAndTheRunGoesOn) {
    const std::vector<std::size_t> sizes = ends();
    fs::remove(path_);
    rlimit old_limit{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old_limit), 0);
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{sizes[6] + 20, old_limit.rlim_max};  // within the seventh entry
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    {
        auto model = journalled();
        const Outcome out = run(model);
        ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old_limit), 0);
        std::signal(SIGXFSZ, old_handler);
        expect_same(out, due_);
        ASSERT_EQ(warnings_.size(), 1U);
        EXPECT_EQ(warnings_[0], path_ +
                                    ": the journal cannot be written (File too large); a run that "
                                    "is killed later goes on from here");
    }
    EXPECT_EQ(content().size(), sizes[6]) << "half an entry";
    expect_goes_on(n_steps_in(6), "after the full disk");
}

TEST_F(Journal, ItsSizeIsLimited) {
    const std::vector<std::size_t> sizes = ends();
    fs::remove(path_);
    {
        auto model = journalled();
        model.limit_size(sizes[6] + 20);
        expect_same(run(model), due_);
        EXPECT_EQ(warnings_.size(), 1U);
    }
    EXPECT_EQ(content().size(), sizes[6]);
    expect_goes_on(n_steps_in(6), "after the limit");
}

TEST_F(Journal, AFolderThatIsMissingIsSaidOnceAndTheRunGoesOn) {
    path_ = (folder_ / "missing" / "journal").string();
    auto model = journalled();
    expect_same(run(model), due_);
    ASSERT_EQ(warnings_.size(), 1U);
    EXPECT_EQ(warnings_[0], path_ +
                                ": the journal cannot be opened (No such file or directory); a run "
                                "that is killed starts again");
    EXPECT_NO_THROW(model.finish());
}

TEST_F(Journal, TwoRunsDoNotShareOne) {
    auto first = journalled();
    run(first, 3);
    {
        FakeModel::Count count;
        std::vector<std::string> warnings;
        JournalledModel second(std::make_unique<FakeModel>(count), path_, "case 1",
                               [&](const std::string& text) { warnings.push_back(text); });
        expect_same(run(second), due_);
        ASSERT_EQ(warnings.size(), 1U);
        EXPECT_EQ(count.solved, n_steps);
        second.finish();
    }
    EXPECT_TRUE(fs::exists(path_)) << "removed by the one that did not own it";
    first.finish();
    EXPECT_FALSE(fs::exists(path_));
}

}  // namespace
}  // namespace tricontact::io::journal_test
