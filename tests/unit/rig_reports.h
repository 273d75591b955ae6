#pragma once

#include <gtest/gtest.h>

#include <string>

#include "io/rig_reader.h"
#include "rig/check_rig.h"

// What tests ask of the report of a file in rigs/.
namespace tricontact {

inline io::Rig rig_file(const std::string& name) {
    return io::read_rig(TRICONTACT_SOURCE_DIR "/rigs/" + name + ".toml");
}

inline rig::RigReport report_of(const std::string& name) {
    return std::visit([](const auto& rig) { return rig::check_rig(rig); }, rig_file(name));
}

inline const rig::Assumption& assumption_of(const rig::RigReport& report, const std::string& name) {
    for (const auto& one : report.assumptions)
        if (one.name == name) return one;
    throw std::out_of_range(name);
}

inline const rig::Calculation& calculation_of(const rig::RigReport& report,
                                              const std::string& name) {
    for (const auto& assumption : report.assumptions) {
        for (const auto& one : assumption.criteria)
            if (one.calculation.name == name) return one.calculation;
        for (const auto& one : assumption.background)
            if (one.name == name) return one;
    }
    throw std::out_of_range(name);
}

inline double value_of(const rig::RigReport& report, const std::string& name) {
    return calculation_of(report, name).result.value;
}

inline const rig::PrintedCheck& print_of(const rig::RigReport& report, const std::string& name) {
    for (const auto& one : report.printed)
        if (one.printed.name == name) return one;
    throw std::out_of_range(name);
}

/// The value of a given quantity that the print would follow from.
inline double needed(const rig::PrintedCheck& check, const std::string& symbol) {
    for (const auto& one : check.substitutes)
        if (one.symbol == symbol) return one.needed;
    throw std::out_of_range(symbol);
}

}  // namespace tricontact
