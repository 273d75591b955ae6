#include "runs/unread_parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "io/case/rig_file.h"

namespace tricontact::runs {

namespace {

/// Which commands read a part of a case file.
const std::map<std::string, std::string>& readers() {
    static const std::map<std::string, std::string> readers{
        {"[rig]", "rig, design, identify, experiment with loops"},
        {"[record]", "experiment, design"},
        {"[measurement]", "identify, experiment with loops or laws"},
        {"[design]", "design"},
        {"[printed]", "rig"},
        {io::uncertainty_mark, "predict --samples, rig, design, experiment, identify"}};
    return readers;
}

void say_unread(const CommandOptions& options, const std::vector<std::string>& parts,
                const std::string& command) {
    std::vector<std::string> words;
    for (const std::string& part : parts)
        words.push_back(fmt::format("{} (read by {})",
                                    part == io::uncertainty_mark ? "± of the numbers"
                                    : part == "[measurement]" && command == "rig"
                                        ? "[measurement] but for sliding_force"
                                        : part,
                                    readers().at(part)));
    if (!words.empty())
        options.say(fmt::format("not read by {}: {}", command, fmt::join(words, "; ")));
}

}  // namespace

void say_unread_parts(const CommandOptions& options, const std::string& command) {
    if (!options.reads || options.quiet) return;
    std::vector<std::string> parts = io::rig_parts(options.file, options.overrides);
    std::erase_if(parts, [&](const std::string& part) {
        return std::ranges::find(*options.reads, part) != options.reads->end();
    });
    say_unread(options, parts, command);
}

void say_unread_parts(const CommandOptions& options, const io::Study& study,
                      const std::string& command) {
    say_unread(options, io::rig_parts(study), command);
}

}  // namespace tricontact::runs
