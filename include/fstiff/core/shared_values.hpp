// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Values that many calls need and no call changes, each computed when it is first asked for.
///
///     static detail::SharedValues<double, Table> tables;
///     const auto table = tables.at(gamma, [&] { return std::make_shared<const Table>(gamma); });

#include <fstiff/core/config.hpp>

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Values by their keys, for any threads. Of more than \p most the older ones are made anew: a value must not depend on
/// who asks.
template <class Key, class Value, std::size_t most = 64>
class SharedValues {
public:
    /// The value of \p key, to which \p make returns a shared_ptr; what it throws reaches the caller.
    template <class Make>
    [[nodiscard]] std::shared_ptr<const Value> at(const Key& key, const Make& make) {
        {
            const std::lock_guard lock(guard_);
            if (const auto found = values_.find(key); found != values_.end()) return found->second;
        }
        std::shared_ptr<const Value> made = make();  // outside of the lock: it may ask for others
        const std::lock_guard lock(guard_);
        if (values_.size() >= most) values_.clear();
        return values_.try_emplace(key, std::move(made)).first->second;
    }

private:
    std::mutex guard_;
    std::map<Key, std::shared_ptr<const Value>> values_;
};

}}}  // namespace fstiff::detail
