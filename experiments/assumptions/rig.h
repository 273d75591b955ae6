#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/substrates/relaxation.h"
#include "io/case/rig_file.h"
#include "statistics/correlations.h"
#include "statistics/estimate.h"

namespace tricontact::experiments {

using statistics::Estimate;

/// A number that a publication states, SI units.
struct PrintedValue : io::UncertainNumber {
    std::string name;    ///< of the quantity: "contact_radius"
    std::string text;    ///< as printed: "4.56 mm"
    std::string source;  ///< "table 5.1.1"
};

/// What a rig measures: U under F_T before it rolls, U after it has rolled until it stands, d under
/// a force, the radius (half the width) of the contact.
enum class Measured { static_shift, settled_shift, indentation, contact_radius };

/// A body pressed by F_N, and then loaded by coupling_tangential_ratio of mu F_N; standard errors
/// are numerical.
struct BodyContact {
    Estimate indentation, contact_radius;  ///< d; of a circle of the contact's area [m]
    Estimate peak_pressure;                ///< [Pa]; NaN under a conical tip
    Estimate static_shift;                 ///< [m]
    /// Of a height map: share of F_N on cells at its border [-].
    double border_force_share = 0;
};
struct BodyContacts {
    BodyContact half_space, layer;  ///< normal and tangential contact uncoupled
    Estimate coupled_static_shift;  ///< on the layer [m]
};

/// An experiment whose evaluation takes something for granted.
struct Rig {
    /// Sphere, cylinder: a heavy roller that lies on a layer of rubber, bonded to a rigid plate,
    /// and is rolled back and forth by a lever. Micro-walking: an hourglass of a body and two discs
    /// that lies with four contact spots in a prism (two planes at 45 degrees) and is dragged by a
    /// rod or spring. Body: as the sphere, but of another shape.
    enum class Kind { sphere, cylinder, body, micro_walking };

    Kind kind = Kind::sphere;
    std::string title;
    std::map<std::string, Estimate> data;  ///< SI units, by symbol; only what the file states
    std::array<Estimate, 2> reach = {};    ///< of rolling from its middle, along x and y [m]
    std::vector<PrintedValue> printed;
    /// Of a substrate with several branches; one alone is eta and G_2/G_1 of the data.
    std::optional<contact::Relaxation> relaxation = {};
    std::optional<BodyContacts> body = {};  ///< of Kind::body, by models that the caller has
    std::vector<Measured> measured;         ///< what the file has records of; empty: anything
    statistics::Correlations correlations;  ///< of the data, by symbol
    std::vector<std::string> uncertain;     ///< keys whose numbers have a standard error

    bool has(const std::string& symbol) const { return data.contains(symbol); }
    /// Throws std::out_of_range.
    const Estimate& operator[](const std::string& symbol) const { return data.at(symbol); }
};

/// A number of a rig in its formulas.
struct RigSymbol {
    std::string_view symbol;  ///< with ' behind where another quantity has the same one
    std::string_view path;    ///< of its key: "indenter.radius"
    io::Dimension dimension = io::Dimension::none;
};
const std::vector<RigSymbol>& rig_symbols(Rig::Kind kind);

/// Young's modulus [Pa] that stands for a rigid indenter: beyond what a file can state.
inline constexpr double rigid_young = 1e18;

/// A quantity whose printed value may be compared.
struct PrintedKey {
    std::string_view name;
    io::Dimension dimension = io::Dimension::none;
};
const std::vector<PrintedKey>& printed_keys(Rig::Kind kind);

/// A rolling rig as a case file describes it, with [rig] and [printed] (docs/how-to/rig.md). What
/// the case resolves - a thickness by its ratio, the amplitude of its rolling, a standard solid -
/// is taken from there. Bodies other than spheres and cylinders still need their contacts. Throws
/// contact::InputError in one line, `file:line:column: key = value: rule; remedy`, for what
/// formulas do not cover: layers on anything but a rigid base to
/// which they are bonded, a prescribed indentation.
Rig rolling_rig(const io::RigFile& file);

/// A rig of the micro-walking machine as its case, which has been checked, describes it. `keys`:
/// all that the file may hold.
Rig walking_rig(const io::Document& document, const io::KeyList& keys);

}  // namespace tricontact::experiments
