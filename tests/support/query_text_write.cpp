// SPDX-License-Identifier: BSD-3-Clause
#include "query_fields.h"
#include "query_text.h"

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
        names_[k] = "hull_" + std::to_string(names_.size() + 1);
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
        out += " " + number_text(*number);
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
    const std::string kind(shape_names[shape.index()]);
    const auto* hull = std::get_if<Hull>(&shape);
    if (hull == nullptr) return kind + text(numbers(shape));
    const std::string name = names.name(*hull);
    return kind + (name.empty() ? points(*hull) : " " + name);
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
            out += indentation + std::string(mine[i].name) + text(mine[i].numbers) + "\n";
    return out;
}

std::string text(const Options& o)
{
    const Options usual;
    std::string out = changed_fields(o, "");
    const auto named = [](const auto& names, auto value) {
        return " " + std::string(names.at(static_cast<std::size_t>(value))) + "\n";
    };
    if (o.start_contact != usual.start_contact)
        out += "start_contact" + named(start_contact_names, o.start_contact);
    if (o.detail != usual.detail) out += "detail" + named(detail_names, o.detail);
    if (o.max_iterations != usual.max_iterations)
        out += "max_iterations " + std::to_string(o.max_iterations) + "\n";
    return out;
}

std::string text(const KeptQuery& kept, const HullNames& names)
{
    std::string note = kept.note;
    std::replace_if(
        note.begin(), note.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    const Query& q = kept.query;
    return "query" + (note.empty() ? "" : " " + note) + "\na " + text(q.a, names) + "\n" +
           changed_fields(q.motion_a, "  ") + "b " + text(q.b, names) + "\n" +
           changed_fields(q.motion_b, "  ") + text(q.options) + "end\n";
}

/// Every line of it behind a '#'.
std::string as_comment(std::string_view comment)
{
    std::string out = comment.empty() ? "" : "# ";
    for (const char c : comment)
        out += c == '\n' ? "\n# " : std::string(1, c);
    return out + (comment.empty() ? "" : "\n");
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
