#include "benchmarks/reference/reference_cache.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "app/models/make_model.h"
#include "io/case/case_reader.h"

namespace tricontact::benchmarks::reference_cache_test {
namespace {

namespace fs = std::filesystem;
namespace keys = quantity_keys;

const char* const cylinder = R"(
models = ["bem"]
[indenter]
shape = "cylinder"
radius = "50 mm"
length = "1 m"
[substrate]
young = "70 GPa"
poisson = 0.3
[friction]
coefficient = 0.1
[contact]
coupling = false
[load]
normal_force = "35 MN"
tangential_ratio = 0.5
)";

class BenchmarkReferenceCache : public testing::Test {
  protected:
    BenchmarkReferenceCache()
        : folder_(fs::path(testing::TempDir()) /
                  ("tricontact_references_" + std::to_string(::getpid()))) {
        fs::remove_all(folder_);
    }
    ~BenchmarkReferenceCache() override { fs::remove_all(folder_); }

    Reference kept(const contact::Case& c, const std::string& identity = "program 1") {
        said_.clear();
        return kept_reference_in(folder_.string(), c, contact::ModelRunner(app::model_makers(), 1),
                                 identity,
                                 [this](const std::string& line) { said_ += line + '\n'; });
    }
    std::vector<fs::path> files() const {
        return {fs::directory_iterator(folder_), fs::directory_iterator()};
    }

    contact::Case case_ = io::parse_case(cylinder, "case.toml");
    fs::path folder_;
    std::string said_;
};

void expect_same(const Reference& a, const Reference& b) {
    ASSERT_EQ(a.values.size(), b.values.size());
    for (const auto& [key, value] : a.values) {
        EXPECT_EQ(value.value, b.values.at(key).value) << key;
        EXPECT_EQ(value.bar(), b.values.at(key).bar()) << key;
        EXPECT_EQ(value.source, b.values.at(key).source) << key;
    }
    EXPECT_EQ(a.digest, b.digest);
    EXPECT_EQ(a.prescribed, b.prescribed);
    EXPECT_EQ(a.models, b.models);
    EXPECT_EQ(a.remarks, b.remarks);
    EXPECT_EQ(a.geometry, b.geometry);
    EXPECT_EQ(a.has_friction(), b.has_friction());
    EXPECT_EQ(a.effects.normal_compliance->value, b.effects.normal_compliance->value);
    EXPECT_EQ(a.effects.tangential_compliance->value, b.effects.tangential_compliance->value);
    for (const double share : {0., .4, .97, 1.2}) {
        const double x = share * a.contact_radius;
        EXPECT_EQ(a.fields->at(x, 0).pressure, b.fields->at(x, 0).pressure);
        EXPECT_EQ(a.fields->at(x, 0).traction_x, b.fields->at(x, 0).traction_x);
        EXPECT_EQ(a.fields->bar_at(x, 0).traction_x, b.fields->bar_at(x, 0).traction_x);
        EXPECT_EQ(a.fields->load_within(x), b.fields->load_within(x));
    }
}

TEST_F(BenchmarkReferenceCache, TheSecondOneIsRead) {
    const Reference made = kept(case_);
    EXPECT_FALSE(said_.empty());
    ASSERT_EQ(files().size(), 1u);
    const Reference read = kept(case_);
    EXPECT_EQ(said_, "");
    expect_same(made, read);
}

TEST_F(BenchmarkReferenceCache, OtherCasesAndProgramsHaveTheirOwn) {
    kept(case_);
    kept(case_, "program 2");
    EXPECT_FALSE(said_.empty());
    contact::Case other = case_;
    other.friction.coefficient = .2;
    kept(other);
    EXPECT_FALSE(said_.empty());
    EXPECT_EQ(files().size(), 3u);
}

// Every byte counts: cut anywhere or changed anywhere the file counts as absent.
TEST_F(BenchmarkReferenceCache, DamagedFilesCountAsAbsent) {
    const Reference made = kept(case_);
    const std::string bytes = written_reference(made);
    ASSERT_TRUE(read_reference(bytes, case_));
    for (const std::size_t n :
         {std::size_t(0), std::size_t(31), std::size_t(32), bytes.size() / 2, bytes.size() - 1})
        EXPECT_FALSE(read_reference(bytes.substr(0, n), case_)) << n;
    for (std::size_t n = 0; n < bytes.size(); n += 1 + bytes.size() / 50) {
        std::string changed = bytes;
        changed[n] = static_cast<char>(changed[n] ^ 1);
        EXPECT_FALSE(read_reference(changed, case_)) << n;
    }
    std::ofstream(files().front()) << "no reference";
    const Reference again = kept(case_);
    EXPECT_NE(said_.find("damaged"), std::string::npos) << said_;
    expect_same(made, again);
    kept(case_);
    EXPECT_EQ(said_, "");
}

TEST_F(BenchmarkReferenceCache, NeedsNoFolder) {
    std::ofstream(folder_.string()) << "a file in its place";
    const Reference made = kept(case_);
    EXPECT_NE(said_.find("not kept"), std::string::npos) << said_;
    EXPECT_GT(made.find(keys::contact_radius)->value, 0);
}

}  // namespace
}  // namespace tricontact::benchmarks::reference_cache_test
