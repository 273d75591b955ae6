// JSON of others: bounded before it is parsed.

#include "io/keys/json_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace tricontact::io::json_text_test {
namespace {

std::string nested(int n, const std::string& open, const std::string& close) {
    std::string text;
    for (int i = 0; i < n; ++i) text += open;
    text += "1";
    for (int i = 0; i < n; ++i) text += close;
    return text;
}

std::string object_of(int n) {
    std::string text = "{";
    for (int i = 0; i < n; ++i) text += (i > 0 ? ", \"" : "\"") + std::to_string(i) + "\": 1";
    return text + '}';
}

TEST(JsonText, RefusesWhatHasNoBounds) {
    for (const std::string& text :
         {nested(20'000, "[", "]"), nested(most_levels + 1, "[", "]"), std::string(1'000'000, '['),
          nested(most_levels + 1, "{\"a\": ", "}"), nested(40, "[{\"a\": ", "}]"),
          object_of(most_members + 1), "{\"a\": " + object_of(most_members + 1) + "}"}) {
        EXPECT_TRUE(parsed_json(text).is_discarded()) << text.substr(0, 40);
        EXPECT_FALSE(is_sound_json(text)) << text.substr(0, 40);
    }
}

TEST(JsonText, RefusesWhatIsNoJson) {
    for (const char* text : {"", "NaN", "{\"a\": NaN}", "1e400", "[-1e400]", "Infinity", "[1", "]",
                             "\"\\", "{\"a\"}", "\xff", "\"\\ud800\""}) {
        EXPECT_TRUE(parsed_json(text).is_discarded()) << text;
        EXPECT_FALSE(is_sound_json(text)) << text;
    }
}

TEST(JsonText, TakesWhatIs) {
    const std::string brackets(1000, '[');
    for (const std::string& text :
         {nested(most_levels, "[", "]"), object_of(most_members), "\"" + brackets + "\"",
          "{\"" + brackets + "\\\"\": \"" + brackets + "\"}",
          std::string(" [1, {\"a\": 1e308}] ")}) {
        EXPECT_TRUE(is_sound_json(text)) << text.substr(0, 40);
        EXPECT_EQ(parsed_json(text), nlohmann::ordered_json::parse(text)) << text.substr(0, 40);
    }
    const std::string wide = "[" + object_of(3000) + ", " + object_of(3000) + "]";
    EXPECT_TRUE(is_sound_json(wide)) << "each object is counted alone";
}

}  // namespace
}  // namespace tricontact::io::json_text_test
