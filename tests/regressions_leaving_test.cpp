// SPDX-License-Identifier: BSD-3-Clause
#include "regressions.h"

#include <doctest/doctest.h>

using namespace brink;
using namespace brink::support;
using brink::tests::check;

namespace {

/// Leaves the contact at the start in a few looks and meets again.
void check_meeting_again(const Query& q)
{
    const Toi toi = answer(q);
    CHECK(toi.status == Status::hit);
    CHECK(toi.iterations < 40);
    check(q);
}

} // namespace

TEST_CASE("regression: bodies that turn far faster than they leave each other")
{
    // Were `undecided`: the way out of contact took all 256 looks, each a part of what the fastest turn could
    // do.
    check_meeting_again(Query{
        Sphere{0x1.124fec559b0acp-3},
        Motion{Pose{Vec3(0x1.a3c4db58d92ccp-3, 0x1.f9383b9ca05f4p-3, -0x1.c38eb84cfa5cp-4),
                    Quat(-0x1.46a96cfd325a5p-1, 0x1.4688b29e86a4bp-2, -0x1.4d4953b026913p-1,
                         -0x1.0a155caa18267p-2)},
               Vec3(0x1.acb06d67953a6p-3, -0x1.5aa7885d3dae3p+0, -0x1.8afad87928b91p-1), Vec3(0, 0, 0),
               Vec3(0, 0, 0)},
        Cylinder{0x1.f0d69855425a3p-2, 0x1.8926d668f91b6p-2},
        Motion{Pose{Vec3(0, 0, 0), Quat(1, 0, 0, 0)},
               Vec3(-0x1.c8806db548553p-4, 0x1.712509922973ap-1, 0x1.a49afa02b14abp-2),
               Vec3(0x1.77c19379ca4c3p+3, 0x1.a844a091d0f5p+2, -0x1.ae38aa20a4065p+1),
               Vec3(0x1.634fb0e442e9cp+0, 0x1.9bab66ada69a4p+0, -0x1.04ee702e3309ap+1)},
        Options{1, 0, 0x1.12e0be826d695p-30, StartContact::ignore_if_separating, Detail::contact, 256}});
    check_meeting_again(
        Query{Sphere{0x1.66fa624bf8517p+0},
              Motion{Pose{Vec3(-0x1.12717f84087cp-3, -0x1.98a1b49d2757ap+0, 0x1.c00d04a0073adp-2),
                          Quat(-0x1.7d9395b29bbeep-3, -0x1.06efbe4548dfep-5, -0x1.726a19e4c21b2p-1,
                               0x1.53f3962fa3989p-1)},
                     Vec3(0x1.0e52840e47e3p+0, 0x1.10fd9471cb8e7p+1, -0x1.2bedc08b3003p+0),
                     Vec3(-0x1.1b75811d7575dp+4, -0x1.88988876883a3p-1, 0x1.a168182005fcep+3),
                     Vec3(-0x1.4fc262cb30a7cp-3, 0x1.5253f03affb48p-4, 0x1.0bac15bbf5a3fp-1)},
              Cylinder{0x1.c3e8f9088c5cbp+0, 0x1.cb594a402d9c8p-30},
              Motion{Pose{Vec3(0, 0, 0), Quat(-0x1.638cc8292bd0bp-1, -0x1.fa283f39dcc05p-5,
                                              -0x1.f34db05328558p-2, 0x1.0d134457f6adfp-1)},
                     Vec3(0, 0, 0), Vec3(-0x1.c835791e0192fp-3, -0x1.032bae001099ap-2, -0x1.4a095d4e93571p-1),
                     Vec3(0x1.61803dcfa179ap-2, -0x1.bfab3bbd16c4fp-2, -0x1.7209919514182p-2)},
              Options{1, 0, 0, StartContact::ignore_if_separating, Detail::contact, 256}});
    check_meeting_again(Query{
        Capsule{Vec3(0x1.2623e63aacdd4p-2, 0x1.2f0663eec2b3p-2, 0x1.c97f7eb399b18p-3),
                Vec3(-0x1.108cb6126e988p-1, 0x1.a67da3434944p-1, -0x1.a8d7882b4799p-1), 0x1.38c4f1c116a5ap-1},
        Motion{
            Pose{Vec3(-0x1.3c5a836d24f73p-2, 0x1.53f9ec34cef66p-2, 0x1.2d46ae1bbcb0ap+0), Quat(1, 0, 0, 0)},
            Vec3(-0x1.1160e40fbb37fp+0, -0x1.929c60ff171c5p+0, 0x1.902985cdf8194p-1),
            Vec3(0x1.738e3062f13a3p+6, -0x1.22a1f7ec82e52p+4, 0x1.a7ac29379d86ep+5),
            Vec3(0x1.0fcdf72afe59p-4, 0x1.eeca0f2d7b9dep-2, 0x1.137471b4d198p-5)},
        Hull::from_points(
            std::vector<Vec3>{Vec3(-0x1.160762d3197f6p-1, -0x1.6ca7356da1567p-1, 0x1.c78236833523fp-2),
                              Vec3(0x1.61e079a66f34dp-2, 0x1.290e7793b6a88p-3, -0x1.daae39090ccf5p-1)}),
        Motion{
            Pose{Vec3(-0x1.2b728d25cdcd8p-2, 0x1.1b062c1229c02p-1, 0x1.ff46c0cab16e2p-1), Quat(1, 0, 0, 0)},
            Vec3(-0x1.111dd62c7b405p+0, -0x1.c0a1a23aa1ba8p+1, -0x1.5ab654c6d72a6p+0), Vec3(0, 0, 0),
            Vec3(0, 0, 0)},
        Options{1, 0, 0x1.0c6f7a0b5ed8dp-20, StartContact::ignore_if_separating, Detail::contact, 256}});
    check_meeting_again(Query{
        Triangle{Vec3(0x1.b85a173612696p-1, 0x1.d496039da99d2p-1, -0x1.ca09cea17a498p-1),
                 Vec3(0x1.ffee34201f0ap-2, -0x1.ddabf9e38b3dp-4, -0x1.523a475aa554p-1),
                 Vec3(0x1.2ffd77d91151p-2, 0x1.7d66297884796p-1, -0x1.1a1201871bfe7p+0)},
        Motion{Pose{Vec3(0x1.5a548b5ac45bap-2, 0x1.3d3937068833cp-3, -0x1.88e7801e3ed9p-2),
                    Quat(0x1.6a09e667f3bcdp-1, 0, 0, 0x1.6a09e667f3bcdp-1)},
               Vec3(-0x1.bd5917a2f06e4p-4, 0x1.3a38b7330340dp+0, 0x1.6fff26df9e7abp-2),
               Vec3(0, 0, 0x1.05400370d0921p+0), Vec3(0, 0, 0)},
        Hull::from_points(std::vector<Vec3>{Vec3(0x1p-2, 0x1.8p-1, -0x1p-2), Vec3(-0x1.8p-1, -1, -0x1.8p-1),
                                            Vec3(0x1p-2, 0x1p-2, -0x1p-2), Vec3(0, -1, -0x1.8p-1),
                                            Vec3(-0x1p-2, 0x1.8p-1, 0x1.8p-1)}),
        Motion{Pose{Vec3(0, 0, 0), Quat(1, 0, 0, 0)},
               Vec3(-0x1.9a256581b94b6p-2, 0x1.c728dd430f0b4p+0, 0x1.64cf56610b5a7p-3),
               Vec3(0x1.9ee991abcfa9cp+3, -0x1.b7f44b04c8091p-2, -0x1.87a0b7da19661p+2), Vec3(0, 0, 0)},
        Options{0x1.1020b715264a2p-1, 0x1.8dd9ab537397cp-1, 0x1.12e0be826d695p-30,
                StartContact::ignore_if_separating, Detail::contact, 256}});
}

TEST_CASE("regression: out of near contact that is none, in steps of rounding")
{
    // Was 3.7e-13 late: 256 steps, none of which let the gap fall by more than rounding.
    check(Query{
        Triangle{Vec3(-0x1.3c546d214dc33p-1, 0x1.edbe918dbb5aap-1, -0x1.2f82ff8ba15fp-3),
                 Vec3(-0x1.eae66a8d62412p-2, 0x1.69840e174ed6p-4, -0x1.5c5fe950bd758p-3),
                 Vec3(0x1.76021b42846acp-2, 0x1.1aa0791a589p-1, 0x1.12265fb5a58a3p+0)},
        Motion{Pose{Vec3(0x1.523115164a0c2p-2, 0x1.a59d2b68e5affp+0, -0x1.a6483e35348cp+1), Quat(1, 0, 0, 0)},
               Vec3(-0x1.793ee2b907facp-1, 0x1.08cb955d54f9p+1, -0x1.71d2c210f2503p+0),
               Vec3(0x1.6516b2fe839b4p+0, -0x1.bedf4c1a26f55p+1, -0x1.6e07c0d1e3f1dp+1),
               Vec3(0x1.0e07292f75acp-6, 0x1.78c8bc56e36fp-2, -0x1.102bee7fc7735p-1)},
        Cone{0x1.e082c2642ad91p-1, 0x1.4fe3a1a498f9ap-1},
        Motion{Pose{Vec3(0x1.45594d41e9254p-2, 0x1.180e8b8ec13f8p-1, -0x1.f3c8ab9e27ed4p-2),
                    Quat(-0x1.d2b7edf9b3da5p-3, -0x1.97b7a5d05e895p-1, 0x1.1ca26616638d4p-1,
                         -0x1.1e2e74c8d0708p-4)},
               Vec3(0x1.253d89d00fd68p-2, -0x1.9ba93750016ffp-1, 0x1.1f78883dab2bap-1),
               Vec3(0x1.6fc892c93cf35p+1, -0x1.5726886c8e93bp+1, 0x1.57f14dd707215p+1),
               Vec3(0x1.32b49ac7fd711p-1, -0x1.f6ee2b84904p-6, -0x1.c8c1b7026ad48p-4)},
        Options{1, 0x1.0f37d5f203e5bp+1, 0, StartContact::ignore_if_separating, Detail::contact, 256}});
}
