// SPDX-License-Identifier: BSD-3-Clause
#include "regressions.h"

#include <doctest/doctest.h>

using namespace brink;
using namespace brink::support;
using brink::tests::check;

TEST_CASE("regression: parallel capsules in a rotated frame, whose axes differ by rounding alone")
{
    // Was `separated`, though they overlap by 0.22.
    check(Query{
        Capsule{Vec3(-0x1.31533eb1ac70ep-1, 0, 0), Vec3(0x1.31533eb1ac70ep-1, 0, 0), 0x1.42c58e041f7b6p-2},
        Motion{Pose{Vec3(0x1.6d7adda7a4558p-2, 0x1.55788c90c62bcp+1, 0x1.13f81ef272458p+2),
                    Quat(0x1.0d0cf5e87e78cp-2, -0x1.8b8dc52a3d9bbp-2, 0x1.b3d8fdab56a58p-1,
                         -0x1.e960693b5a7fp-3)},
               Vec3(0x1.06edc0a7ad876p+1, -0x1.7ec36cf33f665p-4, -0x1.943656b94c0a7p+1), Vec3(0, 0, 0),
               Vec3(0, 0, 0)},
        Capsule{Vec3(-0x1.351321294d645p-1, 0, 0), Vec3(0x1.351321294d645p-1, 0, 0), 0x1.2a374c378eb98p-1},
        Motion{Pose{Vec3(0x1.feb3c2c6f4cfap+0, 0x1.5693467f49bdap+0, 0x1.640d4ddbf652cp+0),
                    Quat(0x1.0d0cf5e87e78cp-2, -0x1.8b8dc52a3d9bbp-2, 0x1.b3d8fdab56a58p-1,
                         -0x1.e960693b5a7fp-3)},
               Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0)},
        Options{}});
}

TEST_CASE("regression: a sphere grazes a triangle that is nearly a segment")
{
    // Was `separated`, though the gap falls 6.4e-10 below zero.
    check(Query{Sphere{0x1.981e12ad3721p-3},
                Motion{Pose{Vec3(-0x1.4bfbf88de1e1bp+0, 0x1.172c6315e8424p-5, 0x1.18799d97cb666p+0),
                            Quat(0x1.1bf074d6d3a3fp-1, 0x1.ee0249b90c8b4p-4, 0x1.11be09e456b9fp-1,
                                 0x1.4095a125f5c23p-1)},
                       Vec3(-0x1.917f8e83e432cp-3, 0x1.fa82dff934c14p+0, -0x1.8bc8e9f45e382p+1)},
                Triangle{Vec3(0x1.7349aa74888p-8, 0x1.1c30e341ad4e7p+0, -0x1.08f7810265761p-1),
                         Vec3(-0x1.e25c1eeb43ae2p-1, 0x1.6a4871e904a2p-4, 0x1.2f0a09c5273b6p-1),
                         Vec3(0x1.a1e0d43ff9eacp-2, 0x1.8b3e1e434a1bep+0, -0x1.fa2370aca3b52p-1)},
                Motion{Pose{}, Vec3(-0x1.23bf6e0e556c6p+0, 0x1.137531576667ep+0, -0x1.180d9db9494d2p+0)},
                Options{}});
}

TEST_CASE("regression: a face without area to speak of")
{
    // Were `separated`: the normal underflowed, and with it the radius times its length.
    const Motion down{Pose{Vec3(0, 0, 2), Quat(1, 0, 0, 0)}, Vec3(0, 0, -1.75)};
    check(Query{Sphere{0.5}, down, Triangle{Vec3(0, 0, 0), Vec3(1e-90, 0, 0), Vec3(0, 1e-90, 0)}, {}, {}});
    check(Query{Capsule{Vec3(-1, 0, 0), Vec3(1, 1e-200, 0), 0.25},
                down,
                Capsule{Vec3(-1, 0, 0), Vec3(1, 0, 0), 0.25},
                {},
                {}});
}

TEST_CASE("regression: a motion whose square underflows")
{
    // Was `separated` from the start, though they overlap.
    check(Query{Sphere{0.7},
                Motion{Pose{Vec3(0, 0, 0.69), Quat(1, 0, 0, 0)}, Vec3(2.63e-162, 0, 0)},
                Triangle{Vec3(0, 0, 0), Vec3(1e-3, 0, 0), Vec3(0, 1e-3, 0)},
                {},
                {}});
}

TEST_CASE("regression: a tiny scene beside a pivot that does not matter")
{
    // Missed: the pivot's length of 1 hid that all others are near 1e-47.
    Motion a{Pose{Vec3(-0x1.d967518c7805ap-155, 0x1.5891b538d7e9ap-153, -0x1.917256bc73e5fp-154)},
             Vec3(0x1.d967518c7805ap-155, -0x1.5891b538d7e9ap-153, 0x1.917256bc73e5fp-154)};
    a.pivot = Vec3(1, 0, 0);
    check(Query{Sphere{0x1.a2cc6f3b5629cp-156},
                a,
                Triangle{Vec3(0, 0, 0), Vec3(0x1p-156, 0, 0), Vec3(0, 0x1p-156, 0x1p-158)},
                {},
                {}});
}

TEST_CASE("regression: spheres that start 1e8 radii apart and meet off centre")
{
    // The normal was that of the motion, 64 degrees off.
    check(Query{Sphere{0.5}, Motion{Pose{Vec3(5e7, 0.9, 0)}, Vec3(-1e8, 0, 0)}, Sphere{0.5}, {}, {}});
}

TEST_CASE("regression: t from a bracket that ends at t_max is t from one that does not")
{
    const Query q{
        Sphere{0x1.3049d3b887a93p+1},
        Motion{Pose{Vec3(-0x1.ccff1e76ad6c6p+0, 0x1.4186dd16c311cp-1, -0x1.1b083ee2a924p-3)},
               Vec3(-0x1.3f620311b06a1p-4, 0x1.729adc24a8ab8p-5, 0x1.2ae85d3591cedp-2)},
        Capsule{Vec3(-0x1.f20351c6a4cd1p-1, 0, 0), Vec3(0x1.f20351c6a4cd1p-1, 0, 0), 0x1.aec4525004fa1p-6},
        Motion{Pose{Vec3(0x1.0d8a4c3ea18b8p-3, -0x1.9f86353f6edacp-1, 0x1.9e212805a2eep-3),
                    Quat(-0x1.d9163fc740bc2p-2, 0x1.983e34e97beb1p-2, 0x1.580cbc3c23215p-1,
                         0x1.adad125d02055p-2)},
               Vec3(0x1.a37e9d651b422p-2, -0x1.e6c5bbac7512ap-3, -0x1.8899f40239229p+0)},
        {}};
    check(q);
    Query bounded = q;
    bounded.options.t_max = answer(q).t_upper;
    CHECK(answer(bounded).t == answer(q).t);
    CHECK(answer(bounded).status == Status::hit);
}

TEST_CASE("regression: a sphere deeper in a box than its radius by half a rounding, on its way out")
{
    // Answered `separated` when the guess has a hundredth of its margin (mutations.sh).
    check(Query{Sphere{0x1.aad78866ef18cp+0},
                Motion{Pose{Vec3(-0x1.22d3a8a2b0c25p-1, -0x1.0fa8b2bd8dd24p-1, 0x1.823cb6df53efap+1),
                            Quat(0x1.53c358p-2, 0x1.738ceap-3, -0x1.d926eep-1, 0x1.bfcbeep-5)},
                       Vec3(-0x1.839ecd338b568p-3, 0x1.9cf1c622c5d5p-4, 0x1.a74e42e7ac9c6p+0), Vec3(0, 0, 0),
                       Vec3(0, 0, 0)},
                Box{Vec3(0x1.09494ee2e6fb1p+0, 0x1.8f03b074004ccp-2, 0x1.0d8f9dcc16829p+0)},
                Motion{Pose{Vec3(0x1.0860b1ca0dd84p-2, -0x1.3292b950f8948p-2, 0x1.c0c9c7c48fap-9),
                            Quat(0x1.1e4c8982b7792p-5, 0x1.cf23748df4102p-1, 0x1.031cf61a1f57cp-2,
                                 -0x1.5d8605bb9d447p-2)},
                       Vec3(0x1.762dfddfc2a7p+0, -0x1.5ce4b8641c81ap-1, -0x1.78a3024eb3c5dp-1), Vec3(0, 0, 0),
                       Vec3(0, 0, 0)},
                Options{1, 0, 0x1.12e0be826d695p-30, StartContact::report, Detail::contact, 256}});
}

TEST_CASE("a needle of an ellipsoid on a box: witness points lie on their shapes")
{
    check(Query{Box{Vec3(0x1.731b63a8b9db5p-2, 0x1.a3ea708bd16c4p-1, 0x1.3f63beaab0c5ep-4)},
                Motion{Pose{Vec3(-0x1.e6dd8fa21cb77p+0, 0x1.d61550f55ea24p-1, -0x1.f053e7a3fb5ep-6),
                            Quat(0x1.11f692b9c6b4cp-3, 0x1.1d7bab5665f75p-1, -0x1.dcd65022a4c6dp-2,
                                 0x1.591f28fbe66d8p-1)},
                       Vec3(0x1.2dbaa90e57f7cp+1, -0x1.336b1d728ec7fp+0, -0x1.05426166d0931p+0),
                       Vec3(0, 0, 0), Vec3(0, 0, 0)},
                Ellipsoid{Vec3(0x1.04348d05e433bp+0, 0x1.5a8c71c0f3c89p-20, 0x1.e173f4a6a5826p-18)},
                Motion{Pose{Vec3(-0x1.287013b130192p-1, 0x1.f8eb76b66401cp-2, -0x1.fbd552f2d08cap-1),
                            Quat(0x1.8e7fep-2, 0x1.41f2c6p-1, 0x1.ec2484p-2, 0x1.e2aa96p-2)},
                       Vec3(0, 0, 0), Vec3(0, 0, 0x1.3148ee89ada27p-34),
                       Vec3(-0x1.7c4feac8b3ecep-3, 0x1.645da3ba66fep-4, -0x1.77c10279dc3ep-4)},
                Options{1, 0, 0, StartContact::report, Detail::contact, 256}});
}

TEST_CASE("a curved contact that turns its normal, and a hundred turns past each other: decided within the "
          "looks there are")
{
    for (const Query& q : {
             Query{Capsule{Vec3(-0x1.3f3987c1513aap-1, -0x1.d02c87b360b38p-3, -0x1.0596295a57af4p-1),
                           Vec3(-0x1.01cb78992e04ap-1, 0x1.0b9fff0c68086p-1, 0x1.7267d44b03a6ep-1),
                           0x1.db0b75bbc169p-15},
                   Motion{Pose{Vec3(0x1.9dc7ce2b9eb2p-4, -0x1.272e42899cd2p-4, -0x1.d71d9f13415c8p-3),
                               Quat(-0x1.88500619d0367p-2, -0x1.60d78fb150075p-3, -0x1.3e6d7801c3d9ap-1,
                                    0x1.525ce8a871493p-1)},
                          Vec3(0x1.8bb300a1dfd3cp+1, 0x1.27d87c726ea52p-1, -0x1.8665be88ef6a5p+0),
                          Vec3(0x1.27942b337c985p-1, -0x1.9d3936721cdc8p-5, 0x1.475730690baeep-1),
                          Vec3(-0x1.141ccd10de832p-1, 0x1.3251427e9218bp-2, 0x1.6bd09e8724fb8p-2)},
                   Cone{0x1.be91196ade27cp-3, 0x1.845e6b5b60afbp-1},
                   Motion{Pose{Vec3(0, 0, 0), Quat(0x1.590655280a5a3p-2, -0x1.4eb2d4a945383p-1,
                                                   0x1.2f6af736d36a9p-1, 0x1.5070a6c9ad998p-2)},
                          Vec3(0x1.8bb21ef9afa6cp+1, 0x1.27d119b416847p-1, -0x1.8664b9ca33e56p+0),
                          Vec3(0, 0, 0), Vec3(0, 0, 0)},
                   Options{1, 0, 0x1.12e0be826d695p-30, StartContact::report, Detail::contact, 256}},
             Query{Triangle{Vec3(-0x1.614f2315823c6p-1, -0x1.1d87910263ed7p-1, -0x1.4e4f65b41dbdcp-1),
                            Vec3(0x1.bc16e9f10b4dp-3, 0x1.1339165db7a92p-1, 0x1.18ac4923fe75fp+0),
                            Vec3(0x1.c40ce96315e4cp-2, -0x1.47d69b9ccba73p-1, -0x1.56c0f8c6e0663p-1)},
                   Motion{Pose{Vec3(-0x1.43f217eef5de8p-1, -0x1.cdd8f49629fp-5, 0x1.4f0ebceeea45p+0),
                               Quat(0x1.07cc6043348bp-1, -0x1.2326cc2a2fd22p-6, -0x1.e8e93ad21ae8dp-2,
                                    0x1.6c4c53f92cc4ep-1)},
                          Vec3(0x1.9712b1a32cbdcp+1, 0x1.5ccef6da0f057p-1, 0x1.be69491b5f094p+2),
                          Vec3(0x1.a91ef622071fap-2, 0x1.8c139e6ac2f8bp-1, 0x1.a5fa7afebeae5p-5),
                          Vec3(0x1.7c4cf020afe4p-4, 0x1.644a07044745dp-2, 0x1.97ea4db9cf8dp-1)},
                   Cylinder{0x1.9a99f1cd6dd6ep-1, 0x1.3b6e9dd8f767bp-2},
                   Motion{Pose{Vec3(-0x1.8f76e9617a88ap-1, -0x1.1ea9afaf039ep-1, 0x1.c7a3e43a07bd6p-1),
                               Quat(0x1.ef21c9b690a5cp-5, -0x1.9e06ccf7e0626p-1, 0x1.397d58ad19ee9p-2,
                                    -0x1.feaefe3a55fd9p-2)},
                          Vec3(0x1.970d141777112p+1, 0x1.5d9562890457fp-1, 0x1.be5f0de2738b7p+2),
                          Vec3(0, 0, 0), Vec3(0, 0, 0)},
                   Options{1, 0, 0x1.12e0be826d695p-30, StartContact::report, Detail::contact, 256}},
             Query{Sphere{0x1.eeca818d5e1e1p+1},
                   Motion{Pose{Vec3(6, -0x1.8p-1, 0x1.8p+0), Quat(1, 0, 0, 0)},
                          Vec3(-0x1.4p+1, -0x1.cp+0, 0x1.ep+1),
                          Vec3(0x1.833290518c88ep+1, 0x1.33e652c5027aep+8, 0x1.0ed22fa180faep+9),
                          Vec3(0x1.6b50310e674f2p-2, -0x1.22ad5a9c65247p-1, -0x1.eaec2eb5dc08p-8)},
                   Cone{0x1.c76d0285e341ap-1, 0x1.d350268aac64ap-22},
                   Motion{Pose{Vec3(1, -0x1.4p+0, 0x1.4p+0), Quat(1, 0, 0, 0)}, Vec3(0, 0, 0),
                          Vec3(-0x1.cdce8d0ff3c7fp+4, -0x1.2a35b2f58a76bp-1, -0x1.c3e5a381189cdp+3),
                          Vec3(0x1.df04258ca1e1ap-2, 0x1.0ee719f975f22p-2, 0x1.5c81ffb897p-12)},
                   Options{1, 0, 0x1.19799812dea11p-40, StartContact::report, Detail::contact, 256}},
             Query{Box{Vec3(0x1.bd2197872f89ap+0, 0x1.a59ffd0d30ad3p-23, 0x1.a59ffd0d30ad3p-23)},
                   Motion{Pose{Vec3(0x1.1d9cb5720338dp+1, -0x1.6df33d3d638fap-1, -0x1.4d1184ffd0b18p+1),
                               Quat(1, 0, 0, 0)},
                          Vec3(-0x1.1ffa4e6a59746p-4, 0x1.0bb2a2a3c8d4ap-5, 0x1.a96f84a7c610cp-5),
                          Vec3(-0x1.af5cb5fc8b37dp-1, 0x1.05a19295fc81dp-1, 0x1.928d1258290ep-3),
                          Vec3(0, 0, 0)},
                   Box{Vec3(0x1.f0a38dbd2e4d6p-2, 0x1.87fbdf235401p-14, 0x1.87fbdf235401p-14)},
                   Motion{Pose{Vec3(-0x1.778f12084edc4p-1, -0x1.a595461320848p-3, -0x1.ef9da49418aeep-1),
                               Quat(0x1.d770a87a7fcacp-1, -0x1.2668c6613a41ap-3, 0x1.52a10c683c0fap-2,
                                    -0x1.30b9539c88619p-3)},
                          Vec3(0x1.836af3554a63fp+1, -0x1.68229278df104p+0, -0x1.1e2b93ec56cebp+1),
                          Vec3(0x1.4cecdd1175df2p+8, 0x1.c31a7a83e6dd6p+7, -0x1.102d47649f475p+7),
                          Vec3(0x1.a9c84b1a69b88p-2, -0x1.3a8fe8eb4db2p+1, 0x1.7aee68d72e63p+1)},
                   Options{1, 0, 0x1.12e0be826d695p-30, StartContact::report, Detail::contact, 256}},
         }) {
        check(q);
        CHECK(answer(q).status != Status::undecided);
    }
}

TEST_CASE("regression: a cone without height and width has no inside")
{
    // Had contact proven 5e-12 and 1e-12 early: the depth in such a cone divided nothing by nothing.
    check(Query{Sphere{0},
                Motion{Pose{Vec3(-0x1.78aa4b5e5bb01p+1, 0x1.880b27d4a95e8p-2, -0x1.693b2b3877f38p+1),
                            Quat(0x1.6a09e667f3bcdp-1, 0, -0x1.6a09e667f3bcdp-1, 0)},
                       Vec3(0x1.73992fdf67d33p+2, -0x1.1f0c4398157ebp+0, 0x1.937785fa923c6p+1), Vec3(0, 0, 0),
                       Vec3(0, 0, 0)},
                Cone{0, 0},
                Motion{Pose{Vec3(0x1.166a208b7a2d4p-1, -0x1.2969d0eea144p-2, -0x1.dbd79cdf7714cp-1),
                            Quat(0x1.ca72a99dedc44p-1, -0x1.02a5304ea0b1ep-4, 0x1.1712874e1b69ap-5,
                                 0x1.c1fa5764769p-2)},
                       Vec3(-0x1.651f07247f279p+0, 0x1.13dd5fd1af348p-2, -0x1.83bf8595c76d4p-1),
                       Vec3(0, 0, 0), Vec3(0, 0, 0)},
                Options{1, 0, 0x1.12e0be826d695p-30, StartContact::report, Detail::contact, 256}});
    check(Query{Cone{0x1.decfffb26b857p-4, 0},
                Motion{Pose{Vec3(-0x1.3af20a15efc3cp-1, 0x1.1822721946c4ep-2, 0x1.7af5a427491fbp-1),
                            Quat(-0x1.3e9699cdd0fc6p-2, -0x1.e9eef6accafaep-2, 0x1.1dd0747139812p-1,
                                 0x1.3455edc33f0dep-1)},
                       Vec3(0x1.0113773dd866p+0, -0x1.6152ecdf4d7ap-1, -0x1.ed2f1b85ac984p-2), Vec3(0, 0, 0),
                       Vec3(0, 0, 0)},
                Cone{0, 0},
                Motion{Pose{Vec3(0x1.e1f36f1afdfccp-2, -0x1.e3eb90df13108p-2, 0x1.c156d89e60a4p-3),
                            Quat(0x1.bc264be84132p-3, 0x1.de84348f4c27cp-2, -0x1.0313aa9392635p-1,
                                 0x1.6230447b6db6ap-1)},
                       Vec3(-0x1.fb9e0c79957f6p-2, 0x1.5cd5531e58028p-2, 0x1.e6ea72a8ccdb7p-3),
                       Vec3(-0x1.07e54a02e786dp+0, -0x1.39b18f44a4d86p-3, -0x1.cadd90f1b1d6dp-5),
                       Vec3(0, 0, 0)},
                Options{1, 0, 0x1.12e0be826d695p-30, StartContact::report, Detail::contact, 256}});
}

TEST_CASE("regression: where bodies come from far away, the points of contact lie on them")
{
    // Were off by 8.5e-6 and 2e-6: the axis from where a guess ended was taken for the normal.
    check(
        Query{Sphere{0x1.1860f7ff7084cp+0},
              Motion{Pose{Vec3(0x1.368326d66e38ap+25, 0x1.1df55706e629bp+24, -0x1.e0a93e9822972p+26),
                          Quat(0x1.a4c4d4ed0bda4p-3, -0x1.46ca1bb54adb4p-2, 0x1.944e294b8b8b8p-1,
                               0x1.eda19cf56017p-2)},
                     Vec3(-0x1.04fda7a3d5d34p+25, -0x1.e0b4a65caa109p+23, 0x1.9400f773200bcp+26),
                     Vec3(0x1.c86794300dbd4p+1, -0x1.ab7d8975948d3p-1, -0x1.fb4ac6e0d9e91p-2), Vec3(0, 0, 0)},
              Capsule{Vec3(-0x1.b671b2f88ebp-3, -0x1.050b4246a7fa5p+2, -0x1.cd002d99b380ep-1),
                      Vec3(-0x1.fd567a415bf2ap+0, -0x1.33c0031a0eadcp+2, 0x1.336438650443cp+2),
                      0x1.52bb74d5b7d57p-24},
              Motion{Pose{Vec3(0, 0, 0), Quat(0x1.82c2c617956cdp-1, -0x1.686ca58587c74p-4,
                                              0x1.0b8369e555fcfp-2, -0x1.305e0530811cfp-1)},
                     Vec3(0x1.d820fe3e4e832p+25, 0x1.b2cb856a6628ap+24, -0x1.6d6b2ddcb0542p+27),
                     Vec3(0, 0, 0), Vec3(0, 0, 0)},
              Options{1, 0, 0x1.12e0be826d695p-30, StartContact::report, Detail::contact, 256}});
    check(
        Query{Sphere{0x1.fe5cf1dcea65bp-1},
              Motion{Pose{Vec3(-0x1.b58ef5dd64b35p+23, 0x1.3a121879bcf26p+25, 0x1.8611e463f5a29p+24),
                          Quat(-0x1.a29ff626315b4p-3, 0x1.2b70d906ac7dcp-3, 0x1.9a6334f7aa4f5p-2,
                               -0x1.c317200bc2d8dp-1)},
                     Vec3(0x1.360a5b098e847p+24, -0x1.bd14e947d28f9p+25, -0x1.14643c7436d21p+25),
                     Vec3(0x1.491bb5224d654p+0, -0x1.822448ab1b02ep-1, 0x1.b895c266cf10fp-1), Vec3(0, 0, 0)},
              Triangle{Vec3(0x1.9694d2a58ae02p-1, -0x1.61d3750a836afp-1, 0x1.1e1523d9a1618p-3),
                       Vec3(-0x1.2594ed4fcad04p-2, 0x1.c8a57451646fep-1, -0x1.1e92b67a1d4fcp-2),
                       Vec3(0x1.23db97e9e7a01p+0, -0x1.1338fdc08fa2dp-1, -0x1.9d356caa77c9p-4)},
              Motion{Pose{Vec3(-0x1.e2586708e931p-3, -0x1.c60fbddb8a298p-2, -0x1.ca0396cdf3a28p-1),
                          Quat(-0x1.97f79c90a48a8p-1, 0x1.279c5431027d3p-2, 0x1.bbf294249e80fp-2,
                               -0x1.399c684e9c892p-2)},
                     Vec3(0, 0, 0), Vec3(0, 0, 0),
                     Vec3(-0x1.c750cad8d6676p-2, 0x1.9c8a590f2984p-5, 0x1.0c171f6bdf284p-2)},
              Options{1, 0, 0x1.12e0be826d695p-30, StartContact::report, Detail::contact, 256}});
}

TEST_CASE("regression: the deepest points of a box and a cylinder that lie along the axes are on both")
{
    // The point told on the cylinder was 4e-5 off it: what grew within the difference had ended short of its
    // surface.
    check(Query{Box{Vec3(0.75, 1.75, 1.75)},
                Motion{Pose{Vec3(1, -2.5, -1.5), Quat(1, 0, 0, 0)}, Vec3(3, 5.75, -5)}, Cylinder{1.5, 1.25},
                Motion{Pose{Vec3(0.25, -0.75, -1.5), Quat(1, 0, 0, 0)}}, Options{}});
}

TEST_CASE("regression: where an axis proves no step that time can tell, another one is looked for")
{
    // Was `undecided` 0.01 away from contact, after 250 looks at the same time t.
    check(Query{
        Box{Vec3(0, 0x1.064438908d033p+0, 0x1.78cfbfba97303p-1)},
        Motion{Pose{Vec3(0x1.604e725d5ac3p-5, 0x1.f0419ed505c6fp+0, -0x1.1649cf55ef2fcp+1),
                    Quat(0x1.465178p-4, 0x1.0334e4p-3, 0x1.51cd48p-2, -0x1.dd3c34p-1)},
               Vec3(-0x1.f206f2a8f0e74p+2, -0x1.87b207c223903p+3, 0x1.5999246590ffep+4), Vec3(0, 0, 0),
               Vec3(0, 0, 0)},
        Box{Vec3(0, 0x1.1be4304ed3129p-1, 0x1.de422f04e4b92p-16)},
        Motion{Pose{Vec3(-0x1.84ef47580c47p-1, 0x1.8e4a6d4a58744p-1, 0x1.9851db817971ap-1),
                    Quat(0x1.465178p-4, 0x1.0334e4p-3, 0x1.51cd48p-2, -0x1.dd3c34p-1)},
               Vec3(0x1.55c98a8873acfp-1, 0x1.0cd04dd2eba2p+0, -0x1.da5b1fb8b7cddp+0),
               Vec3(-0x1.0d676ef9469ebp-5, -0x1.2721a68ac77d5p-7, -0x1.29d38b995ccb1p-4),
               Vec3(-0x1.fdbcf5412738p-7, 0x1.7941bd98a2a3ap-2, 0x1.7b626d9e9ec4ap-2)},
        Options{1, 0x1.9e70e6f1ba10dp-3, 0x1.19799812dea11p-40, StartContact::report, Detail::contact, 256}});
}
