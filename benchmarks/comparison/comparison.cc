#include "benchmarks/comparison/comparison.h"

namespace tricontact::benchmarks {

const char* name_of(Standing standing) {
    constexpr const char* names[] = {"pass", "fail", "not-resolved"};
    return names[static_cast<int>(standing)];
}

double ComparedNumber::explained_change() const {
    double sum = 0;
    for (const Explained& one : explained) sum += one.change;
    return sum;
}

}  // namespace tricontact::benchmarks
