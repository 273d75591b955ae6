#pragma once

#include <algorithm>
#include <future>
#include <span>
#include <thread>
#include <vector>

#include "walking/run/walk.h"

namespace tricontact::walking {

/// walk_batch on all processors, an equal part of the cases each: no run depends on the others.
inline std::vector<Walk> walks_side_by_side(std::span<const WalkCase> cases,
                                            const Recording& recording = {}) {
    const std::size_t n_threads = std::max(1u, std::thread::hardware_concurrency());
    const std::size_t part = (cases.size() + n_threads - 1) / n_threads;
    std::vector<std::future<std::vector<Walk>>> parts;
    for (std::size_t begin = 0; begin < cases.size(); begin += part)
        parts.push_back(std::async(std::launch::async, [=] {
            return walk_batch(cases.subspan(begin, std::min(part, cases.size() - begin)),
                              recording);
        }));
    std::vector<Walk> walks;
    for (auto& each : parts)
        for (Walk& walk : each.get()) walks.push_back(std::move(walk));
    return walks;
}

}  // namespace tricontact::walking
