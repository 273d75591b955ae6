#include "comparisons/run/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <stdexcept>
#include <utility>

#include "comparisons/half_space/layer_report.h"
#include "comparisons/quantities/results.h"
#include "comparisons/resolution/refinement_report.h"
#include "comparisons/run/loading_report.h"
#include "comparisons/run/plots.h"
#include "comparisons/run/reading.h"
#include "comparisons/run/relaxation_report.h"
#include "comparisons/run/report_tables.h"
#include "report/base64.h"
#include "report/format.h"
#include "report/page_templates.h"
#include "report/plot_style.h"

namespace tricontact::comparisons {

namespace {

using contact::State;
using kainjow::mustache::data;

constexpr int most_open_periods = 12;  // longer tables start folded

data list(const std::vector<std::string>& texts) {
    data result{data::type::list};
    for (const std::string& text : texts) result << data{"text", text};
    return result;
}

/// Sentences as HTML.
data typeset_list(const std::vector<std::string>& sentences) {
    data result{data::type::list};
    for (const std::string& sentence : sentences) result << data{"text", report::typeset(sentence)};
    return result;
}

/// A cell's class: verdicts stand out, words align left.
std::string cell_class(const std::string& cell) {
    for (const char* word :
         {"shakedown", "cyclic-slip", "ratcheting", "undecided", "passed", "FAILED"})
        if (cell == word) return std::string("verdict ") + word;
    return "";
}

data cells(const std::vector<std::string>& texts) {
    data result{data::type::list};
    for (const std::string& text : texts) {
        data cell{data::type::object};
        cell.set("text", text);
        cell.set("class", cell_class(text));
        result << cell;
    }
    return result;
}

data to_data(const Table& table) {
    data groups{data::type::list};
    for (const Table::Group& group : table.groups) {
        data rows{data::type::list};
        for (const Table::Row& row : group.rows) {
            data line{data::type::object};
            line.set("label", row.label);
            line.set("unit", row.unit);
            line.set("cells", cells(row.cells));
            rows << line;
        }
        data block{data::type::object};
        block.set("has_title", !group.title.empty());
        block.set("title", group.title);
        block.set("span", std::to_string(table.columns.size() + 2));
        block.set("rows", rows);
        groups << block;
    }
    data result{data::type::object};
    result.set("name", table.name);
    result.set("columns", list(table.columns));
    result.set("groups", groups);
    return result;
}

/// The number that answers the case, with its name.
std::pair<std::string, std::string> headline(const Results& s) {
    using namespace quantities;
    const auto shown = [&s](const Quantity& length, const Quantity& ratio, const char* meaning) {
        return std::pair(
            report::quantity(s.number(length).value_or(0), "m"),
            fmt::format("{} ({} {})", meaning, report::significant(s.number(ratio)), ratio.over));
    };
    if (s.state() == State::ratcheting)
        return shown(shift_increment, shift_increment_ratio, "shift per period");
    if (!s.state()) return shown(static_shift, static_shift_ratio, "static shift");
    if (s.number(settled_shift)) return shown(settled_shift, settled_shift_ratio, "settled shift");
    return shown(final_shift, final_shift_ratio, "shift so far");
}

data cards(const std::vector<Results>& summaries) {
    data result{data::type::list};
    for (std::size_t i = 0; i < summaries.size(); ++i) {
        const Results& s = summaries[i];
        const auto [value, meaning] = headline(s);
        data card{data::type::object};
        card.set("model", report::display_name(s.model));
        card.set("colour", report::model_colour(i));
        card.set("state", s.state() ? contact::name_of(*s.state()) : "static");
        card.set("value", value);
        card.set("meaning", report::typeset(meaning));
        const auto kappa = s.number(quantities::kappa), eta = s.number(quantities::eta);
        if (kappa) card.set("factor", "κ = " + report::significant(kappa, 3));
        if (eta) card.set("factor", "η = " + report::significant(eta, 3));
        card.set("has_factor", kappa || eta);
        result << card;
    }
    return result;
}

data figures(const std::vector<Plot>& plots, const std::vector<Drawing>& drawings) {
    data result{data::type::list};
    for (std::size_t i = 0; i < plots.size(); ++i) {
        const bool svg = plots[i].embedded == report::ImageFormat::svg;
        data figure{data::type::object};
        figure.set("name", plots[i].name);
        figure.set("title", plots[i].title);
        figure.set("caption", plots[i].caption);
        figure.set("caption_html", report::typeset(plots[i].caption));
        figure.set("width", std::to_string(plots[i].picture.width));
        figure.set("height", std::to_string(plots[i].picture.height));
        figure.set("wide", plots[i].picture.width > 700);
        figure.set("source", svg ? "data:image/svg+xml;base64," + report::base64(drawings[i].svg)
                                 : "data:image/png;base64," + report::base64(drawings[i].png));
        result << figure;
    }
    return result;
}

void set_layer(const contact::Case& c, const std::vector<contact::History>& histories,
               const LoadingStudy& study, data& page) {
    const auto layer = compare_with_layer(c, histories, study);
    page.set("has_layer", layer.has_value());
    if (!layer) return;
    page.set("layer_sentences", typeset_list(layer_sentences(c, *layer)));
    page.set("layer_table", to_data(layer_table(*layer)));
}

void set_loading(const contact::Case& c, const std::vector<LoadingVariant>& variants, data& page) {
    page.set("has_loading", c.layer.thickness || !variants.empty());
    page.set("treatment_sentences", typeset_list(treatment_sentences(c, c.models, variants)));
    page.set("has_variants", !variants.empty());
    page.set("variants_table", to_data(variants_table(variants)));
}

void set_relaxation(const contact::Case& c, const RelaxationStudy& study, data& page) {
    page.set("has_relaxation", c.relaxation.has_value());
    if (!c.relaxation) return;
    page.set("relaxation_sentences", typeset_list(relaxation_sentences(c, study)));
    page.set("has_twins", !study.twins.empty());
    page.set("relaxation_table", to_data(relaxation_table(c, study)));
}

void set_refinement(const std::optional<Refinement>& refinement, data& page) {
    page.set("has_refinement", refinement.has_value());
    if (!refinement) return;
    page.set("refinement_sentences", typeset_list(refinement_sentences(*refinement)));
    page.set("refinement_table", to_data(refinement_table(*refinement)));
}

/// Everything but figures, layer, loading, relaxation and refinement.
data page(const contact::Case& c, const std::string& resolved_case, const std::string& version,
          const std::vector<Results>& summaries) {
    data settings{data::type::list};
    for (const Table& table : setting_tables(c)) settings << to_data(table);
    data result{data::type::object};
    result.set("style", std::string(report::page_style) + report::report_style);
    result.set("table", data{kainjow::mustache::partial{
                            [] { return std::string(report::report_table_template); }}});
    result.set("title", c.title.empty() ? "Frictional contact" : c.title);
    result.set("version", version);
    result.set("cards", cards(summaries));
    result.set("findings", typeset_list(reading(c, summaries)));
    result.set("settings", settings);
    result.set("results", to_data(results_table(c, summaries)));
    result.set("rolling", c.rolling.has_value());
    int periods = 0;
    for (const Results& s : summaries) periods = std::max(periods, s.periods());
    result.set("has_periods", periods > 0);
    result.set("few_periods", periods <= most_open_periods);
    result.set("period_table", to_data(period_table(summaries)));
    result.set("audit", to_data(audit_table(summaries)));
    result.set("resolved_case", resolved_case);
    result.set("several_models", summaries.size() > 1);
    result.set("round", contact::is_hertz_round(c));
    result.set("line", c.is_cylindrical());
    result.set("body", !contact::is_hertz_round(c) && !c.is_cylindrical());
    result.set("ellipse", c.indenter.shape == contact::Case::Shape::ellipsoid);
    return result;
}

std::string render(const data& content) {
    kainjow::mustache::mustache engine{report::report_template};
    if (!engine.is_valid())
        throw std::logic_error("report.html.mustache: " + engine.error_message());
    return engine.render(content);
}

}  // namespace

std::vector<ReportFile> make_report(const contact::Case& c, const std::string& resolved_case,
                                    const std::string& version,
                                    const std::vector<contact::History>& histories,
                                    const ReportExtras& extras) {
    std::vector<Results> summaries;
    for (const contact::History& history : histories) summaries.emplace_back(c, history);
    std::vector<Plot> plots = make_plots(c, histories);
    if (c.relaxation) plots.push_back(modulus_plot(c, extras.relaxation));
    const std::vector<Drawing> drawings = draw_all(plots);
    data content = page(c, resolved_case, version, summaries);
    set_layer(c, histories, extras.study, content);
    set_loading(c, extras.study.variants, content);
    set_relaxation(c, extras.relaxation, content);
    set_refinement(extras.refinement, content);
    content.set("figures", figures(plots, drawings));

    std::vector<ReportFile> files{{"report.html", render(content)}};
    for (std::size_t i = 0; i < plots.size(); ++i) {
        files.push_back({"plots/" + plots[i].name + ".svg", drawings[i].svg});
        files.push_back({"plots/" + plots[i].name + ".png", drawings[i].png});
    }
    return files;
}

}  // namespace tricontact::comparisons
