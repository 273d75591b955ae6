#include "experiments/assumptions/rig_reader.h"

#include <algorithm>
#include <array>

#include "experiments/assumptions/measured_quantity.h"
#include "io/case/case_keys.h"
#include "io/keys/field_reader.h"
#include "io/keys/input_file.h"
#include "io/keys/key.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"
#include "io/keys/toml_document.h"

namespace tricontact::experiments {

namespace {

// Place of a quantity; monostate: its part of the rig is absent.
using Target = std::variant<std::monostate, Estimate*, std::optional<Estimate>*>;

// One quantity of a rig file, and its place in a rig, which must outlive it.
struct RigKey : io::Key {
    RigKey(std::string_view name, io::Dimension of, const io::Range& admissible,
           std::string_view shown, Target place)
        : Key(io::quantity_key(name, of, admissible, shown, {},
                               {.required = std::holds_alternative<Estimate*>(place)})),
          target(place) {}
    Target target;
};

constexpr double large = 1e15;
constexpr io::Range positive = io::above_zero(large);
constexpr io::Range poisson_range{-1, 0.5, false, true};

template <class Part, class Member>
Target in_part(std::optional<Part>& part, Member Part::*member) {
    if (!part) return {};
    return &((*part).*member);
}

std::vector<RigKey> rig_keys(RollingRig& rig) {
    using enum io::Dimension;
    auto& [shape, radius, length_of_line, young, poisson] = rig.roller;
    auto& substrate = rig.substrate;
    auto& drive = rig.drive;
    using Pivot = RollingRig::Pivot;
    return {
        {"roller.radius", length, positive, R"("40 mm")", &radius},
        {"roller.length", length, positive, R"("80 mm")", &length_of_line},
        {"roller.young", pressure, positive, R"("206 GPa")", &young},
        {"roller.poisson", none, poisson_range, "0.3", &poisson},
        {"substrate.thickness", length, positive, R"("8 mm")", &substrate.thickness},
        {"substrate.young", pressure, positive, R"("5.2 MPa")", &substrate.young},
        {"substrate.poisson", none, poisson_range, "0.5", &substrate.poisson},
        {"substrate.density", density, positive, R"("1100 kg/m3")", &substrate.density},
        {"substrate.viscosity", viscosity, positive, R"("40 Pa s")", &substrate.viscosity},
        {"substrate.maxwell_ratio", none, positive, "10", &substrate.maxwell_ratio},
        {"friction.coefficient", none, io::above_zero(100), "0.57", &rig.friction_coefficient},
        {"load.normal_force", force, positive, R"("21.1 N")", &rig.normal_force},
        {"drive.speed", velocity, positive, R"("1 mm/s")", &drive.speed},
        {"drive.smallest_amplitude_ratio", none, io::above_zero(1), "0.25",
         &drive.smallest_amplitude_ratio},
        {"drive.reference_radius", length, positive, R"("4.56 mm")", &drive.reference_radius},
        {"drive.eigenfrequency", frequency, positive, R"("22 Hz")", &drive.eigenfrequency},
        {"pivot.displacement", length, positive, R"("1.55 ± 0.13 um")",
         in_part(rig.pivot, &Pivot::displacement)},
        {"pivot.amplitude_ratio", none, io::above_zero(1), "0.75",
         in_part(rig.pivot, &Pivot::amplitude_ratio)},
        {"measured.contact_size", length, positive, R"("9.0 ± 0.5 mm")",
         &rig.measured_contact_size},
    };
}

std::vector<RigKey> rig_keys(WalkingRig& rig) {
    using enum io::Dimension;
    auto& specimen = rig.specimen;
    auto& spring = rig.spring;
    using Oscillation = WalkingRig::Oscillation;
    return {
        {"specimen.mass", mass, positive, R"("201 g")", &specimen.mass},
        {"specimen.disc_diameter", length, positive, R"("60 mm")", &specimen.disc_diameter},
        {"specimen.disc_length", length, positive, R"("5 mm")", &specimen.disc_length},
        {"specimen.centre_length", length, positive, R"("18 mm")", &specimen.centre_length},
        {"specimen.edge_radius", length, positive, R"("5 mm")", &specimen.edge_radius},
        {"specimen.young", pressure, positive, R"("1.4 GPa")", &specimen.young},
        {"specimen.poisson", none, poisson_range, "0.4", &specimen.poisson},
        {"substrate.young", pressure, positive, R"("90 GPa")", &rig.substrate.young},
        {"substrate.poisson", none, poisson_range, "0.3", &rig.substrate.poisson},
        {"friction.coefficient", none, io::above_zero(100), R"("0.75 ± 0.03")",
         &rig.friction_coefficient},
        {"contact.diameter", length, positive, R"("1.8 ± 1.2 mm")", &rig.contact.diameter},
        {"contact.wear_diameter", length, positive, R"("2 mm")", &rig.contact.wear_diameter},
        {"spring.stiffness", stiffness, positive, R"("2.42e5 ± 0.14e5 N/m")", &spring.stiffness},
        {"spring.sensor_stiffness", stiffness, positive, R"("2e7 N/m")", &spring.sensor_stiffness},
        {"spring.length", length, positive, R"("100 mm")", &spring.length},
        {"spring.young", pressure, positive, R"("3.42 ± 0.02 GPa")", &spring.young},
        {"spring.height_ratio", none, {-1, 1, false, true}, "-0.47", &spring.height_ratio},
        {"oscillation.frequency", frequency, positive, R"("240 ± 62 Hz")",
         in_part(rig.oscillation, &Oscillation::frequency)},
        {"oscillation.simulated", none, positive, R"("0.1 ± 0.006")",
         in_part(rig.oscillation, &Oscillation::simulated)},
        {"oscillation.time", time, positive, R"("4.7e-4 ± 1.5e-4 s")",
         in_part(rig.oscillation, &Oscillation::time)},
        {"oscillation.sampling_rate", frequency, positive, R"("4000 Hz")",
         in_part(rig.oscillation, &Oscillation::sampling_rate)},
    };
}

constexpr std::string_view printed = "printed";

bool is_printed(std::string_view path) {
    return path.starts_with("printed.");
}

// A table in [printed]: value and source of one quantity.
bool is_printed_value(std::string_view path) {
    return is_printed(path) && io::section_of(path) == printed;
}

void check_tables(const io::Document& document) {
    for (const io::Entry& entry : document.entries)
        if (io::section_of(entry.path) == printed)
            io::fail(entry.place, entry.subject(), "must be a table",
                     "write " + std::string(io::name_of_key(entry.path)) +
                         R"( = {value = "4.56 mm", source = "table 5.1.1"})");
}

MeasuredQuantity measured(const io::Entry& entry, io::Dimension dimension) {
    try {
        if (const auto* text = std::get_if<std::string>(&entry.value))
            return parse_measured_quantity(*text, dimension);
        if (dimension == io::Dimension::none) {
            if (const auto* whole = std::get_if<std::int64_t>(&entry.value))
                return {{static_cast<double>(*whole), 0}};
            if (const auto* number = std::get_if<double>(&entry.value)) return {{*number, 0}};
        }
        throw io::QuantityError{
            "must be " + std::string(io::name_of(dimension)) +
                (dimension == io::Dimension::none ? "" : " with its unit in quotes") + ", but is " +
                std::string(io::kind_of(entry.value)),
            "write for example " + io::toml_string(io::example_of(dimension))};
    } catch (const io::QuantityError& error) {
        io::fail(entry.place, entry.subject(), error.rule, error.remedy);
    }
}

// What is propagated is evaluated within the errors.
void check_range(const io::Entry& entry, const RigKey& key, const Estimate& quantity) {
    const double value = quantity.value, error = quantity.standard_error;
    const bool inside = key.range.contains(value);
    if (inside && key.range.contains(value - error) && key.range.contains(value + error)) return;
    io::fail(entry.place, entry.subject(),
             (inside ? "with its error it " : "") + io::range_rule(key),
             "write for example " + std::string(key.name()) + " = " + std::string(key.example));
}

void read_key(const io::Document& document, const RigKey& key, const io::KeyList& keys) {
    const io::Entry* entry = document.find(key.path);
    if (!entry && key.required) io::refuse_missing(key, document, keys);
    if (!entry) return;
    const Estimate quantity = measured(*entry, key.dimension).quantity;
    check_range(*entry, key, quantity);
    if (auto* const* place = std::get_if<Estimate*>(&key.target)) **place = quantity;
    if (auto* const* place = std::get_if<std::optional<Estimate>*>(&key.target)) **place = quantity;
}

PrintedValue printed_value(const io::Document& document, const io::Document::Section& section,
                           const std::vector<PrintedKey>& keys) {
    const std::string_view name = io::name_of_key(section.name);
    const auto key = std::ranges::find(keys, name, &PrintedKey::name);
    if (key == keys.end()) {
        std::vector<std::string_view> names;
        for (const PrintedKey& one : keys) names.push_back(one.name);
        const std::string known =
            "known are " + io::joined(names, [](std::string_view one) { return one; });
        io::fail(section.place, "", "unknown printed quantity " + std::string(name),
                 io::did_you_mean(io::likely_path(name, names), known));
    }
    PrintedValue value;
    value.name = name;
    for (const std::string_view part : {"value", "source"})
        if (!document.find(section.name + '.' + std::string(part)))
            io::fail(section.place, "", "missing key " + section.name + '.' + std::string(part),
                     R"(write {value = "4.56 mm", source = "table 5.1.1"})");
    for (const io::Entry& entry : document.entries) {
        if (io::section_of(entry.path) != section.name) continue;
        const std::string_view part = io::name_of_key(entry.path);
        constexpr std::array<std::string_view, 2> parts{"value", "source"};
        if (std::ranges::count(parts, part) == 0)
            io::fail(entry.key_place, "", "unknown key " + entry.path,
                     io::did_you_mean(io::likely_path(part, parts), "known are value, source"));
        const auto* text = std::get_if<std::string>(&entry.value);
        if (!text)
            io::fail(entry.place, entry.subject(),
                     "must be a text in quotes, but is " + std::string(io::kind_of(entry.value)),
                     "write what is printed, with all its digits");
        (part == "value" ? value.text : value.source) = *text;
        if (part != "value") continue;
        const MeasuredQuantity quantity = measured(entry, key->dimension);
        value.value = quantity.quantity;
        value.half_digit = quantity.half_digit;
        value.half_error_digit = quantity.half_error_digit;
    }
    return value;
}

const io::Key& kind_key() {
    static const io::Key key = io::choice_key("rig", {{"rolling"}, {"micro-walking"}},
                                              R"("rolling")", "kind of experiment");
    return key;
}

const io::Key& shape_key() {
    using enum RollingRig::Shape;
    static const io::Key key = io::choice_key(
        "roller.shape", {io::choice("sphere", sphere), io::choice("cylinder", cylinder)},
        R"("sphere")", "shape of the roller");
    return key;
}

// `words`: keys of this kind of rig that hold no quantity.
template <class Data>
Data read(Data rig, const io::Document& document, std::vector<const io::Key*> words) {
    const auto keys = rig_keys(rig);
    const io::Key* const title = io::find_key("title");
    words.insert(words.end(), {title, &kind_key()});
    for (const RigKey& key : keys) words.push_back(&key);
    const io::KeyList all(words, {});
    check_tables(document);
    io::check_names(document, all, {.sections = {printed}, .is_open = is_printed});
    if (const io::Entry* entry = document.find("title"))
        io::read_field(*title, *entry, io::Field(&rig.title));
    for (const RigKey& key : keys) read_key(document, key, all);
    for (const auto& section : document.sections)
        if (is_printed_value(section.name))
            rig.printed.push_back(printed_value(document, section, printed_keys(rig)));
    return rig;
}

RollingRig read_rolling(const io::Document& document) {
    RollingRig rig;
    if (document.find_section("pivot")) rig.pivot = RollingRig::Pivot{};
    rig = read(rig, document, {&shape_key()});
    io::read_field(shape_key(), document.required("roller.shape", "add shape = \"sphere\""),
                   io::Field(&rig.roller.shape));
    const bool cylinder = rig.roller.shape == RollingRig::Shape::cylinder;
    const io::Entry* length = document.find("roller.length");
    if (length && !cylinder)
        io::fail(length->place, length->subject(), "a sphere has no length", "omit this key");
    if (cylinder) document.required("roller.length", "add length = \"80 mm\"");
    return rig;
}

}  // namespace

const std::vector<PrintedKey>& printed_keys(const RollingRig&) {
    using enum io::Dimension;
    static const std::vector<PrintedKey> keys = {
        {"contact_radius", length},
        {"contact_width", length},
        {"indentation", length},
        {"shear_modulus", pressure},
        {"excitation_frequency", frequency},
        {"drive_speed", velocity},
        {"pivot_height_error", length},
        {"pivot_displacement", length},
        {"thickness_ratio", none},
        {"length_ratio", none},
        {"edge_exponent", none},
        {"viscous_ratio", none},
    };
    return keys;
}

const std::vector<PrintedKey>& printed_keys(const WalkingRig&) {
    using enum io::Dimension;
    static const std::vector<PrintedKey> keys = {
        {"half_height", length},
        {"half_width", length},
        {"hertz_diameter", length},
        {"contact_diameter", length},
        {"contact_stiffness", stiffness},
        {"contact_stiffness_of_means", stiffness},
        {"characteristic_time", time},
        {"nyquist_rate", frequency},
        {"spring_stiffness", stiffness},
        {"kappa1", none},
        {"kappa2", none},
        {"kappa3", none},
        {"kappa4", none},
        {"beam_force_ratio", none},
        {"beam_moment_ratio", none},
        {"rod_radius", length},
    };
    return keys;
}

Rig parse_rig(std::string_view text, const std::string& name) {
    const io::Document document = io::parse_document(text, name, is_printed_value);
    io::require_kind(io::FileKind::rig, document);
    const io::Entry& kind =
        document.required("rig", "add rig = \"rolling\" or rig = \"micro-walking\" at the top");
    if (io::read_choice(kind_key(), kind).word == "rolling") return read_rolling(document);
    WalkingRig rig;
    if (document.find_section("oscillation")) rig.oscillation = WalkingRig::Oscillation{};
    return read(rig, document, {});
}

Rig read_rig(const std::string& path) {
    return parse_rig(io::read_input_file(path, "rig file"), path);
}

}  // namespace tricontact::experiments
