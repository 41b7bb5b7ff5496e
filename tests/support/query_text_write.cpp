// SPDX-License-Identifier: BSD-3-Clause
#include "query_fields.h"
#include "query_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <ostream>

namespace brink::support {
namespace {

/// By their points, told apart bit by bit.
class HullNames {
public:
    explicit HullNames(std::span<const KeptQuery> queries)
    {
        for (const KeptQuery& kept : queries)
            for (const Shape* shape : {&kept.query.a, &kept.query.b})
                if (const auto* hull = std::get_if<Hull>(shape)) ++uses_[key(*hull)];
    }

    /// Empty for one that occurs once.
    std::string name(const Hull& hull) const
    {
        const auto found = names_.find(key(hull));
        return found == names_.end() ? "" : found->second;
    }

    /// Names it if it occurs again; whether it did.
    bool introduce(const Hull& hull)
    {
        const Key k = key(hull);
        if (uses_[k] < 2 || names_.contains(k)) return false;
        const std::size_t number = names_.size() + 1;
        names_[k] = fmt::format("hull_{}", number);
        return true;
    }

private:
    using Key = std::vector<std::uint64_t>;
    static Key key(const Hull& hull)
    {
        Key out;
        for (const Vec3& p : hull.vertices())
            for (const double x : p)
                out.push_back(std::bit_cast<std::uint64_t>(x));
        return out;
    }

    std::map<Key, std::size_t> uses_;
    std::map<Key, std::string> names_;
};

std::string text(const Numbers& numbers)
{
    std::string out;
    for (const double* number : numbers)
        out += fmt::format(" {}", number_text(*number));
    return out;
}

std::string points(const Hull& hull)
{
    std::string out;
    for (Vec3 p : hull.vertices())
        out += text({&p.x(), &p.y(), &p.z()});
    return out;
}

std::string text(Shape shape, const HullNames& names)
{
    const std::string_view kind = shape_names[shape.index()];
    const auto* hull = std::get_if<Hull>(&shape);
    if (hull == nullptr) return fmt::format("{}{}", kind, text(numbers(shape)));
    const std::string name = names.name(*hull);
    return name.empty() ? fmt::format("{}{}", kind, points(*hull)) : fmt::format("{} {}", kind, name);
}

bool same_bits(const Numbers& a, const Numbers& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const double* x, const double* y) {
        return std::bit_cast<std::uint64_t>(*x) == std::bit_cast<std::uint64_t>(*y);
    });
}

/// Lines for those of its fields that are not the default's.
template <class Of> std::string changed_fields(Of of, const char* indentation)
{
    Of usual;
    std::string out;
    const auto mine = fields(of);
    const auto theirs = fields(usual);
    for (std::size_t i = 0; i < mine.size(); ++i)
        if (!same_bits(mine[i].numbers, theirs[i].numbers))
            out += fmt::format("{}{}{}\n", indentation, mine[i].name, text(mine[i].numbers));
    return out;
}

std::string text(const Options& o)
{
    const Options usual;
    std::string out = changed_fields(o, "");
    const auto named = [](std::string_view key, const auto& names, auto value) {
        return fmt::format("{} {}\n", key, names.at(static_cast<std::size_t>(value)));
    };
    if (o.start_contact != usual.start_contact)
        out += named("start_contact", start_contact_names, o.start_contact);
    if (o.detail != usual.detail) out += named("detail", detail_names, o.detail);
    if (o.max_iterations != usual.max_iterations) out += fmt::format("max_iterations {}\n", o.max_iterations);
    return out;
}

std::string text(const KeptQuery& kept, const HullNames& names)
{
    std::string note = kept.note;
    std::replace_if(
        note.begin(), note.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    const Query& q = kept.query;
    return fmt::format("query{}{}\na {}\n{}b {}\n{}{}end\n", note.empty() ? "" : " ", note, text(q.a, names),
                       changed_fields(q.motion_a, "  "), text(q.b, names), changed_fields(q.motion_b, "  "),
                       text(q.options));
}

/// Every line of it behind a '#'.
std::string as_comment(std::string_view comment)
{
    std::string out;
    while (!comment.empty()) {
        const std::string_view line = comment.substr(0, comment.find('\n'));
        out += fmt::format("#{}{}\n", line.empty() ? "" : " ", line);
        comment.remove_prefix(std::min(line.size() + 1, comment.size()));
    }
    return out;
}

} // namespace

void write_queries(std::ostream& out, std::span<const KeptQuery> queries, std::string_view comment)
{
    out << "brink-queries 1\n" << as_comment(comment);
    HullNames names(queries);
    for (const KeptQuery& kept : queries) {
        out << '\n';
        for (const Shape* shape : {&kept.query.a, &kept.query.b}) {
            const auto* hull = std::get_if<Hull>(shape);
            if (hull != nullptr && names.introduce(*hull))
                out << "hull " << names.name(*hull) << points(*hull) << '\n';
        }
        out << text(kept, names);
    }
}

} // namespace brink::support
