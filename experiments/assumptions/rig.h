#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/assumptions/measured_quantity.h"
#include "io/keys/key.h"

namespace tricontact::experiments {

/// A number that a publication states, SI units.
struct PrintedValue : MeasuredQuantity {
    std::string name;    ///< of the quantity: "contact_radius"
    std::string text;    ///< as printed: "4.56 mm"
    std::string source;  ///< "table 5.1.1"
};

/// An experiment whose evaluation takes something for granted.
struct Rig {
    /// Sphere, cylinder: a heavy roller that lies on a layer of rubber, bonded to a rigid plate,
    /// and is rolled back and forth by a lever. Micro-walking: an hourglass of a body and two discs
    /// that lies with four contact spots in a prism (two planes at 45 degrees) and is dragged by a
    /// rod or spring.
    enum class Kind { sphere, cylinder, micro_walking };

    Kind kind = Kind::sphere;
    std::string title;
    std::map<std::string, Estimate> data;  ///< SI units, by symbol; only what the file states
    std::vector<PrintedValue> printed;

    bool has(const std::string& symbol) const { return data.contains(symbol); }
    /// Throws std::out_of_range.
    const Estimate& operator[](const std::string& symbol) const { return data.at(symbol); }
};

/// A number that a rig file may state.
struct RigKey : io::Key {
    std::string_view
        symbol;  ///< in formulas, with ' behind where another quantity has the same one
    RigKey(std::string_view name, std::string_view its_symbol, io::Dimension of,
           std::string_view shown, bool is_required = true,
           const io::Range& admissible = io::above_zero(1e15))
        : Key(io::quantity_key(name, of, admissible, shown, {}, {.required = is_required})),
          symbol(its_symbol) {}
};
const std::vector<RigKey>& rig_keys(Rig::Kind kind);

/// A quantity whose printed value may be compared.
struct PrintedKey {
    std::string_view name;
    io::Dimension dimension = io::Dimension::none;
};
const std::vector<PrintedKey>& printed_keys(Rig::Kind kind);

/// Reads a rig file (docs/rig.md). Throws contact::InputError in one line:
/// `file:line:column: key = value: rule; remedy`.
Rig read_rig(const std::string& path);

/// Same for a text; `name` stands for the file in messages.
Rig parse_rig(std::string_view text, const std::string& name);

}  // namespace tricontact::experiments
