// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

/// Exact arithmetic on doubles: for the rare question that rounding must not decide.
namespace brink {

/// A number as mantissa * 2^exponent, for what does not fit a double's range. 1/2 <= |mantissa| < 2, or 0.
struct Scaled {
    double mantissa = 0;
    int exponent = 0;
};

/// A sum of products of doubles, exactly: sign * (limb[0] + limb[1] 2^64 + ...) * 2^(64 place). It lives on
/// the stack and holds `Capacity` limbs; whoever multiplies must know beforehand that they are enough
/// (`Span`): beyond them its value is lost.
template <int Capacity> class Dyadic {
public:
    Dyadic() {} // NOLINT(modernize-use-equals-default): zeroing all limbs costs more than the sums
    Dyadic(const Dyadic& other) { *this = other; }
    /// x * 2^(64 shift). x finite.
    explicit Dyadic(double x, int shift = 0)
    {
        const auto bits = std::bit_cast<std::uint64_t>(x);
        const int biased = static_cast<int>((bits >> 52U) & 0x7ffU);
        std::uint64_t whole = bits & 0xfffffffffffffU;
        if (biased != 0) whole |= std::uint64_t{1} << 52U;
        // The last bit stands for 2^(biased - 1075), or 2^-1074 in a subnormal; 1088 = 17 * 64.
        const int low = (biased != 0 ? biased : 1) - 1075 + 1088, part = low % 64;
        limb_[0] = whole << part;
        limb_[1] = part == 0 ? 0 : whole >> (64 - part);
        count_ = 2;
        place_ = low / 64 - 17 + shift;
        negative_ = (bits >> 63U) != 0;
        trim();
    }
    Dyadic& operator=(const Dyadic& other)
    {
        if (this == &other) return *this;
        for (int i = 0; i < other.count_; ++i)
            limb_[i] = other.limb_[i];
        count_ = other.count_;
        place_ = other.place_;
        negative_ = other.negative_;
        return *this;
    }

    /// -1, 0 or 1.
    int sign() const { return count_ == 0 ? 0 : negative_ ? -1 : 1; }

    /// Rounded towards zero.
    Scaled rounded() const
    {
        if (count_ == 0) return {};
        const auto limb = [&](int back) { return back < count_ ? limb_[count_ - 1 - back] : 0; };
        const int zeros = std::countl_zero(limb(0));
        const std::uint64_t top = zeros == 0 ? limb(0) : limb(0) << zeros | limb(1) >> (64 - zeros);
        const double mantissa = static_cast<double>(top >> 11U) * 0x1p-52;
        return {negative_ ? -mantissa : mantissa, 64 * (place_ + count_) - zeros - 1};
    }

    Dyadic operator-() const
    {
        Dyadic out = *this;
        out.negative_ = !negative_;
        return out;
    }

    friend Dyadic operator+(const Dyadic& a, const Dyadic& b)
    {
        if (a.count_ == 0) return b;
        if (b.count_ == 0) return a;
        if (a.negative_ == b.negative_) return added(a, b);
        const int order = compare_magnitudes(a, b);
        if (order == 0) return {};
        return order > 0 ? taken(a, b) : taken(b, a);
    }
    friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }

    friend Dyadic operator*(const Dyadic& a, const Dyadic& b)
    {
        Dyadic out;
        if (a.count_ == 0 || b.count_ == 0) return out;
        const int width = std::min(b.count_, Capacity - a.count_);
        out.limb_[width] = multiplied(out.limb_, a.limb_[0], b.limb_, width);
        for (int i = 1; i < a.count_; ++i)
            out.limb_[i + width] = multiplied_onto(out.limb_ + i, a.limb_[i], b.limb_, width);
        out.count_ = a.count_ + width;
        out.place_ = a.place_ + b.place_;
        out.negative_ = a.negative_ != b.negative_;
        out.trim();
        return out;
    }

private:
    __extension__ using Wide = unsigned __int128;

    /// out = factor * limbs; the carry.
    static std::uint64_t multiplied(std::uint64_t* out, std::uint64_t factor, const std::uint64_t* limbs,
                                    int count)
    {
        std::uint64_t carry = 0;
        for (int j = 0; j < count; ++j) {
            const Wide wide = static_cast<Wide>(factor) * limbs[j] + carry;
            out[j] = static_cast<std::uint64_t>(wide);
            carry = static_cast<std::uint64_t>(wide >> 64U);
        }
        return carry;
    }
    /// out += factor * limbs; the carry.
    static std::uint64_t multiplied_onto(std::uint64_t* out, std::uint64_t factor, const std::uint64_t* limbs,
                                         int count)
    {
        std::uint64_t carry = 0;
        for (int j = 0; j < count; ++j) {
            const Wide wide = static_cast<Wide>(factor) * limbs[j] + out[j] + carry;
            out[j] = static_cast<std::uint64_t>(wide);
            carry = static_cast<std::uint64_t>(wide >> 64U);
        }
        return carry;
    }

    std::uint64_t at(int place) const
    {
        const int i = place - place_;
        return i >= 0 && i < count_ ? limb_[i] : 0;
    }
    int end() const { return place_ + count_; }

    static int compare_magnitudes(const Dyadic& a, const Dyadic& b)
    {
        if (a.end() != b.end()) return a.end() < b.end() ? -1 : 1;
        for (int place = a.end() - 1; place >= std::min(a.place_, b.place_); --place)
            if (a.at(place) != b.at(place)) return a.at(place) < b.at(place) ? -1 : 1;
        return 0;
    }

    /// Same signs.
    static Dyadic added(const Dyadic& a, const Dyadic& b)
    {
        Dyadic out;
        out.place_ = std::min(a.place_, b.place_);
        out.count_ = std::min(std::max(a.end(), b.end()) + 1 - out.place_, Capacity);
        out.negative_ = a.negative_;
        std::uint64_t carry = 0;
        for (int i = 0; i < out.count_; ++i) {
            const Wide wide = static_cast<Wide>(a.at(out.place_ + i)) + b.at(out.place_ + i) + carry;
            out.limb_[i] = static_cast<std::uint64_t>(wide);
            carry = static_cast<std::uint64_t>(wide >> 64U);
        }
        out.trim();
        return out;
    }

    /// |a| > |b|; the sign of a.
    static Dyadic taken(const Dyadic& a, const Dyadic& b)
    {
        Dyadic out;
        out.place_ = std::min(a.place_, b.place_);
        out.count_ = std::min(a.end() - out.place_, Capacity);
        out.negative_ = a.negative_;
        std::uint64_t borrow = 0;
        for (int i = 0; i < out.count_; ++i) {
            const std::uint64_t from = a.at(out.place_ + i), less = b.at(out.place_ + i);
            const std::uint64_t difference = from - less;
            out.limb_[i] = difference - borrow;
            borrow = (from < less || difference < borrow) ? 1 : 0;
        }
        out.trim();
        return out;
    }

    /// No zero limb at either end.
    void trim()
    {
        while (count_ > 0 && limb_[count_ - 1] == 0)
            --count_;
        int low = 0;
        while (low < count_ && limb_[low] == 0)
            ++low;
        if (low == 0) return;
        count_ -= low;
        for (int i = 0; i < count_; ++i)
            limb_[i] = limb_[i + low];
        place_ += low;
    }

    std::uint64_t limb_[Capacity]; // the first count_ are set
    int count_ = 0;
    int place_ = 0;
    bool negative_ = false;
};

/// The limbs that some doubles reach over. Sums of products of n of them reach over n times as many, and one
/// for carries.
class Span {
public:
    void add(double x)
    {
        if (x == 0) return;
        const int top = std::ilogb(x);
        low_ = std::min(low_, std::max(top - 52, -1074));
        high_ = std::max(high_, top);
    }
    int limbs() const { return empty() ? 0 : limb(high_) - limb(low_) + 1; }
    /// The shift that brings the largest near 1.
    int shift() const { return empty() ? 0 : -limb(high_); }

private:
    bool empty() const { return high_ < low_; }
    static int limb(int bit) { return (bit + 2048) / 64 - 32; }
    int low_ = 2048, high_ = -2048;
};

} // namespace brink
