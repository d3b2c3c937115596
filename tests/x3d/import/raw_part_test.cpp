#include <stdexcept>

#include <gtest/gtest.h>

#include <pleura/x3d/import/raw_part.h>

namespace pleura {
namespace {

TEST(RawPart, ComesBackFromBytes) {
  const std::vector<RawPart> parts = {{"lung", {0, 0.5f, 1, 1}, {{1, 2, 3}, {4, 5, 6}}, {{0, 1, 0}}},
                                      {"", {1, 1, 1, 1}, {}, {}}};
  const std::vector<RawPart> back = unpack(pack(parts));
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[0].name, "lung");
  EXPECT_EQ(back[0].colour, parts[0].colour);
  EXPECT_EQ(back[0].points, parts[0].points);
  EXPECT_EQ(back[0].triangles, parts[0].triangles);
  EXPECT_TRUE(back[1].points.empty());
}

TEST(RawPart, RefusesBytesThatEndTooEarly) {
  const std::string bytes = pack(std::vector<RawPart>{{"lung", {0, 0, 0, 1}, {{1, 2, 3}}, {{0, 0, 0}}}});
  for (std::size_t size = 1; size < bytes.size(); ++size)
    EXPECT_THROW(unpack(std::string_view(bytes).substr(0, size)), std::invalid_argument) << size;
}

}  // namespace
}  // namespace pleura
