#include "studies/sweep.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "comparisons/quantities/left_out.h"
#include "comparisons/run/input_reading.h"
#include "report/csv.h"
#include "runs/unread_parts.h"
#include "studies/shard.h"
#include "studies/study_kind.h"
#include "walking/input/walk_keys.h"

namespace tricontact::studies {

namespace {

using report::csv_field;

constexpr const char* table_name = "results.csv";

/// What files of the points were taken for, and what became of the borders of height maps.
std::vector<std::string> input_lines(const StudyPoints& points, const io::ResultStore& store) {
    constexpr std::size_t most_lines = 8;  // each key that changes a map has its own
    std::vector<std::string> lines;
    std::vector<comparisons::Results> results;
    for (const StudyPoint& point : points) {
        const auto* c = std::get_if<contact::Case>(&point.c);
        if (!c) continue;
        for (const std::string& line : comparisons::input_sentences(*c))
            if (lines.size() < most_lines && !std::ranges::count(lines, line))
                lines.push_back(line);
        if (auto found = results_of(store.find(point.key))) results.push_back(std::move(*found));
    }
    std::vector<const comparisons::Results*> runs;
    for (const comparisons::Results& one : results) runs.push_back(&one);
    if (const auto warning = comparisons::border_warning(runs); !warning.empty())
        lines.push_back("warning: " + warning);
    return lines;
}

std::string field(const json& value) {
    if (value.is_null()) return {};
    return value.is_string() ? csv_field(value.get<std::string>()) : value.dump();
}

/// The results as CSV: a row per point, its values under their headings, then results by name, and
/// error. The same points give the same bytes, however they came about.
std::string table_of(const StudyKind& kind, const io::Study& study, const StudyPoints& points,
                     const io::ResultStore& store) {
    const std::vector<std::string> result_names = kind.result_names();
    std::vector<std::string> headings;
    for (const auto& axis : study.axes) headings.push_back(io::table_heading(*axis.key));
    if (!study.walks) headings.insert(headings.end(), {"model", "level"});
    headings.insert(headings.end(), result_names.begin(), result_names.end());
    headings.emplace_back("error");
    std::string table = report::csv_line(headings);
    for (const StudyPoint& point : points) {
        std::vector<std::string> fields;
        for (const std::string& value : point.values) fields.push_back(csv_field(value));
        if (!study.walks)
            fields.insert(fields.end(), {csv_field(point.model), std::to_string(point.level)});
        const auto outcome = store.find(point.key);
        json results = json::object();
        if (outcome && outcome->results) results = json::parse(*outcome->results);
        for (const std::string& name : result_names)
            fields.push_back(field(results.value(name, json())));
        fields.push_back(outcome && outcome->error ? csv_field(*outcome->error) : "");
        table += report::csv_line(fields);
    }
    return table;
}

}  // namespace

void sweep(SweepOptions options) {
    const Shard shard = shard_of(options.shard);
    const bool is_part = !options.shard.empty();
    options.choose_folder(is_part ? fmt::format("_shard_{}_of_{}", shard.i, shard.n) : "");
    const io::Study study = io::read_study(options.file, walking::walk_key_list());
    const StudyKind& kind = study.walks ? walking_kind() : contact_kind();
    StudyPoints points = kind.points(study, *options.makers);
    std::erase_if(points, [&](const StudyPoint& point) { return !shard.has(point.key); });
    if (options.vtk) kind.require_files(points);

    io::OutputNames names{{table_name, "report.html", map_page_name}, io::result_store_files()};
    names.kept.push_back("points/");
    std::ptrdiff_t n_failed = 0;
    std::vector<std::string> input;
    options.fill(names, [&] {
        io::ResultStore store = open_results(options.output);
        compute_missing(kind, points, store,
                        {.name = "sweep",
                         .options = options,
                         .retry_failed = options.retry_failed,
                         .folder = options.vtk ? options.output : ""});
        options.write(table_name, table_of(kind, study, points, store));
        if (options.report) {
            report::Document document = kind.report(study, points, store, options.output);
            if (is_part) document.settings.emplace_back("shard", options.shard);
            document.files.insert(document.files.end(), {{"table of all points", table_name},
                                                         {"everything that is stored, for SQLite",
                                                          io::result_store_name}});
            options.write_report(document, "tricontact sweep " + study.name +
                                               (is_part ? " --shard " + options.shard : ""));
        }
        input = input_lines(points, store);
        n_failed = std::ranges::count_if(
            points, [&](const auto& point) { return !failure_of(store.find(point.key)).empty(); });
    });
    for (const std::string& line : input) options.say(line);
    for (const std::string& line : left_out_of(points)) options.say(line);
    runs::say_unread_parts(options, study, "sweep");
    const std::string table = options.output + '/' + table_name;
    options.say(fmt::format("{} points in {}", points.size(), table) +
                (options.report ? "; " + options.where() : ""));
    options.answer(runs::Answer([&] {
        return json{{"version", files::version},
                    {"study", study.name},
                    {"folder", options.output},
                    {"table", table},
                    {"shard", is_part ? json(options.shard) : json()},
                    {"points", points.size()},
                    {"failed", n_failed}}
            .dump(2);
    }));
    if (n_failed > 0)
        throw std::runtime_error(
            fmt::format("{} of {} points failed: their errors stand in {}; --retry-failed computes "
                        "them again",
                        n_failed, points.size(), table));
}

std::set<std::string> left_out_of(const StudyPoints& points) {
    std::set<std::string> lines;
    for (const StudyPoint& point : points)
        if (const auto* c = std::get_if<contact::Case>(&point.c))
            for (const std::string& one : comparisons::left_out(*c, point.model))
                lines.insert(point.model + " leaves out " + one);
    return lines;
}

report::Cell cell_of(const std::string& text) {
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    if (read.ec == std::errc() && read.ptr == end) return number;
    return text;
}

comparisons::Sweep::Axis axis_of(const io::Study::Axis& axis) {
    const auto* range = std::get_if<io::Study::Range>(&axis.values);
    const io::Dimension dimension = axis.key->dimension;
    const bool has_unit = dimension != io::Dimension::none;
    return {.key = std::string(axis.key->path),
            .unit = std::string(has_unit ? io::si_unit(dimension) : ""),
            .logarithmic = range && range->scale == io::Study::Scale::log};
}

std::string failure_of(const std::optional<io::PointOutcome>& outcome) {
    return outcome ? outcome->error.value_or("") : "not computed";
}

}  // namespace tricontact::studies
