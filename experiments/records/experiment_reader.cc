#include "experiments/records/experiment_reader.h"

#include <algorithm>
#include <array>

#include "io/keys/field_reader.h"
#include "io/keys/file_kind.h"
#include "io/keys/input_file.h"
#include "io/keys/key_guess.h"
#include "io/keys/key_kinds.h"
#include "io/keys/messages.h"
#include "io/tables/csv_table.h"

namespace tricontact::experiments {

namespace {

constexpr std::array<std::string_view, 3> sections{"record", "drive", "errors"};

// Up to a day of three columns at 20 samples per second.
const io::CsvForm& form() {
    static const io::CsvForm form{"record", "time [s], shift [um], drive [mm]", 2'000'000,
                                  "leave out every second row", 100};
    return form;
}

const std::vector<io::Key>& keys() {
    using enum io::Dimension;
    using enum Experiment::Kind;
    constexpr double longest = 1e9;  // [s], as in cases
    static const std::vector<io::Key> keys{
        io::text_key("title", R"("title")", "what was measured"),
        io::choice_key("kind",
                       {io::choice("shakedown", shakedown), io::choice("ratcheting", ratcheting),
                        io::choice("limit", limit)},
                       R"("shakedown")", "procedure"),
        io::text_key("case", R"("case.toml")", "the case file"),
        io::number_key("confidence", {0.5, 0.999}, "0.683", "level of the intervals"),
        io::quantity_key("record.resolution", length, io::above_zero(1), R"("80 nm")",
                         "step of the recorded shift"),
        io::quantity_key("record.loading", time, {-longest, longest}, R"("10 s")",
                         "when the tangential load was applied"),
        io::quantity_key("drive.start", time, {-longest, longest}, R"("60 s")",
                         "when rolling began"),
        io::quantity_key("drive.period", time, io::above_zero(longest), R"("4.5 s")",
                         "of the rolling"),
        io::quantity_key("drive.amplitude", length, io::above_zero(1), R"("1.1 mm")",
                         "rolling amplitude"),
        io::quantity_key("drive.speed", velocity, io::above_zero(1e9), R"("1 mm/s")",
                         "speed of the drive"),
        io::integer_key("drive.periods", {1, 100'000}, "12", "rolling periods")};
    return keys;
}

bool is_nested_in_experiment(std::string_view path) {
    return path.starts_with("errors.");
}

void check_experiment_keys(const io::Document& document) {
    for (const auto& section : document.sections) {
        if (is_nested_in_experiment(section.name) ||
            std::find(sections.begin(), sections.end(), section.name) != sections.end())
            continue;
        io::fail(section.place, "", "unknown section [" + section.name + "]",
                 "known are record, drive and errors");
    }
    std::vector<std::string_view> paths{"runs"};
    for (const io::Key& key : keys()) paths.push_back(key.path);
    for (const io::Entry& entry : document.entries) {
        if (is_nested_in_experiment(entry.path) ||
            std::find(paths.begin(), paths.end(), entry.path) != paths.end())
            continue;
        io::fail(entry.key_place, "", "unknown key " + entry.path,
                 io::did_you_mean(io::likely_path(entry.path, paths),
                                  "docs/experiment.md lists the keys"));
    }
}

const io::Key& key_of(std::string_view path) {
    return *std::ranges::find(keys(), path, &io::Key::path);
}

// Into a field of a type that cases have too.
template <class T>
void read(const io::Document& document, std::string_view path, T* field) {
    if (const io::Entry* entry = document.find(path))
        io::read_field(key_of(path), *entry, io::Field(field));
}

Experiment::Kind read_kind(const io::Document& document) {
    const io::Entry& entry =
        document.required("kind", R"(add kind = "shakedown", "ratcheting" or "limit")");
    return static_cast<Experiment::Kind>(io::read_choice(key_of("kind"), entry).enumerator);
}

Record read_record(const std::string& path) {
    const io::CsvTable table = io::read_csv_table(path, form());
    Record record{.name = table.name(),
                  .time = table.values("time", io::Dimension::time),
                  .shift = table.values("shift", io::Dimension::length),
                  .drive = {}};
    if (table.has("drive")) record.drive = table.values("drive", io::Dimension::length);
    for (const auto& column : table.columns())
        if (column.name != "time" && column.name != "shift" && column.name != "drive")
            table.refuse_header("the column " + io::toml_string(io::shortened(column.heading, 40)) +
                                " is none of time, shift and drive");
    for (std::size_t i = 1; i < record.time.size(); ++i)
        if (!(record.time[i] > record.time[i - 1]))
            table.refuse_value(i, "time", "times must increase from row to row",
                               "sort the table, or remove the row");
    return record;
}

std::vector<Record> read_records(const io::Document& document) {
    const std::string remedy = R"(write for example runs = ["run_1.csv", "run_2.csv"])";
    const io::Entry& entry = document.required("runs", remedy);
    const auto* files = std::get_if<std::vector<std::string>>(&entry.value);
    if (!files || files->empty())
        io::fail(entry.place, entry.subject(), "must be a list of files", remedy);
    std::vector<Record> records;
    for (auto file = files->begin(); file != files->end(); ++file) {
        if (std::find(files->begin(), file, *file) != file)
            io::fail(entry.place, entry.subject(), io::toml_string(*file) + " stands twice",
                     "a record counts once");
        records.push_back(read_record(document.path_of(*file)));
    }
    return records;
}

std::vector<ExperimentInput::CaseError> read_errors(const io::Document& document) {
    std::vector<ExperimentInput::CaseError> errors;
    for (const io::Entry& entry : document.entries) {
        if (!is_nested_in_experiment(entry.path)) continue;
        const std::string path = entry.path.substr(std::string_view("errors.").size());
        const io::CaseKey* key = io::find_key(path);
        if (!key || (key->kind != io::Key::Kind::quantity && key->kind != io::Key::Kind::number)) {
            std::vector<std::string_view> paths;
            for (const io::Key& k : io::case_keys()) paths.push_back(k.path);
            io::fail(entry.key_place, "",
                     "unknown key " + entry.path + ": the case has no number " + path,
                     io::did_you_mean(key ? "" : io::likely_path(path, paths),
                                      "docs/case-file.md lists the keys"));
        }
        double error = 0;
        io::read_field(*key, entry, io::Field(&error));
        if (!(error > 0))
            io::fail(entry.place, entry.subject(), "a standard error must be positive",
                     "omit what is exact");
        errors.push_back({key, error, entry.place});
    }
    if (!errors.empty() && !document.find("case"))
        io::fail(document.find_section("errors") ? document.find_section("errors")->place
                                                 : errors.front().place,
                 "", "[errors] are those of a case, but there is none", "add case = \"case.toml\"");
    return errors;
}

// What the drive did, if no column says it.
void check_drive(const Experiment& e, const io::Document& document) {
    const bool all =
        std::ranges::all_of(e.records, [](const Record& r) { return !r.drive.empty(); });
    const bool none =
        std::ranges::all_of(e.records, [](const Record& r) { return r.drive.empty(); });
    const std::string place = document.place_of("drive.start");
    if (!all && !none)
        io::fail(place, "", "some runs have a column drive, others have not",
                 "add it to all, or evaluate them in two files");
    if (all && document.find_section("drive"))
        io::fail(document.find_section("drive")->place, "",
                 "[drive] and the column drive of the runs say it twice", "omit one of the two");
    if (all) return;
    if (e.kind == Experiment::Kind::limit)
        io::fail(place, "", "amplitudes that rise in steps need the column drive",
                 "record the drive: time [s], shift [um], drive [mm]");
    if (!e.drive.start || !e.drive.periods)
        io::fail(place, "", "without a column drive its start and number of periods must be known",
                 "add start = \"60 s\" and periods = 12 below [drive]");
    if (e.drive.period && e.drive.speed)
        io::fail(document.place_of("drive.speed"), "drive.speed", "period and speed say the same",
                 "omit one of the two");
    if (e.drive.speed && !e.drive.amplitude)
        io::fail(document.place_of("drive.speed"), "drive.speed",
                 "gives the period only together with drive.amplitude",
                 "add amplitude = \"1.1 mm\"");
}

}  // namespace

ExperimentInput read_experiment(const std::string& path) {
    const io::Document document = io::parse_document(io::read_input_file(path, "experiment file"),
                                                     path, is_nested_in_experiment);
    io::require_kind(io::FileKind::experiment, document);
    check_experiment_keys(document);
    ExperimentInput input;
    Experiment& e = input.experiment;
    read(document, "title", &e.title);
    e.kind = read_kind(document);
    read(document, "confidence", &e.confidence);
    read(document, "record.resolution", &e.resolution);
    read(document, "record.loading", &e.loading);
    read(document, "drive.start", &e.drive.start);
    read(document, "drive.period", &e.drive.period);
    read(document, "drive.amplitude", &e.drive.amplitude);
    read(document, "drive.speed", &e.drive.speed);
    if (document.find("drive.periods")) read(document, "drive.periods", &e.drive.periods.emplace());
    std::string case_file;
    read(document, "case", &case_file);
    if (!case_file.empty()) input.case_file = document.path_of(case_file);
    input.errors = read_errors(document);
    e.records = read_records(document);
    check_drive(e, document);
    return input;
}

}  // namespace tricontact::experiments
