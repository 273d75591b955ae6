#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "app/options.h"
#include "app/papers/paper_export.h"
#include "app/unread_parts.h"
#include "io/case/case_reader.h"

// Files of commands take from here what most of them need: texts, output, options, cases.
namespace tricontact::app {

inline constexpr const char* program_text =
    "Tricontact: models of frictional contact side by side, from one case file.";

/// As CLI::Range, which takes "nan" for a number between all others.
CLI::Validator in_range(double low, double high);

/// A subcommand of the program, its options in the order in which the help names them.
struct Command {
    CLI::App_p parser;
    std::function<int()> run;           ///< exit code: 0 done, 1 failed
    CommandOptions* options = nullptr;  ///< what it has in common with others, if anything
};

/// Declares a command with its struct of options (CommandOptions and its own), which `run` gets.
template <class Options>
class Declared {
  public:
    template <class Run>
    Declared(const char* name, const char* text, Run run)
        : options_(std::make_shared<Options>()),
          command_{std::make_shared<CLI::App>(text, name), {}} {
        if constexpr (std::is_base_of_v<CommandOptions, Options>) command_.options = options_.get();
        command_.run = [options = options_, parser = command_.parser, run] {
            const auto call = [&]() -> int {
                using Result = decltype(run(*options));
                int code = 0;
                if constexpr (std::is_same_v<Result, bool>) code = run(*options) ? 0 : 1;
                if constexpr (std::is_same_v<Result, int>) code = run(*options);
                if constexpr (std::is_void_v<Result>) run(*options);
                if constexpr (std::is_base_of_v<CommandOptions, Options>)
                    say_unread_parts(*options, parser->get_name());
                return code;
            };
            if constexpr (std::is_base_of_v<CommandOptions, Options>)
                if (!options->papers.folder.empty()) return run_for_papers(*parser, *options, call);
            return call();
        };
    }
    operator Command() const { return command_; }

    template <class T, class Base>
    Declared& option(const char* name, T Base::*place, const char* text, const char* type = "") {
        last_ = command_.parser->add_option(name, (*options_).*place, text);
        if (*type) last_->type_name(type);
        return *this;
    }
    template <class T, class Base>
    Declared& required(const char* name, T Base::*place, const char* text, const char* type) {
        option(name, place, text, type);
        last_->required();
        return *this;
    }
    template <class T, class Base>
    Declared& number(const char* name, T Base::*place, const char* text, double low, double high) {
        option(name, place, text);
        if constexpr (std::is_same_v<T, int>)
            last_->check(CLI::Range(static_cast<int>(low), static_cast<int>(high)));
        else
            last_->check(in_range(low, high));
        return *this;
    }
    template <class Base>
    Declared& flag(const char* name, bool Base::*place, const char* text, bool value = true) {
        // A flag declared as "!--no-report" would stand as "--no-report{false}" in the help.
        const auto set = [options = options_, place, value] { (*options).*place = value; };
        command_.parser->add_flag_callback(name, set, text);
        return *this;
    }
    /// One of some words, which stand in the help as the type, not as the parser shows a set.
    template <class Base>
    Declared& word(const char* name, std::string Base::*place, const char* text,
                   const std::vector<std::string>& words) {
        return option(name, place, text).one_of(words);
    }

    /// What was declared last is one of some words, which stand in the help as its type.
    Declared& one_of(const std::vector<std::string>& words) {
        last_->check(CLI::IsMember(words).description(""))
            ->type_name(CLI::detail::join(words, "|"));
        return *this;
    }

    Declared& on_file(const char* name, const char* text, const char* type) {
        return required(name, &CommandOptions::file, text, type);
    }
    /// The case file and --set. `reads`: what of io::rig_parts the command reads.
    Declared& on_case(std::vector<std::string> reads = {}) {
        options_->reads = std::move(reads);
        on_file("case", "Case file (TOML)", "CASE.toml");
        option("--set", &CommandOptions::overrides,
               "Override a key of the case: section.key=value (may be repeated)", "KEY=VALUE");
        last_->take_all()->allow_extra_args(false);
        return *this;
    }
    Declared& output(const char* text) {
        return option("--output", &CommandOptions::output, text, "DIR");
    }
    /// --export, of a command with a report. `filled_by`: the command that has to fill its folder
    /// before.
    Declared& exports(const char* filled_by = "") {
        options_->papers.filled_by = filled_by;
        const auto set = [options = options_](const std::string& folder) {
            options->papers.folder = folder;
        };
        last_ = command_.parser->add_option_function<std::string>(
            "--export", set, "Folder for figures, tables, sources and an archive, for papers");
        last_->type_name("DIR");
        return *this;
    }
    Declared& models(const char* text) {
        option("--models", &CommandOptions::models, text, "NAME,NAME");
        last_->delimiter(',');
        return *this;
    }
    Declared& threads() { return cores("--threads", "Threads for large grids (all cores)"); }
    Declared& jobs() { return cores("--jobs", "Processes side by side (all cores)"); }
    Declared& quiet(const char* text = "No progress, no closing line") {
        return flag("--quiet", &CommandOptions::quiet, text);
    }
    Declared& no_report(const char* text = "Skip report.html") {
        return flag("--no-report", &CommandOptions::report, text, false);
    }

  private:
    Declared& cores(const char* name, const char* text) {
        options_->threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
        return number(name, &CommandOptions::threads, text, 1, 1024);
    }

    std::shared_ptr<Options> options_;
    Command command_;
    CLI::Option* last_ = nullptr;
};

// The commands, each declared in a file of its own beside what it does, which throws
// contact::InputError and contact::NotConverged; mesh, condense and cache in fem_loader.cc.
Command run_command();
Command check_command();
Command mesh_command();
Command condense_command();
Command cache_command();
Command refine_command();
Command influence_command();
Command export_command();
Command reproduce_command();
Command import_command();
Command limit_command();
Command verify_command();
Command walk_command();
Command roll_command();
Command sweep_command();
Command atlas_command();
Command predict_command();
Command experiment_command();
Command deviation_command();
Command fit_command();
Command merge_command();
Command identify_command();
Command rig_command();
Command design_command();
Command keys_command();
Command list_command();
Command manual_command();

/// All of them, in the order of the help.
std::vector<Command> all_commands();

}  // namespace tricontact::app
