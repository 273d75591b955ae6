#pragma once

#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace tricontact::contact {

/// Numbers, texts and vectors of numbers one after the other, as they lie in memory: for state
/// that the same program on the same machine reads again.
class StateWriter {
  public:
    template <class... T>
    void operator()(const T&... values) {
        (add(values), ...);
    }
    std::string take() { return std::move(bytes_); }

  private:
    template <class T>
    void add(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    template <class T>
    void add(const std::vector<T>& values) {
        static_assert(std::is_trivially_copyable_v<T>);
        add(values.size());
        if (!values.empty())
            bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    }
    void add(const std::string& text) {
        add(text.size());
        bytes_ += text;
    }

    std::string bytes_;
};

/// Reads what StateWriter wrote, in the same order. Throws std::runtime_error at the end.
class StateReader {
  public:
    explicit StateReader(std::string_view bytes) : rest_(bytes) {}

    template <class... T>
    void operator()(T&... values) {
        (get(values), ...);
    }
    bool at_end() const { return rest_.empty(); }

  private:
    template <class T>
    void get(T& value) {
        std::memcpy(&value, next(sizeof value), sizeof value);
    }
    template <class T>
    void get(std::vector<T>& values) {
        std::size_t n = 0;
        get(n);
        if (n > rest_.size() / sizeof(T)) throw std::runtime_error("state: it ends too early");
        values.resize(n);
        if (n > 0) std::memcpy(values.data(), next(n * sizeof(T)), n * sizeof(T));
    }
    void get(std::string& text) {
        std::size_t n = 0;
        get(n);
        text.assign(next(n), n);
    }

    const char* next(std::size_t n) {
        if (n > rest_.size()) throw std::runtime_error("state: it ends too early");
        const char* const here = rest_.data();
        rest_.remove_prefix(n);
        return here;
    }

    std::string_view rest_;
};

}  // namespace tricontact::contact
