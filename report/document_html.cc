#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <kainjow/mustache.hpp>
#include <stdexcept>

#include "report/base64.h"
#include "report/chart_json.h"
#include "report/csv.h"
#include "report/document.h"
#include "report/document_csv.h"
#include "report/format.h"
#include "report/gnuplot_figure.h"
#include "report/packed.h"
#include "report/page_templates.h"
#include "report/player_json.h"
#include "report/plot_style.h"
#include "report/table_style.h"

namespace tricontact::report {

namespace {

using kainjow::mustache::data;

data object(std::initializer_list<std::pair<const char*, data>> members) {
    data result{data::type::object};
    for (const auto& [name, value] : members) result.set(name, value);
    return result;
}

data verdict(const Verdict& content) {
    // Class and word: colour is never the only difference.
    const std::string word = word_of(content.standing);
    std::string name = word;
    std::ranges::replace(name, ' ', '_');
    return object({{"class", name},
                   {"standing", content.word.empty() ? word : content.word},
                   {"sentence", typeset(content.sentence)}});
}

/// Between the quotes of a string in CSS, in a page's style.
std::string css_text(const std::string& text) {
    std::string result;
    for (const char c : text)
        result += c == '"' || c == '\\' || c == '<' || static_cast<unsigned char>(c) < ' '
                      ? fmt::format("\\{:x} ", c)
                      : std::string(1, c);
    return result;
}

std::string escaped(const std::string& text) {
    return kainjow::mustache::html_escape<std::string>(text);
}

data cell(const Cell& content, const ColumnStyle& style, const std::string& heading) {
    const auto* words = std::get_if<std::string>(&content);
    std::string text, value;
    if (words) {
        text = typeset(*words);
    } else if (const auto* link = std::get_if<Link>(&content)) {
        text = R"(<a href=")" + escaped(link->path) + R"(">)" + escaped(link->text) + "</a>";
    } else {
        text = number_text(content, style);
        if (const auto* number = std::get_if<double>(&content)) value = csv_field(*number);
        if (std::holds_alternative<int>(content)) value = text;
        if (const auto* measured = std::get_if<WithError>(&content))
            value = csv_field(measured->value);
    }
    return object({{"has_words", is_text(content)},
                   {"is_words", style.words},
                   {"is_heading", words && style.first},
                   {"heading", heading},
                   {"text", text},
                   {"has_value", !value.empty()},
                   {"value", value}});
}

data table(const DocumentTable& content) {
    data columns{data::type::list};
    std::vector<ColumnStyle> styles;
    for (std::size_t i = 0; i < content.columns.size(); ++i) {
        styles.push_back(style_of(content, i));
        columns << object(
            {{"text", typeset(content.columns[i].heading)}, {"is_words", styles[i].words}});
    }
    data rows{data::type::list};
    for (const std::vector<Cell>& row : content.rows) {
        data cells{data::type::list};
        for (std::size_t i = 0; i < row.size(); ++i)
            cells << cell(row[i], styles[i], content.columns[i].heading);
        rows << data{"cells", cells};
    }
    return object({{"id", content.id},
                   {"title", typeset(content.title)},
                   {"title_text", content.title},
                   {"note", typeset(content.note)},
                   {"folded", content.folded},
                   {"stacks", content.stacks},
                   {"columns", columns},
                   {"rows", rows},
                   {"csv", base64(table_csv(content))}});
}

data figure_data(const Figure& content, const std::string& plots) {
    return object({{"id", content.id},
                   {"title", typeset(content.title)},
                   {"title_text", content.title},
                   {"caption", typeset(content.caption)},
                   {"content", content_of(content)},
                   {"wide", content.panels.size() > 2},
                   {"files", plots.empty() ? "" : plots + "/" + content.id},
                   {"has_files", !plots.empty()},
                   {"has_png", has_png(content)},
                   {"csv", plots.empty() ? base64(figure_csv(content)) : ""}});
}

data section(const DocumentSection& content, const std::string& plots) {
    data paragraphs{data::type::list}, figures{data::type::list}, tables{data::type::list};
    for (const std::string& text : content.paragraphs) paragraphs << data{"text", typeset(text)};
    for (const Figure& each : content.figures) figures << figure_data(each, plots);
    for (const DocumentTable& each : content.tables) tables << table(each);
    return object({{"id", content.id},
                   {"heading", typeset(content.heading)},
                   {"open", content.open},
                   {"paragraphs", paragraphs},
                   {"printed", content.printed},
                   {"section_has_figures", !content.figures.empty()},
                   {"figures", figures},
                   {"tables", tables}});
}

/// What stands before the details.
void set_answer(const Document& document, data& page) {
    data list{data::type::list}, answer{data::type::list}, comparison{data::type::list},
        figure{data::type::list};
    const DocumentTable judged = verdict_table(document);
    data judged_list{data::type::list};
    if (!judged.rows.empty()) judged_list << table(judged);
    bool has_cards = false;
    for (const Verdict& each : by_severity(document.verdicts))
        if (each.subject.empty()) list << verdict(each), has_cards = true;
    if (document.answer) answer << verdict(*document.answer);
    if (document.comparison) comparison << table(*document.comparison);
    if (document.figure) figure << figure_data(*document.figure, document.plots);
    page.set("has_verdicts", has_cards);
    page.set("has_judged", !judged.rows.empty());
    page.set("judged", judged_list);
    page.set("verdicts_heading", document.verdicts_heading);
    page.set("verdicts", list);
    page.set("has_answer", document.answer.has_value());
    page.set("answer", answer);
    page.set("comparison", comparison);
    page.set("has_figure", document.figure.has_value());
    page.set("figure", figure);
}

/// The document with a figure beside its answer.
Document with_figure(Document document) {
    for (DocumentSection& section : document.sections) {
        if (document.figure) break;
        if (section.figures.empty()) continue;
        document.figure = std::move(section.figures.front());
        section.figures.erase(section.figures.begin());
    }
    std::erase_if(document.sections, [](const DocumentSection& section) {
        return section.paragraphs.empty() && section.figures.empty() && section.tables.empty();
    });
    return document;
}

/// The figures' data and the scripts that draw them.
void set_scripts(const Document& document, data& page) {
    data list{data::type::list};
    std::string colours;
    for (int i = 0; i < n_model_colours; ++i)
        colours += (i > 0 ? " " : "") + model_colour(static_cast<std::size_t>(i));
    const std::vector<Figure> figures = figures_of(document);
    for (const Figure& each : figures)
        list << object({{"id", each.id}, {"json", script_json(figure_json(each))}});
    page.set("colours", colours);
    page.set("states", stick_colour + ' ' + slip_colour);
    page.set("has_figures", !figures.empty());
    page.set("figure_data", list);
    page.set("library", std::string(figures.empty() ? "" : chart_library()));
    page.set("script", charts_script() + figures_script + document_script);
}

void set_player(const std::optional<Player>& player, data& page) {
    page.set("has_player", player.has_value());
    if (!player) return;
    data films{data::type::list};
    for (std::size_t i = 0; i < player->films.size(); ++i)
        films << object({{"name", player->films[i].name}, {"index", std::to_string(i)}});
    page.set("films", films);
    page.set("player_axis", player->axis);
    page.set("player_caption", player->caption);
    page.set("films_json", script_json(player_json(*player)));
    page.set("player_script", std::string(player_movie) + player_difference + player_script);
    page.set("has_scene", !player->body_heights.empty());
    if (player->body_heights.empty()) return;
    static const std::string library = packed(scene_library());
    page.set("scene_library", library);
}

void set_origin(const Document& document, data& page) {
    data settings{data::type::list}, files{data::type::list};
    for (const auto& [name, value] : document.settings)
        settings << object({{"name", typeset(name)}, {"value", typeset(value)}});
    for (const auto& [text, path] : document.files)
        files << object({{"text", text}, {"path", path}});
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

const char* word_of(Verdict::Standing standing) {
    constexpr const char* words[] = {"holds", "violated", "not testable", "finding",
                                     "pass",  "fail",     "not resolved"};
    return words[static_cast<int>(standing)];
}

DocumentTable verdict_table(const Document& document) {
    DocumentTable table{
        .id = "verdicts",
        .title = "Verdicts",
        .columns = columns(document.judged, "verdict", "number", "threshold", document.consequence),
        .stacks = true};
    for (const Verdict& one : by_severity(document.verdicts))
        if (!one.subject.empty())
            table.rows.push_back({one.subject,
                                  one.word.empty() ? std::string(word_of(one.standing)) : one.word,
                                  one.number, one.threshold, one.effect});
    return table;
}

std::vector<Verdict> by_severity(std::vector<Verdict> verdicts) {
    using enum Verdict::Standing;
    std::ranges::stable_sort(verdicts, {}, [](const Verdict& one) {
        const bool is_bad = one.standing == violated || one.standing == fail;
        return is_bad ? 0 : one.standing == not_testable || one.standing == not_resolved ? 1 : 2;
    });
    return verdicts;
}

std::vector<Figure> figures_of(const Document& document) {
    std::vector<Figure> figures;
    if (document.figure) figures.push_back(*document.figure);
    for (const DocumentSection& each : document.sections)
        figures.insert(figures.end(), each.figures.begin(), each.figures.end());
    for (Figure& figure : figures)
        figure.provenance = "tricontact " + document.version + ": " + document.command;
    return figures;
}

std::string document_html(const Document& given) {
    check_document(given);
    const Document document = with_figure(given);
    data sections{data::type::list};
    for (const DocumentSection& each : document.sections) sections << section(each, document.plots);
    data page = object({{"style", std::string(page_style) + document_style +
                                      (document.player ? player_style : "")},
                        {"version", document.version},
                        {"kind", document.kind},
                        {"title", document.title},
                        {"title_html", typeset(document.title)},
                        {"title_css", css_text(document.title)},
                        {"has_lead", !document.lead.empty()},
                        {"lead", typeset(document.lead)},
                        {"has_sections", !document.sections.empty()},
                        {"sections", sections}});
    set_answer(document, page);
    set_player(document.player, page);
    set_origin(document, page);
    set_scripts(document, page);
    using kainjow::mustache::partial;
    page.set("table_part", data{partial{[] { return table_template; }}});
    page.set("verdicts_part", data{partial{[] { return verdicts_template; }}});
    page.set("figure_part", data{partial{[] { return figure_template; }}});
    kainjow::mustache::mustache engine{document_template};
    if (!engine.is_valid())
        throw std::logic_error("document.html.mustache: " + engine.error_message());
    return engine.render(page);
}

}  // namespace tricontact::report
