// The documents hold what `tricontact keys` prints.

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "comparisons/quantities/quantity.h"
#include "io/case/case_keys.h"
#include "io/keys/key.h"
#include "tests/paths.h"
#include "walking/input/walk_keys.h"

namespace tricontact::walking::case_reference_test {
namespace {

class CaseReference : public testing::TestWithParam<const io::KeyList*> {};

void expect_held(const std::string& name, const std::string& reference) {
    std::ifstream file(paths::source(name));
    std::stringstream document;
    document << file.rdbuf();
    EXPECT_NE(document.str().find(reference), std::string::npos)
        << name << ": scripts/key_reference.sh writes it anew; it should hold this:\n"
        << reference;
}

TEST_P(CaseReference, DocumentNamesEveryKeyAsDeclared) {
    expect_held(std::string(GetParam()->reference()), io::key_reference(*GetParam()));
}

TEST(ResultReference, DocumentsNameEveryQuantityAsDeclared) {
    expect_held("docs/reference/quantities.md", comparisons::glossary());
    expect_held("docs/reference/quantities.md", comparisons::summary_keys());
}

INSTANTIATE_TEST_SUITE_P(Documents, CaseReference,
                         testing::Values(&io::case_file_keys(), &walk_file_keys()));

}  // namespace
}  // namespace tricontact::walking::case_reference_test
