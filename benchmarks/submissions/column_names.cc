#include "benchmarks/submissions/column_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

namespace tricontact::benchmarks {

namespace {

using enum Meaning;
using Words = std::vector<std::string_view>;

/// Names in lower case without blanks and signs; Greek letters by their names.
std::string plain_name(std::string_view name) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 5> letters{
        {{"\u03c3", "sigma"},
         {"\u03c4", "tau"},
         {"\u03bb", "lambda"},
         {"\u2093", "x"},
         {"\u2099", "n"}}};
    std::string out;
    for (std::size_t i = 0; i < name.size();) {
        const auto letter = std::ranges::find_if(
            letters, [&](const auto& one) { return name.substr(i).starts_with(one.first); });
        if (letter != letters.end()) {
            out += letter->second;
            i += letter->first.size();
            continue;
        }
        const auto c = static_cast<unsigned char>(name[i++]);
        if (c < 0x80 && std::isalnum(c)) out += static_cast<char>(std::tolower(c));
    }
    return out;
}

/// ParaView writes the components of an array as "u:0".
std::string with_letter(std::string_view name) {
    const auto colon = name.rfind(':');
    const bool counted =
        colon != name.npos && colon + 2 == name.size() && name.back() >= '0' && name.back() <= '2';
    if (!counted) return std::string(name);
    return std::string(name.substr(0, colon)) + "xyz"[name.back() - '0'];
}

using Names = std::map<std::string, Recognised, std::less<>>;

void add(Names& names, const Words& words, Meaning meaning, bool is_specific = false) {
    for (const auto word : words) names.emplace(word, Recognised{meaning, is_specific});
}

/// "ux", "u1", "xu" ... of each base; "ur" as "ux".
void add_vector(Names& names, const Words& bases, const std::array<Meaning, 3>& meanings,
                bool is_specific = false) {
    for (const auto base : bases)
        for (std::size_t k = 0; k < 3; ++k) {
            Words ends{std::string_view("xyz").substr(k, 1), std::string_view("123").substr(k, 1)};
            if (k == 0) ends.push_back("r");
            for (const auto end : ends)
                names.emplace(std::string(base) + std::string(end),
                              Recognised{meanings[k], is_specific});
        }
}

void add_positions(Names& names) {
    add(names,
        {"r", "radius", "rad", "radial", "radialcoordinate", "radialposition", "distancefromaxis"},
        r);
    add_vector(names,
               {"", "coord", "coor", "coordcoor", "coordinate", "coordinates", "points", "point",
                "pos", "position", "node"},
               {x, y, z});
    for (const char* base : {"coord", "coordinate", "pos", "position"})
        for (std::size_t k = 0; k < 3; ++k)
            names.emplace("xyz"[k] + std::string(base), Recognised{std::array{x, y, z}[k], false});
    add(names, {"x1"}, x);
    add(names, {"x2"}, y);
    add(names, {"x3"}, z);
    names.erase("1");  // numbers of columns, no names
    names.erase("2");
    names.erase("3");
    names.insert_or_assign("r", Recognised{r, false});
}

void add_pressures(Names& names) {
    add(names, {"p", "pressure", "press", "pres", "pn", "sigman", "sn", "normalstress"}, pressure);
    add(names,
        {"cpress",
         "contactpressure",
         "contpres",
         "contactpres",
         "pcontact",
         "contactp",
         "normaltraction",
         "tractionnormal",
         "tractionn",
         "tn",
         "contactstress",
         "normalcontactstress",
         "contactnormalstress",
         "contactnormaltraction",
         "normalcontacttraction",
         "normalcontactpressure",
         "contactnormalpressure",
         "augmentednormalcontactpressure",
         "lagrangemultiplier",
         "lagrangemultipliernormal",
         "lagrangemultipliercontactpressure",
         "normallm",
         "frictionalnormallm",
         "frictionlessnormallm",
         "lambda",
         "lambdan",
         "lagsc"},
        pressure, true);
}

void add_tractions(Names& names) {
    constexpr std::array all{traction_x, traction_y, traction_z};
    add_vector(names, {"t", "tau", "q", "traction", "shear", "shearstress", "tangentialstress"},
               all);
    add_vector(names,
               {"cshear", "contacttraction", "contactshear", "contactshearstress",
                "tangentialtraction", "tangentialcontactstress", "friction", "frictionstress",
                "frictionaltraction", "frictionalstress", "contactstress", "contactstresses"},
               all, true);
    add(names, {"px"}, traction_x, true);  // of the program CONTACT
    add(names, {"py"}, traction_y, true);
    add(names,
        {"tau", "q", "shearstress", "tangentialtraction", "tangentialstress", "sheartraction"},
        traction_x);
    names.erase("tr");
}

void add_forces(Names& names) {
    constexpr std::array all{force_x, force_y, force_z};
    add_vector(names, {"f", "force", "forc"}, all);
    add_vector(names, {"nodalforce", "contactforce", "cforce", "cforc", "contactnodalforce"}, all,
               true);
    add(names, {"fn", "normalforce", "forcen", "forcenormal", "nodalforce"}, force_normal);
    add(names,
        {"cnormf", "cnormfmagnitude", "contactforce", "normalcontactforce", "contactnormalforce",
         "contactforcenormal"},
        force_normal, true);
    add(names, {"cshearf1"}, force_x, true);
    add(names, {"cshearf2"}, force_y, true);
    names.erase("fr");
}

void add_stresses(Names& names) {
    for (const char* base :
         {"s", "sigma", "sig", "stress", "cauchystress", "stresses", "tau", "sigm", "sief", "si"}) {
        const auto of = [&](const Words& ends, Meaning meaning) {
            for (const auto end : ends)
                names.emplace(std::string(base) + std::string(end), Recognised{meaning, false});
        };
        of({"zz", "33"}, stress_zz);
        of({"xz", "13", "zx", "31"}, stress_xz);
        of({"yz", "23", "zy", "32"}, stress_yz);
    }
}

void add_others(Names& names) {
    add_vector(names,
               {"u", "d", "disp", "displ", "displacement", "displacements", "depl", "solidu"},
               {displacement_x, displacement_y, displacement_z});
    add(names, {"gap", "g", "gn", "gapn", "opening", "clearance", "normalgap"}, gap);
    add(names,
        {"copen", "contactgap", "contgap", "contactopening", "contactclearance", "weightedgap"},
        gap, true);
    add(names, {"status", "state", "stick"}, status);
    add(names, {"contactstatus", "contactstate", "cstatus", "contactstick"}, status, true);
    add(names,
        {"area", "da", "weight", "weights", "jxw", "nodalarea", "cellarea", "nodearea", "pointarea",
         "tributaryarea", "areas", "ds"},
        area);
    add(names, {"cnarea", "contactarea"}, area, true);
}

Names make_names() {
    Names names;
    add_positions(names);
    add_pressures(names);
    add_tractions(names);
    add_forces(names);
    add_stresses(names);
    add_others(names);
    return names;
}

}  // namespace

Recognised recognised(std::string_view name) {
    static const Names names = make_names();
    const auto found = names.find(plain_name(with_letter(name)));
    return found == names.end() ? Recognised{} : found->second;
}

std::string_view name_of(Meaning meaning) {
    switch (meaning) {
        case x:
            return "position x";
        case y:
            return "position y";
        case z:
            return "position z";
        case r:
            return "distance r from the axis";
        case area:
            return "area of a point";
        case pressure:
            return "normal traction";
        case traction_x:
            return "traction along x";
        case traction_y:
            return "traction along y";
        case traction_z:
            return "traction along z";
        case force_normal:
            return "normal nodal force";
        case force_x:
            return "nodal force along x";
        case force_y:
            return "nodal force along y";
        case force_z:
            return "nodal force along z";
        case stress_zz:
            return "stress zz";
        case stress_xz:
            return "stress xz";
        case stress_yz:
            return "stress yz";
        case displacement_x:
            return "displacement along x";
        case displacement_y:
            return "displacement along y";
        case displacement_z:
            return "displacement along z";
        case gap:
            return "gap";
        case status:
            return "contact status";
        case other:
            break;
    }
    return "not used";
}

std::vector<io::Dimension> dimensions_of(Meaning meaning) {
    using io::Dimension;
    switch (meaning) {
        case x:
        case y:
        case z:
        case r:
        case gap:
        case displacement_x:
        case displacement_y:
        case displacement_z:
            return {Dimension::length};
        case area:
            return {Dimension::area, Dimension::length};
        case pressure:
        case traction_x:
        case traction_y:
        case traction_z:
        case stress_zz:
        case stress_xz:
        case stress_yz:
            return {Dimension::pressure};
        case force_normal:
        case force_x:
        case force_y:
        case force_z:
            return {Dimension::force, Dimension::stiffness};
        case status:
        case other:
            break;
    }
    return {};
}

Meaning as_force(Meaning meaning) {
    switch (meaning) {
        case pressure:
            return force_normal;
        case traction_x:
            return force_x;
        case traction_y:
            return force_y;
        case traction_z:
            return force_z;
        default:
            return meaning;
    }
}

std::vector<std::string> component_names(std::string_view array, int n_components,
                                         std::string_view axes) {
    const std::string base(array);
    const auto letter = [&](char c) { return axes[static_cast<std::size_t>(c - 'x')]; };
    std::vector<std::string> names;
    static const Words of_6{"xx", "yy", "zz", "xy", "yz", "xz"},
        of_9{"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
    if (n_components == 1) return {base};
    for (int k = 0; k < n_components; ++k) {
        if (n_components == 6 || n_components == 9) {
            const auto pair = (n_components == 6 ? of_6 : of_9)[static_cast<std::size_t>(k)];
            names.push_back(base + '_' + letter(pair[0]) + letter(pair[1]));
        } else if (n_components <= 3) {
            names.push_back(base + '_' + letter("xyz"[k]));
        } else {
            names.push_back(base + '_' + std::to_string(k));
        }
    }
    return names;
}

}  // namespace tricontact::benchmarks
