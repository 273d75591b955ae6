#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <kainjow/mustache.hpp>
#include <string_view>
#include <utility>

#include "report/format.h"

namespace tricontact::report {

namespace {

constexpr std::string_view infinity = "∞";

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

bool is_alphanumeric(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// "mu" -> μ where it is a word of its own, and no part of a key's name ("a.mu").
std::string with_greek(const std::string& text) {
    constexpr std::pair<std::string_view, std::string_view> letters[] = {
        {"beta", "β"}, {"chi", "χ"}, {"eta", "η"}, {"theta", "θ"}, {"kappa", "κ"}, {"mu", "μ"},
        {"nu", "ν"},   {"pi", "π"},  {"rho", "ρ"}, {"tau", "τ"},   {"omega", "ω"}};
    std::string result;
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = begin;
        while (end < text.size() && is_letter(text[end])) ++end;
        const std::string word = text.substr(begin, end - begin);
        const char before = begin > 0 ? text[begin - 1] : ' ';
        const char after = end < text.size() ? text[end] : ' ';
        const bool alone = !is_alphanumeric(before) && before != '_' && before != '.' &&
                           !std::isdigit(static_cast<unsigned char>(after));
        const auto* found =
            std::ranges::find_if(letters, [&](const auto& letter) { return letter.first == word; });
        result += alone && found != std::end(letters) ? std::string(found->second) : word;
        if (end < text.size()) result += text[end];
        begin = end + 1;
    }
    return result;
}

/// Letters and digits, and a point between digits: not that of the sentence's end.
bool is_part_of_power(const std::string& text, std::size_t at) {
    const auto is_digit = [&](std::size_t i) {
        return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
    };
    return is_alphanumeric(text[at]) || (text[at] == '.' && is_digit(at - 1) && is_digit(at + 1));
}

/// "a^2", "q^n", "10^-4", "f^0.92", "x^(1/3)" -> superscripts.
std::string with_powers(const std::string& text) {
    std::string html;
    std::size_t copied = 0;
    for (std::size_t at = text.find('^'); at != std::string::npos; at = text.find('^', at + 1)) {
        std::size_t begin = at + 1, end = begin, next = begin;
        if (begin < text.size() && text[begin] == '(') {
            end = std::min(text.find(')', begin++), text.size());
            next = end + 1;
        } else {
            if (end < text.size() && text[end] == '-') ++end;
            while (end < text.size() && is_part_of_power(text, end)) ++end;
            next = end;
        }
        if (next > text.size() || end == begin) continue;  // no bracket, or nothing follows
        std::string power = text.substr(begin, end - begin);
        replace_all(power, "-", "−");
        html += text.substr(copied, at - copied) + "<sup>" + power + "</sup>";
        copied = next;
    }
    return html + text.substr(copied);
}

/// First of the two bytes of a Greek letter.
bool begins_greek(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte == 0xCE || byte == 0xCF;
}

/// Where the symbol begins whose index begins at `index`: one letter, Latin or Greek (two bytes),
/// that ends no word; npos if there is none.
std::size_t symbol_before(const std::string& text, std::size_t index) {
    const std::size_t end = index - 1;  // of the underscore
    if (end >= 2 && begins_greek(text[end - 2])) return end - 2;
    const bool letter = end >= 1 && is_letter(text[end - 1]);
    const bool word = end >= 2 && (is_alphanumeric(text[end - 2]) || text[end - 2] == '_');
    return letter && !word ? end - 1 : std::string::npos;
}

/// "f_T,lim" -> f with its index: letters, digits, infinity, a comma only before a lower-case
/// letter.
std::string with_symbols(const std::string& text) {
    std::string html;
    std::size_t copied = 0;
    for (std::size_t at = text.find('_'); at != std::string::npos; at = text.find('_', at + 1)) {
        const std::size_t symbol = symbol_before(text, at + 1);
        std::size_t end = at + 1;
        if (text.compare(end, infinity.size(), infinity) == 0) end += infinity.size();
        while (end < text.size() && is_alphanumeric(text[end])) ++end;
        if (end + 1 < text.size() && text[end] == ',' && text[end + 1] >= 'a' &&
            text[end + 1] <= 'z')
            for (++end; end < text.size() && is_alphanumeric(text[end]);) ++end;
        if (symbol == std::string::npos || end == at + 1 || (end < text.size() && text[end] == '_'))
            continue;
        html += text.substr(copied, symbol - copied);
        html += fmt::format("<i>{}</i><sub>{}</sub>", text.substr(symbol, at - symbol),
                            text.substr(at + 1, end - at - 1));
        copied = end;
    }
    return html + text.substr(copied);
}

}  // namespace

std::string typeset(const std::string& sentence) {
    std::string html = kainjow::mustache::html_escape(sentence);
    html = with_powers(with_symbols(with_greek(html)));
    replace_all(html, "&gt;=", "≥");
    replace_all(html, "&lt;=", "≤");
    replace_all(html, " - ", " − ");
    for (const std::string sign : {"=", "±"})
        replace_all(html, " " + sign + " ", "\u00a0" + sign + "\u00a0");
    for (const char* end : {" ", ")", ",", ".", ":", ";"}) {
        replace_all(html, std::string(" um") + end, std::string(" µm") + end);
        for (const std::string unit : {"%", "m", "mm", "µm", "nm"})
            replace_all(html, " " + unit + end, "\u00a0" + unit + end);
    }
    return html;
}

}  // namespace tricontact::report
