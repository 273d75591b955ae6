#include "benchmarks/submissions/columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "benchmarks/submissions/column_names.h"
#include "benchmarks/submissions/total_keys.h"
#include "io/keys/messages.h"

namespace tricontact::benchmarks {

namespace {

std::string quoted(const std::string& heading) {
    return io::toml_string(io::shortened(heading, 40));
}

/// A name of several words of which the first is known: "CPRESS   ASSEMBLY_TOP/ASSEMBLY_BALL".
Recognised meaning_of(const std::string& name) {
    const Recognised whole = recognised(name);
    const auto blank = name.find(' ');
    if (whole.meaning != Meaning::other || blank == name.npos) return whole;
    const std::string first = name.substr(0, blank);
    return first.size() > 2 ? recognised(first) : whole;
}

void bring_to_si(RawColumn& column, Meaning& meaning, const std::string& place) {
    if (!column.unit || meaning == Meaning::other) return;
    const auto refuse = [&](const std::string& rule, const std::string& remedy) {
        io::fail(place, "column " + quoted(column.heading), rule, remedy);
    };
    if (dimensions_of(meaning).empty()) {
        if (*column.unit != "-" && *column.unit != "1" && !column.unit->empty())
            refuse("is a pure number, without a unit", "write " + column.name + " alone");
        return;
    }
    double factor = 1;
    try {
        try {
            factor = unit_factor(*column.unit, dimensions_of(meaning));
        } catch (const io::QuantityError&) {
            const Meaning force = as_force(meaning);
            if (force == meaning) throw;
            factor = unit_factor(*column.unit, std::array{io::Dimension::force});
            meaning = force;
        }
    } catch (const io::QuantityError&) {
        try {
            unit_factor(*column.unit, dimensions_of(meaning));
        } catch (const io::QuantityError& error) {
            refuse(error.rule, error.remedy);
        }
    }
    for (std::size_t i = 0; i < column.values.size(); ++i) {
        const double given = std::exchange(column.values[i], in_si(column.values[i], factor));
        if (!std::isfinite(column.values[i]) || (column.values[i] == 0 && given != 0))
            refuse("row " + std::to_string(i + 1) +
                       " leaves the range of double precision in SI units",
                   "correct the row");
    }
}

struct Candidate {
    RawColumn raw;
    Meaning meaning;
    bool is_specific;
};

/// Index of the one that is taken of those of a meaning.
std::size_t chosen(const std::vector<Candidate>& all, Meaning meaning, const std::string& place,
                   Twice twice) {
    std::vector<std::size_t> same;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].meaning == meaning) same.push_back(i);
    if (same.size() > 1 && twice == Twice::specific_first &&
        std::ranges::any_of(same, [&](std::size_t i) { return all[i].is_specific; }))
        std::erase_if(same, [&](std::size_t i) { return !all[i].is_specific; });
    if (same.size() > 1)
        io::fail(place,
                 "columns " + quoted(all[same[0]].raw.heading) + " and " +
                     quoted(all[same[1]].raw.heading),
                 "are both read as " + std::string(name_of(meaning)),
                 "keep one, or rename the other");
    return same[0];
}

}  // namespace

void add_columns(MeshField& field, std::vector<RawColumn> columns, const std::string& place,
                 Twice twice) {
    std::vector<Candidate> all;
    for (RawColumn& raw : columns) {
        const Recognised found = meaning_of(raw.name);
        Candidate one{std::move(raw), found.meaning, found.is_specific};
        bring_to_si(one.raw, one.meaning, place);
        all.push_back(std::move(one));
    }
    std::vector<std::string> used, unused, unitless;
    std::vector<bool> taken(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        taken[i] =
            all[i].meaning != Meaning::other && chosen(all, all[i].meaning, place, twice) == i;
    for (std::size_t i = 0; i < all.size(); ++i) {
        Candidate& one = all[i];
        if (!taken[i]) {
            unused.push_back(quoted(one.raw.heading));
            continue;
        }
        for (std::size_t row = 0; row < one.raw.values.size(); ++row)
            if (!std::isfinite(one.raw.values[row]))
                io::fail(place, "column " + quoted(one.raw.heading),
                         "value " + std::to_string(row + 1) + " is not a finite number",
                         "write zeros where there is no contact");
        used.push_back(quoted(one.raw.heading) + " as " + std::string(name_of(one.meaning)));
        if (!one.raw.unit && !dimensions_of(one.meaning).empty())
            unitless.push_back(quoted(one.raw.heading));
        field.columns.push_back(
            {one.raw.heading, one.meaning, one.raw.unit, std::move(one.raw.values)});
    }
    const auto note = [&](const char* what, const std::vector<std::string>& headings) {
        if (!headings.empty()) field.notes.push_back(what + io::joined(headings));
    };
    note("columns read: ", used);
    note("columns without units, values as written: ",
         unitless.size() == used.size() ? std::vector<std::string>{"all"} : unitless);
    note("columns not used: ", unused);
}

bool has_contact(const MeshField& field) {
    using enum Meaning;
    for (const Meaning meaning :
         {pressure, traction_x, traction_y, traction_z, force_normal, force_z, stress_zz})
        if (field.find(meaning)) return true;
    return false;
}

void check_field(const MeshField& field, const std::string& place) {
    using enum Meaning;
    std::vector<std::string> headings;
    for (const FieldColumn& column : field.columns) headings.push_back(quoted(column.heading));
    const std::string known = headings.empty() ? "" : "; read are " + io::joined(headings);
    if (!field.find(x) && !field.find(r) && !field.find(y))
        io::fail(place, "", "no column of positions" + known,
                 "name columns for example r [mm], p [MPa] or x [mm], y [mm], p [MPa]");
    if (!has_contact(field))
        io::fail(place, "", "no pressure, traction, nodal force or stress of the surface" + known,
                 "name it for example p [MPa], fn [N] or stress_zz [MPa]");
    if (field.size() == 0) io::fail(place, "", "the field has no points", "write its values");
}

}  // namespace tricontact::benchmarks
