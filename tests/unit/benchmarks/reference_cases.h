#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/models/make_model.h"
#include "benchmarks/reference/reference.h"
#include "contact/base/error.h"
#include "io/case/case_reader.h"
#include "tests/paths.h"

// Cases of references, and their references.
namespace tricontact::benchmarks::reference_cases {

inline contact::Case foreign_case(const std::string& name,
                                  const std::vector<std::string>& overrides = {}) {
    return io::read_case(paths::source("tests/benchmarks/foreign/") + name + ".toml", overrides);
}

/// Of boundary elements on the half-space.
inline contact::Case half_space_case(const std::string& rest,
                                     const std::vector<std::string>& overrides = {}) {
    return io::parse_case("models = [\"bem\"]\n" + rest, "case.toml", overrides);
}

inline Reference of(const contact::Case& c) {
    return reference(c, contact::ModelRunner(app::model_makers(), 1));
}

inline const std::string hertz = R"(
[indenter]
radius = "1 m"
[substrate]
young = "15 MPa"
poisson = 0.3
[friction]
coefficient = 0.3
[contact]
coupling = false
[load]
indentation = "10 mm"
tangential_ratio = 0
)";

/// Of a value and its bar.
inline void expect_within_bar(const Reference& reference, const char* key, double exact) {
    const ReferenceValue* value = reference.find(key);
    ASSERT_TRUE(value) << key;
    EXPECT_NEAR(value->value, exact, value->bar()) << key;
}

inline void expect_refused(const contact::Case& c, const std::string& assumption) {
    try {
        of(c);
        ADD_FAILURE() << "expected: " << assumption;
    } catch (const contact::InputError& error) {
        EXPECT_NE(std::string(error.what()).find(assumption), std::string::npos) << error.what();
    }
}

}  // namespace tricontact::benchmarks::reference_cases
