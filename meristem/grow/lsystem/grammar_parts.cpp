// SPDX-License-Identifier: Apache-2.0
// The texts of the kit. `side(x)` is the branch that parts set beside a stem. It is a segment unless the grammar has
// rules of its own for it. Symbols that end in _ count for a part and are not for users.
#include "meristem/grow/lsystem/grammar_parts.h"

#include <algorithm>
#include <array>

namespace meristem {

namespace {

constexpr std::array<GrammarPart, 6> kKit{{
    {"arch",
     "arch(n, x, a): a shoot of n pieces, x long in all, that turns down by a degrees from its base to its tip.",
     R"(#symbols arch arch_
arch(n, x, a) : n >= 1 -> arch_(n, x/n, a/n)
arch_(k, l, d) : k > 0 -> &(d) F(l) arch_(k - 1, l, d)
)"},
    {"fork", "fork(a, x): two sides, left and right of the stem by a degrees, and a quarter turn for the next fork.",
     R"(#symbols fork side
fork(a, x) -> [+(a) side(x)] [-(a) side(x)] /(90)
side(x) -> F(x)
)"},
    {"frond",
     "frond(n, x, a, y): a midrib of n pieces, x long in all, with a pair of sides at each piece, shorter to "
     "the tip: y at the base, at a degrees.",
     R"(#symbols frond frond_ side
frond(n, x, a, y) : n >= 1 -> frond_(n, n, x/n, a, y)
frond_(k, n, l, a, y) : k > 0 -> F(l) [+(a) side(y*k/n)] [-(a) side(y*k/n)] frond_(k - 1, n, l, a, y)
side(x) -> F(x)
)"},
    {"spiral",
     "spiral(n, s, a, x): a stem of n pieces of length s, with a side at a degrees behind each, turned by the "
     "golden angle from one to the next.",
     R"(#symbols spiral side
spiral(n, s, a, x) : n >= 1 -> F(s) [&(a) side(x)] /(137.5) spiral(n - 1, s, a, x)
side(x) -> F(x)
)"},
    {"taper", "taper(n, x, w, v): a stem of n pieces, x long in all, whose radius falls evenly from w to v.",
     R"(#symbols taper taper_
taper(n, x, w, v) : n >= 1 -> !(w) taper_(n, x/n, w, (w - v)/n)
taper_(k, l, w, d) : k > 0 -> !(w - d) F(l) taper_(k - 1, l, w - d, d)
)"},
    {"whorl", "whorl(n, a, x): n sides around the stem at one height, at a degrees from it.",
     R"(#symbols whorl whorl_ side
whorl(n, a, x) : n >= 1 -> whorl_(n, 360/n, a, x)
whorl_(k, d, a, x) : k > 0 -> [&(a) side(x)] /(d) whorl_(k - 1, d, a, x)
side(x) -> F(x)
)"},
}};

}  // namespace

std::span<const GrammarPart> grammar_parts() { return kKit; }

const GrammarPart* find_grammar_part(std::string_view name) {
  const auto found = std::ranges::find(kKit, name, &GrammarPart::name);
  return found == kKit.end() ? nullptr : &*found;
}

}  // namespace meristem
