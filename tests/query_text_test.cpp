// SPDX-License-Identifier: BSD-3-Clause
#include "support/query_text.h"

#include "support/query_fields.h"

#include <doctest/doctest.h>

#include <bit>
#include <clocale>
#include <fstream>
#include <limits>
#include <locale>
#include <sstream>

namespace brink::tests {
namespace {

using namespace support;

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

std::vector<std::uint64_t> bits(const Numbers& numbers)
{
    std::vector<std::uint64_t> out;
    for (const double* x : numbers)
        out.push_back(bits(*x));
    return out;
}

/// All that there is in a query, bit for bit.
std::vector<std::uint64_t> bits(Query q)
{
    std::vector<std::uint64_t> out{q.a.index(), q.b.index()};
    const auto add = [&](const Numbers& numbers) {
        const std::vector<std::uint64_t> more = bits(numbers);
        out.insert(out.end(), more.begin(), more.end());
    };
    for (Shape* shape : {&q.a, &q.b}) {
        add(numbers(*shape));
        if (const auto* hull = std::get_if<Hull>(shape))
            for (Vec3 p : hull->vertices())
                add({&p.x(), &p.y(), &p.z()});
    }
    for (Motion* motion : {&q.motion_a, &q.motion_b})
        for (const Field& field : fields(*motion))
            add(field.numbers);
    for (const Field& field : fields(q.options))
        add(field.numbers);
    out.push_back(static_cast<std::uint64_t>(q.options.start_contact));
    out.push_back(static_cast<std::uint64_t>(q.options.detail));
    out.push_back(static_cast<std::uint64_t>(q.options.max_iterations));
    return out;
}

std::string written(std::span<const KeptQuery> queries, std::string_view comment = "")
{
    std::ostringstream out;
    write_queries(out, queries, comment);
    return out.str();
}

std::vector<KeptQuery> read(const std::string& text)
{
    std::istringstream in(text);
    return read_queries(in, "some.txt");
}

/// What reading it says is wrong.
std::string complaint(const std::string& text)
{
    try {
        read(text);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

/// A query with `line` among the options.
std::string with(const std::string& line)
{
    return "brink-queries 1\nquery\na sphere 1\nb box 1 1 1\n" + line + "\nend\n";
}

std::vector<KeptQuery> generated()
{
    std::vector<KeptQuery> out;
    for (const Pair& pair : all_pairs())
        for (std::uint64_t i = 0; i < 40; ++i) {
            const std::string note = pair.name() + " " + std::to_string(i);
            out.push_back({query(pair, Family::any, 5, i), note});
            out.push_back({campaign_query(pair, 6, i), note});
        }
    return out;
}

void check_same(const std::vector<KeptQuery>& before, const std::vector<KeptQuery>& after)
{
    REQUIRE(before.size() == after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        CAPTURE(before[i].note);
        CHECK(bits(before[i].query) == bits(after[i].query));
        CHECK(before[i].note == after[i].note);
    }
}

} // namespace

TEST_CASE("query text: every pair's queries come back bit for bit")
{
    const std::vector<KeptQuery> queries = generated();
    CHECK(queries.size() == 55 * 80);
    const std::string text = written(queries, "of a test");
    const std::vector<KeptQuery> back = read(text);
    check_same(queries, back);
    CHECK(written(back, "of a test") == text);
}

TEST_CASE("query text: every double comes back")
{
    using Limits = std::numeric_limits<double>;
    for (const double x : {0.0, 1.0, 0.1, 1.0 / 3, Limits::max(), Limits::min(), Limits::denorm_min(),
                           0x1.23456789abcdep-1030, Limits::infinity(), Limits::quiet_NaN()})
        for (const double y : {x, -x}) {
            CAPTURE(number_text(y));
            REQUIRE(number_from(number_text(y)));
            CHECK(bits(*number_from(number_text(y))) == bits(y));
        }
    const auto odd = std::bit_cast<double>(std::uint64_t{0xfff0000000000123});
    CHECK(number_text(odd) == "nan:fff0000000000123");
    CHECK(bits(*number_from("nan:fff0000000000123")) == bits(odd));
    CHECK(number_text(-0.3) == "-0x1.3333333333333p-2");
    CHECK(*number_from("0.3") == 0.3);
    CHECK(*number_from("-12e-3") == -0.012);
    for (const char* wrong : {"", "-", "0x", "1p-3", "0x-1p+0", "--1", "+1", "1,5", "0x1.8p-3x", "infinity",
                              "nan:", "nan:7ff0000000000000", "1e999", "one", " 1"})
        CHECK_MESSAGE(!number_from(wrong), wrong);
}

TEST_CASE("query text: what is not finite, out of range or has a note of its own comes back")
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    KeptQuery kept{{Sphere{-nan}, {}, Capsule{{infinity, -infinity, nan}, {0, -0.0, 1}, -1}, {}, {}},
                   "# a b"};
    kept.query.motion_a.start.orientation = Quat(0, 0, 0, 0);
    kept.query.motion_b.pivot = {-0.0, 0, 0};
    kept.query.options = {nan, -1, infinity, StartContact::ignore, Detail::time_only, -7};
    check_same({kept}, read(written(std::vector{kept})));
    kept.note = "two\r\nlines";
    CHECK(read(written(std::vector{kept})).front().note == "two  lines");
}

TEST_CASE("query text: a hull that occurs again is named once")
{
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Shape stone = Hull::from_points(points), ball = Sphere{1};
    const std::vector<KeptQuery> twice{{{stone, {}, ball, {}, {}}}, {{ball, {}, stone, {}, {}}}};
    const std::string text = written(twice);
    CHECK(text.find("hull hull_1 0x0p+0") != std::string::npos);
    CHECK(text.find("b hull hull_1\n") != std::string::npos);
    check_same(twice, read(text));
    CHECK(written(std::span(twice).first(1)).find("hull_1") == std::string::npos);
}

TEST_CASE("query text: by hand, with what is left out at its default")
{
    const std::vector<KeptQuery> back =
        read("# mine\r\n  brink-queries 1\r\n\r\nquery  near\r\n"
             "\ta sphere 0.5\n  position 1 2 3\n\n# now the other\nb plane 0 0 1 0\n"
             "rotation 0 0 0x1p1\nstart_contact ignore\nend\nquery\na hull 1 2 3\n"
             "b cone 1 2\nend");
    REQUIRE(back.size() == 2);
    CHECK(back[0].note == " near");
    CHECK(back[0].line == 4);
    CHECK(std::get<Sphere>(back[0].query.a).radius == 0.5);
    CHECK(back[0].query.motion_a.start.position == Vec3(1, 2, 3));
    CHECK(back[0].query.motion_b.rotation == Vec3(0, 0, 2));
    CHECK(back[0].query.options.start_contact == StartContact::ignore);
    CHECK(back[0].query.options.tolerance == Options{}.tolerance);
    CHECK(back[1].note.empty());
    CHECK(std::get<Hull>(back[1].query.a).vertices().front() == Vec3(1, 2, 3));
    CHECK(std::get<Cone>(back[1].query.b).radius == 2);
}

TEST_CASE("query text: what is malformed is told with its line and what would be right")
{
    const std::string head = "brink-queries 1\n";
    const auto says = [](const std::string& text, const std::string& start, const std::string& expected) {
        const std::string said = complaint(text);
        CHECK_MESSAGE(said.starts_with("some.txt:" + start), said);
        CHECK_MESSAGE(said.find("; expected " + expected) != std::string::npos, said);
    };
    says("", "1: no queries", "'brink-queries 1' as the first line");
    says("brink-queries 2\n", "1: 'brink-queries 2'", "'brink-queries 1'");
    says(head + "a sphere 1\n", "2: 'a' outside of a block", "'query NOTE'");
    says(head + "query\na sphere 1\nend\n", "4: a block without both bodies", "'a SHAPE' and 'b SHAPE'");
    says(head + "query\na sphere 1\nb sphere 1\n", "5: the file ends within the block of line 2", "'end'");
    says(head + "query\nposition 0 0 0\n", "3: 'position' in a block", "'a SHAPE'");
    says(head + "query\na ball 1\n", "3: 'ball' is no shape", "one of sphere, capsule");
    says(head + "query\na\n", "3: '' is no shape", "one of sphere");
    says(head + "query\na capsule 1 2 3\n", "3: 3 numbers", "7 of 'capsule'");
    says(head + "query\na sphere 1 2\n", "3: 2 numbers", "1 of 'sphere'");
    says(head + "query\na sphere one\n", "3: 'one' is no double", "a number");
    says(head + "query\na hull stone\n", "3: no hull is called 'stone'", "points, or a name");
    says(head + "query\na hull 1 2 3 4\n", "3: 4 numbers", "the points of a hull");
    says(head + "hull 1 2 3\n", "2: a hull without a name", "'hull NAME POINT ...'");
    says(head + "hull h\n", "2: 0 numbers", "the points of a hull");
    says(head + "hull h 0 0 nan\n", "2: ", "the points of a hull");
    says(head + "hull h 1 2 3\nhull h 1 2 3\n", "3: 'h' names two hulls", "another name");
    says(with("a sphere 1"), "5: 'a' for the second time", "it once");
    says(with("pivot 0 0 0\npivot 0 0 0"), "6: 'b ... pivot' for the second time", "it once");
    says(with("t_max 1\nt_max 1"), "6: 't_max' for the second time", "it once");
    says(with("t_max"), "5: 0 numbers", "1 of 't_max'");
    says(with("position 0 0"), "5: 2 numbers", "3 of 'position'");
    says(with("start_contact no"), "5: 'no' for start_contact", "report or ignore_if_separating or ignore");
    says(with("detail"), "5: 0 words after 'detail'", "one");
    says(with("max_iterations 1.5"), "5: '1.5'", "a whole number");
    says(with("velocity 1 2 3"), "5: 'velocity' in a block", "a body, a field of its motion");
    CHECK(complaint(with("pivot 0 0 0")).empty());
}

TEST_CASE("query text: a file that is not there is told")
{
    CHECK_THROWS_WITH(read_queries(std::filesystem::path("no/such.txt")),
                      "cannot read 'no/such.txt'; expected a file of queries");
    CHECK_THROWS_WITH(read_queries(std::filesystem::path("/")),
                      "cannot read '/'; expected a file of queries");
}

TEST_CASE("query text: the locale has no say")
{
    struct Commas : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\1"; }
    };
    const std::vector<KeptQuery> queries{{{Sphere{0.1}, {}, Box{{1234.5, 1e-9, 3}}, {}, {}}, "12345"}};
    const std::string text = written(queries);
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Commas));
    const std::string c_before = std::setlocale(LC_ALL, nullptr);
    for (const char* name : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8"}) // whichever is installed
        if (std::setlocale(LC_ALL, name) != nullptr) break;
    const std::string text_there = written(queries);
    const std::vector<KeptQuery> back = read(text);
    std::setlocale(LC_ALL, c_before.c_str());
    std::locale::global(before);
    CHECK(text_there == text);
    check_same(queries, back);
}

} // namespace brink::tests
