#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/commands/option_list.h"
#include "app/models/make_model.h"
#include "io/case/case_reader.h"
#include "papers/paper_export.h"
#include "runs/options.h"
#include "runs/unread_parts.h"

// Files of commands take from here what most of them need: texts, output, options, cases.
namespace tricontact::app {

using contact::Case;
using contact::Say;
using runs::Answer;
using runs::CommandOptions;
using runs::resolved_case_name;

inline constexpr const char* program_text =
    "Tricontact: models of frictional contact side by side, from one case file.";

/// What a command is for; the help shows them in this order.
enum class Group { compute, trust, ask, rigs, exchange, tools };
const char* title_of(Group group);

/// A command of the program, its options in the order in which the help names them.
struct Command {
    Group group;
    std::string name;  ///< of a part of another command two words: "sweep merge"
    std::shared_ptr<CLI::App> parser;
    std::function<int()> run = {};      ///< exit code: 0 done, 1 failed
    CommandOptions* options = nullptr;  ///< what it has in common with others, if anything
    bool is_part() const { return name.find(' ') != std::string::npos; }
};

/// Declares a command with its struct of options (CommandOptions and its own), which `run` gets.
template <class Options>
class Declared {
  public:
    template <class Run>
    Declared(Group group, const char* name, const char* text, Run run)
        : options_(std::make_shared<Options>()),
          list_(name, text),
          command_{group, name, list_.parser()} {
        if constexpr (std::is_base_of_v<CommandOptions, Options>) {
            command_.options = options_.get();
            options_->makers = &model_makers();
        }
        command_.run = [options = options_, parser = command_.parser, name = command_.name, run] {
            const auto call = [&]() -> int {
                using Result = decltype(run(*options));
                int code = 0;
                if constexpr (std::is_same_v<Result, bool>) code = run(*options) ? 0 : 1;
                if constexpr (std::is_same_v<Result, int>) code = run(*options);
                if constexpr (std::is_void_v<Result>) run(*options);
                if constexpr (std::is_base_of_v<CommandOptions, Options>)
                    runs::say_unread_parts(*options, name);
                return code;
            };
            if constexpr (std::is_base_of_v<CommandOptions, Options>) {
                options->given = given_options(*parser);
                if (!options->papers.folder.empty())
                    return papers::run_for_papers(*parser, *options, call);
            }
            return call();
        };
    }
    operator Command() const { return command_; }

    template <class T, class Base>
    Declared& option(const char* name, T Base::*place, const char* text, const char* type = "") {
        list_.add(name, &((*options_).*place), text, type);
        return *this;
    }
    template <class T, class Base>
    Declared& required(const char* name, T Base::*place, const char* text, const char* type) {
        option(name, place, text, type);
        list_.require();
        return *this;
    }
    template <class T, class Base>
    Declared& number(const char* name, T Base::*place, const char* text, double low, double high) {
        option(name, place, text);
        list_.keep_within(low, high);
        return *this;
    }
    template <class Base>
    Declared& flag(const char* name, bool Base::*place, const char* text, bool value = true) {
        const auto set = [options = options_, place, value] { (*options).*place = value; };
        list_.add_flag(name, set, text);
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
        list_.keep_to(words);
        return *this;
    }

    Declared& on_file(const char* name, const char* text, const char* type) {
        return required(name, &CommandOptions::file, text, type);
    }
    /// The case file and --set. `reads`: what of io::rig_parts the command reads.
    Declared& on_case(std::vector<std::string> reads = {}) {
        options_->reads = std::move(reads);
        on_file("case", "Case file (TOML)", "CASE.toml");
        return settings("Override a key of the case: section.key=value (may be repeated)");
    }
    /// --set.
    Declared& settings(const char* text) {
        option("--set", &CommandOptions::overrides, text, "KEY=VALUE");
        list_.take_one_at_a_time();
        return *this;
    }
    Declared& output(const char* text) {
        return option("-o,--output", &CommandOptions::output, text, "DIR");
    }
    /// --export, of a command with a report. `filled_by`: the command that has to fill its folder
    /// before.
    Declared& exports(const char* filled_by = "") {
        options_->papers.filled_by = filled_by;
        list_.add("--export", &options_->papers.folder,
                  "Folder for figures, tables, sources and an archive, for papers", "DIR");
        return *this;
    }
    Declared& models(const char* text) {
        option("-m,--models", &CommandOptions::models, text, "NAME,NAME");
        list_.divide_by(',');
        return *this;
    }
    Declared& threads() { return cores("-t,--threads", "Threads for large grids (all cores)"); }
    Declared& jobs() { return cores("-j,--jobs", "Processes side by side (all cores)"); }
    Declared& quiet(const char* text = "No progress, no closing line") {
        return flag("-q,--quiet", &CommandOptions::quiet, text);
    }
    /// --json, of a command that gives its answer by CommandOptions::answer.
    Declared& json(const char* text = "The answer as JSON on standard output, SI units") {
        return flag("--json", &CommandOptions::json, text);
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
    OptionList list_;
    Command command_;
};

/// All commands, in the order of the help: by groups, each before its parts.
std::vector<Command> all_commands();

/// The name of a command that was called otherwise before: of "merge" it is "sweep merge"; any
/// other name is given back. Former names stay for one version.
std::string_view name_now(std::string_view name);

}  // namespace tricontact::app
