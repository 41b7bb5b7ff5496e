// SPDX-License-Identifier: BSD-3-Clause
#include <brink/ledger.h>

#include <doctest/doctest.h>

#include <iomanip>
#include <sstream>

using namespace brink;

TEST_CASE("Ledger: prints as a table")
{
    Ledger ledger;
    ledger.pairs = 1000;
    ledger.removed = {500, 100, 200, 50, 40, 30, 20, 10};
    ledger.exact = 45;
    ledger.left = 5;
    ledger.update_seconds = 0.0012;
    ledger.search_seconds = 1.5;
    ledger.exact_seconds = 0.25;
    std::ostringstream out;
    out << std::setprecision(5) << std::scientific << ledger;
    CHECK(out.str() == "  pairs                               1000    100.0000 %\n"
                       "  neither can move                     500     50.0000 %\n"
                       "  asleep                               100     10.0000 %\n"
                       "  bounds apart                         200     20.0000 %\n"
                       "  balls apart, receding                 50      5.0000 %\n"
                       "  balls pass                            40      4.0000 %\n"
                       "  too late                              30      3.0000 %\n"
                       "  category and mask                     20      2.0000 %\n"
                       "  filter                                10      1.0000 %\n"
                       "  asked exactly                         45      4.5000 %\n"
                       "  left open                              5      0.5000 %\n"
                       "  bounds                          1.200 ms\n"
                       "  search                       1500.000 ms\n"
                       "  exact                         250.000 ms\n"
                       "  order                           0.000 ms\n");
    out.str("");
    out << 0.5; // as it was told before
    CHECK(out.str() == "5.00000e-01");
    out.str("");
    ledger.again = 7;
    out << ledger;
    CHECK(out.str().find("  asked again                            7") != std::string::npos);
}

TEST_CASE("Ledger: of nothing no share is taken")
{
    std::ostringstream out;
    out << Ledger{};
    CHECK(out.str().find("nan") == std::string::npos);
    CHECK(Ledger{}.by(Layer::filter) == 0);
}

TEST_CASE("Layers: a set")
{
    const Layers some = Layer::mask | Layer::simd;
    CHECK(some.has(Layer::mask));
    CHECK(some.has(Layer::simd));
    CHECK(!some.has(Layer::immovable));
    CHECK(!Layers{}.has(Layer::immovable));
    Ledger ledger;
    ledger.removed[static_cast<unsigned>(Layer::late)] = 3;
    CHECK(ledger.by(Layer::late) == 3);
}
