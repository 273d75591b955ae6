// What the store keeps, what it leaves out, and what it says of files that are not its own.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "contact/error.h"
#include "io/result_store.h"

namespace tricontact::io {
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

TEST_F(Store, OneWriterAtATime) {
    const ResultStore store(path("a"));
    EXPECT_NE(message_of([&] { ResultStore(path("a")); }).find("is in use by another program"),
              std::string::npos);
}

}  // namespace
}  // namespace tricontact::io
