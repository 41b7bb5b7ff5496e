// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/multiprecision/mpfr.hpp>

namespace brink::support {

/// 100 decimal digits (MPFR). A double converts exactly; exponents do not overflow.
using Hundred = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<100, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

} // namespace brink::support
