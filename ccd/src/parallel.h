// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace brink {

/// A reference to something that may be called with an index. It must outlive the reference.
class PartTask {
public:
    template <class F>
    PartTask(const F& task)
        : task_(&task), call_([](const void* t, std::size_t i) { (*static_cast<const F*>(t))(i); })
    {
    }
    void operator()(std::size_t i) const { call_(task_, i); }

private:
    const void* task_;
    void (*call_)(const void*, std::size_t);
};

/// Calls task(0), ..., task(count - 1), in any order and side by side in the caller's oneTBB arena where
/// there is one. Small parts are taken together, so many as `grain`.
void for_each_part(std::size_t count, PartTask task, std::size_t grain = 64);

} // namespace brink
