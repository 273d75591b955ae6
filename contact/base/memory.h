#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace tricontact::contact {

/// Memory that this process may still take [bytes]: the system's, the limits of the process
/// (ulimit -v, -d) and of its control group, whichever is least.
double available_bytes();

/// Throws InputError "<what> needs 12.3 GB of memory, 4.5 GB are there; <remedy>" where that is so.
void require_memory(const std::string& what, double bytes, const std::string& remedy);

/// Asks for large pages under memory that has not been touched yet: touching it for the first time
/// takes a fault for each page, and fields of large grids are passed over again and again, where
/// each page has to be found. No effect on small memory or where the system has none.
void use_large_pages(void* memory, std::size_t bytes);

/// Touches memory for the first time, as use_large_pages(), by several threads: the system clears
/// it then, which takes longer than to fill it. What it holds does not change. No effect where the
/// system does not know how.
void touch(void* memory, std::size_t bytes, int n_threads);

/// Not initialised, on large pages.
template <class Number>
std::unique_ptr<Number[]> large_memory(std::size_t n) {
    auto memory = std::make_unique_for_overwrite<Number[]>(n);
    use_large_pages(memory.get(), n * sizeof(Number));
    return memory;
}

/// Of an empty vector, on large pages, first touched by so many threads.
template <class T>
void reserve_large(std::vector<T>& vector, std::size_t n, int n_threads = 1) {
    vector.reserve(n);
    use_large_pages(vector.data(), n * sizeof(T));
    if (n_threads > 1) touch(vector.data(), n * sizeof(T), n_threads);
}

/// `n` zeros, likewise.
inline std::vector<double> large_field(std::size_t n, int n_threads = 1) {
    std::vector<double> field;
    reserve_large(field, n, n_threads);
    field.resize(n);
    return field;
}

/// A copy, likewise where it is new memory.
inline void copy_large(const std::vector<double>& from, std::vector<double>& to,
                       int n_threads = 1) {
    if (to.capacity() < from.size()) {
        to = {};
        reserve_large(to, from.size(), n_threads);
    }
    to.assign(from.begin(), from.end());
}
inline std::vector<double> large_copy(const std::vector<double>& field, int n_threads = 1) {
    std::vector<double> copy;
    copy_large(field, copy, n_threads);
    return copy;
}

}  // namespace tricontact::contact
