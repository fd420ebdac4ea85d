// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The values that a program gives to the fields of a request, by their keys.

#include "request/field.hpp"

#include <functional>
#include <map>

namespace fstiff::request {

class Values {
public:
    /// \throws domain_error for a key that is there.
    void add(const std::string& key, Value value) {
        if (!values_.emplace(key, std::move(value)).second) throw domain_error("options: " + key + " is listed twice");
    }
    /// Puts the value of \p key into \p to, if there is one. \throws as put().
    template <class Member>
    void read(std::string_view key, Member& to, const Field& field = {}) {
        known_ += (known_.empty() ? "" : ", ") + std::string(key);
        const auto entry = values_.find(key);
        if (entry == values_.end()) return;
        put(entry->second, to, key, field);
        values_.erase(entry);
    }
    /// Reads every field of \p owner.
    template <class Owner>
    void fill(Owner& owner) {
        owner.each_field([&](std::string_view key, auto& to, const Field& field) { read(key, to, field); });
    }
    /// \throws domain_error for a value that nobody has read.
    void require_known() const {
        if (!values_.empty())
            throw domain_error("options: " + values_.begin()->first.substr(0, 40) +
                               " is not an option; must be one of " + known_);
    }

private:
    std::map<std::string, Value, std::less<>> values_;
    std::string known_;
};

}  // namespace fstiff::request
