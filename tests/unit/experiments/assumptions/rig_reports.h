#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "experiments/assumptions/check_rig.h"
#include "experiments/assumptions/rig_quantities.h"
#include "io/keys/input_file.h"
#include "tests/paths.h"
#include "walking/input/walk_keys.h"

// What tests ask of the report of a file in examples/rigs/.
namespace tricontact {

inline experiments::Rig rig_file(const std::string& name) {
    const std::string path = paths::source("examples/rigs/") + name + ".toml";
    if (!name.starts_with("micro")) return experiments::rolling_rig(io::read_rig_file(path));
    return experiments::walking_rig(io::parse_document(io::read_input_file(path), path),
                                    walking::walk_file_keys());
}

/// Numbers of a rig and what they become, in turn.
using RigChanges = std::vector<std::pair<experiments::Inputs::Member, experiments::RigNumber>>;
inline experiments::Rig changed(experiments::Rig rig, const RigChanges& changes) {
    for (const auto& [number, value] : changes) rig.*number = value;
    return rig;
}

/// Computed once: the layer's equations behind every derivative take a second.
inline const experiments::RigReport& report_of(const std::string& name) {
    static std::map<std::string, experiments::RigReport> reports;
    const auto found = reports.find(name);
    if (found != reports.end()) return found->second;
    return reports[name] = experiments::check_rig(rig_file(name));
}

inline const experiments::Assumption& assumption_of(const experiments::RigReport& report,
                                                    const std::string& name) {
    for (const auto& one : report.assumptions)
        if (one.name == name) return one;
    throw std::out_of_range(name);
}

inline const experiments::Calculation& calculation_of(const experiments::RigReport& report,
                                                      const std::string& name) {
    for (const auto& assumption : report.assumptions)
        if (const auto* found = assumption.find(name)) return *found;
    throw std::out_of_range(name);
}

inline double value_of(const experiments::RigReport& report, const std::string& name) {
    return calculation_of(report, name).result.value;
}

inline const experiments::PrintedCheck& print_of(const experiments::RigReport& report,
                                                 const std::string& name) {
    for (const auto& one : report.printed)
        if (one.printed.name == name) return one;
    throw std::out_of_range(name);
}

/// The value of a given quantity that the print would follow from.
inline double needed(const experiments::PrintedCheck& check, const std::string& symbol) {
    for (const auto& one : check.substitutes)
        if (one.symbol == symbol) return one.needed;
    throw std::out_of_range(symbol);
}

}  // namespace tricontact
