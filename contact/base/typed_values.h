#pragma once

#include <any>
#include <map>
#include <typeindex>

namespace tricontact::contact {

/// At most one value of each type, copied with their owner, who does not have to know the types: a
/// change of one of them recompiles those who read it, not those who see the owner.
class TypedValues {
  public:
    /// Null where none was set.
    template <class T>
    const T* find() const {
        const auto found = values_.find(typeid(T));
        return found == values_.end() ? nullptr : std::any_cast<T>(&found->second);
    }
    /// T's default where none was set.
    template <class T>
    const T& of() const {
        static const T unset{};
        const T* found = find<T>();
        return found ? *found : unset;
    }
    /// The same to be changed; T's default is set where none was.
    template <class T>
    T& of() {
        std::any& value = values_[typeid(T)];
        if (!value.has_value()) value.emplace<T>();
        return *std::any_cast<T>(&value);
    }
    template <class T>
    void reset() {
        values_.erase(typeid(T));
    }

  private:
    std::map<std::type_index, std::any> values_;
};

}  // namespace tricontact::contact
