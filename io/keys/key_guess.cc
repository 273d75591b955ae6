#include "io/keys/key_guess.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "io/keys/key.h"
#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

using Paths = std::vector<std::string_view>;

// What formulas and textbooks call a key.
constexpr std::array<std::pair<std::string_view, std::string_view>, 21> symbols{
    {{"E", "young"},
     {"modulus", "young"},
     {"nu", "poisson"},
     {"mu", "coefficient"},
     {"mu", "friction_coefficient"},
     {"friction", "coefficient"},
     {"R", "radius"},
     {"b", "thickness"},
     {"h", "spacing"},
     {"h", "size"},
     {"d", "indentation"},
     {"F_N", "normal_force"},
     {"FN", "normal_force"},
     {"F_T", "tangential_force"},
     {"FT", "tangential_force"},
     {"f_T", "tangential_ratio"},
     {"fT", "tangential_ratio"},
     {"w", "amplitude_ratio"},
     {"W", "amplitude"},
     {"v_0", "base_velocity"},
     {"v0", "base_velocity"}}};

std::string_view named(std::string_view name, const Paths& paths) {
    const auto found = std::ranges::find(paths, name, name_of_key);
    return found == paths.end() ? std::string_view() : *found;
}

std::string_view behind_symbol(std::string_view symbol, const Paths& paths) {
    for (const auto& [from, to] : symbols)
        if (from == symbol)
            if (const auto path = named(to, paths); !path.empty()) return path;
    return {};
}

std::string_view nearly_named(std::string_view name, const Paths& paths) {
    Paths names;
    for (const auto path : paths) names.push_back(name_of_key(path));
    const std::string_view near = nearest(name, names);
    return near.empty() ? near : named(near, paths);
}

// By the whole path, if the name alone is near too: "substrate.E" is not nearly "substrate.base".
std::string_view nearly_spelt(std::string_view path, const Paths& paths) {
    const std::string_view near = nearest(path, paths);
    return nearly_named(name_of_key(path), {near}).empty() ? std::string_view() : near;
}

// "youngs_modulus" begins with "young".
std::string_view begun_alike(std::string_view name, const Paths& paths) {
    constexpr std::size_t least = 4;
    const auto alike = [&](std::string_view path) {
        const std::string_view other = name_of_key(path);
        return std::min(name.size(), other.size()) >= least &&
               (name.starts_with(other) || other.starts_with(name));
    };
    const auto found = std::ranges::find_if(paths, alike);
    return found == paths.end() ? std::string_view() : *found;
}

}  // namespace

std::string likely_path(std::string_view path, std::span<const std::string_view> known) {
    const std::string_view name = name_of_key(path);
    const Paths all(known.begin(), known.end());
    Paths siblings, others;
    for (const auto one : known)
        (section_of(one) == section_of(path) ? siblings : others).push_back(one);
    for (const auto& guess :
         {named(name, all), behind_symbol(name, siblings), nearly_named(name, siblings),
          begun_alike(name, siblings), behind_symbol(name, others), nearly_spelt(path, others)})
        if (!guess.empty()) return std::string(guess);
    return {};
}

std::string did_you_mean(std::string_view near, std::string_view otherwise) {
    return near.empty() ? std::string(otherwise) : "did you mean " + std::string(near) + "?";
}

}  // namespace tricontact::io
