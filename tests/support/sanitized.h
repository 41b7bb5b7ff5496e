// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace brink::support {

/// Whether this is compiled with AddressSanitizer, under which what takes seconds takes minutes.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#else
inline constexpr bool sanitized = false;
#endif

} // namespace brink::support
