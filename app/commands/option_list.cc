#include "app/commands/option_list.h"

#include <CLI/CLI.hpp>
#include <cmath>

namespace tricontact::app {

namespace {

/// As CLI::Range, which takes "nan" for a number between all others.
CLI::Validator in_range(double low, double high) {
    const CLI::Range range(low, high);
    return {[range](std::string& text) {
                double value = 0;
                if (CLI::detail::lexical_cast(text, value) && std::isnan(value))
                    return "Value " + text + " is no number";
                return range(text);
            },
            range.get_description()};
}

}  // namespace

OptionList::OptionList(const std::string& name, const char* text)
    : parser_(std::make_shared<CLI::App>(text, name)) {}

void OptionList::add(const char* name, const Place& place, const char* text, const char* type) {
    const auto add_to = [&](auto* value) { return parser_->add_option(name, *value, text); };
    last_ = std::visit(add_to, place);
    last_is_whole_ = std::holds_alternative<int*>(place);
    if (*type) last_->type_name(type);
}

void OptionList::add_flag(const char* name, const std::function<void()>& set, const char* text) {
    // A flag declared as "!--no-report" would stand as "--no-report{false}" in the help.
    last_ = parser_->add_flag_callback(name, set, text);
}

void OptionList::require() {
    last_->required();
}

void OptionList::keep_within(double low, double high) {
    if (last_is_whole_)
        last_->check(CLI::Range(static_cast<int>(low), static_cast<int>(high)));
    else
        last_->check(in_range(low, high));
}

void OptionList::keep_to(const std::vector<std::string>& words) {
    last_->check(CLI::IsMember(words).description(""))->type_name(CLI::detail::join(words, "|"));
}

void OptionList::divide_by(char mark) {
    last_->delimiter(mark);
}

void OptionList::take_one_at_a_time() {
    last_->take_all()->allow_extra_args(false);
}

std::vector<std::string> given_options(const CLI::App& parser) {
    std::vector<std::string> names;
    for (const CLI::Option* option : parser.get_options())
        if (option->count() > 0) names.push_back(option->get_name());
    return names;
}

}  // namespace tricontact::app
