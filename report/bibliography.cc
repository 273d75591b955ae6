#include "report/bibliography.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "report/sources.h"

namespace tricontact::report {

namespace {

/// Value of a field of an entry, which stands in braces at the end of its line.
std::string field_of(const std::string& entry, const std::string& name) {
    const std::string begin = "  " + name + " = {";
    const auto at = entry.find(begin);
    if (at == std::string::npos) throw std::logic_error("sources.bib: no " + name + ": " + entry);
    const auto from = at + begin.size();
    return entry.substr(from, entry.rfind('}', entry.find('\n', from)) - from);
}

/// "Heß, M. and Popov, V. L." -> Heß, Popov.
std::vector<std::string> names_of(std::string authors) {
    constexpr std::string_view and_word = " and ";
    std::vector<std::string> names;
    for (authors += and_word; !authors.empty();) {
        const auto end = authors.find(and_word);
        names.push_back(authors.substr(0, std::min(authors.find(','), end)));
        authors.erase(0, end + and_word.size());
    }
    return names;
}

/// Without umlauts, as sources in letters of a keyboard write them.
std::string in_plain_letters(std::string name) {
    constexpr std::pair<std::string_view, std::string_view> letters[] = {
        {"ä", "ae"}, {"ö", "oe"}, {"ü", "ue"}, {"ß", "ss"}};
    for (const auto& [from, to] : letters)
        for (auto at = name.find(from); at != std::string::npos; at = name.find(from, at))
            name.replace(at, from.size(), to);
    return name;
}

std::vector<std::string> citations_of(const std::string& authors, const std::string& year) {
    const std::vector<std::string> names = names_of(authors);
    std::vector<std::string> forms;
    const bool has_others = names.back() == "others";
    if (!has_others) {
        const std::vector<std::string> first(names.begin(), names.end() - 1);
        forms.push_back(first.empty()
                            ? names.back()
                            : fmt::format("{} and {}", fmt::join(first, ", "), names.back()));
    }
    if (names.size() > 2) forms.push_back(names.front() + " et al.");
    std::vector<std::string> citations;
    for (const std::string& form : forms)
        for (const std::string& spelt : {form, in_plain_letters(form)})
            for (const char* pattern : {"{} ({})", "{} {}"})
                citations.push_back(fmt::format(fmt::runtime(pattern), spelt, year));
    std::ranges::sort(citations);
    const auto repeated = std::ranges::unique(citations);
    citations.erase(repeated.begin(), repeated.end());
    return citations;
}

std::vector<Source> read_sources() {
    std::vector<Source> sources;
    const std::string text = sources_text;
    for (std::size_t begin = 0; begin < text.size();) {
        const auto end = std::min(text.find("\n\n", begin), text.size());
        Source source{{}, text.substr(begin, end - begin), {}};
        while (source.entry.ends_with('\n')) source.entry.pop_back();
        const auto brace = source.entry.find('{');
        source.key = source.entry.substr(brace + 1, source.entry.find(',') - brace - 1);
        source.citations =
            citations_of(field_of(source.entry, "author"), field_of(source.entry, "year"));
        sources.push_back(std::move(source));
        begin = end + 2;
    }
    return sources;
}

/// Whether what stands before a citation is a further author of another one.
bool continues_a_list(std::string_view before) {
    if (before.ends_with("and ")) return true;
    return before.size() > 2 && before.ends_with(", ") &&
           std::isalpha(static_cast<unsigned char>(before[before.size() - 3])) != 0;
}

bool is_cited(const std::string& citation, std::string_view text) {
    for (auto at = text.find(citation); at != text.npos; at = text.find(citation, at + 1)) {
        const bool inside_a_word =
            at > 0 && std::isalpha(static_cast<unsigned char>(text[at - 1])) != 0;
        if (!inside_a_word && !continues_a_list(text.substr(0, at))) return true;
    }
    return false;
}

void add(const Cell& cell, std::string& words) {
    if (const auto* text = std::get_if<std::string>(&cell)) words += *text + '\n';
}

void add(const Figure& figure, std::string& words) {
    words += figure.title + '\n' + figure.caption + '\n';
    for (const Curve& curve : figure.curves) words += curve.name + '\n';
    for (const Band& band : figure.bands) words += band.name + '\n';
}

void add(const DocumentTable& table, std::string& words) {
    words += table.title + '\n' + table.note + '\n';
    for (const auto& column : table.columns) words += column.heading + '\n';
    for (const auto& row : table.rows)
        for (const Cell& cell : row) add(cell, words);
}

}  // namespace

const std::vector<Source>& all_sources() {
    static const std::vector<Source> sources = read_sources();
    return sources;
}

Sources cited_in(std::string_view text) {
    Sources cited;
    for (const Source& source : all_sources())
        if (std::ranges::any_of(source.citations,
                                [&](const std::string& form) { return is_cited(form, text); }))
            cited.push_back(&source);
    return cited;
}

std::string words_of(const Document& document) {
    std::string words = document.lead + '\n';
    if (document.answer) words += document.answer->sentence + '\n';
    for (const Verdict& verdict : document.verdicts) words += verdict.sentence + '\n';
    for (const auto& [name, value] : document.settings) words += name + '\n' + value + '\n';
    if (document.comparison) add(*document.comparison, words);
    if (document.figure) add(*document.figure, words);
    for (const DocumentSection& section : document.sections) {
        for (const std::string& paragraph : section.paragraphs) words += paragraph + '\n';
        for (const Figure& figure : section.figures) add(figure, words);
        for (const DocumentTable& table : section.tables) add(table, words);
    }
    return words;
}

std::string bibtex(const Sources& sources, const std::string& version, const std::string& date) {
    std::string text = fmt::format(
        "@misc{{Tricontact,\n  author = {{{{The Tricontact developers}}}},\n"
        "  title = {{Tricontact: frictional contact by several independent models}},\n"
        "  year = {{{}}},\n  note = {{Version {}, {}}}\n}}\n",
        date.substr(0, 4), version, date);
    for (const Source* source : sources) text += '\n' + source->entry + '\n';
    return text;
}

}  // namespace tricontact::report
