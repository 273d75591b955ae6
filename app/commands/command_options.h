#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tricontact::app {

/// A subcommand of the program: its options in the order in which the help names them.
template <class Options>
class Command {
  public:
    CLI::App& app;
    Options& options;

    template <class T, class... Check>
    Command option(const char* name, T Options::*place, const char* text, const char* type,
                   const Check&... check) {
        CLI::Option* added = app.add_option(name, options.*place, text);
        (added->check(check), ...);
        if (*type) added->type_name(type);
        return *this;
    }
    template <class T>
    Command required(const char* name, T Options::*place, const char* text, const char* type) {
        option(name, place, text, type);
        app.get_option(name)->required();
        return *this;
    }
    Command flag(const char* name, bool Options::*place, const char* text) {
        app.add_flag(name, options.*place, text);
        return *this;
    }
    /// A flag declared as "!--no-report" would stand as "--no-report{false}" in the help.
    Command no(const char* name, bool Options::*place, const char* text) {
        app.add_flag_callback(
            name, [&value = options.*place] { value = false; }, text);
        return *this;
    }
    /// One of some words, which stand in the help as the type, not as CLI11 shows a set.
    Command word(const char* name, std::string Options::*place, const char* text,
                 std::vector<std::string> words) {
        const std::string type = CLI::detail::join(words, "|");
        return option(name, place, text, type.c_str(),
                      CLI::IsMember(std::move(words)).description(""));
    }
    /// The case file and --set.
    Command on_case() {
        required("case", &Options::case_file, "Case file (TOML)", "CASE.toml");
        option("--set", &Options::overrides,
               "Override a key of the case: section.key=value (may be repeated)", "KEY=VALUE");
        app.get_option("--set")->take_all()->allow_extra_args(false);
        return *this;
    }
    Command output(const char* text) { return option("--output", &Options::output, text, "DIR"); }
    Command models(const char* text) {
        option("--models", &Options::models, text, "NAME,NAME");
        app.get_option("--models")->delimiter(',');
        return *this;
    }
    Command threads() {
        return option("--threads", &Options::threads, "Threads for large grids (all cores)", "",
                      CLI::Range(1, 1024));
    }
    Command jobs() {
        return option("--jobs", &Options::jobs, "Processes side by side (all cores)", "",
                      CLI::Range(1, 1024));
    }
    Command quiet(const char* text = "No progress, no closing line") {
        return flag("--quiet", &Options::quiet, text);
    }
};

/// All subcommands.
class Commands {
  public:
    /// `threads`: threads and jobs of those that have any.
    Commands(CLI::App& app, int threads) : app_(app), threads_(threads) {}

    /// A command that `run` runs with its options; false if that failed.
    template <class Options, class Run>
    Command<Options> add(const char* name, const char* text, Run run) {
        const auto options = std::make_shared<Options>();
        if constexpr (requires { options->threads; }) options->threads = threads_;
        if constexpr (requires { options->jobs; }) options->jobs = threads_;
        CLI::App& command = *app_.add_subcommand(name, text);
        commands_.emplace_back(&command, [options, run]() -> bool {
            if constexpr (std::is_same_v<decltype(run(*options)), bool>)
                return run(*options);
            else
                return run(*options), true;
        });
        return {command, *options};
    }

    /// Runs those that were given.
    bool run() const {
        for (const auto& [command, run] : commands_)
            if (*command && !run()) return false;
        return true;
    }

  private:
    CLI::App& app_;
    int threads_;
    std::vector<std::pair<const CLI::App*, std::function<bool()>>> commands_;
};

}  // namespace tricontact::app
