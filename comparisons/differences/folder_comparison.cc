#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "comparisons/differences/results_folder.h"
#include "comparisons/quantities/quantities.h"
#include "contact/base/error.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using json = nlohmann::ordered_json;

constexpr std::size_t most_instants = 24;  // whose surfaces are read
constexpr double time_apart = 1e-9;        // times are sums of fractions of a period

struct HistoryQuantity {
    const char *column, *label, *unit;
};
/// Along x, which rolling and loads without an angle have; columns named as results are theirs.
std::vector<HistoryQuantity> history_quantities() {
    return {{"shift_x_m", "shift U", "m"},
            {"tangential_force_x_N", "tangential force F_T", "N"},
            {quantities::indentation.key, "indentation d", "m"},
            {quantities::normal_force.key, "normal force F_N", "N"}};
}

/// Leaves of an object by their keys: "load.indentation".
void flatten(const json& value, const std::string& key, std::map<std::string, std::string>& out) {
    if (!value.is_object()) {
        out[key] = value.is_string() ? value.get<std::string>() : value.dump();
        return;
    }
    for (const auto& [name, member] : value.items())
        flatten(member, key.empty() ? name : key + '.' + name, out);
}

std::vector<ChangedKey> changed_keys(const json& a, const json& b) {
    std::map<std::string, std::string> of_a, of_b;
    flatten(a, "", of_a), flatten(b, "", of_b);
    std::set<std::string> keys;
    for (const auto* all : {&of_a, &of_b})
        for (const auto& [key, value] : *all) keys.insert(key);
    std::vector<ChangedKey> changes;
    for (const std::string& key : keys) {
        const ChangedKey change{key, of_a[key], of_b[key]};
        if (change.a != change.b && key != "title") changes.push_back(change);
    }
    return changes;
}

std::optional<double> number_at(const json& numbers, const json::json_pointer& place) {
    if (!numbers.contains(place)) return {};
    const json& value = numbers.at(place);
    return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

std::optional<double> width_of(const SavedRun& run, const std::string& key) {
    const auto found = run.half_widths.find(key);
    return found == run.half_widths.end() ? std::nullopt : std::optional(found->second);
}

/// Adds a number, or the members of a list one by one, where one of the two has it.
void add_numbers(const SavedRun& a, const SavedRun& b, const std::string& place, NumberPair pair,
                 std::vector<NumberPair>& numbers) {
    const json::json_pointer pointer(place);
    pair.a = number_at(a.numbers, pointer);
    pair.b = number_at(b.numbers, pointer);
    if (pair.a || pair.b) {
        pair.bar_a = width_of(a, pair.key), pair.bar_b = width_of(b, pair.key);
        numbers.push_back(std::move(pair));
        return;
    }
    const auto length = [&](const json& of) {
        return of.contains(pointer) && of.at(pointer).is_array() ? of.at(pointer).size() : 0;
    };
    for (std::size_t n = 0; n < std::max(length(a.numbers), length(b.numbers)); ++n) {
        NumberPair one = pair;
        one.key = fmt::format("{}/{}", pair.key, n);
        one.label = fmt::format("{}, period {}", pair.label, n + 1);
        one.is_of_list = true;
        one.a = number_at(a.numbers, pointer / n), one.b = number_at(b.numbers, pointer / n);
        if (one.a || one.b) numbers.push_back(std::move(one));
    }
}

std::string unit_in_files(const Quantity& q) {
    return *q.over ? "" : q.unit;
}

std::vector<NumberPair> number_pairs(const SavedRun& a, const SavedRun& b) {
    std::vector<NumberPair> numbers;
    std::set<std::string> known;
    for (const Quantity* q : all_quantities()) {
        const std::string place = q->place ? q->place : std::string("/") + q->key;
        known.insert(place.substr(1, place.find('/', 1) - 1));
        add_numbers(a, b, place,
                    {.key = q->key,
                     .label = label_of(*q) + (*q->over ? fmt::format(" [{}]", q->over) : ""),
                     .unit = unit_in_files(*q)},
                    numbers);
    }
    // What is no quantity of a contact: rolling on, walking machines.
    for (const auto& [key, value] : a.numbers.items())
        if (!known.contains(key) && value.is_number())
            add_numbers(a, b, '/' + key, {.key = key, .label = key, .unit = ""}, numbers);
    return numbers;
}

/// The last value of each phase, phases increasing.
std::vector<std::pair<double, double>> by_phase(const SavedRun& run, const std::string& column) {
    std::vector<std::pair<double, double>> points;
    const auto phase = run.history.find("phase"), values = run.history.find(column);
    if (phase == run.history.end() || values == run.history.end()) return points;
    for (std::size_t k = 0; k < phase->second.size(); ++k) {
        const double at = phase->second[k];
        if (!points.empty() && at <= points.back().first) points.pop_back();
        points.emplace_back(at, values->second[k]);
    }
    return points;
}

std::vector<CurvePair> curve_pairs(const SavedRun& a, const SavedRun& b) {
    std::vector<CurvePair> curves;
    for (const auto& [column, label, unit] : history_quantities()) {
        const auto of_a = by_phase(a, column), of_b = by_phase(b, column);
        if (of_a.size() < 2 || of_b.size() < 2) continue;
        CurvePair pair{column, label, unit, {}, {}, {}};
        for (const auto& [at, value] : of_a) {
            const auto after =
                std::ranges::lower_bound(of_b, at, {}, &std::pair<double, double>::first);
            if (after == of_b.end() || (after == of_b.begin() && after->first > at)) continue;
            double beside = after->second;
            if (after->first > at) {
                const auto before = std::prev(after);
                const double share = (at - before->first) / (after->first - before->first);
                beside = (1 - share) * before->second + share * after->second;
            }
            pair.phase.push_back(at), pair.a.push_back(value), pair.b.push_back(beside);
        }
        if (pair.phase.size() > 1) curves.push_back(std::move(pair));
    }
    return curves;
}

void add_fields(const SavedRun& a, const SavedRun& b, RunPair& pair) {
    std::vector<std::pair<const io::SeriesFile*, const io::SeriesFile*>> common;
    auto of_b = b.surfaces.begin();
    const auto ends_its_time = [](const auto& surfaces, auto one) {
        return std::next(one) == surfaces.end() || std::next(one)->time > one->time + time_apart;
    };
    for (auto of_a = a.surfaces.begin(); of_a != a.surfaces.end(); ++of_a) {
        if (!ends_its_time(a.surfaces, of_a)) continue;
        while (of_b != b.surfaces.end() &&
               (of_b->time < of_a->time - time_apart || !ends_its_time(b.surfaces, of_b)))
            ++of_b;
        if (of_b != b.surfaces.end() && of_b->time < of_a->time + time_apart)
            common.emplace_back(&*of_a, &*of_b);
    }
    if (common.empty()) {
        pair.why_no_fields = a.surfaces.empty() || b.surfaces.empty()
                                 ? "surfaces were not written (output.vtk)"
                                 : "the runs have no instant in common";
        return;
    }
    for (const std::size_t k : report::thinned(common.size(), most_instants)) {
        const auto& [first, second] = common[k];
        SurfaceDifference one = difference_of(io::read_surface_file(first->path, first->state),
                                              io::read_surface_file(second->path, second->state));
        pair.instants.push_back({first->time, one.pressure, one.traction});
        one.name_a = pair.model_a == pair.model_b ? "A" : pair.model_a;
        one.name_b = pair.model_a == pair.model_b ? "B" : pair.model_b;
        one.title = fmt::format("{} minus {}", pair.title_a(), pair.title_b());
        one.phase = first->time;
        pair.last = std::move(one);
    }
}

RunPair pair_of(const SavedRun& a, const SavedRun& b) {
    RunPair pair{.model_a = a.model, .model_b = b.model};
    const auto state = [](const SavedRun& run) {
        const auto found = run.numbers.find("state");
        return found != run.numbers.end() && found->is_string() ? found->get<std::string>() : "";
    };
    pair.state_a = state(a), pair.state_b = state(b);
    pair.numbers = number_pairs(a, b);
    pair.curves = curve_pairs(a, b);
    add_fields(a, b, pair);
    return pair;
}

const SavedRun* run_of(const ResultsFolder& folder, const std::string& model) {
    const auto found = std::ranges::find(folder.runs, model, &SavedRun::model);
    return found == folder.runs.end() ? nullptr : &*found;
}

}  // namespace

std::optional<double> NumberPair::relative() const {
    if (!a || !b || *b == 0) return {};
    return *a / *b - 1;
}

std::optional<bool> NumberPair::overlaps() const {
    if (!a || !b || !bar_a || !bar_b) return {};
    return std::abs(*a - *b) <= *bar_a + *bar_b;
}

std::string RunPair::id() const {
    return model_a == model_b ? model_a : model_a + '_' + model_b;
}
std::string RunPair::title_a() const {
    return "A, " + report::display_name(model_a);
}
std::string RunPair::title_b() const {
    return "B, " + report::display_name(model_b);
}

FolderComparison compare_folders(const ResultsFolder& a, const ResultsFolder& b) {
    FolderComparison comparison{.path_a = a.path,
                                .path_b = b.path,
                                .version_a = a.version,
                                .version_b = b.version,
                                .changes = changed_keys(a.c, b.c),
                                .pairs = {},
                                .notes = {}};
    for (const SavedRun& run : a.runs)
        if (const SavedRun* other = run_of(b, run.model))
            comparison.pairs.push_back(pair_of(run, *other));
    if (comparison.pairs.empty()) {
        comparison.pairs.push_back(pair_of(a.runs.back(), b.runs.back()));
        comparison.notes.push_back(
            fmt::format("No model is in both: the last of A, {}, beside the last of B, {}.",
                        a.runs.back().model, b.runs.back().model));
        return comparison;
    }
    const auto note = [&](const ResultsFolder& one, const ResultsFolder& other, const char* name) {
        for (const SavedRun& run : one.runs)
            if (!run_of(other, run.model))
                comparison.notes.push_back(fmt::format("{} is in {} only.", run.model, name));
    };
    note(a, b, "A"), note(b, a, "B");
    return comparison;
}

}  // namespace tricontact::comparisons
