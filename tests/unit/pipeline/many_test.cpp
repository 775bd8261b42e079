#include "toolpace/pipeline/many.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

#include "toolpace/base/exception_error.h"

namespace toolpace {
namespace {

constexpr std::size_t kThreads = 3;

TEST(ForMany, GivesResultsInTheOrderOfTheValues) {
  const auto squares = for_many<std::size_t>(
      20, kThreads, {}, [](std::size_t i, const Monitor&) -> Result<std::size_t> { return i * i; });
  ASSERT_TRUE(squares);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ((*squares)[i], i * i);
}

TEST(ForMany, ThrowsOnTheThreadThatAskedWhatAWorkerThrows) {
  const auto run = [](auto thrown) {
    (void)for_many<int>(20, kThreads, {}, [&](std::size_t i, const Monitor&) -> Result<int> {
      if (i >= 5) throw thrown;
      return 0;
    });
  };
  EXPECT_THROW(run(std::bad_alloc()), std::bad_alloc);
  EXPECT_THROW(run(std::runtime_error("odd")), std::runtime_error);
}

TEST(ForMany, ThrowsOnTheThreadThatAskedWhatProgressThrows) {
  const Monitor monitor{{}, [](double) { throw std::bad_alloc(); }};
  EXPECT_THROW((void)for_many<int>(5, kThreads, monitor, [](std::size_t, const Monitor&) -> Result<int> { return 0; }),
               std::bad_alloc);
}

TEST(CaughtError, TellsTheWantOfMemoryFromWhatShouldNotBe) {
  const auto code = [](auto thrown) {
    try {
      throw thrown;
    } catch (...) {
      return caught_error().code;
    }
  };
  EXPECT_EQ(code(std::bad_alloc()), "out-of-memory");
  EXPECT_EQ(code(std::runtime_error("odd")), "internal");
  EXPECT_EQ(code(7), "internal");
}

}  // namespace
}  // namespace toolpace
