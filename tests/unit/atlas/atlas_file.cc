#include "atlas/atlas_file.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "atlas/shipped.h"
#include "contact/base/error.h"

namespace tricontact::atlas::atlas_file_test {
namespace {

std::string refusal_of(const std::string& text) {
    try {
        parse_atlas(text, "some.json");
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(AtlasFile, TheSameAtlasHasTheSameBytes) {
    for (const std::string_view name : shipped_names()) {
        EXPECT_EQ(shipped(name).name, name);
        const std::string text = write_atlas(shipped(name));
        EXPECT_EQ(write_atlas(parse_atlas(text, "some.json")), text) << name;
    }
}

TEST(AtlasFile, ChangedBytesAreRefused) {
    const std::string text = write_atlas(shipped("sphere_half_space"));
    const std::size_t place = text.find("\"coefficients\":[") + 20;
    std::string changed = text;
    changed[place] = text[place] == '1' ? '2' : '1';
    EXPECT_NE(refusal_of(changed).find("does not fit its digest"), std::string::npos)
        << refusal_of(changed);
    // Wherever it is: a byte is another text, or none that is JSON.
    for (std::size_t i = 0; i + 1 < text.size(); i += 997) {
        changed = text;
        changed[i] = changed[i] == '7' ? '3' : '7';
        EXPECT_NE(refusal_of(changed), "accepted") << i;
    }
}

TEST(AtlasFile, OtherFilesAreRefused) {
    EXPECT_NE(refusal_of("").find("some.json: is no atlas"), std::string::npos);
    EXPECT_NE(refusal_of("{}").find("tricontact atlas 1"), std::string::npos);
    EXPECT_NE(refusal_of("[1, 2]"), "accepted");
    EXPECT_THROW(read_atlas("nowhere.json"), contact::InputError);
    EXPECT_THROW(shipped("nowhere"), std::out_of_range);
}

}  // namespace
}  // namespace tricontact::atlas::atlas_file_test
