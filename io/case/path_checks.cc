#include <fmt/format.h>

#include <cmath>

#include "contact/load_path.h"
#include "contact/path_cycles.h"
#include "contact/rig_stiffness.h"
#include "contact/wearing_contact.h"
#include "io/case/case_checks.h"
#include "io/case/case_input.h"
#include "io/tables/path_table.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::NormalControl;
using contact::PrescribedPath;
using contact::TangentialControl;

/// What a path says instead.
constexpr std::array prescribed_keys{"load.normal_force",
                                     "load.indentation",
                                     "load.tangential_ratio",
                                     "load.tangential_force",
                                     "load.limit_fraction",
                                     "load.limit_excess",
                                     "load.normal_amplitude_ratio",
                                     "load.tangential_amplitude_ratio",
                                     "load.bulk_stress"};

void check_alone(const Case& c, const Document& document) {
    for (const char* key : prescribed_keys)
        if (document.find(key))
            refuse(document, key, "contradicts [path], whose rows prescribe all loads",
                   "give one of the two");
    if (c.load.hold != 0)
        refuse(document, "load.hold", "contradicts [path], whose rows give the hold times",
               "omit it, and give a row that changes nothing but the time");
    for (const char* section : {"rolling", "tractive_rolling"})
        if (const auto* found = document.find_section(section))
            fail(found->place, fmt::format("[{}]", section),
                 "contradicts [path], whose rows give the rolling", "give one of the two");
}

/// What an oscillation about zero says instead, or has no place for.
void check_alternates_alone(const Case& c, const Document& document, const std::string& key) {
    for (const char* section : {"path", "rolling", "tractive_rolling"})
        if (const auto* found = document.find_section(section))
            fail(found->place, fmt::format("[{}]", section),
                 "contradicts " + key + ", which says the whole path", "give one of the two");
    for (const char* other : {"load.normal_amplitude_ratio", "load.tangential_amplitude_ratio"})
        if (document.find(other))
            refuse(document, other, "contradicts " + key + ", which oscillates about zero alone",
                   "omit it, or prescribe both loads by [path]");
    if (c.relaxation)
        refuse(document, key, "a relaxing substrate needs times, and this path has none",
               "give [path] with a column time [s]");
}

/// 0, a quarter up to the amplitude, then there and back again in each period, the bulk stress [Pa]
/// in proportion.
PrescribedPath alternating(const OscillationInput& input, const NormalControl& normal,
                           double bulk_stress) {
    const auto kind = input.force ? TangentialControl::Kind::force : TangentialControl::Kind::shift;
    const double amplitude = input.force ? *input.force : input.shift.value();
    PrescribedPath path;
    const auto add = [&](double value, int quarters) {
        PrescribedPath::Row row;
        row.normal = normal;
        row.tangential[0] = {kind, value};
        row.bulk_stress = value / amplitude * bulk_stress;
        row.tangential[1] = {TangentialControl::Kind::force, 0};
        row.steps = quarters * input.steps_per_quarter;
        path.rows.push_back(row);
    };
    add(0, 1);
    add(amplitude, 1);
    for (int n = 0; n < input.periods; ++n) {
        add(-amplitude, 2);
        add(amplitude, 2);
    }
    return path;
}

bool lies_on_a_line(const PrescribedPath& path) {
    const double angle = path.direction();
    const double scale = contact::norm(path.reach());
    return std::ranges::all_of(path.rows, [&](const PrescribedPath::Row& row) {
        return std::abs(row.offset[1] * std::cos(angle) - row.offset[0] * std::sin(angle)) <=
               1e-9 * scale;
    });
}

/// Of the keys of the centre of rotation one that the case has.
std::string centre_key(const Document& document) {
    for (const char* key : {"path.centre_of_rotation", "path.centre_x"})
        if (document.find(key)) return key;
    return "path.centre_y";
}

/// Some bodies, models and materials know fewer motions.
void check_motions(const Case& c, const Document& document) {
    const PrescribedPath& path = *c.prescribed_path;
    const std::string key = path_key(document);
    const auto refuse_motions = [&](const std::string& what, const std::string& remedy) {
        if (path.centre != contact::CentreOfRotation{})
            refuse(document, centre_key(document), what + " has neither twist nor torque",
                   "omit it, or " + remedy);
        if (path.twists())
            refuse(document, key, what + " cannot be twisted", "omit rotation, or " + remedy);
        if (path.loads_across())
            refuse(document, key, what + " has no tangential load or shift along y",
                   "omit these columns, or " + remedy);
    };
    for (const std::string& model : c.models) {
        if (!contact::model_kind(model).is_on_line()) continue;
        refuse_motions(model + ", a line of springs,", "leave out " + model);
        if (!lies_on_a_line(path))
            refuse(document, key,
                   model + ", a line of springs, rolls along one line through its start",
                   "let all offsets lie on one, or leave out " + model);
    }
    if (c.is_cylindrical()) {
        refuse_motions("the contact of a cylinder or roller", "take a body of revolution");
        if (path.reach()[1] > 0)
            refuse(document, key, "a cylinder or roller rolls across its axis, along x, only",
                   "omit offset_y, or take a body of revolution");
    }
    if (c.period && path.twists())
        refuse(document, key,
               "a periodic contact cannot be twisted: its images would turn about other points",
               "omit rotation, or bem.period");
    if (c.law != Case::Law::linear && path.twists())
        refuse(document, key, "fem does not twist the indenter at finite strains",
               "omit rotation, or set substrate.material to \"linear\"");
    if (c.relaxation && !path.is_timed())
        refuse(document, key, "a relaxing substrate needs times, and the path has no column time",
               "add a column time [s]");
}

/// Forces that friction carries, in all rows; between two rows the ratio is below that of one.
void check_carried(const Case& c, const Document& document) {
    const bool springs_alone =
        all_have(c, &contact::ModelKind::steps_are_exact) && !c.interface.is_elastic();
    const auto& rows = c.prescribed_path->rows;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const double force = contact::prescribed_force(rows[r].tangential);
        if (force == 0 || rows[r].normal.kind != NormalControl::Kind::force) continue;
        const double limit = c.friction.law()->limit({rows[r].normal.value, contact::infinity});
        if (force <= (springs_alone ? 1 : 1 - closest_to_sliding) * limit && force < limit)
            continue;
        refuse(document, path_key(document),
               fmt::format("row {}: the tangential force {} N reaches the friction limit mu F_N = "
                           "{} N: the contact slides",
                           r + 1, rounded(force), rounded(limit)),
               "reduce it, or prescribe the shift");
    }
}

/// Whether the strain of a bulk stress is a shift of the surface beside those of the tractions, as
/// solvers over a half-space's surface take it.
bool strains_freely(const contact::ModelKind& kind) {
    return kind.is_on_cells_of(contact::ModelKind::Body::half_space);
}

/// A rig that yields is felt where displacements are prescribed, and told where forces are; along
/// the surface it is in measured loops as well.
void check_rig(const Case& c, const Document& document) {
    const std::string_view of_loops =
        document.find("measurement.friction_loop") ? "rig.tangential_stiffness" : "";
    for (const char* key : {"rig.tangential_stiffness", "rig.normal_stiffness"})
        if (document.find(key) && !c.prescribed_path && key != of_loops)
            refuse(document, key, "has no effect without a path, whose drive it holds",
                   "give [path], load.tangential_amplitude or load.shift_amplitude, or omit it");
}

const std::string omit_wear = "leave out [wear]";

void check_wear_models(const Case& c, const std::string& key, const Document& document) {
    for (const std::string& model : c.models) {
        const contact::ModelKind& kind = contact::model_kind(model);
        const bool wears = (kind.is_on_cells() || kind.is_meshed() || kind.is_on_line()) &&
                           !kind.is_section() && !kind.is_read();
        if (!wears)
            refuse(
                document, key, model + " has no worn profile",
                "leave out " + model + " or [wear]; bem, bem-layer, fem, mdr and mdr-layer wear");
        if (!kind.is_on_line()) continue;
        if (contact::norm(c.prescribed_path->reach()) > 0)
            refuse(document, path_key(document),
                   model + " wears along rings, and a body that rolls has none",
                   "omit offset_x and offset_y, leave out " + model + ", or " + omit_wear);
        if (!contact::is_hertz_round(c) || !c.friction.is_coulomb() || c.interface.is_elastic())
            refuse(document, key,
                   model + " wears a paraboloid or sphere under Coulomb's law on a rigid interface",
                   "leave out " + model + ", take " +
                       (kind.is_layer() ? contact::models::bem_layer : contact::models::bem));
    }
}

}  // namespace

void check_bulk_stress(const Case& c, const Document& document) {
    if (!c.has_bulk_stress()) return;
    const bool by_path = c.load.bulk_stress == 0;
    const std::string key = by_path ? path_key(document) : "load.bulk_stress";
    const std::string what = by_path ? "bulk_stress: " : "";
    for (const std::string& model : c.models)
        if (!strains_freely(contact::model_kind(model)))
            refuse(document, key,
                   what + (contact::model_kind(model).is_layer()
                               ? "a layer strains along its surface as the base that it is bonded "
                                 "to, and by no stress of its own; bem has the strain of a "
                                 "half-space"
                               : "models on the surface of a half-space alone, bem, know a "
                                 "substrate that is strained as a whole"),
                   "leave out " + model + ", or omit it");
    if (c.rolling || c.tractive_rolling)
        refuse(document, key, "a bulk stress acts on a contact that stays in its place",
               "omit it, or give a [path] without offsets in place of the rolling");
    if (c.prescribed_path && contact::norm(c.prescribed_path->reach()) > 0)
        refuse(document, key, "a bulk stress acts on a contact that stays in its place",
               "omit the column bulk_stress, or those of the offsets");
    if (c.relaxation || c.has_rigid_substrate || c.period)
        refuse(
            document, key,
            what + (c.relaxation ? "the strain of a substrate that relaxes lags behind its stress"
                    : c.period   ? "the strain of a periodic surface is not periodic"
                                 : "a rigid substrate is not strained"),
            "omit it");
}

std::string path_key(const Document& document) {
    for (const char* key : oscillation_keys)
        if (document.find(key)) return key;
    return used(document, "path.table", "path.file");
}

void resolve_oscillation(Case& c, const Document& document) {
    const auto* const input = c.kept.find<OscillationInput>();
    if (!input) return;
    check_alternates_alone(c, document, path_key(document));
    c.prescribed_path =
        alternating(*input, contact::mean_normal_control(c.load), c.load.bulk_stress);
    c.load.tangential_force = 0;
}

void resolve_path(Case& c, const Document& document) {
    if (!c.kept.find<PathInput>()) return;
    const PathInput& input = c.of<PathInput>();
    told_at(document, path_key(document), [&] {
        const bool may_pull = c.adhesion.has_value();
        c.prescribed_path = input.file
                                ? read_path_file(*input.file, input.steps, may_pull)
                                : read_path_text(*input.table, "table", input.steps, may_pull);
        c.prescribed_path->centre = input.centre;
    });
    check_alone(c, document);
    const NormalControl hardest = c.prescribed_path->hardest_normal();
    (hardest.kind == NormalControl::Kind::force ? c.load.normal_force : c.load.indentation) =
        hardest.value;
    c.load.tangential_force = 0;
}

void check_prescribed_path(const Case& c, const Document& document) {
    check_rig(c, document);
    if (!c.prescribed_path) return;
    check_motions(c, document);
    check_carried(c, document);
}

void check_wear(const Case& c, const Document& document) {
    const contact::Wear* wear = c.kept.find<contact::Wear>();
    if (!wear) return;
    const std::string key = "wear.cycles";
    if (!c.prescribed_path)
        refuse(document, key, "only the closed cycles of [path] wear the surfaces",
               "give [path] instead of the load, or " + omit_wear);
    if (contact::repeated_cycles(*c.prescribed_path).empty())
        refuse(document, path_key(document),
               "no closed cycle, which [wear] repeats: its drive has to turn back twice, and end "
               "where it turned first",
               "add rows, or " + omit_wear);
    const auto* const rig = c.kept.find<contact::RigStiffness>();
    if (rig && rig->normal)
        refuse(document, "rig.normal_stiffness",
               "jumps over cycles are those of a contact whose own depth or force is prescribed",
               "prescribe normal_force, or " + omit_wear);
    if (c.relaxation)
        refuse(document, key, "cycles of a relaxing substrate do not repeat themselves",
               "leave out [substrate.relaxation] or [wear]");
    if (c.friction.weakening || c.friction.yield)
        refuse(document, key, "friction that remembers the way of slip is not worn",
               "leave out its memory, or " + omit_wear);
    if (c.law != Case::Law::linear)
        refuse(document, key, "fem at finite strains has no worn profile",
               "set substrate.material to \"linear\", or " + omit_wear);
    if (c.period || contact::is_nominally_flat(c))
        refuse(document, key, "rough and periodic surfaces are not worn",
               "take a smooth body without bem.period, or " + omit_wear);
    check_wear_models(c, key, document);
}

}  // namespace tricontact::io
