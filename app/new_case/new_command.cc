#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/new_case/example_cases.h"
#include "app/new_case/first_case.h"
#include "io/keys/messages.h"

namespace tricontact::app {

namespace {

using Json = nlohmann::ordered_json;

struct NewOptions : CommandOptions {
    std::string example;
    bool list = false;
    bool defaults = false;
};

void list_examples(const NewOptions& options) {
    std::size_t width = 0;
    for (const ExampleCase& one : example_cases()) width = std::max(width, one.name.size());
    std::string text;
    for (const ExampleCase& one : example_cases())
        text += fmt::format("{:<{}}  {}\n", one.name, width, one.title());
    options.answer(Answer(
        [] {
            Json list = Json::array();
            for (const ExampleCase& one : example_cases())
                list.push_back(
                    {{"name", one.name}, {"title", one.title()}, {"command", one.command}});
            return Json{{"examples", list}}.dump(2);
        },
        text));
}

/// Before anything is asked, and once more before it is written.
void refuse_existing(const std::string& path) {
    std::error_code unknown;
    if (std::filesystem::symlink_status(path, unknown).type() !=
        std::filesystem::file_type::not_found)
        throw contact::InputError(path + ": exists already; name another file by --output");
}

void write_new(const NewOptions& options, const std::string& text, std::string_view command) {
    refuse_existing(options.output);
    io::write_file(options.output, text);
    const std::string check = "tricontact check " + options.output,
                      use = fmt::format("tricontact {} {}", command, options.output);
    const bool is_case = command == "run";
    options.answer(Answer(
        [&] {
            return Json{{"written", options.output},
                        {"example", options.example.empty() ? Json() : Json(options.example)},
                        {"command", use}}
                .dump(2);
        },
        fmt::format("written: {}\nnext:    {}\n{}", options.output, is_case ? check : use,
                    is_case ? fmt::format("         {}\n", use) : "")));
}

/// Answers by --set. Throws contact::InputError for what is not asked.
void take_answers(const std::vector<std::string>& overrides, FirstCase& first) {
    std::vector<std::string_view> keys;
    for (const Question& one : first_questions()) keys.emplace_back(one.key);
    for (const std::string& text : overrides) {
        const std::string key(io::trimmed(text.substr(0, text.find('='))));
        if (text.find('=') != text.npos && std::ranges::count(keys, key) == 1) continue;
        const std::string_view near = io::nearest(key, keys);
        io::fail("", "--set " + io::shortened(text, 60), "answers none of the questions",
                 near.empty()
                     ? "they are about " + io::joined(keys) + "; write other keys into the file"
                     : fmt::format("did you mean {}=...?", near));
    }
    // In the order of the questions: what is usual follows from those before.
    for (const Question& one : first_questions())
        for (const std::string& text : overrides) {
            const std::size_t mark = text.find('=');
            if (io::trimmed(text.substr(0, mark)) != one.key) continue;
            if (first.is_answered(one))
                io::fail("", std::string("--set ") + one.key, "is given twice", "leave out one");
            first.answer(one, text.substr(mark + 1));
        }
}

/// Asks on the terminal until there is an answer that a case can have.
void ask(const Question& question, FirstCase& first) {
    while (true) {
        std::cerr << question.text << " [" << first.usual(question) << "]: " << std::flush;
        std::string line;
        if (!std::getline(std::cin, line)) {
            std::cerr << '\n';
            throw contact::InputError(
                "new: the input ended before the last question; nothing is written");
        }
        try {
            return first.answer(question, line);
        } catch (const contact::InputError& error) {
            std::cerr << "error: " << error.what() << '\n';
        }
    }
}

void write_first_case(const NewOptions& options) {
    FirstCase first;
    take_answers(options.overrides, first);
    std::vector<Question> open;
    for (const Question& one : first_questions())
        if (!first.is_answered(one)) open.push_back(one);
    const bool asks = !options.defaults && !open.empty();
    if (asks && (options.listener || ::isatty(STDIN_FILENO) == 0 || ::isatty(STDERR_FILENO) == 0))
        throw contact::InputError(fmt::format(
            "new: no terminal, on which {} would be asked; answer by --set {}=..., take the usual "
            "answers by --defaults, or an example by --example NAME",
            open.front().key, open.front().key));
    if (asks)
        std::cerr << "Enter takes the answer in brackets; " << options.output
                  << " is written after the last one.\n";
    for (const Question& one : open) asks ? ask(one, first) : first.answer(one, first.usual(one));
    write_new(options, first.text(), "run");
}

/// A first case: of answers, or one of the examples.
void make_new(NewOptions options) {
    if (options.list) {
        if (options.given.size() > (options.json ? 2U : 1U))
            throw contact::InputError("--list: lists the examples; leave out the other options");
        return list_examples(options);
    }
    const std::string& example = options.example;
    if (!example.empty() && (options.defaults || !options.overrides.empty()))
        throw contact::InputError(
            "--example: is written as it stands, without answers; leave out --set and --defaults, "
            "and change the file");
    if (example.empty()) {
        if (options.output.empty()) options.output = "case.toml";
        refuse_existing(options.output);
        return write_first_case(options);
    }
    const ExampleCase& found = required_example(example);
    if (options.output.empty()) options.output = example + ".toml";
    write_new(options, std::string(found.text), found.command);
}

}  // namespace

Command new_command() {
    return Declared<NewOptions>(Group::compute, "new",
                                "Write a first case, from questions or from an example", make_new)
        .option("--example", &NewOptions::example,
                "Write this example instead of asking; --list names all", "NAME")
        .flag("--list", &NewOptions::list, "List the examples")
        .settings("Answer a question before it is asked: section.key=value (may be repeated)")
        .flag("--defaults", &NewOptions::defaults, "Ask nothing: take the usual answers")
        .option("-o,--output", &CommandOptions::output,
                "File to be written, which must not be there (case.toml or NAME.toml)", "FILE")
        .json("As JSON: what was written, or the list");
}

}  // namespace tricontact::app
