#include "io/case/rig_file.h"

#include <algorithm>
#include <stdexcept>

#include "contact/models/model_kind.h"
#include "io/case/case_reader.h"
#include "io/case/rig_keys.h"
#include "io/case/study_reader.h"
#include "io/keys/field_reader.h"
#include "io/keys/input_file.h"
#include "io/keys/key_checks.h"
#include "io/keys/number_text.h"

namespace tricontact::io {

namespace {

bool is_setting(const Key& key) {
    const std::string_view section = key.section();
    return contact::is_model_section(section) || section == "output" || section == "time" ||
           key.path == "rolling.increment";
}

bool has_uncertainty(const Entry& entry) {
    const auto* text = std::get_if<std::string>(&entry.value);
    return text && states_uncertainty(*text);
}

Document case_document(std::string_view text, const std::string& name,
                       const std::vector<std::string>& overrides) {
    Document document = parse_document(text, name);
    require_kind(FileKind::contact, document);
    apply_overrides(document, overrides, case_file_keys());
    return document;
}

// What is propagated is evaluated within the errors.
void check_range(const Entry& entry, const Key& key, const statistics::Estimate& number) {
    const double error = number.standard_error;
    if (key.range.contains(number.value - error) && key.range.contains(number.value + error))
        return;
    // At the end of its range, such as nu = 1/2, a number is uncertain to the other side.
    if (number.value == key.range.high && key.range.contains(number.value - error)) return;
    fail(entry.place, entry.subject(), "with its error it " + range_rule(key),
         "write for example " + std::string(key.name()) + " = " + std::string(key.example));
}

/// Both keys of "first and second".
std::pair<std::string, std::string> keys_of_pair(const Entry& entry) {
    constexpr std::string_view between = " and ";
    std::string_view name = name_of_key(entry.path);
    if (name.size() > 1 && (name.front() == '"' || name.front() == '\''))
        name = name.substr(1, name.size() - 2);
    const auto at = name.find(between);
    if (at == std::string_view::npos)
        fail(entry.key_place, "", "unknown key " + entry.path,
             "name two numbers: \"substrate.young and friction.coefficient\" = 0.5");
    return {std::string(trimmed(name.substr(0, at))),
            std::string(trimmed(name.substr(at + between.size())))};
}

double coefficient_of(const Entry& entry) {
    double coefficient = 0;
    read_field(number_key(entry.path, {-1, 1, false, false}, "0.5", "coefficient of correlation"),
               entry, Field(&coefficient));
    return coefficient;
}

}  // namespace

statistics::Correlations correlations(const Document& document,
                                      const std::vector<UncertainKey>& uncertain) {
    statistics::Correlations all;
    std::vector<std::string> names;
    for (const UncertainKey& one : uncertain) names.emplace_back(one.key->path);
    const Entry* last = nullptr;
    for (const Entry& entry : document.entries) {
        if (!entry.path.starts_with("correlation.")) continue;
        const auto [first, second] = keys_of_pair(entry);
        for (const std::string& name : {first, second})
            if (std::ranges::count(names, name) == 0)
                fail(entry.key_place, entry.subject(), name + " states no uncertainty",
                     names.empty() ? "write for example young = \"5.2 MPa ± 5 %\""
                                   : "uncertain are " + joined(names));
        try {
            all.add(first, second, coefficient_of(entry));
        } catch (const std::invalid_argument& error) {
            fail(entry.key_place, entry.subject(), error.what(), "keep one coefficient per pair");
        }
        last = &entry;
    }
    if (last && !all.is_possible(names))
        fail(last->place, "[correlation]",
             "no numbers can be correlated like this: the matrix is not positive definite",
             "lower the coefficients");
    return all;
}

std::vector<UncertainKey> uncertain_keys(const Document& document, const KeyList& keys) {
    std::vector<UncertainKey> uncertain;
    for (const Entry& entry : document.entries) {
        const Key* key = keys.find(entry.path);
        const bool is_number =
            key && (key->kind == Key::Kind::number || key->kind == Key::Kind::quantity);
        if (!is_number || !has_uncertainty(entry)) continue;
        if (is_setting(*key))
            fail(entry.place, entry.subject(),
                 "is a setting of the computation, and has no uncertainty", "omit what follows ±");
        const UncertainNumber number = read_uncertain_number(*key, entry);
        check_range(entry, *key, number.value);
        if (number.value.standard_error > 0) uncertain.push_back({key, number, entry.place});
    }
    return uncertain;
}

void check_known_of_rig(const Document& document, const KeyList& all,
                        const std::vector<Key>& rig_keys) {
    check_known(document, all,
                {.sections = {"printed", "correlation"}, .is_open = is_read_elsewhere});
    for (const Key& key : rig_keys)
        if (const Entry* entry = document.find(key.path)) read_field(key, *entry, {});
    correlations(document, uncertain_keys(document, all));
}

Document read_rig_document(const std::string& path, const std::vector<std::string>& overrides) {
    Document document = case_document(read_input_file(path), path, overrides);
    check_known_of_rig(document, case_file_keys(), rolling_rig_keys());
    return document;
}

Document read_rig_document(const std::string& path, const std::vector<std::string>& overrides,
                           std::string_view section, const std::string& missing,
                           const std::string& remedy) {
    Document document = read_rig_document(path, overrides);
    if (!document.find_section(section))
        fail(path + ":1:1", "", "missing section [" + std::string(section) + "]: " + missing,
             remedy);
    return document;
}

std::vector<UncertainKey> RigFile::uncertain_of_case() const {
    std::vector<UncertainKey> result;
    std::ranges::copy_if(uncertain, std::back_inserter(result),
                         [](const UncertainKey& one) { return find_key(one.key->path); });
    return result;
}

namespace {

std::vector<std::string> parts_of(const Document& document) {
    std::vector<std::string> parts;
    for (const char* section : {"rig", "record", "measurement", "design", "printed"}) {
        if (!document.find_section(section)) continue;
        const auto is_of_case = [&](const Entry& entry) {
            return section_of(entry.path) == section && find_key(entry.path);
        };
        const auto is_other = [&](const Entry& entry) {
            return section_of(entry.path) == section && !find_key(entry.path);
        };
        const auto& entries = document.entries;
        if (std::ranges::any_of(entries, is_other) || std::ranges::none_of(entries, is_of_case))
            parts.push_back("[" + std::string(section) + "]");
    }
    const auto of_case = [](const UncertainKey& one) { return find_key(one.key->path); };
    if (std::ranges::any_of(uncertain_keys(document, case_file_keys()), of_case))
        parts.emplace_back(uncertainty_mark);
    return parts;
}

}  // namespace

std::vector<std::string> rig_parts(const std::string& path,
                                   const std::vector<std::string>& overrides) {
    const std::string text = read_input_file(path);
    if (parse_document(text, path).find_section("machine")) return {};  // reads all
    return parts_of(case_document(text, path, overrides));
}

std::vector<std::string> rig_parts(const Study& study) {
    if (study.walks) return {};
    Document document = study.base;
    const auto& settings = study.settings;
    document.entries.insert(document.entries.end(), settings.begin(), settings.end());
    for (const Study::Axis& axis : study.axes)
        if (const auto* values = std::get_if<std::vector<Entry>>(&axis.values))
            document.entries.insert(document.entries.end(), values->begin(), values->end());
    return parts_of(document);
}

bool states_unrelaxed(const Document& document) {
    const Entry* modulus = document.find("substrate.relaxation.modulus");
    return modulus && std::get<std::string>(modulus->value) == "unrelaxed";
}

std::vector<UncertainKey> uncertain_numbers(const Document& document, const contact::Case& c) {
    std::vector<UncertainKey> uncertain = uncertain_keys(document, case_file_keys());
    if (!states_unrelaxed(document)) return uncertain;
    const bool is_in_proportion = c.relaxation->bulk == contact::Relaxation::Bulk::proportional &&
                                  !document.find("substrate.relaxation.moduli") &&
                                  !document.find("substrate.relaxation.G2");
    for (UncertainKey& one : uncertain) {
        const bool is_young = one.key->path == "substrate.young";
        if (!is_young && one.key->path != "substrate.poisson") continue;
        if (!is_in_proportion)
            fail(one.place, document.find(one.key->path)->subject(),
                 "is that of the unrelaxed substrate, and its uncertainty is carried to the "
                 "relaxed one only where all relaxes in proportion",
                 "give substrate.relaxation.relative_moduli without bulk, or the relaxed modulus");
        if (!is_young) continue;
        statistics::Estimate& young = one.number.value;
        young = {c.substrate.young, young.standard_error * c.substrate.young / young.value};
    }
    return uncertain;
}

std::optional<statistics::Estimate> RigFile::number(std::string_view path) const {
    const Entry* entry = document.find(path);
    if (!entry) return {};
    const auto one = std::ranges::find(uncertain, path, [](const auto& u) { return u.key->path; });
    if (one != uncertain.end()) return one->number.value;
    if (const CaseKey* key = find_key(path)) {
        contact::Case held = c;
        if (const double* number = number_of(*key, held)) return statistics::Estimate{*number};
    }
    return read_uncertain_number(*case_file_keys().find(path), *entry).value;
}

RigFile parse_rig_file(std::string_view text, const std::string& name,
                       const std::vector<std::string>& overrides) {
    RigFile rig{.document = case_document(text, name, overrides)};
    rig.c = resolve_case(rig.document, {});
    rig.uncertain = uncertain_numbers(rig.document, rig.c);
    rig.correlations = correlations(rig.document, rig.uncertain);
    return rig;
}

RigFile read_rig_file(const std::string& path, const std::vector<std::string>& overrides) {
    return parse_rig_file(read_input_file(path), path, overrides);
}

}  // namespace tricontact::io
