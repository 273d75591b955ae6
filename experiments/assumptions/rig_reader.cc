#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "comparisons/strength/body_strength.h"
#include "contact/bodies/upper_plate.h"
#include "contact/half_space_scales.h"
#include "contact/load_path.h"
#include "contact/section_scales.h"
#include "experiments/assumptions/rig_quantities.h"
#include "io/case/case_checks.h"
#include "io/case/case_input.h"
#include "io/case/rig_keys.h"
#include "io/keys/field_reader.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"

namespace tricontact::experiments {

namespace {

using contact::Case;

constexpr std::string_view printed = "printed";

// A table in [printed]: value and source of one quantity.
bool is_printed_value(std::string_view path) {
    return io::section_of(path) == printed;
}

void check_tables(const io::Document& document) {
    for (const io::Entry& entry : document.entries)
        if (io::section_of(entry.path) == printed)
            io::fail(entry.place, entry.subject(), "must be a table",
                     "write " + std::string(io::name_of_key(entry.path)) +
                         R"( = {value = "4.56 mm", source = "table 5.1.1"})");
}

io::UncertainNumber measured(const io::Entry& entry, const std::string& text,
                             io::Dimension dimension) {
    try {
        return io::parse_uncertain_number(text, dimension);
    } catch (const io::QuantityError& error) {
        io::fail(entry.place, entry.subject(), error.rule, error.remedy);
    }
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
            result = {measured(entry, *text, key->dimension), std::string(name), *text,
                      result.source};
        else
            result.source = *text;
    }
    return result;
}

void read_printed(Rig& rig, const io::Document& document) {
    check_tables(document);
    for (const auto& section : document.sections)
        if (is_printed_value(section.name))
            rig.printed.push_back(printed_value(document, section, printed_keys(rig.kind)));
    for (const PrintedValue& one : rig.printed) {
        if (one.name == "excitation_frequency") rig.f_0_printed = one.value;
        if (one.name == "pivot_height_error") rig.Dh_printed = one.value;
    }
}

/// All numbers of the rig that the file states: `stated` of a key's path.
template <class Stated>
void read_numbers(Rig& rig, const io::Document& document, const io::KeyList& keys,
                  const Stated& stated) {
    for (const RigQuantity& one : rig_quantities(rig.kind)) {
        const io::Entry* entry = one.path.empty() ? nullptr : document.find(one.path);
        if (!entry) continue;
        const io::Key& key = *keys.find(one.path);
        const Estimate number = stated(key, *entry);
        // Derivatives are taken to both sides.
        if (!key.range.contains(number.value + number.standard_error))
            io::fail(entry->place, entry->subject(), "with its error it " + io::range_rule(key),
                     "move the value away from the end of the range");
        rig.*one.number = number;
    }
}

Rig::Kind kind_of(const io::RigFile& file) {
    switch (file.c.indenter.shape) {
        case Case::Shape::paraboloid:
        case Case::Shape::sphere:
            return Rig::Kind::sphere;
        case Case::Shape::cylinder:
            return Rig::Kind::cylinder;
        default:
            return Rig::Kind::body;
    }
}

void check_covered(const io::RigFile& file) {
    const Case& c = file.c;
    const io::Document& document = file.document;
    if (c.prescribed_path && c.layer.thickness)
        io::fail(document.place_of(io::path_key(document)), "",
                 io::path_words(c) +
                     ": the formulas of rigs on a layer are those of one normal force and of "
                     "rolling back and forth",
                 "give load.normal_force and [rolling] in place of the path; tricontact run "
                 "computes it");
    if (c.prescribed_path && contact::norm(c.prescribed_path->reach()) > 0)
        io::fail(document.place_of(io::path_key(document)), "",
                 "[path]: rigs that roll are described by [rolling]",
                 "give load.normal_force and [rolling] in place of the path");
    if (c.tractive_rolling)
        io::fail(document.place_of("tractive_rolling.distance"), "",
                 "[tractive_rolling]: the formulas of rigs are those of rolling back and forth",
                 "give [rolling] in place of it; tricontact run computes rolling on");
    for (const auto& [key, ratio] :
         {std::pair("load.normal_amplitude_ratio", c.load.normal_amplitude_ratio),
          std::pair("load.tangential_amplitude_ratio", c.load.tangential_amplitude_ratio)})
        if (ratio != 0)
            io::refuse(document, key, "the formulas of rigs are those of constant loads",
                       "omit it; tricontact run computes loads that oscillate");
    if (contact::is_section_alone(c))
        io::refuse(document, c.has_hole() ? "substrate.shape" : "indenter.shape",
                   "the formulas of rigs are those of round indenters on flat substrates",
                   "take one; tricontact run computes holes and punches");
    if (c.kept.find<contact::UpperPlate>())
        io::refuse(document, io::used(document, "upper_plate.rigid", "upper_plate.young"),
                   "the formulas of rigs are those of one substrate",
                   "omit [upper_plate]; tricontact run computes both contacts");
    if (!c.layer.thickness && c.has_rigid_substrate)
        io::refuse(document, "substrate.rigid",
                   "the formulas of rigs are those of an elastic substrate",
                   "let the indenter be rigid instead: omit indenter.young, and give its modulus "
                   "to the substrate");
    if (!c.friction.is_coulomb()) {
        const contact::HalfSpaceScales hertz = contact::half_space_scales(c);
        c.require_coulomb("the check of rigs",
                          document.place_of(c.friction.coefficient ? "friction.coefficient"
                                                                   : "friction.shear_strength") +
                              ": friction",
                          fmt::format("take F_lim/F_N = {:.3g} of the half-space in its place",
                                      hertz.friction_limit / hertz.normal_force));
    }
    if (!c.layer.thickness && kind_of(file) == Rig::Kind::body)
        io::fail(document.place_of("substrate.thickness"), "", "missing key substrate.thickness",
                 "add thickness = \"8 mm\" or the like: without it rig knows spheres and "
                 "cylinders alone");
    if (!c.layer.thickness && c.relaxation)
        io::fail(document.place_of("substrate.thickness"), "", "missing key substrate.thickness",
                 "add thickness = \"8 mm\" or the like: rigs on a half-space are elastic");
    if (c.layer.thickness) {
        c.refuse_extras("assumptions of rigs on a layer");
        for (const char* key : {"substrate.yield_stress", "indenter.yield_stress"})
            if (document.find(key))
                io::refuse(document, key, "strength is judged of rigs on a half-space alone",
                           "omit it, or omit substrate.thickness");
    }
    if (c.layer.base != Case::Base::bonded || !c.layer.lower.empty())
        io::fail(document.place_of("substrate.base"), "",
                 "the formulas of rigs are those of one layer bonded to a rigid base",
                 "tricontact deviation compares such a layer with the half-space");
    if (!c.load.normal_force)
        io::fail(document.place_of("load.normal_force"), "", "missing key load.normal_force",
                 "give the force, not the indentation: add normal_force = \"21.1 N\"");
    for (const char* key :
         {"rig.specimen_thickness", "rig.displacement_amplitude", "rig.cycle_frequency"})
        if (c.layer.thickness && document.find(key))
            io::refuse(document, key, "describes rigs on a half-space, and the case has a layer",
                       "omit it, or omit substrate.thickness");
    if (c.indenter.shape != Case::Shape::cylinder && document.find("rig.axis_tilt"))
        io::refuse(document, "rig.axis_tilt", "has no effect without an axis: a cylinder's",
                   "omit it, or take shape = \"cylinder\"");
    for (const char* key : {"rig.viscosity", "rig.maxwell_ratio"})
        if (c.relaxation && document.find(key))
            io::refuse(document, key,
                       "[substrate.relaxation] gives the relaxation of the substrate",
                       "omit one of the two");
}

/// Its standard error over its value; 0 of a key whose number is certain.
double relative_error_of_key(const io::RigFile& file, std::string_view path) {
    const auto found = std::ranges::find_if(
        file.uncertain, [&](const io::UncertainKey& one) { return one.key->path == path; });
    if (found == file.uncertain.end()) return 0;
    return found->number.value.standard_error / found->number.value.value;
}

/// What the rows of a path say of a fretting test.
void complete_half_space(Rig& rig, const Case& c) {
    if (!rig.F_N.is_known()) rig.F_N = *c.load.normal_force;
    if (!c.prescribed_path) return;
    const auto& rows = c.prescribed_path->rows;
    using Row = contact::PrescribedPath::Row;
    const auto along = [](const Row& row) { return row.tangential[0].value; };
    const auto [least, most] = std::ranges::minmax(rows, {}, along);
    if (rows.front().tangential[0].kind == contact::TangentialControl::Kind::shift) {
        if (!rig.U_a.is_known()) rig.U_a = (along(most) - along(least)) / 2;
    } else {
        rig.F_T = std::max(std::abs(along(least)), std::abs(along(most)));
    }
    rig.sigma = std::abs(comparisons::largest_bulk_stress(c));
}

/// What follows from the resolved case where the file has no such key.
void complete(Rig& rig, const io::RigFile& file) {
    const Case& c = file.c;
    if (!rig.E_1.is_known()) {
        rig.E_1 = rigid_young;
        rig.nu_1 = 0.3;
    }
    if (!rig.b.is_known() && c.layer.thickness)  // by its ratio
        rig.b = {*c.layer.thickness,
                 *c.layer.thickness * relative_error_of_key(file, "substrate.thickness_ratio")};
    const double radius = contact::half_space_scales(c).contact_radius;
    const contact::Vector2 reach = contact::path_reach(c, radius);
    const double relative = relative_error_of_key(file, "rolling.amplitude") +
                            relative_error_of_key(file, "rolling.amplitude_ratio");  // one of both
    rig.W_x = {reach[0], reach[0] * relative};
    rig.W_y = {reach[1], reach[1] * relative};
    if (!rig.w.is_known() && !rig.a_reference.is_known() && c.rolling) {
        const double ratio = contact::path_amplitude(c, radius) / radius;
        rig.w = {ratio, ratio * relative};
    }
    if (const auto& roughness = c.indenter.roughness) {
        if (!rig.h_rms.is_known()) rig.h_rms = contact::rms_height(*roughness);
        if (!rig.s_rms.is_known()) rig.s_rms = roughness->rms_slope;
    }
    if (!c.layer.thickness) complete_half_space(rig, c);
    if (!rig.n.is_known() && c.rolling) rig.n = static_cast<double>(c.rolling->periods);
    if (c.relaxation && c.relaxation->branches.size() == 1) {
        const auto [ratio, time] = c.relaxation->branches.front();
        rig.G_ratio = ratio;
        rig.eta = ratio * time * c.substrate.shear_modulus();
    }
}

/// What the records and tables of the file show.
std::vector<Measured> measured_by(const io::Document& document) {
    using enum Measured;
    std::vector<Measured> measured;
    const bool recorded = document.find("record.runs") != nullptr;
    const auto has = [&](const char* table) { return document.find(table) != nullptr; };
    if (recorded || has("measurement.static_shift")) measured.push_back(static_shift);
    if (recorded) measured.push_back(settled_shift);
    if (has("measurement.force_indentation") || has("measurement.force_relaxation") ||
        has("measurement.indentation_creep"))
        measured.push_back(indentation);
    if (has("measurement.contact_radius")) measured.push_back(contact_radius);
    return measured;
}

}  // namespace

Rig rolling_rig(const io::RigFile& file) {
    Rig rig;
    rig.kind = kind_of(file);
    rig.title = file.c.title;
    rig.c = file.c;
    check_covered(file);
    read_numbers(rig, file.document, io::case_file_keys(),
                 [&](const io::Key& key, const io::Entry&) { return *file.number(key.path); });
    rig.measured = measured_by(file.document);
    rig.sliding = sliding_slope(file.document);
    complete(rig, file);
    rig.correlations = file.correlations;
    for (const io::UncertainKey& one : file.uncertain) rig.uncertain.emplace_back(one.key->path);
    read_printed(rig, file.document);
    return rig;
}

Rig walking_rig(const io::Document& document, const io::KeyList& keys) {
    Rig rig;
    rig.kind = Rig::Kind::micro_walking;
    if (const io::Entry* title = document.find("title"))
        io::read_field(*keys.find("title"), *title, io::Field(&rig.title));
    for (const io::Key& key : io::walking_rig_keys())
        if (key.required) io::required(key, document, keys);
    for (const char* path : {"machine.mass", "contact.diameter", "contact.young"})
        io::required(*keys.find(path), document, keys);
    read_numbers(rig, document, keys, [](const io::Key& key, const io::Entry& entry) {
        return io::read_uncertain_number(key, entry).value;
    });
    rig.correlations = io::correlations(document, io::uncertain_keys(document, keys));
    read_printed(rig, document);
    return rig;
}

}  // namespace tricontact::experiments
