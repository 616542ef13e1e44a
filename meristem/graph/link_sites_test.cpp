// SPDX-License-Identifier: Apache-2.0
// Which links an instance follows, and what a limit tells to change. expand_test.cpp has the places of children.
#include "meristem/graph/link_sites.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/build_graph.h"
#include "tests/support/test_components.h"

namespace meristem::link_sites_test {

using testing::ElementsAre;
using testing::IsEmpty;

/// A graph and what its links are read with.
class LinksOf {
 public:
  explicit LinksOf(const GraphBuilder& builder) : graph_(builder.sound_graph()) {}

  std::vector<LinkIndex> followed(std::string_view component, std::uint16_t depth = 0) {
    Site site;
    site.depth = depth;
    site.depths.fill(depth);
    return sites_.links_followed(index(component), site);
  }

  std::string multiplier(std::string_view component) {
    return sites_.multiplier(index(component), followed(component));
  }

  const LinkSites& sites() const { return sites_; }

 private:
  ComponentIndex index(std::string_view id) const {
    for (ComponentIndex k = 0; k < graph_.components.size(); ++k) {
      if (graph_.components[k].id == id) return k;
    }
    throw std::invalid_argument("no such component");
  }

  Graph graph_;
  Scene scene_;
  Directions directions_;
  Progress progress_;
  LinkSites sites_{graph_, scene_, directions_, 0, progress_};
};

/// A camera, and a stick that stands on itself three times and then bears a leaf. Links: 0 view to stick, 1 stick to
/// stick, 2 stick to leaf by a leaf link, 3 stick to side.
GraphBuilder recursion() {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("stick", "stick", {{"recursion", 3}});
  builder.component("leaf", "stick").component("side", "star");
  builder.link("view", "stick").link("stick", "stick").link("stick", "leaf", LinkKind::leaf);
  return builder.link("stick", "side");
}

TEST(LinkSites, ALinkBackLeadsOnUntilItsDepthAndLeafLinksFromThere) {
  LinksOf links(recursion());
  EXPECT_THAT(links.followed("view"), ElementsAre(0));
  EXPECT_THAT(links.followed("stick", 0), ElementsAre(1, 3));
  EXPECT_THAT(links.followed("stick", 1), ElementsAre(1, 3));
  EXPECT_THAT(links.followed("stick", 2), ElementsAre(2, 3));
  EXPECT_THAT(links.followed("leaf", 2), IsEmpty());
}

TEST(LinkSites, ALimitNamesTheRecursionOrTheComponentThatMultiplies) {
  LinksOf links(recursion());
  EXPECT_EQ(links.multiplier("stick"), "components.stick.recursion");
  EXPECT_EQ(links.multiplier("view"), "components.view");
}

TEST(LinkSites, LinksWithOtherPlacesHaveOtherFingerprints) {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("pole", "pole").component("a", "stick");
  builder.link("view", "pole");
  for (const int count : {4, 5}) builder.link("pole", "a", LinkKind::branch, {{"count", count}});
  LinksOf links(builder);
  ASSERT_TRUE(links.sites().fingerprint(1));
  EXPECT_NE(links.sites().fingerprint(1), links.sites().fingerprint(2));
  EXPECT_EQ(links.sites().fingerprint(1), links.sites().fingerprint(1));
}

}  // namespace meristem::link_sites_test
