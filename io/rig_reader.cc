#include "io/rig_reader.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "io/case_keys.h"
#include "io/field_reader.h"
#include "io/file_kind.h"
#include "io/input_file.h"
#include "io/key_guess.h"
#include "io/key_kinds.h"
#include "io/measured_quantity.h"
#include "io/messages.h"
#include "io/rig_keys.h"
#include "io/toml_document.h"

namespace tricontact::io {

namespace {

using contact::RollingRig;
using contact::Uncertain;
using contact::WalkingRig;

constexpr std::string_view printed = "printed";

// A table in [printed]: value and source of one quantity.
bool is_printed_value(std::string_view path) {
    return path.starts_with("printed.") && section_of(path) == printed;
}

[[noreturn]] void refuse_unknown(const std::string& place, const std::string& what,
                                 std::string_view word,
                                 const std::vector<std::string_view>& known) {
    std::string remedy = "known are ";
    for (const auto one : known) remedy.append(&one == &known.front() ? "" : ", ").append(one);
    fail(place, "", "unknown " + what, did_you_mean(likely_path(word, known), remedy));
}

std::vector<std::string_view> sections_of(const std::vector<RigKey>& keys) {
    std::set<std::string_view> names{printed};
    for (const RigKey& key : keys) names.insert(section_of(key.path));
    return {names.begin(), names.end()};
}

void check_sections(const Document& document, const std::vector<RigKey>& keys) {
    const auto known = sections_of(keys);
    for (const auto& section : document.sections)
        if (!is_printed_value(section.name) &&
            std::ranges::find(known, section.name) == known.end())
            refuse_unknown(section.place, "section [" + section.name + "]", section.name, known);
}

// `words`: keys of this kind of rig that hold no quantity.
void check_keys(const Document& document, const std::vector<RigKey>& keys,
                const std::vector<std::string_view>& words) {
    for (const Entry& entry : document.entries) {
        if (is_printed_value(section_of(entry.path))) continue;
        std::vector<std::string_view> known;
        for (const RigKey& key : keys)
            if (section_of(key.path) == section_of(entry.path)) known.push_back(key.path);
        for (const auto word : words)
            if (section_of(word) == section_of(entry.path)) known.push_back(word);
        if (section_of(entry.path) == printed)
            fail(entry.place, entry.subject(), "must be a table",
                 "write " + std::string(name_of_key(entry.path)) +
                     R"( = {value = "4.56 mm", source = "table 5.1.1"})");
        if (std::ranges::find(known, entry.path) == known.end())
            refuse_unknown(entry.key_place, "key " + entry.path, entry.path, known);
    }
}

MeasuredQuantity measured(const Entry& entry, Dimension dimension) {
    try {
        if (const auto* text = std::get_if<std::string>(&entry.value))
            return parse_measured_quantity(*text, dimension);
        if (dimension == Dimension::none) {
            if (const auto* whole = std::get_if<std::int64_t>(&entry.value))
                return {{static_cast<double>(*whole), 0}};
            if (const auto* number = std::get_if<double>(&entry.value)) return {{*number, 0}};
        }
        throw QuantityError{"must be " + std::string(name_of(dimension)) +
                                (dimension == Dimension::none ? "" : " with its unit in quotes") +
                                ", but is " + std::string(kind_of(entry.value)),
                            "write for example " + toml_string(example_of(dimension))};
    } catch (const QuantityError& error) {
        fail(entry.place, entry.subject(), error.rule, error.remedy);
    }
}

// What is propagated is evaluated within the errors.
void check_range(const Entry& entry, const RigKey& key, const Uncertain& quantity) {
    const auto [value, error] = quantity;
    const bool inside = key.range.contains(value);
    if (inside && key.range.contains(value - error) && key.range.contains(value + error)) return;
    const std::string unit =
        key.dimension == Dimension::none ? "" : ' ' + std::string(si_unit(key.dimension));
    fail(entry.place, entry.subject(),
         std::string(inside ? "with its error it " : "") + "must be " +
             std::string(key.range.low_included ? "at least " : "greater than ") +
             shortest(key.range.low) + unit + " and at most " + shortest(key.range.high) + unit,
         "write for example " + std::string(name_of_key(key.path)) + " = " +
             std::string(key.example));
}

void read_key(const Document& document, const RigKey& key) {
    const Entry* entry = document.find(key.path);
    if (!entry) {
        const std::string section(section_of(key.path));
        const std::string missing =
            document.find_section(section) ? "add " : "add a section [" + section + "] with ";
        if (key.required())
            fail(document.place_of(key.path), "", "missing key " + std::string(key.path),
                 missing + std::string(name_of_key(key.path)) + " = " + std::string(key.example));
        return;
    }
    const Uncertain quantity = measured(*entry, key.dimension).quantity;
    check_range(*entry, key, quantity);
    if (auto* const* place = std::get_if<Uncertain*>(&key.target)) **place = quantity;
    if (auto* const* place = std::get_if<std::optional<Uncertain>*>(&key.target))
        **place = quantity;
}

contact::PrintedValue printed_value(const Document& document, const Document::Section& section,
                                    const std::vector<PrintedKey>& keys) {
    const std::string_view name = name_of_key(section.name);
    const auto key = std::ranges::find(keys, name, &PrintedKey::name);
    if (key == keys.end()) {
        std::vector<std::string_view> known;
        for (const PrintedKey& one : keys) known.push_back(one.name);
        refuse_unknown(section.place, "printed quantity " + std::string(name), name, known);
    }
    contact::PrintedValue value;
    value.name = name;
    for (const std::string_view part : {"value", "source"})
        if (!document.find(section.name + '.' + std::string(part)))
            fail(section.place, "", "missing key " + section.name + '.' + std::string(part),
                 R"(write {value = "4.56 mm", source = "table 5.1.1"})");
    for (const Entry& entry : document.entries) {
        if (section_of(entry.path) != section.name) continue;
        const std::string_view part = name_of_key(entry.path);
        if (part != "value" && part != "source")
            refuse_unknown(entry.key_place, "key " + entry.path, part, {"value", "source"});
        const auto* text = std::get_if<std::string>(&entry.value);
        if (!text)
            fail(entry.place, entry.subject(),
                 "must be a text in quotes, but is " + std::string(kind_of(entry.value)),
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
Data read(Data rig, const Document& document, const std::vector<std::string_view>& words) {
    const auto keys = rig_keys(rig);
    check_sections(document, keys);
    check_keys(document, keys, words);
    if (const Entry* title = document.find("title"))
        read_field(*find_key("title"), *title, Field(&rig.title));
    for (const RigKey& key : keys) read_key(document, key);
    for (const auto& section : document.sections)
        if (is_printed_value(section.name))
            rig.printed.push_back(printed_value(document, section, printed_keys(rig)));
    return rig;
}

RollingRig read_rolling(const Document& document) {
    RollingRig rig;
    if (document.find_section("pivot")) rig.pivot = RollingRig::Pivot{};
    rig = read(rig, document, {"title", "rig", "roller.shape"});
    const Entry& shape = document.required("roller.shape", "add shape = \"sphere\"");
    const Key shape_key = choice_key("roller.shape", {{"sphere"}, {"cylinder"}}, R"("sphere")",
                                     "shape of the roller");
    const bool cylinder = read_choice(shape_key, shape).word == "cylinder";
    rig.roller.shape = cylinder ? RollingRig::Shape::cylinder : RollingRig::Shape::sphere;
    const Entry* length = document.find("roller.length");
    if (length && !cylinder)
        fail(length->place, length->subject(), "a sphere has no length", "omit this key");
    if (cylinder) document.required("roller.length", "add length = \"80 mm\"");
    return rig;
}

WalkingRig read_walking(const Document& document) {
    WalkingRig rig;
    if (document.find_section("oscillation")) rig.oscillation = WalkingRig::Oscillation{};
    return read(rig, document, {"title", "rig"});
}

}  // namespace

Rig parse_rig(std::string_view text, const std::string& name) {
    const Document document = parse_document(text, name, is_printed_value);
    require_kind(FileKind::rig, document);
    const Entry& kind =
        document.required("rig", "add rig = \"rolling\" or rig = \"micro-walking\" at the top");
    const Key key =
        choice_key("rig", {{"rolling"}, {"micro-walking"}}, R"("rolling")", "kind of experiment");
    if (read_choice(key, kind).word == "rolling") return read_rolling(document);
    return read_walking(document);
}

Rig read_rig(const std::string& path) {
    return parse_rig(read_input_file(path, "rig file"), path);
}

}  // namespace tricontact::io
