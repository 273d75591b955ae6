// The command line program. Exit codes: 0 done, 1 did not converge (or failed), 2 bad input, 3 what
// was kept is not reproduced, or a code fails a comparison, 4 a comparison is not resolved.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "app/commands/command.h"
#include "app/help.h"
#include "app/plain_output.h"
#ifdef TRICONTACT_WITH_FEM
#include "app/models/fem_entries.h"
#endif
#include "contact/base/freed_memory.h"
#include "io/keys/messages.h"

namespace {

using namespace tricontact;
using app::Command;

constexpr int exit_failed = 1;
constexpr int exit_bad_input = 2;

bool errors_are_printed_elsewhere = false;  // by the first of processes that work together

int fail(int code, const std::string& message) {
    if (errors_are_printed_elsewhere)  // mpirun ends all as soon as one has failed: it has time to
        std::this_thread::sleep_for(std::chrono::seconds(2));
    else
        std::fprintf(stderr, "error: %s\n", io::one_line(message).c_str());
    return code;
}

/// The command that the first words name, and its arguments.
struct Call {
    Command command;
    std::vector<std::string> arguments;
};

/// Nothing where the first argument is no command of the program.
std::optional<Call> call_of(const std::vector<Command>& commands, int argc,
                            const char* const* argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    if (words.empty()) return {};
    const auto called = [&](std::string_view name) {
        return std::ranges::find(commands, name, &Command::name);
    };
    const std::string_view now = app::name_now(words[0]);
    auto found = called(now);
    const bool is_part = words.size() > 1 && called(words[0] + ' ' + words[1]) != commands.end();
    if (is_part) found = called(words[0] + ' ' + words[1]);
    if (found == commands.end()) return {};
#ifdef TRICONTACT_WITH_FEM
    if (found->name == "cache condense")  // runs as several processes, of which the first speaks
        errors_are_printed_elsewhere = app::fem_entries().is_further_process();
#endif
    if (now != words[0] && !errors_are_printed_elsewhere)
        std::cerr << fmt::format(
            "tricontact {} is now tricontact {}; the former name is gone in the next version\n",
            words[0], now);
    words.erase(words.begin(), words.begin() + (is_part ? 2 : 1));
    return Call{*found, std::move(words)};
}

int run_call(Call call, const std::string& program) {
    CLI::App& parser = *call.command.parser;
    const std::vector<std::string> arguments = call.arguments;
    std::ranges::reverse(call.arguments);  // as CLI11 wants them
    try {
        parser.parse(call.arguments);
    } catch (const CLI::CallForHelp&) {
        std::cout << parser.help(program);
        return 0;
    } catch (const CLI::ExtrasError& e) {
        return fail(exit_bad_input,
                    fmt::format("{}{}; see tricontact {} --help", e.what(),
                                app::near_option(parser, arguments), call.command.name));
    } catch (const CLI::ParseError& e) {
        return fail(exit_bad_input,
                    fmt::format("{}; see tricontact {} --help", e.what(), call.command.name));
    }
    return call.command.run();
}

/// What is wrong with the first argument, which is no command of the program; empty if it is an
/// option.
std::string what_is_wrong(const CLI::App& app, const std::vector<Command>& commands,
                          const char* const* argv) {
    const std::string_view word = argv[1];
    const std::string shown = io::one_line(io::shortened(word, 60));
    if (word.starts_with('-') && app.get_option_no_throw(std::string(word))) return {};
    if (word.starts_with('-'))
        return fmt::format(
            "unknown option {} where a command is due; tricontact --help lists both, a "
            "command's options stand behind it",
            shown);
    std::vector<std::string_view> known;
    for (const Command& one : commands) known.push_back(one.name);
    if (word.ends_with(".toml"))
        return fmt::format("{} is no command; write one before the file, as in tricontact check {}",
                           shown, shown);
    constexpr std::size_t tellable = 4;  // letters: of fewer, most words are near
    const std::string_view near = word.size() < tellable ? "" : io::nearest(word, known);
    return near.empty()
               ? fmt::format("unknown command {}; tricontact --help lists them", shown)
               : fmt::format("unknown command {}; did you mean tricontact {}?", shown, near);
}

// What has been printed is part of the answer: a full disk behind standard output is a failure.
int flushed(int code) {
    errno = 0;
    std::cout.flush();
    const bool flushed = std::fflush(stdout) == 0;
    int error = errno;
    if (flushed && std::ferror(stdout) == 0 && std::cout) return code;
    // Where an earlier write failed its reason is lost; one more tells it.
    if (error == 0) error = ::write(STDOUT_FILENO, "\n", 1) < 0 ? errno : EIO;
    const std::string reason = std::generic_category().message(error);
    fail(code, "standard output cannot be written (" + reason + ")");
    return std::max(code, exit_failed);
}

int run_program(int argc, char** argv) {
    const std::vector<Command> commands = app::all_commands();
    const bool asks = argc > 1 && std::string_view(argv[1]) == "help";
    if (argc < 2 || (asks && argc == 2)) {
        std::cout << app::overview(commands);
        return asks ? 0 : exit_bad_input;  // a script that forgot the command is to stop
    }
    if (asks) {  // help COMMAND is COMMAND --help
        ++argv;
        --argc;
        if (auto call = call_of(commands, argc, argv)) {
            std::cout << call->command.parser->help("tricontact");
            return 0;
        }
    }
    if (auto call = call_of(commands, argc, argv)) return run_call(*std::move(call), argv[0]);
    CLI::App app{app::program_text};
    app.set_version_flag("--version", std::string("tricontact ") + files::version);
    for (const Command& command : commands)
        if (!command.is_part())
            app.add_subcommand(command.parser)->group(app::title_of(command.group));
    app.require_subcommand(1);
    app.footer("tricontact COMMAND --help lists the options of a command");
    if (const auto wrong = what_is_wrong(app, commands, argv); !wrong.empty())
        return fail(exit_bad_input, wrong);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& e) {
        return app.exit(e);
    } catch (const CLI::ParseError& e) {
        return fail(exit_bad_input, std::string(e.what()) + "; see tricontact --help");
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    tricontact::contact::keep_freed_memory();
    // Destroyed in the end: what was printed is out before a code is given.
    const tricontact::app::PlainOutput out(std::cout), err(std::cerr);
    // A file size limit is then an error like a full disk, with a message, instead of a signal.
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        return flushed(run_program(argc, argv));
    } catch (const tricontact::contact::InputError& e) {
        return fail(exit_bad_input, e.what());
    } catch (const std::bad_alloc&) {
        return fail(exit_failed, "not enough memory; choose a larger spacing or fewer springs");
    } catch (const std::exception& e) {
        return fail(exit_failed, e.what());
    }
}
