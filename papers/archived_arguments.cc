#include "papers/archived_arguments.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <stdexcept>

#include "io/keys/messages.h"
#include "io/keys/number_text.h"
#include "papers/input_places.h"

namespace tricontact::papers {

namespace {

constexpr std::array kept_options{"--set",       "--models",     "--levels",     "--points",
                                  "--samples",   "--vary",       "--tolerance",  "--shard",
                                  "--elements",  "--no-runs",    "--confidence", "--finite-strain",
                                  "--posterior", "--no-studies", "--body"};
constexpr std::array own_options{"--output", "--export", "--quiet",        "--threads",
                                 "--jobs",   "--vtk",    "--retry-failed", "--no-report",
                                 "--help",   "--json"};

bool is_flag(const CLI::Option& option) {
    return option.get_items_expected_max() == 0;
}

}  // namespace

ArchivedOption archived_option(const std::string& name) {
    if (std::ranges::find(kept_options, name) != kept_options.end()) return ArchivedOption::kept;
    if (std::ranges::find(own_options, name) != own_options.end())
        return ArchivedOption::own_matter;
    return ArchivedOption::unknown;
}

std::vector<std::string> archived_arguments(const CLI::App& parser) {
    std::vector<std::string> arguments;
    for (const CLI::Option* option : parser.get_options()) {
        const std::string name = option->get_name();
        const ArchivedOption what =
            option->get_positional() ? ArchivedOption::kept : archived_option(name);
        if (what == ArchivedOption::unknown)  // given or not: any export of the command tells
            throw std::logic_error(name + " is neither kept in archives nor left out of them");
        if (what == ArchivedOption::own_matter || option->count() == 0) continue;
        if (is_flag(*option)) arguments.push_back(name);
        if (is_flag(*option)) continue;
        std::vector<std::string> values = option->results();
        if (option->get_delimiter() != '\0')
            values = {fmt::format("{}", fmt::join(values, std::string{option->get_delimiter()}))};
        for (const std::string& value : values) {
            if (!option->get_positional()) arguments.push_back(name);
            arguments.push_back(value);
        }
    }
    return arguments;
}

std::vector<std::string> arguments_now(std::vector<std::string> arguments) {
    // To the parser all that begins with a dash is an option: it is no value.
    std::ranges::replace(arguments, "--model", "--models");
    return arguments;
}

void check_archived_arguments(const CLI::App& parser, const std::string& archive,
                              const io::ZipFiles& files,
                              const std::vector<std::string>& arguments) {
    const auto refuse = [&](const std::string& argument) {
        io::fail(archive, "",
                 parser.get_name() + ": holds the argument " + io::shortened(argument, 80) +
                     ", which is none of those that an archive may have",
                 "take the archive as --export wrote it");
    };
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        std::string value = arguments[i];
        if (archived_option(value) == ArchivedOption::kept) {
            const CLI::Option* option = parser.get_option_no_throw(value);
            if (!option) refuse(value);
            if (is_flag(*option)) continue;
            if (++i == arguments.size()) refuse(value);
            value = arguments[i];
        }
        // To the parser all that begins with a dash is an option, but for numbers.
        if (value.starts_with('-') && !io::number_in(value)) refuse(value);
        check_inside(archive, files, value);
    }
}

}  // namespace tricontact::papers
