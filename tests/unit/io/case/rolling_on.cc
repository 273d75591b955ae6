#include "io/case/rolling_on.h"

#include <gtest/gtest.h>

#include "contact/base/error.h"

namespace tricontact::io::rolling_on_test {
namespace {

std::string why(void (*check)(const contact::Case&, const std::string&), bool rolls_on) {
    contact::Case c;
    if (rolls_on) c.tractive_rolling.emplace();
    try {
        check(c, "a.toml");
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return {};
}

TEST(RollingOn, IsRefusedOrDemandedByName) {
    EXPECT_EQ(why(refuse_rolling_on, false), "");
    EXPECT_EQ(why(require_rolling_on, true), "");
    EXPECT_TRUE(why(refuse_rolling_on, true).starts_with("a.toml: [tractive_rolling]: "));
    EXPECT_TRUE(
        why(require_rolling_on, false).starts_with("a.toml: there is no [tractive_rolling]"));
}

}  // namespace
}  // namespace tricontact::io::rolling_on_test
