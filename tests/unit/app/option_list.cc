#include "app/commands/option_list.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tricontact::option_list_test {
namespace {

/// A command with an option of each kind.
struct Options {
    std::string file;
    int threads = 4;
    std::optional<double> tolerance;
    std::string variable = "load";
    std::vector<std::string> models, overrides;
    bool report = true;
};

class Command {
  public:
    Command() {
        list_.add("case", &options.file, "Case file", "CASE.toml");
        list_.require();
        list_.add("--threads", &options.threads, "Threads");
        list_.keep_within(1, 1024);
        list_.add("--tolerance", &options.tolerance, "Bracket width");
        list_.keep_within(1e-9, .1);
        list_.add("--vary", &options.variable, "Limit in");
        list_.keep_to({"load", "amplitude"});
        list_.add("--models", &options.models, "Models", "NAME,NAME");
        list_.divide_by(',');
        list_.add("--set", &options.overrides, "Override", "KEY=VALUE");
        list_.take_one_at_a_time();
        list_.add_flag(
            "--no-report", [this] { options.report = false; }, "Skip report.html");
    }

    /// What the parser says against the arguments; nothing where they are good.
    std::string refused(std::vector<std::string> arguments) {
        std::ranges::reverse(arguments);  // as CLI11 takes them
        try {
            list_.parser()->parse(arguments);
        } catch (const CLI::ParseError& error) {
            return error.what();
        }
        return {};
    }
    const CLI::App& parser() const { return *list_.parser(); }

    Options options;

  private:
    app::OptionList list_{"limit", "Bisect the limit"};
};

TEST(OptionList, TakesValuesOfAllKinds) {
    Command command;
    EXPECT_EQ(
        command.refused({"a.toml", "--threads", "2", "--tolerance", "1e-3", "--vary", "amplitude",
                         "--models", "mdr,bem", "--set", "a=1", "--set", "b=2", "--no-report"}),
        "");
    EXPECT_EQ(command.options.file, "a.toml");
    EXPECT_EQ(command.options.threads, 2);
    EXPECT_EQ(command.options.tolerance, 1e-3);
    EXPECT_EQ(command.options.variable, "amplitude");
    EXPECT_EQ(command.options.models, (std::vector<std::string>{"mdr", "bem"}));
    EXPECT_EQ(command.options.overrides, (std::vector<std::string>{"a=1", "b=2"}));
    EXPECT_FALSE(command.options.report);
}

TEST(OptionList, LeavesWhatIsNotGiven) {
    Command command;
    EXPECT_EQ(command.refused({"a.toml"}), "");
    EXPECT_EQ(command.options.threads, 4);
    EXPECT_FALSE(command.options.tolerance.has_value());
    EXPECT_TRUE(command.options.report);
    EXPECT_EQ(app::given_options(command.parser()), (std::vector<std::string>{"case"}));
}

// One value for each --set: a second one is no override, and there is no other place for it.
TEST(OptionList, AnOverrideTakesOneValue) {
    EXPECT_NE(Command().refused({"a.toml", "--set", "a=1", "b=2"}), "");
}

TEST(OptionList, RefusesByName) {
    const auto expect = [](const std::vector<std::string>& arguments, const std::string& part) {
        const std::string why = Command().refused(arguments);
        EXPECT_NE(why.find(part), std::string::npos) << why;
    };
    expect({}, "case is required");
    expect({"a.toml", "--threads", "0"}, "--threads");
    expect({"a.toml", "--tolerance", "nan"}, "Value nan is no number");
    expect({"a.toml", "--tolerance", "1"}, "--tolerance");
    expect({"a.toml", "--vary", "loads"}, "--vary");
    expect({"a.toml", "--threds", "2"}, "--threds");
}

}  // namespace
}  // namespace tricontact::option_list_test
