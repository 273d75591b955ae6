#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tricontact::benchmarks {

/// What a column of a field stands for.
enum class Meaning {
    x,
    y,
    z,
    r,         ///< positions [m]
    area,      ///< what a point stands for [m^2]
    pressure,  ///< normal traction [Pa], of either sign
    traction_x,
    traction_y,
    traction_z,
    force_normal,
    force_x,
    force_y,
    force_z,  ///< nodal forces [N]
    stress_zz,
    stress_xz,
    stress_yz,  ///< of the body at the surface [Pa]
    displacement_x,
    displacement_y,
    displacement_z,
    gap,
    status,  ///< 0 open, 1 stick, 2 slip
    other    ///< read, not used
};

/// Values as they stand in a file.
struct FieldColumn {
    std::string heading;  ///< "CPRESS"
    Meaning meaning = Meaning::other;
    std::optional<std::string> unit;  ///< "MPa"; empty: the file has none, `values` as written
    std::vector<double> values;       ///< SI if the file has a unit
};

/// A number beside the field: a force, a depth.
struct Total {
    double value = 0;  ///< SI if the file has a unit
    std::optional<std::string> unit;
    std::string place;  ///< where it was read: "run_1.dat, set NIND", "submission.toml:12"
};

/// Faces of a surface, joined to a field's points: 2 or 3 (lines), 3 or 6 (triangles), 4, 8 or 9
/// (quadrilaterals) points, corners first, in VTK's order.
struct Faces {
    std::vector<int> offsets{0};  ///< n + 1
    std::vector<int> points;
    int size() const { return static_cast<int>(offsets.size()) - 1; }
};

/// What a code computed on one mesh, as its file says it.
struct MeshField {
    std::string file;    ///< for messages
    std::string format;  ///< "CSV", "CalculiX frd", "VTU"
    std::vector<FieldColumn> columns;
    Faces faces;                          ///< empty where the file has none
    std::map<std::string, Total> totals;  ///< by quantity_keys, and "size", "cpu_time"
    std::vector<std::string> notes;       ///< "columns read: "CPRESS" as normal traction"
    double n_elements = 0;                ///< of the whole mesh; 0: the file does not say it

    const FieldColumn* find(Meaning meaning) const;
    std::size_t size() const { return columns.empty() ? 0 : columns.front().values.size(); }
};

/// How a code enforces contact, as far as its user says it.
struct ContactMethod {
    enum class Kind { unknown, penalty, augmented_lagrangian, lagrange, mortar, nitsche };
    enum class Kinematics { unknown, undeformed, displaced, finite };
    Kind kind = Kind::unknown;
    Kinematics kinematics = Kinematics::unknown;
    std::optional<double> stiffness;    ///< K [Pa/m]
    std::optional<double> stick_slope;  ///< K_T [Pa/m]
    std::optional<int> press_steps;     ///< in how many steps it was pressed
    bool faceted_indenter = false;      ///< its surface is meshed with straight faces
};

/// How submissions and options name those, but for what is unknown.
struct MethodWord {
    const char* word;  ///< "augmented-lagrangian"
    ContactMethod::Kind kind;
};
std::span<const MethodWord> method_words();
struct KinematicsWord {
    const char* word;
    ContactMethod::Kinematics kinematics;
};
std::span<const KinematicsWord> kinematics_words();

/// Relative tolerances, by quantity or norm key; `usual` of all others.
struct Tolerances {
    double usual = .01;
    std::map<std::string, double> of;
    double at(const std::string& key) const {
        const auto found = of.find(key);
        return found == of.end() ? usual : found->second;
    }
};

/// Results of a code on one or more meshes, coarse to fine.
struct Submission {
    std::string problem;  ///< name in the catalogue, or a case file
    std::string code;     ///< "CalculiX 2.20"; empty: not said
    ContactMethod contact;
    Tolerances tolerances;
    std::optional<double> block_width;    ///< half width or radius of the block computed [m]
    std::optional<std::string> elements;  ///< "CAX8R"
    std::vector<MeshField> meshes;
};

}  // namespace tricontact::benchmarks
