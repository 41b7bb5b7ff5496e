// SPDX-License-Identifier: BSD-3-Clause
#include "query_fields.h"
#include "query_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <functional>
#include <istream>
#include <map>
#include <set>
#include <stdexcept>

namespace brink::support {
namespace {

constexpr std::string_view first_line = "brink-queries 1";
constexpr std::string_view blanks = " \t";

using Words = std::vector<std::string_view>;

Words words(std::string_view line)
{
    Words out;
    for (;;) {
        line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
        if (line.empty()) return out;
        out.push_back(line.substr(0, line.find_first_of(blanks)));
        line.remove_prefix(out.back().size());
    }
}

template <std::size_t n> std::vector<Shape> one_of_each_shape()
{
    return []<std::size_t... i>(std::index_sequence<i...>)
    {
        return std::vector<Shape>{std::variant_alternative_t<i, Shape>{}...};
    }
    (std::make_index_sequence<n>());
}

class Reader {
public:
    Reader(std::istream& in, std::string_view file) : in_(in), file_(file) {}

    std::vector<KeptQuery> read()
    {
        if (!next_line() || line_ != first_line)
            fail(line_.empty() ? "no queries" : fmt::format("'{}'", line_),
                 fmt::format("'{}' as the first line", first_line));
        std::vector<KeptQuery> out;
        while (next_line()) {
            if (said_[0] == "hull")
                name_hull();
            else if (said_[0] == "query")
                out.push_back(block());
            else
                fail(fmt::format("'{}' outside of a block", said_[0]),
                     "'query NOTE' or 'hull NAME POINT ...'");
        }
        return out;
    }

private:
    [[noreturn]] void fail(const std::string& wrong, const std::string& expected) const
    {
        throw std::runtime_error(fmt::format("{}:{}: {}; expected {}", file_, number_, wrong, expected));
    }

    /// The next that says something, without its indentation.
    bool next_line()
    {
        while (std::getline(in_, line_)) {
            ++number_;
            if (line_.ends_with('\r')) line_.pop_back();
            line_.erase(0, line_.find_first_not_of(blanks));
            said_ = words(line_);
            if (!said_.empty() && said_[0][0] != '#') return true;
        }
        ++number_;
        line_.clear();
        if (in_.bad()) fail("reading failed", "a file that can be read");
        return false;
    }

    double number(std::string_view word) const
    {
        const std::optional<double> x = number_from(word);
        if (!x) fail(fmt::format("'{}' is no double", word), "a number such as 0x1.8p-3, 0.1, inf or nan");
        return *x;
    }

    /// The words from `first` on, exactly as many as there are numbers to be had.
    void fill(const Numbers& numbers, std::size_t first) const
    {
        const std::size_t there = said_.size() - first;
        if (there != numbers.size())
            fail(fmt::format("{} numbers", there),
                 fmt::format("{} of '{}'", numbers.size(), said_[first - 1]));
        for (std::size_t i = 0; i < numbers.size(); ++i)
            *numbers[i] = number(said_[first + i]);
    }

    Hull hull(std::size_t first) const
    {
        const std::size_t there = said_.size() - first;
        if (there == 0 || there % 3 != 0)
            fail(fmt::format("{} numbers", there), "the points of a hull, three numbers each");
        std::vector<Vec3> points(there / 3);
        for (std::size_t i = 0; i < there; ++i)
            points[i / 3][static_cast<Eigen::Index>(i % 3)] = number(said_[first + i]);
        try {
            return Hull::from_points(points);
        } catch (const std::invalid_argument& error) {
            fail(error.what(), "the points of a hull");
        }
    }

    void name_hull()
    {
        if (said_.size() < 2 || number_from(said_[1])) fail("a hull without a name", "'hull NAME POINT ...'");
        if (!hulls_.emplace(said_[1], hull(2)).second)
            fail(fmt::format("'{}' names two hulls", said_[1]), "another name");
    }

    Shape shape() const
    {
        static const std::vector<Shape> each = one_of_each_shape<shape_names.size()>();
        const std::string_view name = said_.size() > 1 ? said_[1] : "";
        const auto* found = std::find(shape_names.begin(), shape_names.end(), name);
        if (found == shape_names.end())
            fail(fmt::format("'{}' is no shape", name),
                 fmt::format("one of {}", fmt::join(shape_names, ", ")));
        Shape out = each[static_cast<std::size_t>(found - shape_names.begin())];
        if (!std::holds_alternative<Hull>(out)) {
            fill(numbers(out), 2);
            return out;
        }
        if (said_.size() != 3) return hull(2);
        const auto known = hulls_.find(said_[2]);
        if (known == hulls_.end())
            fail(fmt::format("no hull is called '{}'", said_[2]), "points, or a name that a line above gave");
        return known->second;
    }

    std::string_view only_word() const
    {
        if (said_.size() != 2) fail(fmt::format("{} words after '{}'", said_.size() - 1, said_[0]), "one");
        return said_[1];
    }

    template <class Enum, class Names> Enum named(const Names& names) const
    {
        const std::string_view word = only_word();
        const auto* found = std::find(names.begin(), names.end(), word);
        if (found == names.end())
            fail(fmt::format("'{}' for {}", word, said_[0]), fmt::format("{}", fmt::join(names, " or ")));
        return static_cast<Enum>(found - names.begin());
    }

    int whole() const
    {
        const std::string_view word = only_word();
        int out = 0;
        const char* const end = word.data() + word.size();
        const auto [stopped, error] = std::from_chars(word.data(), end, out);
        if (error != std::errc() || stopped != end) fail(fmt::format("'{}'", word), "a whole number");
        return out;
    }

    /// Whether the line gives one of these fields, which it then fills.
    template <class Fields> bool filled(const Fields& fields) const
    {
        for (const Field& field : fields) {
            if (field.name != said_[0]) continue;
            fill(field.numbers, 1);
            return true;
        }
        return false;
    }

    bool option(Options& o) const
    {
        if (filled(fields(o))) return true;
        if (said_[0] == "start_contact")
            o.start_contact = named<StartContact>(start_contact_names);
        else if (said_[0] == "detail")
            o.detail = named<Detail>(detail_names);
        else if (said_[0] == "max_iterations")
            o.max_iterations = whole();
        else
            return false;
        return true;
    }

    KeptQuery block()
    {
        constexpr std::size_t mark = std::string_view("query").size();
        KeptQuery out{{}, line_.substr(std::min(mark + 1, line_.size())), number_};
        Query& q = out.query;
        std::set<std::string> said;
        std::string body; // whose motion the lines are about
        const auto once = [&](const std::string& what) {
            if (!said.insert(what).second) fail(fmt::format("'{}' for the second time", what), "it once");
        };
        while (next_line()) {
            const std::string key(said_[0]);
            if (key == "end") {
                if (!said.contains("a") || !said.contains("b"))
                    fail("a block without both bodies", "'a SHAPE' and 'b SHAPE' before its end");
                return out;
            }
            if (key == "a" || key == "b") {
                once(body = key);
                (key == "a" ? q.a : q.b) = shape();
            } else if (option(q.options)) {
                once(key);
            } else if (!body.empty() && filled(fields(body == "a" ? q.motion_a : q.motion_b))) {
                once(body + " ... " + key);
            } else {
                fail(fmt::format("'{}' in a block", key),
                     body.empty() ? "'a SHAPE', 'b SHAPE', an option or 'end'"
                                  : "a body, a field of its motion, an option or 'end'");
            }
        }
        fail("the file ends within the block of line " + std::to_string(out.line), "'end'");
    }

    std::istream& in_;
    std::string_view file_;
    std::string line_;
    Words said_; // its words
    std::size_t number_ = 0;
    std::map<std::string, Hull, std::less<>> hulls_;
};

} // namespace

std::vector<KeptQuery> read_queries(std::istream& in, std::string_view file)
{
    return Reader(in, file).read();
}

std::vector<KeptQuery> read_queries(const std::filesystem::path& path)
{
    std::ifstream in(path);
    if (!in || std::filesystem::is_directory(path))
        throw std::runtime_error(fmt::format("cannot read '{}'; expected a file of queries", path.string()));
    return read_queries(in, path.string());
}

} // namespace brink::support
