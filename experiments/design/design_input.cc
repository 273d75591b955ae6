#include "experiments/design/design_input.h"

#include <algorithm>
#include <array>

#include "contact/case.h"
#include "io/case/case_reader.h"
#include "io/case/rig_keys.h"
#include "io/keys/field_reader.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"
#include "io/keys/number_text.h"

namespace tricontact::experiments {

namespace {

constexpr std::string_view design = "design.";

/// Below "vary", as a study states its axes.
io::Document varied_of(const io::Document& document) {
    io::Document varied{.name = document.name, .sections = {}, .entries = {}};
    const auto outer = [](const std::string& path) { return path.substr(design.size()); };
    for (const auto& section : document.sections)
        if (io::is_varied_in_design(section.name))
            varied.sections.push_back({outer(section.name), section.place});
    for (io::Entry entry : document.entries)
        if (io::is_varied_in_design(entry.path)) {
            entry.path = outer(entry.path);
            varied.entries.push_back(std::move(entry));
        }
    return varied;
}

void check(const io::Study::Axis& axis) {
    constexpr std::array<std::string_view, 6> sections{"indenter", "substrate", "friction",
                                                       "load",     "rolling",   "rig"};
    constexpr std::string_view ratio = "design.load_ratio";
    const std::string name = "design.vary." + std::string(axis.key->path);
    const bool is_of_rig =
        std::ranges::count(sections, axis.key->section()) > 0 || axis.key->path == ratio;
    const bool is_one =
        axis.key->kind == io::Key::Kind::quantity || axis.key->kind == io::Key::Kind::number;
    if (!is_of_rig || !is_one)
        io::fail(
            axis.place, name, "is no number of the rig",
            "vary numbers of [indenter], [substrate], [friction], [load], [rolling], [rig], or "
            "design.load_ratio");
    const auto* range = std::get_if<io::Study::Range>(&axis.values);
    if (!range) io::fail(axis.place, name, "must be a range", "write {from = ..., to = ...}");
    if (range->points)
        io::fail(axis.place, name, "has points, but the design is searched in between",
                 "omit points");
}

/// "± 0.1 mm" of "8 ± 0.1 mm".
std::string uncertainty_of(const io::Document& document, std::string_view path) {
    const io::Entry* entry = document.find(path);
    const auto* text = entry ? std::get_if<std::string>(&entry->value) : nullptr;
    if (!text || !io::states_uncertainty(*text)) return {};
    for (const std::string_view sign : {"±", "+-"})
        if (const auto at = text->find(sign); at != std::string::npos)
            return "± " +
                   std::string(io::trimmed(std::string_view(*text).substr(at + sign.size())));
    return {};
}

void read_keys(DesignInput& input, const io::Document& document) {
    const io::KeyList& keys = io::case_file_keys();
    const auto read = [&](std::string_view path, const io::Field& field) {
        io::read_or_default(io::rig_key(path), field, document, keys);
    };
    read("design.assumptions", &input.assumptions);
    read("design.deviation", &input.deviation);
    read("design.resolution", &input.resolution);
    const io::Key& quantity = io::rig_key("design.quantity");
    const io::Entry* entry = document.find(quantity.path);
    input.quantity = entry ? io::read_choice(quantity, *entry).word : quantity.choices[0].word;
    read("design.scatter", &input.record.scatter);
    read("design.repeats", &input.record.repeats);
    read("record.resolution", &input.record.step);
    if (document.find("design.laws")) {
        read("design.laws", &input.laws.laws);
        read("design.sliding_error", &input.laws.sliding_error);
        read("design.shift_error", &input.laws.shift_error);
        if (document.find("design.limit_error"))
            read("design.limit_error", &input.laws.limit_error);
    }
}

void check_asked(const DesignInput& input, const io::Document& document) {
    const io::Document::Section& section = *document.find_section("design");
    if (input.assumptions.empty() && !input.resolution && input.laws.laws.empty())
        io::fail(section.place, "", "[design] asks for nothing",
                 "name design.assumptions that shall hold, the design.resolution that the "
                 "comparison shall have, or design.laws that shall be told apart");
    if (input.axes.empty())
        io::fail(section.place, "", "[design] varies nothing",
                 "add [design.vary] with for example substrate.thickness = {from = \"4 mm\", to = "
                 "\"20 mm\"}");
    if (input.axes.size() > most_design_axes)
        io::fail(input.axes.back().axis.place, "",
                 "[design.vary] has " + std::to_string(input.axes.size()) + " keys, more than " +
                     std::to_string(most_design_axes),
                 "choose the others yourself");
    if (input.resolution && !input.record.scatter && !input.record.step &&
        input.rig.uncertain_of_case().empty())
        io::refuse(document, "design.resolution",
                   "neither a number of the case nor the record is uncertain: any comparison "
                   "would see everything",
                   "write for example thickness = \"8 ± 0.1 mm\", or add design.scatter");
}

/// Closed forms of the half-space tell laws apart, and predict under others than Coulomb's.
void check_friction_of(const DesignInput& input, const io::Document& document) {
    const contact::Case& c = input.rig.c;
    if (input.laws.laws.empty() && c.friction.is_coulomb()) return;
    if (!input.assumptions.empty())
        io::refuse(document, "design.assumptions",
                   c.friction.is_coulomb()
                       ? "the check of rigs is about layers, and design.laws are told apart on the "
                         "half-space"
                       : "the check of rigs presumes Coulomb's law, tau = mu p, and the case has "
                         "tau = " +
                             c.friction.formula(),
                   c.friction.is_coulomb() ? "ask for them in two files"
                                           : "omit it, or give friction.coefficient alone");
    if (!input.laws.laws.empty() && !contact::is_hertz_round(c))
        io::refuse(document, "design.laws", "closed forms of a sphere tell laws of friction apart",
                   "give a sphere or paraboloid without roughness, or omit design.laws");
    if (document.find("friction.map"))
        io::refuse(document, "friction.map",
                   "designs have one law of friction over the whole substrate", "omit it");
    if (c.layer.thickness)
        io::refuse(document, "substrate.thickness",
                   "under laws of friction other than Coulomb's, and to tell them apart, designs "
                   "have closed forms of the half-space",
                   "omit it, or give friction.coefficient alone without design.laws");
    const io::MeasurementLaw* own = law_of(c.friction);
    for (const std::string& name : input.laws.laws) {
        const io::MeasurementLaw& law = io::measurement_law(name);
        if (own && (own == &law || law.contains(*own)))
            io::refuse(
                document, "design.laws",
                name + (own == &law ? " is the law of [friction] itself"
                                    : " contains the law of [friction], " + std::string(own->name) +
                                          ": no table tells them apart"),
                "name others, or state that of [friction] otherwise");
    }
}

}  // namespace

io::RigFile DesignInput::at(const std::vector<double>& fractions) const {
    std::vector<io::Entry> entries;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        io::Entry entry = io::entries_at(axes[i].axis, {fractions[i]}).front();
        if (const auto* number = std::get_if<double>(&entry.value);
            number && !axes[i].uncertainty.empty())
            entry.value = io::shortest(*number);
        if (auto* text = std::get_if<std::string>(&entry.value);
            text && !axes[i].uncertainty.empty())
            *text += ' ' + axes[i].uncertainty;
        entries.push_back(std::move(entry));
    }
    io::RigFile result{.document = rig.document};
    // What is varied takes the place also of what was set on the command line.
    for (io::Entry& entry : result.document.entries)
        if (std::ranges::count(entries, entry.path, &io::Entry::path) > 0) entry.overridden = false;
    io::apply_overrides(result.document, entries, io::case_file_keys());
    result.c = io::resolve_case(result.document, {});
    result.uncertain = io::uncertain_numbers(result.document, result.c);
    result.correlations = io::correlations(result.document, result.uncertain);
    return result;
}

DesignInput read_design(const io::RigFile& rig) {
    const io::Document& document = rig.document;
    DesignInput input{.rig = rig};
    if (!document.find_section("design"))
        io::fail(document.name + ":1:1", "", "missing section [design]",
                 "give what shall hold and what may vary (docs/how-to/design.md)");
    read_keys(input, document);
    const io::Document varied = varied_of(document);
    if (!varied.sections.empty())
        for (io::Study::Axis& axis : io::read_axes(varied, io::case_file_keys())) {
            check(axis);
            std::string uncertainty = uncertainty_of(document, axis.key->path);
            input.axes.push_back({std::move(axis), std::move(uncertainty)});
        }
    check_asked(input, document);
    check_friction_of(input, document);
    return input;
}

}  // namespace tricontact::experiments
