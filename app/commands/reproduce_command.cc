#include <CLI/CLI.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "app/commands/command.h"
#include "comparisons/reproduction/reproduction.h"
#include "io/keys/messages.h"
#include "papers/archive.h"
#include "papers/archived_arguments.h"
#include "papers/input_places.h"
#include "papers/paper_export.h"
#include "papers/temporary_folder.h"

namespace tricontact::app {

namespace {

struct ReproduceOptions : CommandOptions {
    double tolerance = 1e-6;
};

constexpr int exit_differs = 3;
constexpr const char* text_name = "reproduction.json";

/// Every command whose archives run again: those that export. Archives of earlier versions have
/// former names.
std::optional<Command> exporting_command(const std::string& name) {
    for (Command& command : all_commands())
        if (command.name == name_now(name) && command.parser->get_option_no_throw("--export"))
            return std::move(command);
    return {};
}

void check_calls(const ReproduceOptions& options, const papers::Archive& archive) {
    for (const papers::Call& call : archive.calls) {
        const auto command = exporting_command(call.command);
        if (!command)
            options.refuse("asks for " + io::one_line(io::shortened(call.command, 60)) +
                           ", which is no command that exports");
        papers::check_archived_arguments(*command->parser, options.file, archive.files,
                                         call.arguments);
    }
    papers::check_inside(options.file, archive.files);
    try {  // before anything runs
        for (const auto& [name, text] : archive.numbers()) comparisons::numbers_in(name, text);
    } catch (const std::runtime_error& error) {
        options.refuse(std::string(error.what()) + "; take the archive as --export wrote it");
    }
}

void unpack(const papers::Archive& archive, const std::string& folder) {
    for (const auto& [name, content] : archive.files) {
        if (!name.starts_with("inputs/")) continue;
        const std::string path = folder + '/' + name;
        io::make_output_folder(std::filesystem::path(path).parent_path().string());
        io::write_file(path, content);
    }
}

/// Runs a command of the archive in the folder; what it came to.
runs::Findings run_again(const ReproduceOptions& options, const papers::Call& call,
                         const std::string& folder) {
    const Command command = *exporting_command(call.command);
    std::vector<std::string> arguments{folder + "/results", "--output"};  // as CLI11 wants them
    for (const std::string& argument : call.arguments)
        arguments.insert(arguments.begin() + 2,
                         boost::replace_all_copy(argument, papers::archive_place, folder));
    try {
        command.parser->parse(arguments);
    } catch (const CLI::Error& error) {
        options.refuse(call.command + ": " + error.what());
    }
    std::ostream nowhere(nullptr);
    command.options->listener = std::make_shared<runs::Listener>(
        runs::Listener{.out = &nowhere,
                       .say = [&](const std::string& line) { options.say(line); },
                       .progress =
                           [&](const std::string& name, int done, int total) {
                               if (options.listener) options.listener->progress(name, done, total);
                           }});
    command.options->papers.findings = std::make_shared<runs::Findings>();
    command.options->papers.findings->draws = !options.output.empty();
    if (command.run() != 0) throw std::runtime_error(options.file + ": the command failed");
    return *command.options->papers.findings;
}

/// What of the program is another one than when the archive was written.
std::string version_lines(const papers::Archive& archive) {
    std::string lines;
    const papers::Archive now = papers::new_archive();
    if (archive.version != now.version)
        lines += fmt::format("made by version {}, run again by {}\n", io::one_line(archive.version),
                             now.version);
    else if (archive.numerics != now.numerics)
        lines += "made by the same version from other sources\n";
    for (const auto& [library, version] : now.libraries) {
        const auto found = archive.libraries.find(library);
        if (found != archive.libraries.end() && found->second != version)
            lines += fmt::format("made with {} {}, run again with {}\n", library,
                                 io::one_line(found->second), version);
    }
    return lines;
}

/// While it lives, condensed layers are kept in a folder that goes away with it: an archive of
/// others leaves nothing in the user's own, and none from there stands in for what is to be
/// computed again.
class LayersApart {
  public:
    LayersApart() {
        if (const char* before = std::getenv(variable)) before_ = before;
        ::setenv(variable, folder_.path().c_str(), 1);
    }
    ~LayersApart() {
        if (before_)
            ::setenv(variable, before_->c_str(), 1);
        else
            ::unsetenv(variable);
    }
    LayersApart(const LayersApart&) = delete;
    LayersApart& operator=(const LayersApart&) = delete;

  private:
    static constexpr const char* variable = "TRICONTACT_CACHE";
    papers::TemporaryFolder folder_;
    std::optional<std::string> before_;
};

comparisons::Reproduction compared(const ReproduceOptions& options, const papers::Archive& archive,
                                   const std::string& folder) {
    unpack(archive, folder);
    const std::string real = std::filesystem::canonical(folder).string();
    runs::Findings findings;
    const io::InputLog inputs;
    const LayersApart apart;
    try {
        for (const papers::Call& call : archive.calls) findings = run_again(options, call, real);
    } catch (const contact::InputError& error) {
        const std::string said = boost::replace_all_copy(std::string(error.what()), real + '/', "");
        options.refuse(boost::replace_all_copy(said, options.file + ": ", ""));
    }
    for (const std::string& path : inputs.paths())
        if (!path.starts_with(real + '/'))
            options.refuse("its command reads " + io::one_line(path) + ", outside the archive");
    std::map<std::string, std::string> now;
    for (const auto& [name, text] : papers::numbers_of(findings))
        now[name] = boost::replace_all_copy(text, real + "/inputs/", "inputs/");
    return comparisons::compare_with_kept(archive.numbers(), now, options.tolerance);
}

int reproduce(const ReproduceOptions& options) {
    papers::Archive archive = papers::read_archive(options.file);
    for (papers::Call& call : archive.calls) call.arguments = papers::arguments_now(call.arguments);
    check_calls(options, archive);
    std::optional<papers::TemporaryFolder> temporary;
    const std::string folder = options.output.empty() ? temporary.emplace().path() : options.output;
    comparisons::Reproduction result;
    io::OutputFolder(folder, {{text_name}, {"inputs/", "results/"}}).fill([&] {
        result = compared(options, archive, folder);
        io::write_file(folder + '/' + text_name,
                       comparisons::reproduction_json(result).dump(2) + '\n');
    });
    options.answer(Answer([&] { return comparisons::reproduction_json(result).dump(2); })
                       .note(version_lines(archive))
                       .add(comparisons::reproduction_text(result)));
    return result.reproduces() ? 0 : exit_differs;
}

}  // namespace

Command reproduce_command() {
    return Declared<ReproduceOptions>(Group::trust, "reproduce",
                                      "Run an exported archive again and compare its numbers",
                                      reproduce)
        .on_file("archive", "Archive that --export wrote", "ARCHIVE.zip")
        .number("--tolerance", &ReproduceOptions::tolerance,
                "Relative difference of numbers that counts as none (1e-6)", 0, 1)
        .output("Folder that keeps inputs and results of this run (none)")
        .json()
        .quiet("No progress");
}

}  // namespace tricontact::app
