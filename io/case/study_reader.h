#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/keys/key.h"
#include "io/keys/toml_document.h"

namespace tricontact::io {

/// What a study file says: a case, and what is to be varied in it.
struct Study {
    /// How the values x of a range lie, s being the fraction of the way along it.
    enum class Scale {
        linear,
        log,        ///< equal ratios
        cosine,     ///< cos(pi (x - from)/(to - from)) = 1 - 2 s: of functions even about both ends
        root_from,  ///< s = sqrt((x - from)/(to - from)), of functions of that root
        root_to     ///< 1 - s likewise of (to - x)
    };
    /// Values between two ends, in the key's SI unit. Integers are rounded.
    struct Range {
        double from = 0, to = 0;
        Scale scale = Scale::linear;
        std::optional<int> points;  ///< equidistant in s, ends included; empty: sampled

        double value_at(double s) const;
        /// The inverse, of a value of the range.
        double fraction_of(double value) const;
    };
    struct Axis {
        const Key* key = nullptr;
        std::string place;  ///< file:line:column
        std::variant<std::vector<Entry>, Range> values;

        bool is_sampled() const {
            const auto* range = std::get_if<Range>(&values);
            return range && !range->points;
        }
    };
    struct LatinHypercube {
        int points = 0;
        std::uint64_t seed = 0;
    };
    /// Maps over the sampled ranges, see atlas/.
    struct Atlas {
        int points = 0;            ///< at most
        double error = 0;          ///< that ends it earlier, over the values
        double largest_error = 0;  ///< beyond which a value is not said, over it
        double safety_factor = 1;  ///< what bars count of the correction for cells and steps
        std::vector<std::string> quantities;  ///< keys of results that are mapped
    };

    std::string title;
    std::string name;                 ///< of the file
    Document base;                    ///< the case file
    bool walks = false;               ///< whether it is about the micro-walking machine
    std::vector<std::string> models;  ///< of the study, else of the case; none if it walks
    int levels = 1;                   ///< of refinement
    std::vector<Entry> settings;      ///< keys of the case that have another value
    std::vector<Axis> axes;           ///< in the order of the file
    /// One of both if there are ranges without points.
    std::optional<LatinHypercube> sampling;
    std::optional<Atlas> atlas;
};

/// Most points of one axis or sample.
inline constexpr int most_values = 10'000;

/// Reads study and case file, whose keys are those of a contact, or `machine_keys` for the
/// micro-walking machine; every value is checked by itself for unit, kind and range. Throws
/// contact::InputError in one line: `file:line:column: key = value: rule; remedy`.
Study read_study(const std::string& path, const KeyList& machine_keys);

/// Same for a text; `name` stands for the file in messages and for the folder of the case.
Study parse_study(std::string_view text, const std::string& name, const KeyList& machine_keys);

/// The value of a range at these fractions of the way (or of the logarithm), as entries of a case.
/// Twelve digits: the last bits of powers and logarithms differ between computers.
std::vector<Entry> entries_at(const Study::Axis& axis, const std::vector<double>& fractions);

/// The value of an entry in a table: a number in the key's SI unit, or a word.
std::string table_value(const Key& key, const Entry& entry);
/// "substrate.thickness_m", "rolling.speed_m_per_s", "load.tangential_ratio".
std::string table_heading(const Key& key);

/// The keys below [set] of a study, as entries of a case that has these keys. Throws
/// contact::InputError.
std::vector<Entry> read_settings(const Document& document, const KeyList& keys);

/// The keys below [vary], each with its list or range. Throws contact::InputError.
std::vector<Study::Axis> read_axes(const Document& document, const KeyList& keys);

}  // namespace tricontact::io
