#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/records/experiment.h"
#include "tests/random/random_rig.h"
#include "tests/unit/experiments/records/synthetic_record.h"

namespace tricontact {

/// Values of a record and what is stated of it, then the text of its file.
struct RecordFile {
    experiments::Record record;
    experiments::Experiment stated;
    std::string heading = "time [s], shift [m], drive [m]", text = {};
};

/// A way to damage: how the record is made, its values, its text.
struct Damage {
    const char* name;
    std::function<void(tests::SyntheticRecord&, Random&)> before = [](auto&, auto&) {};
    std::function<void(RecordFile&, Random&)> values = [](auto&, auto&) {};
    std::function<void(RecordFile&, Random&)> text = [](auto&, auto&) {};
};

/// The first one leaves the record in order. Records are loaded at 10 s and roll from 40 s to 88 s.
std::vector<Damage> record_damages();

}  // namespace tricontact
