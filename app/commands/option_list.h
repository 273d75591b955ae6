#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace tricontact::app {

/// The options of a command, in the order of the help, and what each may be. The library that
/// parses them, whose header takes seconds to compile, is seen by option_list.cc.
class OptionList {
  public:
    /// Where a value goes.
    using Place = std::variant<std::string*, int*, double*, unsigned*, unsigned long*,
                               std::optional<std::string>*, std::optional<int>*,
                               std::optional<double>*, std::vector<std::string>*>;

    OptionList(const std::string& name, const char* text);
    const std::shared_ptr<CLI::App>& parser() const { return parser_; }

    /// `type` as the help shows it; empty: as the parser names it.
    void add(const char* name, const Place& place, const char* text, const char* type = "");
    void add_flag(const char* name, const std::function<void()>& set, const char* text);

    // Of what was added last.
    void require();
    void keep_within(double low, double high);
    void keep_to(const std::vector<std::string>& words);
    void divide_by(char mark);
    void take_one_at_a_time();  ///< may be repeated, with one value each

  private:
    std::shared_ptr<CLI::App> parser_;
    CLI::Option* last_ = nullptr;
    bool last_is_whole_ = false;  // an int
};

/// Names of the options that a call of the command has.
std::vector<std::string> given_options(const CLI::App& parser);

}  // namespace tricontact::app
