// What the order of a journal's entries tells.

#include "io/results/journal_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/results/journal.h"
#include "tests/unit/io/results/fake_model.h"

namespace tricontact::io::journal_file_test {
namespace {

namespace fs = std::filesystem;

class JournalOrder : public testing::Test {
  protected:
    void TearDown() override { fs::remove(path_); }

    std::string content() const {
        std::ostringstream out;
        out << std::ifstream(path_, std::ios::binary).rdbuf();
        return out.str();
    }
    std::size_t n_entries_of(const std::string& bytes) const {
        std::ofstream(path_, std::ios::binary | std::ios::trunc) << bytes;
        return JournalFile(path_, "key").size();
    }
    JournalledModel journalled() {
        return {std::make_unique<FakeModel>(count_), path_, "key", [](const std::string&) {}};
    }

    FakeModel::Count count_;
    std::string path_ =
        (fs::path(testing::TempDir()) / ("journal_order_" + std::to_string(::getpid()))).string();
};

// Each entry's checksum is that of all before it too: whole entries in another order are damage.
TEST_F(JournalOrder, ExchangedEntriesAreDamage) {
    std::size_t header = 0;
    {
        JournalFile file(path_, "key");
        header = content().size();
        file.append("first.");
        file.append("second");
    }
    const std::string bytes = content(), front = bytes.substr(0, header);
    const std::size_t entry = (bytes.size() - header) / 2;
    EXPECT_EQ(n_entries_of(bytes), 2u);
    EXPECT_EQ(n_entries_of(front + bytes.substr(header + entry) + bytes.substr(header, entry)), 0u);
}

// What follows the start of the limit is no answer to what follows a release.
TEST_F(JournalOrder, AReleaseIsNotTheStartOfTheLimit) {
    const contact::LoadStep step{.phase = 0.5};
    for (int runs = 0; runs < 2; ++runs) {
        auto model = journalled();
        model.start_limit();
        model.advance(step);
        EXPECT_EQ(count_.solved, 1);  // the second run takes it from the journal
    }
    auto model = journalled();
    model.release();
    model.advance(step);
    EXPECT_EQ(count_.solved, 2);
}

}  // namespace
}  // namespace tricontact::io::journal_file_test
