#include "benchmarks/submissions/submission.h"

#include <algorithm>
#include <array>

namespace tricontact::benchmarks {

std::span<const MethodWord> method_words() {
    using enum ContactMethod::Kind;
    static constexpr std::array words{MethodWord{"penalty", penalty},
                                      MethodWord{"augmented-lagrangian", augmented_lagrangian},
                                      MethodWord{"lagrange", lagrange},
                                      MethodWord{"mortar", mortar}, MethodWord{"nitsche", nitsche}};
    return words;
}

std::span<const KinematicsWord> kinematics_words() {
    using enum ContactMethod::Kinematics;
    static constexpr std::array words{KinematicsWord{"undeformed", undeformed},
                                      KinematicsWord{"displaced", displaced},
                                      KinematicsWord{"finite", finite}};
    return words;
}

const FieldColumn* MeshField::find(Meaning meaning) const {
    const auto found = std::ranges::find(columns, meaning, &FieldColumn::meaning);
    return found == columns.end() ? nullptr : &*found;
}

}  // namespace tricontact::benchmarks
