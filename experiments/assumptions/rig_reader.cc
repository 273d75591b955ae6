#include <algorithm>
#include <array>
#include <functional>

#include "experiments/assumptions/rig.h"
#include "io/case/case_keys.h"
#include "io/keys/field_reader.h"
#include "io/keys/input_file.h"
#include "io/keys/key.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"
#include "io/keys/toml_document.h"

namespace tricontact::experiments {

namespace {

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

PrintedValue printed_value(const io::Document& document, const io::Document::Section& section,
                           const std::vector<PrintedKey>& keys) {
    const std::string_view name = io::name_of_key(section.name);
    const auto key = std::ranges::find(keys, name, &PrintedKey::name);
    if (key == keys.end()) {
        std::vector<std::string_view> names;
        for (const PrintedKey& one : keys) names.push_back(one.name);
        const std::string known = "known are " + io::joined(names, std::identity());
        io::fail(section.place, "", "unknown printed quantity " + std::string(name),
                 io::did_you_mean(io::likely_path(name, names), known));
    }
    constexpr std::array<std::string_view, 2> parts{"value", "source"};
    for (const std::string_view part : parts)
        if (!document.find(section.name + '.' + std::string(part)))
            io::fail(section.place, "", "missing key " + section.name + '.' + std::string(part),
                     R"(write {value = "4.56 mm", source = "table 5.1.1"})");
    PrintedValue result;
    for (const io::Entry& entry : document.entries) {
        if (io::section_of(entry.path) != section.name) continue;
        const std::string_view part = io::name_of_key(entry.path);
        if (std::ranges::count(parts, part) == 0)
            io::fail(entry.key_place, "", "unknown key " + entry.path,
                     io::did_you_mean(io::likely_path(part, parts), "known are value, source"));
        const auto* text = std::get_if<std::string>(&entry.value);
        if (!text)
            io::fail(entry.place, entry.subject(),
                     "must be a text in quotes, but is " + std::string(io::kind_of(entry.value)),
                     "write what is printed, with all its digits");
        if (part == "value")
            result = {measured(entry, key->dimension), std::string(name), *text, result.source};
        else
            result.source = *text;
    }
    return result;
}

const io::Key& kind_key() {
    static const io::Key key = io::choice_key("rig", {{"rolling"}, {"micro-walking"}},
                                              R"("rolling")", "kind of experiment");
    return key;
}

const io::Key& shape_key() {
    using enum Rig::Kind;
    static const io::Key key = io::choice_key(
        "roller.shape", {io::choice("sphere", sphere), io::choice("cylinder", cylinder)},
        R"("sphere")", "shape of the roller");
    return key;
}

void read_data(Rig& rig, const io::Document& document) {
    const auto& keys = rig_keys(rig.kind);
    const io::Key* const title = io::find_key("title");
    std::vector<const io::Key*> known{title, &kind_key()};
    if (rig.kind != Rig::Kind::micro_walking) known.push_back(&shape_key());
    for (const RigKey& key : keys) known.push_back(&key);
    const io::KeyList all(known, {});
    check_tables(document);
    io::check_names(document, all, {.sections = {printed}, .is_open = is_printed});
    if (const io::Entry* entry = document.find("title"))
        io::read_field(*title, *entry, io::Field(&rig.title));
    for (const RigKey& key : keys) {
        const std::string section(key.section());
        if (const io::Entry* entry = document.find(key.path)) {
            const Estimate quantity = measured(*entry, key.dimension).value;
            check_range(*entry, key, quantity);
            rig.data[std::string(key.symbol)] = quantity;
        } else if (const bool may_lack = section == "pivot" || section == "oscillation";
                   key.required && (!may_lack || document.find_section(section))) {
            io::refuse_missing(key, document, all);
        }
    }
    for (const auto& section : document.sections)
        if (is_printed_value(section.name))
            rig.printed.push_back(printed_value(document, section, printed_keys(rig.kind)));
}

void read_shape(Rig& rig, const io::Document& document) {
    io::read_field(shape_key(), document.required("roller.shape", "add shape = \"sphere\""),
                   io::Field(&rig.kind));
    if (document.find("roller.length") && rig.kind == Rig::Kind::sphere)
        io::refuse(document, "roller.length", "a sphere has no length", "omit this key");
    if (rig.kind == Rig::Kind::cylinder)
        document.required("roller.length", "add length = \"80 mm\"");
}

}  // namespace

Rig parse_rig(std::string_view text, const std::string& name) {
    const io::Document document = io::parse_document(text, name, is_printed_value);
    io::require_kind(io::FileKind::rig, document);
    const io::Entry& kind =
        document.required("rig", "add rig = \"rolling\" or rig = \"micro-walking\" at the top");
    Rig rig;
    const bool rolling = io::read_choice(kind_key(), kind).word == "rolling";
    if (!rolling) rig.kind = Rig::Kind::micro_walking;
    read_data(rig, document);
    if (rolling) read_shape(rig, document);
    return rig;
}

Rig read_rig(const std::string& path) {
    return parse_rig(io::read_input_file(path, "rig file"), path);
}

}  // namespace tricontact::experiments
