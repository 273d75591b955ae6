// What the store keeps, what it leaves out, and what it says of files that are not its own.

#include "io/results/result_store.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "contact/base/error.h"

namespace tricontact::io::result_store_test {
namespace {

namespace fs = std::filesystem;

class Store : public testing::Test {
  protected:
    Store() { fs::create_directories(folder_); }
    ~Store() override { fs::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    fs::path folder_ = fs::path(testing::TempDir()) / ("store-" + std::to_string(::getpid()));
};

PointOutcome done(const std::string& key, const std::string& results) {
    return {.key = key,
            .version = "1",
            .model = "mdr",
            .resolved = "a = 1\n",
            .results = results,
            .cpu_s = 0.25,
            .wall_s = 0.5};
}

PointOutcome failed(const std::string& key, const std::string& error) {
    return {.key = key, .version = "1", .model = "mdr", .resolved = "a = 1\n", .error = error};
}

template <class Call>
std::string message_of(const Call& call) {
    try {
        call();
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "(accepted)";
}

TEST_F(Store, AddsALotAtOnce) {
    ResultStore store(path("a"));
    store.add(done("first", R"({"x":1})"));
    const std::vector<PointOutcome> lot{done("first", R"({"x":2})"), failed("second", "no"),
                                        done("third", R"({"x":3})")};
    store.add(lot);
    EXPECT_EQ(store.find("first")->results, R"({"x":1})");  // a point has one result
    EXPECT_EQ(store.find("second")->error, "no");
    EXPECT_EQ(store.find("third")->results, R"({"x":3})");
}

TEST_F(Store, FindsAfterReopeningWhatWasAdded) {
    ResultStore(path("a")).add(done("k", R"({"x":0.1})"));
    const ResultStore store(path("a"));
    const auto found = store.find("k");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->results, R"({"x":0.1})");
    EXPECT_EQ(found->resolved, "a = 1\n");
    EXPECT_EQ(found->version, "1");
    EXPECT_EQ(found->wall_s, 0.5);
    EXPECT_FALSE(found->error);
    EXPECT_FALSE(store.find("other"));
}

// What a process killed between two transactions leaves: SQLite does not take it for its own.
TEST_F(Store, AnEndedJournalIsRemoved) {
    { ResultStore(path("a")).add(done("first", R"({"x":1})")); }
    std::ofstream(path("a-journal")) << std::string(512, '\0');
    EXPECT_EQ(ResultStore(path("a")).find("first")->results, R"({"x":1})");
    EXPECT_FALSE(fs::exists(path("a-journal")));
}

TEST_F(Store, AResultStaysAndAFailureGivesWayToAResult) {
    ResultStore store(path("a"));
    store.add(failed("k", "first"));
    store.add(failed("k", "second"));
    EXPECT_EQ(store.find("k")->error, "second");
    store.add(done("k", "{}"));
    EXPECT_FALSE(store.find("k")->error);
    store.add(done("k", R"({"x":1})"));
    store.add(failed("k", "third"));
    EXPECT_EQ(store.find("k")->results, "{}");
}

TEST_F(Store, MergesWhatIsMissingOnce) {
    ResultStore whole(path("whole"));
    whole.add(done("both", "1"));
    whole.add(failed("healed", "error"));
    whole.add(done("better", "1"));
    {
        ResultStore part(path("part"));
        part.add(done("both", "2"));
        part.add(done("healed", "1"));
        part.add(failed("better", "error"));
        part.add(failed("bad", "error"));
        part.add(done("new", "1"));
    }
    for (const bool again : {false, true}) {
        const auto merged = whole.merge(ResultStore(path("part"), ResultStore::Mode::read));
        EXPECT_EQ(merged.points, again ? 0 : 2);
        EXPECT_EQ(merged.failures, again ? 0 : 1);
        EXPECT_EQ(merged.different, 1);
    }
    EXPECT_EQ(whole.find("both")->results, "1");
    EXPECT_EQ(whole.find("healed")->results, "1");
    EXPECT_EQ(whole.find("better")->results, "1");
    EXPECT_EQ(whole.find("bad")->error, "error");
    EXPECT_EQ(whole.find("new")->results, "1");
}

TEST_F(Store, RefusesWhatIsNotItsOwn) {
    std::ofstream(path("text")) << std::string(5000, 'x');
    EXPECT_NE(message_of([&] { ResultStore(path("text")); }).find("is no file of results"),
              std::string::npos);
    SqliteFile(path("other"), SqliteFile::Open::create).execute("CREATE TABLE t (a)");
    EXPECT_NE(message_of([&] { ResultStore(path("other")); }).find("is no file of results"),
              std::string::npos);
    EXPECT_NE(message_of([&] {
                  ResultStore(path("missing"), ResultStore::Mode::read);
              }).find("cannot be opened"),
              std::string::npos);
    EXPECT_NE(message_of([&] { ResultStore(path("no/folder")); }).find("cannot be opened"),
              std::string::npos);
}

void execute(const std::string& path, const std::string& sql) {
    SqliteFile(path, SqliteFile::Open::existing).execute(sql);
}

// Each change meets a row of its own; the first row stays as it is.
TEST_F(Store, RowsThatWereChangedAreNotTaken) {
    const std::vector<std::string> changes{"points SET results = '{\"x\":2}' WHERE id",
                                           "points SET resolved_case = 'a = 2' WHERE id",
                                           "points SET version = '2' WHERE id",
                                           "points SET model = 'bem' WHERE id",
                                           "points SET digest = '' WHERE id",
                                           "points SET results = NULL, error = 'no' WHERE id",
                                           "times SET cpu_s = 1 WHERE point",
                                           "times SET wall_s = 1 WHERE point",
                                           "times SET digest = '' WHERE point",
                                           "times SET point = 99 WHERE point"};
    std::vector<PointOutcome> rows{done("0", "{}")};
    std::string sql;
    for (std::size_t i = 0; i < changes.size(); ++i) {
        rows.push_back(done(std::to_string(i + 1), R"({"x":1})"));
        sql += "UPDATE " + changes[i] + " = " + std::to_string(i + 2) + ';';
    }
    ResultStore(path("a")).add(rows);
    execute(path("a"), sql);
    const ResultStore reader(path("a"), ResultStore::Mode::read);
    for (std::size_t i = 0; i < rows.size(); ++i)
        EXPECT_EQ(message_of([&] { reader.find(rows[i].key); }).find("its row is damaged; call") ==
                      std::string::npos,
                  i == 0)
            << i;
    ResultStore whole(path("b"));
    const auto merged = whole.merge(reader);
    EXPECT_EQ(merged.damaged, static_cast<std::int64_t>(changes.size()));
    EXPECT_EQ(merged.points, 1);
}

TEST_F(Store, AnErrorThatWasChangedIsNotTold) {
    ResultStore(path("a")).add(failed("k", "not converged"));
    EXPECT_EQ(ResultStore(path("a"), ResultStore::Mode::read).find("k")->error, "not converged");
    execute(path("a"), "UPDATE points SET error = 'too stiff'");
    EXPECT_NE(message_of([&] {
                  ResultStore(path("a"), ResultStore::Mode::read).find("k");
              }).find("its row is damaged"),
              std::string::npos);
}

TEST_F(Store, DamagedRowsGiveWay) {
    ResultStore(path("a")).add(done("k", R"({"x":1})"));
    execute(path("a"), "UPDATE points SET key = 'l'");
    ResultStore store(path("a"));
    EXPECT_EQ(store.n_damaged(), 1u);
    EXPECT_FALSE(store.find("k"));
    EXPECT_FALSE(store.find("l"));
    store.add(done("k", R"({"x":3})"));
    EXPECT_EQ(store.find("k")->results, R"({"x":3})");
}

TEST_F(Store, RowsOfAnotherFormAreRefused) {
    ResultStore(path("a")).add(done("k", "{}"));
    execute(path("a"), "PRAGMA user_version = 1");
    EXPECT_NE(message_of([&] { ResultStore(path("a")); })
                  .find("was written by another version of the program, whose rows this one does "
                        "not trust; move it away"),
              std::string::npos);
}

// One bit in bytes all over a small store: what is found afterwards is what was stored, or it is
// not found, or the file is refused.
TEST_F(Store, NoFlippedBitGivesAnotherResult) {
    const std::vector<std::string> keys{"0123456789abcdef", "first", "second", "third"};
    {
        ResultStore store(path("whole"));
        for (const std::string& key : keys) store.add(done(key, "{\"x\":0.123456789}"));
    }
    std::string whole;
    {
        std::ifstream in(path("whole"), std::ios::binary);
        whole.assign(std::istreambuf_iterator<char>(in), {});
    }
    constexpr std::size_t n_flips = 60;  // more of them: tests/cli/results/corruption.sh
    int n_refused = 0;
    for (std::size_t i = 0; i < whole.size(); i += 1 + whole.size() / n_flips) {
        std::string damaged = whole;
        damaged[i] ^= static_cast<char>(1 << (i * 7 % 8));
        std::ofstream(path("a"), std::ios::binary | std::ios::trunc) << damaged;
        try {
            ResultStore store(path("a"));
            for (const std::string& key : keys) {
                const auto found = store.find(key);
                if (!found) continue;
                EXPECT_EQ(found->results, "{\"x\":0.123456789}") << i;
                EXPECT_EQ(found->cpu_s, 0.25) << i;
            }
            for (const std::string& key : keys) store.add(done(key, "{\"x\":0.123456789}"));
        } catch (const contact::InputError& error) {
            ++n_refused;
            EXPECT_EQ(std::string(error.what()).find("check the disk"), std::string::npos)
                << error.what();
        }
    }
    EXPECT_GT(n_refused, 0);
}

TEST_F(Store, WhatIsNoFileIsRefusedWithoutWaiting) {
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    EXPECT_NE(message_of([&] { ResultStore(path("pipe")); }).find("is not a regular file"),
              std::string::npos);
    EXPECT_NE(message_of([&] {
                  ResultStore(path("pipe"), ResultStore::Mode::read);
              }).find("is not a regular file"),
              std::string::npos);
}

TEST_F(Store, OneWriterAtATime) {
    const ResultStore store(path("a"));
    EXPECT_NE(message_of([&] { ResultStore(path("a")); }).find("is in use by another program"),
              std::string::npos);
}

}  // namespace
}  // namespace tricontact::io::result_store_test
