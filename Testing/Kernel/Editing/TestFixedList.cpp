// Short lists say when they are full.
#include "Editing/FixedList.h"

#include <gtest/gtest.h>

namespace cartesian
{

TEST(FixedList, SaysWhenItIsFull)
{
  FixedList<int, 2> list;
  EXPECT_TRUE(list.add(1));
  list.push(2);
  EXPECT_FALSE(list.add(3));
  list.offer(4);
  EXPECT_THROW(list.push(5), std::length_error);
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0], 1);
  EXPECT_EQ(list[1], 2);
}

}
