#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/reference/reference.h"
#include "benchmarks/submissions/submission.h"
#include "comparisons/resolution/refinement.h"

namespace tricontact::benchmarks {

/// A point of a code's surface in this project's conventions: SI, about the centre of the contact,
/// tractions on the elastic body, compression positive. What the code does not tell is NaN.
struct SurfacePoint {
    double x = 0, y = 0;
    double area = 0;  ///< what it stands for [m^2], in a plane contact the length along x [m]
    SurfaceValues values;
    double gap, status;
};

/// A convention that was found out, and the number that decided.
struct Convention {
    std::string id;      ///< "units", "kind", "share", "sign", "axes", "coordinates"
    std::string choice;  ///< "pressure in MPa"
    std::string number;  ///< "the integral is 1.002 F_N"
};

/// What one mesh says, understood.
struct MeshResult {
    std::string file;
    double size = 0;  ///< of elements in the contact [m]
    Geometry geometry = Geometry::spatial;
    std::vector<SurfacePoint> points;
    Faces faces;
    std::map<std::string, double> totals;  ///< of the whole contact, SI
    std::optional<double> cpu_time;        ///< [s]
};

/// A diagnosis: what the numbers show and what helps.
struct Diagnosis {
    std::string id;        ///< "penalty", "locking"
    std::string sentence;  ///< with its number and formula
    std::string remedy;
};

enum class Standing { pass, fail, not_resolved };
/// "pass", "fail", "not-resolved".
const char* name_of(Standing standing);

/// A first-order effect that explains part of a difference.
struct Explained {
    std::string id;     ///< "penalty", "stick_slope", "displaced_surface", "block", "one_step"
    std::string title;  ///< "normal penalty"
    double change = 0;  ///< over the reference's value [-]
    double bar = 0;     ///< half width [-]
};

/// A number of the code beside that of the reference. Relative to the reference's value where it
/// has one, norms to 0.
struct ComparedNumber {
    std::string key;    ///< quantity_keys, or of a norm "pressure_l2", "load_within", ...
    std::string title;  ///< "normal force F_N"
    std::string unit;   ///< SI; "" of norms
    bool is_norm = false;
    std::vector<std::optional<double>> values;        ///< per mesh
    ReferenceValue reference;                         ///< of norms value 0, bars relative
    std::optional<comparisons::LimitEstimate> limit;  ///< over a family of at least three meshes
    std::string expected_order;                       ///< "1 (square root at the contact's edge)"
    double finest = 0;                                ///< difference of the finest mesh [-]
    double difference = 0;  ///< extrapolated, else finest, minus reference [-]
    std::vector<Explained> explained;
    double discretisation = 0;  ///< GCI or spread [-]
    double uncertainty = 0;     ///< U: discretisation, reference and explained [-]
    double tolerance = 0;
    Standing standing = Standing::not_resolved;  ///< with what is explained
    Standing unexplained_standing = Standing::not_resolved;
    std::string blame;   ///< the largest term of U where not resolved
    std::string remedy;  ///< what would resolve it

    double explained_change() const;
    double left() const { return difference - explained_change(); }
};

/// All that is said of a submission.
struct Comparison {
    std::string title;  ///< of the problem
    std::string name;   ///< of the problem
    Submission submission;
    Reference reference;
    std::vector<MeshResult> meshes;  ///< coarse to fine
    bool is_family = false;          ///< similar in every direction
    std::vector<Convention> conventions;
    std::vector<ComparedNumber> numbers;  ///< quantities first, then norms
    std::vector<Diagnosis> diagnoses;
    std::vector<std::string> sentences;  ///< in order of weight
    Standing standing = Standing::not_resolved;
    Standing unexplained_standing = Standing::not_resolved;
    std::string blame;
};

/// Throws contact::InputError where conventions are ambiguous (with both readings) or nothing can
/// be compared.
Comparison compare(Submission submission, Reference reference);

}  // namespace tricontact::benchmarks
