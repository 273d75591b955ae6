#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/design/law_separation.h"
#include "experiments/design/planned_comparison.h"
#include "io/case/rig_file.h"
#include "io/case/study_reader.h"

namespace tricontact::experiments {

/// A key of a rig that a design may choose.
struct DesignAxis {
    io::Study::Axis axis;     ///< a range without points
    std::string uncertainty;  ///< "± 0.1 mm" as the file states it of the key; empty: none

    const io::Study::Range& range() const { return std::get<io::Study::Range>(axis.values); }
    const io::Key& key() const { return *axis.key; }
};

/// What [design] asks of a rig.
struct DesignInput {
    io::RigFile rig;  ///< as the file has it
    std::vector<DesignAxis> axes;
    std::vector<std::string> assumptions;  ///< that shall hold, or criteria of them
    double deviation = 0;                  ///< instead of the rig check's accepted difference
    std::optional<double> resolution;      ///< that the comparison shall have, relative
    std::string quantity;                  ///< that is compared
    RecordPlan record;
    LawPlan laws;

    /// The rig with its keys at these fractions of their ranges, each with the uncertainty that the
    /// file states. Throws contact::InputError where that is no rig.
    io::RigFile at(const std::vector<double>& fractions) const;
};

/// Most keys that one design varies.
inline constexpr std::size_t most_design_axes = 4;

/// Reads [design] of a rig's file, and record.resolution. Throws contact::InputError in one line,
/// `file:line:column: key = value: rule; remedy`.
DesignInput read_design(const io::RigFile& rig);

}  // namespace tricontact::experiments
