#include <cmath>
#include <kainjow/mustache.hpp>
#include <stdexcept>

#include "report/base64.h"
#include "report/chart_json.h"
#include "report/chart_library.h"
#include "report/csv.h"
#include "report/document.h"
#include "report/document_check.h"
#include "report/document_csv.h"
#include "report/format.h"
#include "report/page_templates.h"
#include "report/script_json.h"

namespace tricontact::report {

namespace {

using kainjow::mustache::data;

/// Class and word of a verdict's standing: colour is never the only difference.
std::pair<std::string, std::string> words_of(Verdict::Standing standing) {
    switch (standing) {
        case Verdict::Standing::holds:
            return {"holds", "holds"};
        case Verdict::Standing::fails:
            return {"fails", "fails"};
        case Verdict::Standing::cannot_tell:
            return {"cannot_tell", "cannot tell"};
        case Verdict::Standing::finding:
            break;
    }
    return {"finding", "finding"};
}

data verdicts(const std::vector<Verdict>& list) {
    data result{data::type::list};
    for (const Verdict& verdict : list) {
        const auto [name, word] = words_of(verdict.standing);
        data item{data::type::object};
        item.set("class", name);
        item.set("standing", verdict.word.empty() ? word : verdict.word);
        item.set("sentence", typeset(verdict.sentence));
        result << item;
    }
    return result;
}

/// How the cells of a column are written.
struct ColumnStyle {
    bool first = false;  ///< words in it are headings of their rows
    bool words = true;   ///< nothing else: aligned left
    bool whole = true;   ///< numbers, if any, are whole: written without decimals
    int digits = 4;      ///< significant, of other numbers
    bool change = false;
};

bool is_text(const Cell& content) {
    return std::holds_alternative<std::string>(content) || std::holds_alternative<Link>(content);
}

std::string escaped(const std::string& text) {
    return kainjow::mustache::html_escape<std::string>(text);
}

ColumnStyle style_of(const DocumentTable& content, std::size_t column) {
    constexpr double most = 1e6;  // beyond, numbers are magnitudes and no counts
    ColumnStyle style{.first = column == 0,
                      .digits = content.columns[column].digits,
                      .change = content.columns[column].change};
    for (const std::vector<Cell>& row : content.rows) {
        style.words = style.words && is_text(row[column]);
        if (const auto* number = std::get_if<double>(&row[column]))
            style.whole = style.whole && (std::isnan(*number) || (std::abs(*number) < most &&
                                                                  std::rint(*number) == *number));
    }
    return style;
}

/// "+16.5": the heading has the unit.
std::string signed_percent(double value) {
    const std::string text = percent(1 + value / 100);
    return text.substr(0, text.find(' '));
}

std::string number_text(double number, const ColumnStyle& style) {
    if (style.change) return signed_percent(number);
    return style.whole ? as_given(number) : significant(number, style.digits);
}

data cell(const Cell& content, const ColumnStyle& style) {
    data result{data::type::object};
    const auto* words = std::get_if<std::string>(&content);
    result.set("has_words", is_text(content));
    result.set("is_words", style.words);
    result.set("is_heading", words && style.first);
    std::string value;
    if (words) {
        result.set("text", typeset(*words));
    } else if (const auto* link = std::get_if<Link>(&content)) {
        result.set("text",
                   R"(<a href=")" + escaped(link->path) + R"(">)" + escaped(link->text) + "</a>");
    } else if (const auto* number = std::get_if<double>(&content)) {
        value = csv_field(*number);
        result.set("text", number_text(*number, style));
    } else if (const auto* count = std::get_if<int>(&content)) {
        value = std::to_string(*count);
        result.set("text", value);
    } else {
        const auto& measured = std::get<WithError>(content);
        value = csv_field(measured.value);
        result.set("text", with_error(measured.value, measured.error, style.digits));
    }
    result.set("has_value", !value.empty());
    result.set("value", value);
    return result;
}

data table(const DocumentTable& content) {
    data columns{data::type::list};
    std::vector<ColumnStyle> styles;
    for (std::size_t i = 0; i < content.columns.size(); ++i) {
        styles.push_back(style_of(content, i));
        data column{data::type::object};
        column.set("text", typeset(content.columns[i].heading));
        column.set("is_words", styles[i].words);
        columns << column;
    }
    data rows{data::type::list};
    for (const std::vector<Cell>& row : content.rows) {
        data cells{data::type::list};
        for (std::size_t i = 0; i < row.size(); ++i) cells << cell(row[i], styles[i]);
        rows << data{"cells", cells};
    }
    data result{data::type::object};
    result.set("id", content.id);
    result.set("title", typeset(content.title));
    result.set("title_text", content.title);
    result.set("note", typeset(content.note));
    result.set("folded", content.folded);
    result.set("columns", columns);
    result.set("rows", rows);
    result.set("csv", base64(table_csv(content)));
    return result;
}

data figure_data(const Figure& content, const std::string& plots) {
    data result{data::type::object};
    result.set("id", content.id);
    result.set("title", typeset(content.title));
    result.set("title_text", content.title);
    result.set("caption", typeset(content.caption));
    result.set("caption_text", content.caption);
    result.set("wide", content.panels.size() > 2);
    result.set("files", plots.empty() ? "" : plots + "/" + content.id);
    result.set("has_files", !plots.empty());
    result.set("csv", plots.empty() ? base64(figure_csv(content)) : "");
    return result;
}

data section(const DocumentSection& content, const std::string& plots) {
    data paragraphs{data::type::list}, figures{data::type::list}, tables{data::type::list};
    for (const std::string& text : content.paragraphs) paragraphs << data{"text", typeset(text)};
    for (const Figure& each : content.figures) figures << figure_data(each, plots);
    for (const DocumentTable& each : content.tables) tables << table(each);
    data result{data::type::object};
    result.set("id", content.id);
    result.set("heading", typeset(content.heading));
    result.set("paragraphs", paragraphs);
    result.set("section_has_figures", !content.figures.empty());
    result.set("figures", figures);
    result.set("tables", tables);
    return result;
}

/// The figures' data and the scripts that draw them.
void set_scripts(const Document& document, data& page) {
    std::vector<Figure> figures;
    for (const DocumentSection& each : document.sections)
        figures.insert(figures.end(), each.figures.begin(), each.figures.end());
    page.set("has_figures", !figures.empty());
    page.set("figures", script_json(chart_json(figures)));
    page.set("library", std::string(figures.empty() ? "" : chart_library()));
    page.set("script", std::string(charts_script) + document_script);
}

void set_origin(const Document& document, data& page) {
    data settings{data::type::list}, files{data::type::list};
    for (const auto& [name, value] : document.settings) {
        data item{data::type::object};
        item.set("name", typeset(name));
        item.set("value", typeset(value));
        settings << item;
    }
    for (const auto& [text, path] : document.files) {
        data item{data::type::object};
        item.set("text", text);
        item.set("path", path);
        files << item;
    }
    page.set("has_settings", !document.settings.empty());
    page.set("settings", settings);
    page.set("has_files", !document.files.empty());
    page.set("files", files);
    page.set("has_command", !document.command.empty());
    page.set("command", document.command);
    page.set("has_input", !document.input.empty());
    page.set("input", document.input);
    page.set("has_origin",
             !document.files.empty() || !document.command.empty() || !document.input.empty());
}

}  // namespace

std::string document_html(const Document& document) {
    check_document(document);
    data sections{data::type::list};
    for (const DocumentSection& each : document.sections) sections << section(each, document.plots);
    data page{data::type::object};
    page.set("style", std::string(page_style) + document_style);
    page.set("version", document.version);
    page.set("kind", document.kind);
    page.set("title", document.title);
    page.set("title_html", typeset(document.title));
    page.set("has_lead", !document.lead.empty());
    page.set("lead", typeset(document.lead));
    page.set("has_verdicts", !document.verdicts.empty());
    page.set("verdicts", verdicts(document.verdicts));
    page.set("sections", sections);
    set_origin(document, page);
    set_scripts(document, page);
    kainjow::mustache::mustache engine{document_template};
    if (!engine.is_valid())
        throw std::logic_error("document.html.mustache: " + engine.error_message());
    return engine.render(page);
}

}  // namespace tricontact::report
