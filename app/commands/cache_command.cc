#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <filesystem>
#include <iostream>

#include "app/fem_entries.h"
#include "contact/error.h"
#include "fem/layer_cache.h"
#include "fem/layer_folder.h"
#include "files/partial_file.h"

namespace tricontact::app {

namespace {

namespace fs = std::filesystem;

std::string summary_of(const std::vector<fem::KeptLayer>& layers) {
    return fmt::format("{} condensed layer{}, {}", layers.size(), layers.size() == 1 ? "" : "s",
                       fem::size_text(fem::bytes_of(layers)));
}

std::string line_of(const fem::KeptLayer& layer) {
    return fmt::format("{:>8}  {:%Y-%m-%d %H:%M}  {}\n", fem::size_text(layer.bytes),
                       fmt::localtime(layer.used.tv_sec), fs::path(layer.path).stem().string());
}

void clear(const std::string& folder, const std::vector<fem::KeptLayer>& layers) {
    for (const fem::KeptLayer& layer : layers) {
        std::error_code error;
        fs::remove(layer.path, error);
        if (error)
            throw contact::InputError(fmt::format(
                "{}: cannot be removed ({}); check the permissions", layer.path, error.message()));
    }
    std::cout << fmt::format("{}: removed {}\n", folder, summary_of(layers));
}

}  // namespace

void list_or_clear_cache(const CacheOptions& options) {
    const std::string folder = fem::LayerCache(options.folder).folder();
    if (folder.empty())
        throw contact::InputError(
            "cache: layers are kept nowhere (neither XDG_CACHE_HOME nor HOME is set, or the folder "
            "is \"none\"); name one by --folder");
    files::remove_left_partial_files(folder);
    const std::vector<fem::KeptLayer> layers = fem::kept_layers(folder);
    if (options.clear) return clear(folder, layers);
    std::cout << fmt::format("{}: {}, at most {} (TRICONTACT_CACHE_LIMIT)\n", folder,
                             summary_of(layers), fem::size_text(fem::cache_limit()));
    for (const fem::KeptLayer& layer : layers) std::cout << line_of(layer);
}

}  // namespace tricontact::app
