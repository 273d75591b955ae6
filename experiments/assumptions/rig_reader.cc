#include "experiments/assumptions/rig_reader.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "experiments/assumptions/measured_quantity.h"
#include "experiments/assumptions/rig_keys.h"
#include "io/case/case_keys.h"
#include "io/keys/field_reader.h"
#include "io/keys/file_kind.h"
#include "io/keys/input_file.h"
#include "io/keys/key_guess.h"
#include "io/keys/key_kinds.h"
#include "io/keys/messages.h"
#include "io/keys/toml_document.h"

namespace tricontact::experiments {

namespace {

using statistics::Uncertain;

constexpr std::string_view printed = "printed";

// A table in [printed]: value and source of one quantity.
bool is_printed_value(std::string_view path) {
    return path.starts_with("printed.") && io::section_of(path) == printed;
}

[[noreturn]] void refuse_unknown(const std::string& place, const std::string& what,
                                 std::string_view word,
                                 const std::vector<std::string_view>& known) {
    std::string remedy = "known are ";
    for (const auto one : known) remedy.append(&one == &known.front() ? "" : ", ").append(one);
    io::fail(place, "", "unknown " + what, io::did_you_mean(io::likely_path(word, known), remedy));
}

std::vector<std::string_view> sections_of(const std::vector<RigKey>& keys) {
    std::set<std::string_view> names{printed};
    for (const RigKey& key : keys) names.insert(io::section_of(key.path));
    return {names.begin(), names.end()};
}

void check_sections(const io::Document& document, const std::vector<RigKey>& keys) {
    const auto known = sections_of(keys);
    for (const auto& section : document.sections)
        if (!is_printed_value(section.name) &&
            std::ranges::find(known, section.name) == known.end())
            refuse_unknown(section.place, "section [" + section.name + "]", section.name, known);
}

// `words`: keys of this kind of rig that hold no quantity.
void check_keys(const io::Document& document, const std::vector<RigKey>& keys,
                const std::vector<std::string_view>& words) {
    for (const io::Entry& entry : document.entries) {
        if (is_printed_value(io::section_of(entry.path))) continue;
        std::vector<std::string_view> known;
        for (const RigKey& key : keys)
            if (io::section_of(key.path) == io::section_of(entry.path)) known.push_back(key.path);
        for (const auto word : words)
            if (io::section_of(word) == io::section_of(entry.path)) known.push_back(word);
        if (io::section_of(entry.path) == printed)
            io::fail(entry.place, entry.subject(), "must be a table",
                     "write " + std::string(io::name_of_key(entry.path)) +
                         R"( = {value = "4.56 mm", source = "table 5.1.1"})");
        if (std::ranges::find(known, entry.path) == known.end())
            refuse_unknown(entry.key_place, "key " + entry.path, entry.path, known);
    }
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
void check_range(const io::Entry& entry, const RigKey& key, const Uncertain& quantity) {
    const auto [value, error] = quantity;
    const bool inside = key.range.contains(value);
    if (inside && key.range.contains(value - error) && key.range.contains(value + error)) return;
    const std::string unit =
        key.dimension == io::Dimension::none ? "" : ' ' + std::string(io::si_unit(key.dimension));
    io::fail(entry.place, entry.subject(),
             std::string(inside ? "with its error it " : "") + "must be " +
                 std::string(key.range.low_included ? "at least " : "greater than ") +
                 io::shortest(key.range.low) + unit + " and at most " +
                 io::shortest(key.range.high) + unit,
             "write for example " + std::string(io::name_of_key(key.path)) + " = " +
                 std::string(key.example));
}

void read_key(const io::Document& document, const RigKey& key) {
    const io::Entry* entry = document.find(key.path);
    if (!entry) {
        const std::string section(io::section_of(key.path));
        const std::string missing =
            document.find_section(section) ? "add " : "add a section [" + section + "] with ";
        if (key.required())
            io::fail(document.place_of(key.path), "", "missing key " + std::string(key.path),
                     missing + std::string(io::name_of_key(key.path)) + " = " +
                         std::string(key.example));
        return;
    }
    const Uncertain quantity = measured(*entry, key.dimension).quantity;
    check_range(*entry, key, quantity);
    if (auto* const* place = std::get_if<Uncertain*>(&key.target)) **place = quantity;
    if (auto* const* place = std::get_if<std::optional<Uncertain>*>(&key.target))
        **place = quantity;
}

PrintedValue printed_value(const io::Document& document, const io::Document::Section& section,
                           const std::vector<PrintedKey>& keys) {
    const std::string_view name = io::name_of_key(section.name);
    const auto key = std::ranges::find(keys, name, &PrintedKey::name);
    if (key == keys.end()) {
        std::vector<std::string_view> known;
        for (const PrintedKey& one : keys) known.push_back(one.name);
        refuse_unknown(section.place, "printed quantity " + std::string(name), name, known);
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
        if (part != "value" && part != "source")
            refuse_unknown(entry.key_place, "key " + entry.path, part, {"value", "source"});
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

template <class Data>
Data read(Data rig, const io::Document& document, const std::vector<std::string_view>& words) {
    const auto keys = rig_keys(rig);
    check_sections(document, keys);
    check_keys(document, keys, words);
    if (const io::Entry* title = document.find("title"))
        io::read_field(*io::find_key("title"), *title, io::Field(&rig.title));
    for (const RigKey& key : keys) read_key(document, key);
    for (const auto& section : document.sections)
        if (is_printed_value(section.name))
            rig.printed.push_back(printed_value(document, section, printed_keys(rig)));
    return rig;
}

RollingRig read_rolling(const io::Document& document) {
    RollingRig rig;
    if (document.find_section("pivot")) rig.pivot = RollingRig::Pivot{};
    rig = read(rig, document, {"title", "rig", "roller.shape"});
    const io::Entry& shape = document.required("roller.shape", "add shape = \"sphere\"");
    const io::Key shape_key = io::choice_key("roller.shape", {{"sphere"}, {"cylinder"}},
                                             R"("sphere")", "shape of the roller");
    const bool cylinder = io::read_choice(shape_key, shape).word == "cylinder";
    rig.roller.shape = cylinder ? RollingRig::Shape::cylinder : RollingRig::Shape::sphere;
    const io::Entry* length = document.find("roller.length");
    if (length && !cylinder)
        io::fail(length->place, length->subject(), "a sphere has no length", "omit this key");
    if (cylinder) document.required("roller.length", "add length = \"80 mm\"");
    return rig;
}

WalkingRig read_walking(const io::Document& document) {
    WalkingRig rig;
    if (document.find_section("oscillation")) rig.oscillation = WalkingRig::Oscillation{};
    return read(rig, document, {"title", "rig"});
}

}  // namespace

Rig parse_rig(std::string_view text, const std::string& name) {
    const io::Document document = io::parse_document(text, name, is_printed_value);
    io::require_kind(io::FileKind::rig, document);
    const io::Entry& kind =
        document.required("rig", "add rig = \"rolling\" or rig = \"micro-walking\" at the top");
    const io::Key key = io::choice_key("rig", {{"rolling"}, {"micro-walking"}}, R"("rolling")",
                                       "kind of experiment");
    if (io::read_choice(key, kind).word == "rolling") return read_rolling(document);
    return read_walking(document);
}

Rig read_rig(const std::string& path) {
    return parse_rig(io::read_input_file(path, "rig file"), path);
}

}  // namespace tricontact::experiments
