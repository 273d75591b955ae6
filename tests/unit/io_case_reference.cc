// docs/case-file.md and docs/walking.md hold what `tricontact keys` prints.

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "io/case_keys.h"
#include "io/key_reference.h"
#include "io/walk_keys.h"

namespace tricontact::io {
namespace {

class CaseReference : public testing::TestWithParam<const KeyList*> {};

TEST_P(CaseReference, DocumentNamesEveryKeyAsDeclared) {
    const KeyList& keys = *GetParam();
    const std::string name(keys.reference());
    std::ifstream file(TRICONTACT_SOURCE_DIR "/" + name);
    std::stringstream document;
    document << file.rdbuf();
    EXPECT_NE(document.str().find(key_reference(keys)), std::string::npos)
        << name << ": scripts/key_reference.sh writes it anew; it should hold this:\n"
        << key_reference(keys);
}

INSTANTIATE_TEST_SUITE_P(Documents, CaseReference,
                         testing::Values(&case_key_list(), &walk_key_list()));

}  // namespace
}  // namespace tricontact::io
