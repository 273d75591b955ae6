#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/models/make_model.h"
#include "benchmarks/comparison/comparison.h"
#include "benchmarks/submissions/read_field.h"
#include "io/case/case_reader.h"
#include "tests/paths.h"

// Results of other codes, and the references of their cases, each computed once.
namespace tricontact::benchmarks::foreign {

inline const std::string folder = paths::source("tests/benchmarks/foreign/");

inline Reference reference_of(const std::string& file,
                              const std::vector<std::string>& overrides = {}) {
    return reference(io::read_case(folder + file, overrides),
                     contact::ModelRunner(app::model_makers(), 1));
}

inline const Reference& layer_pressed() {
    static const Reference one = reference_of("layer_pressed.toml");
    return one;
}

inline MeshField field(const std::string& file) {
    return read_field({.file = folder + file, .set = "", .totals = ""});
}

inline Submission submission(const std::vector<std::string>& files) {
    Submission s;
    for (const std::string& file : files) s.meshes.push_back(field(file));
    return s;
}

inline Comparison compared(const Submission& s) {
    return compare(s, layer_pressed());
}

inline const ComparedNumber& number(const Comparison& c, const std::string& key) {
    const auto found = std::ranges::find(c.numbers, key, &ComparedNumber::key);
    if (found == c.numbers.end()) throw std::runtime_error("no number " + key);
    return *found;
}

inline bool has(const Comparison& c, const std::string& id) {
    return std::ranges::find(c.diagnoses, id, &Diagnosis::id) != c.diagnoses.end();
}

}  // namespace tricontact::benchmarks::foreign
