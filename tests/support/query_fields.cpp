// SPDX-License-Identifier: BSD-3-Clause
#include "query_fields.h"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace brink::support {
namespace {

constexpr std::uint64_t usual_nan = 0x7ff8000000000000U;

/// What std::from_chars makes of the whole text.
template <class Number, class How> std::optional<Number> all_of(std::string_view text, How how)
{
    Number out{};
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, out, how);
    if (error != std::errc() || stopped != end) return std::nullopt;
    return out;
}

void add(Numbers& to, double& number) { to.push_back(&number); }

void add(Numbers& to, Vec3& v)
{
    for (double& x : v)
        to.push_back(&x);
}

void add(Numbers& to, Quat& q)
{
    for (double* x : {&q.w(), &q.x(), &q.y(), &q.z()})
        to.push_back(x);
}

template <class... Members> Numbers all(Members&... members)
{
    Numbers out;
    (add(out, members), ...);
    return out;
}

Numbers numbers(Sphere& s) { return all(s.radius); }
Numbers numbers(Capsule& s) { return all(s.a, s.b, s.radius); }
Numbers numbers(Box& s) { return all(s.half_extents); }
Numbers numbers(Triangle& s) { return all(s.a, s.b, s.c); }
Numbers numbers(Plane& s) { return all(s.normal, s.offset); }
Numbers numbers(HalfSpace& s) { return all(s.normal, s.offset); }
Numbers numbers(Cylinder& s) { return all(s.half_length, s.radius); }
Numbers numbers(Cone& s) { return all(s.half_length, s.radius); }
Numbers numbers(Ellipsoid& s) { return all(s.radii); }
Numbers numbers(Hull&) { return {}; }

} // namespace

Numbers numbers(Shape& shape)
{
    return std::visit([](auto& s) { return numbers(s); }, shape);
}

std::array<Field, 5> fields(Motion& m)
{
    return {{{"position", all(m.start.position)},
             {"orientation", all(m.start.orientation)},
             {"translation", all(m.translation)},
             {"rotation", all(m.rotation)},
             {"pivot", all(m.pivot)}}};
}

std::array<Field, 3> fields(Options& o)
{
    return {{{"t_max", all(o.t_max)}, {"target_gap", all(o.target_gap)}, {"tolerance", all(o.tolerance)}}};
}

std::string number_text(double x)
{
    if (std::isnan(x)) {
        constexpr std::uint64_t sign = std::uint64_t{1} << 63U;
        const auto bits = std::bit_cast<std::uint64_t>(x);
        if ((bits | sign) != (usual_nan | sign)) return fmt::format("nan:{:016x}", bits);
        return bits == usual_nan ? "nan" : "-nan";
    }
    const std::string_view sign = std::signbit(x) ? "-" : "";
    if (std::isinf(x)) return fmt::format("{}inf", sign);
    std::array<char, 32> digits{};
    char* const first = digits.data();
    char* const last = std::to_chars(first, first + digits.size(), std::abs(x), std::chars_format::hex).ptr;
    return fmt::format("{}0x{}", sign, std::string_view(first, last));
}

std::optional<double> number_from(std::string_view text)
{
    constexpr std::string_view bits_mark = "nan:";
    if (text.starts_with(bits_mark)) {
        const auto bits = all_of<std::uint64_t>(text.substr(bits_mark.size()), 16);
        const auto x = std::bit_cast<double>(bits.value_or(0));
        return std::isnan(x) ? std::optional(x) : std::nullopt;
    }
    const bool negative = text.starts_with('-');
    if (negative) text.remove_prefix(1);
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    std::optional<double> x;
    if (text == "nan")
        x = std::bit_cast<double>(usual_nan);
    else if (text == "inf")
        x = infinity;
    else if (text.starts_with("0x") && text.size() > 2 && text[2] != '-')
        x = all_of<double>(text.substr(2), std::chars_format::hex);
    else if (!text.empty() && is_digit(text[0]))
        x = all_of<double>(text, std::chars_format::general);
    if (x && negative) x = -*x;
    return x;
}

} // namespace brink::support
