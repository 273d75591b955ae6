#include "experiments/conversion/old_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <utility>
#include <vector>

#include "io/case/case_keys.h"
#include "io/case/rig_keys.h"
#include "io/keys/input_file.h"
#include "io/keys/messages.h"
#include "io/keys/number_text.h"
#include "io/keys/toml_document.h"

namespace tricontact::experiments {

namespace {

using Renamed = std::pair<std::string_view, std::string_view>;

constexpr std::array<Renamed, 16> rolling_names{
    {{"roller.shape", "indenter.shape"},
     {"roller.radius", "indenter.radius"},
     {"roller.length", "indenter.length"},
     {"roller.young", "indenter.young"},
     {"roller.poisson", "indenter.poisson"},
     {"substrate.density", "rig.density"},
     {"substrate.viscosity", "rig.viscosity"},
     {"substrate.maxwell_ratio", "rig.maxwell_ratio"},
     {"drive.speed", "rolling.speed"},
     {"drive.smallest_amplitude_ratio", "rig.smallest_amplitude_ratio"},
     {"drive.reference_radius", "rig.reference_radius"},
     {"drive.eigenfrequency", "rig.eigenfrequency"},
     {"pivot.displacement", "rig.pivot_displacement"},
     {"pivot.amplitude_ratio", "rig.pivot_amplitude_ratio"},
     {"measured.contact_size", "rig.contact_size"},
     {"rig", ""}}};

constexpr std::array<Renamed, 21> walking_names{
    {{"specimen.mass", "machine.mass"},
     {"specimen.disc_diameter", "rig.disc_diameter"},
     {"specimen.disc_length", "rig.disc_length"},
     {"specimen.centre_length", "rig.centre_length"},
     {"specimen.edge_radius", "rig.edge_radius"},
     {"specimen.young", "contact.young"},
     {"specimen.poisson", "contact.poisson"},
     {"substrate.young", "contact.substrate_young"},
     {"substrate.poisson", "contact.substrate_poisson"},
     {"friction.coefficient", "machine.friction_coefficient"},
     {"contact.wear_diameter", "rig.wear_diameter"},
     {"spring.stiffness", "rig.rod_stiffness"},
     {"spring.sensor_stiffness", "rig.sensor_stiffness"},
     {"spring.length", "rig.rod_length"},
     {"spring.young", "rig.rod_young"},
     {"spring.height_ratio", "machine.height_ratio"},
     {"oscillation.frequency", "rig.frequency"},
     {"oscillation.simulated", "rig.simulated_frequency"},
     {"oscillation.time", "rig.characteristic_time"},
     {"oscillation.sampling_rate", "rig.sampling_rate"},
     {"rig", ""}}};

constexpr std::array<Renamed, 9> record_names{{{"kind", "record.kind"},
                                               {"confidence", "record.confidence"},
                                               {"drive.start", "record.drive.start"},
                                               {"drive.period", "record.drive.period"},
                                               {"drive.amplitude", "record.drive.amplitude"},
                                               {"drive.speed", "record.drive.speed"},
                                               {"drive.periods", "record.drive.periods"},
                                               {"runs", ""},
                                               {"case", ""}}};

constexpr std::array<Renamed, 4> measurement_names{{{"models", "measurement.models"},
                                                    {"confidence", "measurement.confidence"},
                                                    {"measurement", ""},
                                                    {"data", ""}}};

template <std::size_t n>
std::string new_name(const std::array<Renamed, n>& names, const std::string& path) {
    const auto found = std::ranges::find(names, path, &Renamed::first);
    return found == names.end() ? path : std::string(found->second);
}

struct TomlText {
    std::string operator()(bool v) const { return v ? "true" : "false"; }
    std::string operator()(std::int64_t v) const { return std::to_string(v); }
    std::string operator()(double v) const { return io::toml_number(v); }
    std::string operator()(const std::string& v) const { return io::toml_string(v); }
    std::string operator()(const std::vector<std::string>& v) const {
        return '[' + io::joined(v, io::toml_string) + ']';
    }
    template <class T>
    std::string operator()(const std::vector<T>& v) const {
        return '[' + io::joined(v, TomlText{}) + ']';
    }
    std::string operator()(const io::OtherValue&) const { return "\"\""; }
};

/// The new file: keys with the texts of their values, in the order of their declarations.
class NewFile {
  public:
    NewFile(const io::Document& old, const std::string& output) : old_(old), output_(output) {}

    void add(const std::string& path, const io::Value& value) {
        values_[path] = std::visit(TomlText{}, value);
    }
    void add_missing(const std::string& path, const io::Value& value) {
        if (values_.contains(path)) return;
        add(path, value);
        remarks_[path] = "  # not in the old file";
    }
    /// "0.57" becomes "0.57 ± 0.01".
    void add_error(const std::string& path, const io::Value& error) {
        const auto found = values_.find(path);
        if (found == values_.end()) return;
        const auto bare = [](std::string text) {
            return text.starts_with('"') ? text.substr(1, text.size() - 2) : text;
        };
        found->second = io::toml_string(
            fmt::format("{} ± {}", bare(found->second), bare(std::visit(TomlText{}, error))));
    }
    /// A file that the old one names, or a file beside another one that it names.
    std::string file_name(const std::string& file, const io::Document& named_by) const {
        namespace fs = std::filesystem;
        const fs::path folder = fs::absolute(output_).parent_path();
        return fs::absolute(named_by.path_of(file)).lexically_relative(folder).string();
    }
    const io::Document& old() const { return old_; }

    std::string text(const io::KeyList& keys, const std::string& printed) const {
        std::string text = fmt::format("{}{}\n", converted_beginning,
                                       std::filesystem::path(old_.name).filename().string());
        std::string_view section;
        for (const io::Key* key : keys.keys()) {
            const auto value = values_.find(std::string(key->path));
            if (value == values_.end()) continue;
            if (key->section() != section) {
                section = key->section();
                text += fmt::format("\n[{}]\n", section);
            }
            const auto remark = remarks_.find(value->first);
            text += fmt::format("{} = {}{}\n", key->name(), value->second,
                                remark == remarks_.end() ? "" : remark->second);
        }
        return text + printed;
    }

  private:
    const io::Document& old_;
    std::string output_;
    std::map<std::string, std::string> values_, remarks_;
};

bool is_nested(std::string_view path) {
    return io::is_printed(path) || path.starts_with("errors.") ||
           path.starts_with("standard_errors.") || io::is_section(path);
}

std::string printed_text(const io::Document& old) {
    std::string text;
    for (const auto& section : old.sections) {
        if (io::section_of(section.name) != "printed") continue;
        if (text.empty()) text = "\n[printed]\n";
        const auto part = [&](const char* name) {
            return std::visit(TomlText{}, old.find(section.name + '.' + name)->value);
        };
        text += fmt::format("{} = {{value = {}, source = {}}}\n", io::name_of_key(section.name),
                            part("value"), part("source"));
    }
    return text;
}

template <std::size_t n>
void add_renamed(NewFile& file, const std::array<Renamed, n>& names) {
    for (const io::Entry& entry : file.old().entries) {
        const std::string path = new_name(names, entry.path);
        if (!path.empty()) file.add(path, entry.value);
    }
}

void add_errors(NewFile& file, const std::string& section) {
    for (const io::Entry& entry : file.old().entries)
        if (entry.path.starts_with(section + '.'))
            file.add_error(entry.path.substr(section.size() + 1), entry.value);
}

std::string rolling_rig_text(NewFile file) {
    add_renamed(file, rolling_names);
    file.add_missing("models", std::vector<std::string>{"mdr-layer", "bem-layer"});
    file.add_missing("load.tangential_ratio", .5);
    file.add_missing("rolling.amplitude_ratio", .25);
    return file.text(io::case_file_keys(), printed_text(file.old()));
}

/// Walking cases are another feature's: of their keys the order alone is known here.
std::string walking_rig_text(NewFile file) {
    static const std::vector<io::Key> machine = [] {
        std::vector<io::Key> keys;
        for (const char* path :
             {"title", "machine.model", "machine.mass", "machine.half_height", "machine.half_width",
              "machine.moment_of_inertia", "machine.spring_stiffness",
              "machine.friction_coefficient", "machine.base_velocity", "machine.height_ratio",
              "contact.diameter", "contact.young", "contact.poisson", "contact.substrate_young",
              "contact.substrate_poisson", "time.step", "time.duration"})
            keys.push_back(io::text_key(path, {}, {}));
        return keys;
    }();
    add_renamed(file, walking_names);
    file.add("machine.model", std::string("prism"));
    const auto printed = [&](const char* name, const char* otherwise) {
        const io::Entry* value = file.old().find(fmt::format("printed.{}.value", name));
        return value ? value->value : io::Value(std::string(otherwise));
    };
    file.add("machine.half_height", printed("half_height", "21.2 mm"));
    file.add("machine.half_width", printed("half_width", "14 mm"));
    file.add("machine.spring_stiffness",
             printed("spring_stiffness",
                     std::get<std::string>(file.old().find("spring.stiffness")->value).c_str()));
    file.add_missing("machine.moment_of_inertia", std::string("1.7e-4 kg m2"));
    file.add_missing("machine.base_velocity", std::string("40 mm/s"));
    file.add_missing("time.step", 1e-3);
    file.add_missing("time.duration", std::string("5 s"));
    return file.text(io::with_rig_keys(io::KeyList(machine, {}), io::walking_rig_keys()),
                     printed_text(file.old()));
}

std::string experiment_text(NewFile file) {
    const io::Document& old = file.old();
    if (const io::Entry* entry = old.find("case")) {
        const std::string path = old.path_of(std::get<std::string>(entry->value));
        const io::Document c = io::parse_document(io::read_input_file(path), path);
        for (const io::Entry& one : c.entries) file.add(one.path, one.value);
    }
    add_renamed(file, record_names);
    add_errors(file, "errors");
    std::vector<std::string> runs;
    for (const auto& run : std::get<std::vector<std::string>>(old.find("runs")->value))
        runs.push_back(file.file_name(run, old));
    file.add("record.runs", runs);
    return file.text(io::case_file_keys(), {});
}

std::string measurement_text(NewFile file) {
    const io::Document& old = file.old();
    add_renamed(file, measurement_names);
    add_errors(file, "standard_errors");
    const auto text_at = [&](const char* path, const char* remedy) {
        return std::get<std::string>(old.required(path, remedy).value);
    };
    std::string kind = text_at("measurement", "name what the table holds");
    const bool sheared = kind == "static-shift";
    std::ranges::replace(kind, '-', '_');
    file.add("measurement." + kind, file.file_name(text_at("data", "name the table"), old));
    std::vector<std::string> find;
    for (const char* path : {"substrate.young", "friction.coefficient"})
        if (!old.find(path) && (sheared || path == std::string_view("substrate.young")))
            find.emplace_back(path);
    file.add("measurement.find", find);
    return file.text(io::case_file_keys(), {});
}

}  // namespace

std::string converted(std::string_view text, const std::string& name, const std::string& output) {
    const io::Document old = io::parse_document(text, name, is_nested);
    const NewFile file(old, output);
    switch (io::kind_of(old)) {
        case io::FileKind::rig: {
            const auto* word = std::get_if<std::string>(&old.find("rig")->value);
            return word && *word == "rolling" ? rolling_rig_text(file) : walking_rig_text(file);
        }
        case io::FileKind::experiment:
            return experiment_text(file);
        case io::FileKind::measurement:
            return measurement_text(file);
        default:
            io::fail(name, "", "is of no old format: nothing is to be converted",
                     "use it as it is");
    }
}

}  // namespace tricontact::experiments
